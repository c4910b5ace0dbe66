//! Hovers.

use super::{cursor, on};
use tipc::Robot;
use tipc::message::Lang;

/// The lines of a hover.
#[track_caller]
fn check(statements: &str, expected: &[&str]) {
    let (document, at) = cursor(statements);
    let hover = document.hover(at, Lang::English).expect("a word");
    for line in expected {
        assert!(
            hover.text.lines().any(|found| found == *line),
            "{line} in\n{}",
            hover.text
        );
    }
}

#[track_caller]
fn check_none(statements: &str) {
    let (document, at) = cursor(statements);
    assert_eq!(document.hover(at, Lang::English), None);
}

#[test]
fn a_command_shows_its_row_for_the_robot() {
    check(
        "SLEEP 40\nSLE$0EP 20\nEND\n",
        &[
            "SLEEP number",
            "Waits for a time.",
            "- unit: ms",
            "- takes at least 1 control cycle, until the time is over: V divided by the sampling time, rounded up",
            "- emergency stop, Domain error: below 0",
            "- T.I.P. 3.1 §7-4-1, clause 7.14 of the language reference",
            "- step 1",
        ],
    );
    let (document, at) = on(Robot::Hand, "TEACH_TORQU$0E J11 A\nDEF_VAR A\nEND\n");
    let hover = document.hover(at, Lang::English).expect("a command");
    assert!(hover.text.contains("- only for hand"), "{}", hover.text);
}

#[test]
fn words_are_found_in_any_case_and_at_both_ends() {
    let description = "Waits for a time.";
    check("$0sleep 40\nEND\n", &[description]);
    check("sleep$0 40\nEND\n", &[description]);
}

#[test]
fn a_variable_shows_what_the_program_does_with_it() {
    check(
        "DEF_VAR A\nA = 80\nA = 60\nA = 80\nSLEEP $0A\nEND\n",
        &[
            "DEF_VAR A",
            "- declared on line 3",
            "- assignments: 3, reads: 1",
            "- assigned values: 80, 60",
        ],
    );
}

#[test]
fn values_are_listed_only_if_they_are_all() {
    for other in ["A = B", "A += 1", "KEY_IN A", "FOR A = 1 TO 2\nNEXT"] {
        let program = format!("DEF_VAR A, B\nA = 80\nB = 1\n{other}\nSLEEP $0A\nEND\n");
        let (document, at) = cursor(&program);
        let hover = document.hover(at, Lang::English).expect("a variable");
        assert!(!hover.text.contains("all that"), "{other}: {}", hover.text);
    }
}

#[test]
fn a_member_has_values_of_its_own() {
    let values = "- assigned values: 10";
    check(
        "DEF_POS P\nP.X = 10\nP.Y = 20\nP.Z = 30\nSLEEP $0P.X\nEND\n",
        &[values],
    );
    check("DEF_POS P\nSLEEP P.$0X\nEND\n", &["To the right, in mm."]);
}

#[test]
fn a_loop_counts_its_variable_and_its_cycles() {
    // A turn is the SLEEP of two cycles at most or more, and NEXT.
    check(
        "DEF_VAR N\nFOR $0N = 1 TO 5\nREM\nNEXT\nEND\n",
        &["- FOR counts it from 1 to 5"],
    );
    check(
        "DEF_VAR N\nF$0OR N = 1 TO 5\nREM\nNEXT\nEND\n",
        &["- step 0", "- 5 turns, each turn: 2 cycles, 40 ms"],
    );
}

#[test]
fn a_label_shows_who_leads_there_and_how_long_it_takes() {
    check(
        "GOSUB LIFT:\nIF KB_HIT GOSUB LIFT:\nEXIT\n$0LIFT:\nREM\nRETURN\nEND\n",
        &[
            "LIFT:",
            "- declared on line 6",
            "- jumps: 0, calls: 2",
            "- until it returns: 3 cycles, 60 ms",
        ],
    );
}

#[test]
fn a_sampling_time_of_the_program_leaves_milliseconds_open() {
    check(
        "DEF_VAR N\nSET_SAMPLING_TIME 10\nF$0OR N = 1 TO 5\nREM\nNEXT\nEND\n",
        &["- 5 turns, each turn: 2 cycles"],
    );
}

#[test]
fn functions_flags_targets_inputs_and_constants_have_their_rows() {
    check(
        "DEF_VAR A\nA = SQ$0RT 2\nEND\n",
        &["SQRT number", "The square root."],
    );
    check(
        "IF KB_$0HIT THEN\nENDIF\nEND\n",
        &["The keyboard buffer is not empty."],
    );
    check(
        "WAIT_INPOS AL$0L\nEND\n",
        &["Everything that the command can act on."],
    );
    check(
        "DEF_VAR A\nAD_IN VR$01 A\nEND\n",
        &["A potentiometer of the control box."],
    );
    check("DEF_VAR A\nA = CHAR_$0F\nEND\n", &["- value: 70"]);
    check(
        "PTP F1 $0R 0 0 0\nEND\n",
        &["The value after it counts from where the foot or joint is."],
    );
    check(
        "IF KB_HIT $0THEN\nENDIF\nEND\n",
        &["Ends the condition of IF and ELSEIF; the block follows."],
    );
}

#[test]
fn comments_texts_numbers_and_what_follows_end_say_nothing() {
    check_none("REM // SLE$0EP\nEND\n");
    check_none("MESSAGE SLE$0EP\nEND\n");
    check_none("SLEEP 1$00\nEND\n");
    check_none("END\nSLE$0EP 10\n");
    check_none("$0");
}

#[test]
fn a_name_in_a_message_is_a_variable() {
    check(
        "DEF_VAR A\nA = 1\nMESSAGE 歩数 %$0A%\nEND\n",
        &["- assigned values: 1"],
    );
}

#[test]
fn facts_are_japanese_where_that_is_read() {
    let (document, at) = cursor("DEF_VAR A\nA = 80\nSLEEP $0A\nEND\n");
    let hover = document.hover(at, Lang::Japanese).expect("a variable");
    assert!(
        hover.text.contains("- 3行目で宣言されています"),
        "{}",
        hover.text
    );
    assert!(hover.text.contains("- 代入される値: 80"), "{}", hover.text);
}

#[test]
fn the_tables_speak_japanese() {
    let (document, at) = cursor("SLE$0EP 20\nEND\n");
    let hover = document.hover(at, Lang::Japanese).expect("a command");
    for line in [
        "指定した時間だけ待ちます。",
        "- 少なくとも1制御周期かかり、次の条件まで待ちます: 時間が経過する(V÷サンプリング時間、端数切り上げ)",
        "- 緊急停止(Domain error): 0未満",
    ] {
        assert!(hover.text.contains(line), "{}", hover.text);
    }
}
