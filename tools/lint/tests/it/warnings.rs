//! Warnings about programs that load: where they fire, and where they stay silent.

use tip_lint::{Options, load};
use tipc::Robot;
use tipc::source::Unit;

/// Returns the diagnostics of some statements, each as code, line and column; the first statement is on line 3.
fn found(statements: &str, robot: Robot) -> Vec<String> {
    let text = format!("3.1\nA title\n{statements}\nEND\n");
    let options = Options {
        robot,
        ..Options::default()
    };
    let loaded = load("warnings.prg", text.as_bytes(), &options);
    let place = |start| loaded.source.position(start, Unit::Character);
    let diagnostic = |one: &tipc::diagnostic::Diagnostic| {
        let at = place(one.span.start);
        format!("{} {}:{}", one.code.id(), at.line, at.column)
    };
    loaded.diagnostics.iter().map(diagnostic).collect()
}

#[track_caller]
fn check(statements: &str, expected: &[&str]) {
    assert_eq!(found(statements, Robot::Titan8), expected, "{statements}");
}

#[test]
fn names_between_percent_signs_are_variables() {
    check(
        "DEF_VAR COUNT\nCOUNT = 1\nMESSAGE %CUONT% of %count.2%",
        &["W110 5:9"],
    );
    check("MESSAGE %X%", &["W110 3:9"]);
    // That nothing reads the variable follows from it.
    check("DEF_VAR COUNT\nCOUNT = 1\nMESSAGE %CUONT%", &["W110 5:9"]);
    // One of nine decimals, one of a POS, one of its member.
    check(
        "DEF_VAR N\nDEF_POS P\nN = 1\nP.X = N; N = P.X\nMESSAGE %N% %N.9% %P% %P.X%",
        &["W110 7:13", "W110 7:19", "W110 7:23"],
    );
    // Percent signs that are meant as such, and a value between two of them.
    check(
        "DEF_VAR N\nN = 1\nMESSAGE 50% of 100%\nMESSAGE 100%%, 5 % 3 %\nMESSAGE 50%%N%%\nMESSAGE %5%\nMESSAGE %X%N%",
        &[],
    );
}

#[test]
fn a_text_needs_no_quotes() {
    check("MESSAGE \"hello\"", &["W111 3:9"]);
    check("MESSAGE 'hello'", &["W111 3:9"]);
    check("MESSAGE say \"hello\"", &[]);
    check("MESSAGE \"one\" and \"two\"", &[]);
    check("MESSAGE 'tis\nMESSAGE \"", &[]);
}

#[test]
fn values_of_other_languages_are_shown_as_they_are() {
    let with = |text: &str| format!("DEF_VAR N\nN = 1\nSLEEP N\nMESSAGE {text}");
    for (text, column) in [
        ("N=%d", 11),
        ("N=%5.2f mm", 11),
        ("N=$N", 11),
        ("N={n} mm", 11),
        ("N=%N", 11),
        ("N = %N!", 13),
    ] {
        check(&with(text), &[&format!("W124 6:{column}")]);
    }
    // Other signs, names that nothing bears, and values as they are written here.
    for text in [
        "100 % done",
        "50%d",
        "{M} $M",
        "%N% $ {",
        "5 $",
        "{N",
        "a%%N%",
    ] {
        check(&with(text), &[]);
    }
    check("DEF_VAR N\nN = 1\nMESSAGE \"N=\" + N", &["W111 5:9"]);
    // That nothing reads the variable follows from it.
    check("DEF_VAR N\nN = 1\nMESSAGE N=%d", &["W124 5:11"]);
    check("DEF_VAR N\nN = 1\nMESSAGE N=%N", &["W124 5:11"]);
}

#[test]
fn steps_behind_a_jump_are_reached_by_a_label() {
    check("LOOP: REM\nGOTO LOOP:\nALL_STOP\nMESSAGE a", &["W112 5:1"]);
    check("EXIT\nPART: ALL_STOP", &["W112 4:1"]);
    check(
        "GOTO OUT:\nALL_STOP\nOUT: REM\nEXIT\nALL_STOP",
        &["W112 4:1", "W112 7:1"],
    );
    // What unreachable steps jump to follows from them.
    check(
        "EXIT\nALL_STOP\nGOTO L:\nSUBROUTINE S:\nSUBEND\nL: ALL_STOP",
        &["W112 4:1"],
    );
    // A loop that nothing enters.
    check("EXIT\nL: ALL_STOP\nGOTO L:", &["W112 4:1"]);
}

#[test]
fn closers_and_jumps_behind_a_jump_are_no_mistake() {
    check("WHILE 1 == 1\nALL_STOP\nWEND", &[]);
    check("WHILE 1 == 1\nALL_STOP\nWEND\nMESSAGE a", &["W112 6:1"]);
    check("IF KB_HIT THEN\nEXIT\nELSE\nEXIT\nENDIF\nEXIT", &[]);
    check(
        "CALL S:\nEXIT\nSUBROUTINE S:\nALL_STOP\nRETURN\nSUBEND",
        &[],
    );
    // More routines than the program needs.
    check("EXIT\nSPARE: ALL_STOP\nRETURN", &[]);
    check("EXIT\nSUBROUTINE S:\nALL_STOP\nSUBEND", &[]);
}

#[test]
fn called_parts_return() {
    check("GOSUB A:\nEXIT\nA: ALL_STOP", &["W113 5:1"]);
    check(
        "LOOP: REM\nIF KB_HIT GOSUB A:\nGOTO LOOP:\nA: MESSAGE a\nGOTO LOOP:",
        &["W113 6:1"],
    );
    // It ends the program, repeats for ever, or returns through another part.
    check(
        "LOOP: IF KB_HIT GOSUB A:\nGOTO LOOP:\nA: ALL_STOP\nEXIT",
        &[],
    );
    check("GOSUB A:\nEXIT\nA: ALL_STOP\nGOTO A:", &[]);
    check("GOSUB A:\nGOSUB B:\nEXIT\nA: ALL_STOP\nB: REM\nRETURN", &[]);
    check(
        "GOSUB A:\nEXIT\nA: IF KB_HIT THEN\nRETURN\nENDIF\nGOTO A:",
        &[],
    );
}

// clauses: 3.2
#[test]
fn a_jump_in_one_word_is_a_label() {
    check("L1: ALL_STOP\nGOTOL1:", &["W130 4:1"]);
    check("gosubL1:\nEXIT\nL1: ALL_STOP\nRETURN", &["W130 3:1"]);
    check("LOOP: ALL_STOP\nGOTOLOOP:", &["W130 4:1"]);
    check(
        "CALLA:\nEXIT\nSUBROUTINE A:\nALL_STOP\nSUBEND",
        &["W130 3:1"],
    );
    // That nothing jumps to the label follows from it.
    check("GOTOL1:\nEXIT\nL1: ALL_STOP", &["W130 3:1"]);
    // Something jumps there, there is no such label, or nothing that CALL could call.
    check("L1: ALL_STOP\nGOTOL1:\nGOTO GOTOL1:", &[]);
    check("L1: ALL_STOP\nGOTOL2:\nGOTO L1:", &[]);
    check("L1: ALL_STOP\nCALLL1:\nGOTO L1:", &[]);
    check("GOTO: ALL_STOP", &["E205 3:1"]);
}

/// Judges statements and flow of a long program like those of a short one.
#[test]
fn a_long_program_is_judged_like_a_short_one() {
    let begin = "ALL_STOP\n".repeat(2100);
    check(
        &format!("{begin}A = B\nB = 1\nDEF_VAR A B\nGOTOL1:\nEXIT\nL1: ALL_STOP"),
        &["W108 2103:5", "W102 2105:9", "W130 2106:1"],
    );
}

#[test]
fn a_return_belongs_to_a_call() {
    check("ALL_STOP\nRETURN", &["W114 4:1"]);
    check("GOSUB A:\nA: ALL_STOP\nRETURN", &["W114 5:1"]);
    check("GOSUB A:\nGOTO OUT:\nA: ALL_STOP\nRETURN\nOUT: REM", &[]);
    // The other warning speaks of SUBROUTINEs.
    check("CALL S:\nSUBROUTINE S:\nRETURN\nSUBEND", &["W106 4:1"]);
}

#[test]
fn constants_decide_nothing() {
    check(
        "DEF_VAR I\nFOR I = 10 TO 1\nGOSUB A:\nNEXT\nEXIT\nA: RETURN",
        &["W115 4:1"],
    );
    check("DEF_VAR I\nFOR I = 10 TO 1\nNEXT", &[]);
    check(
        "DEF_VAR I\nFOR I = 1 TO 10 STEP -1\nALL_STOP\nNEXT",
        &["W115 4:1"],
    );
    check("DEF_VAR I\nFOR I = 10 TO 1 STEP -1\nREM\nNEXT", &[]);
    check("DEF_VAR I\nFOR I = 1 TO 1\nREM\nNEXT", &[]);
    check("IF 1 == 1 THEN\nALL_STOP\nENDIF", &["W116 3:4"]);
    check("IF 1 == 2 THEN\nALL_STOP\nELSE\nREM\nENDIF", &["W116 3:4"]);
    check("IF 1 == 1 THEN\nENDIF", &[]);
    check("WHILE 1 == 2\nALL_STOP\nWEND", &["W116 3:7"]);
    check("REPEAT\nALL_STOP\nUNTIL 1 == 1", &["W116 5:7"]);
    check(
        "DEF_VAR N\nN = 1\nIF N < N GOTO OUT:\nALL_STOP\nOUT: REM",
        &["W116 5:4"],
    );
    // Loops without an end are meant so.
    check("WHILE 1 == 1\nALL_STOP\nWEND", &[]);
    check("REPEAT\nALL_STOP\nUNTIL 1 == 0", &[]);
}

#[test]
fn a_step_of_zero_is_one_mistake() {
    check(
        "DEF_VAR I\nFOR I = 1 TO 3 STEP 0\nALL_STOP\nNEXT\nMESSAGE a",
        &["W107 4:21"],
    );
}

#[test]
fn something_in_a_loop_changes_its_condition() {
    let n = "DEF_VAR N\nN = 0\n";
    let check = |statements: &str, expected: &[&str]| check(&format!("{n}{statements}"), expected);
    check("WHILE N < 10\nALL_STOP\nWEND", &["W117 5:7"]);
    check("REPEAT\nSLEEP 100\nUNTIL N > 10", &["W117 7:7"]);
    check("AGAIN: SLEEP 100\nIF N < 10 GOTO AGAIN:", &["W117 6:4"]);
    check(
        "WHILE N < 10\nCALL S:\nWEND\nEXIT\nSUBROUTINE S:\nALL_STOP\nSUBEND",
        &["W117 5:7"],
    );
    // It is assigned: here, in a routine, by an input or a FOR; or the loop is left otherwise.
    check("WHILE N < 10\nN += 1\nWEND", &[]);
    check(
        "WHILE N < 10\nCALL S:\nWEND\nEXIT\nSUBROUTINE S:\nN += 1\nSUBEND",
        &[],
    );
    check("WHILE N < 10\nAD_IN VR1 N\nWEND", &[]);
    check("WHILE N < 10\nKEY_IN N\nWEND", &[]);
    check("WHILE N < 10\nFOR N = 1 TO 20\nREM\nNEXT\nWEND", &[]);
    check("WHILE N < 10\nIF KB_HIT GOTO OUT:\nWEND\nOUT: REM", &[]);
    check("WHILE N < 10\nIF KB_HIT THEN\nEXIT\nENDIF\nWEND", &[]);
    check(
        "CALL S:\nEXIT\nSUBROUTINE S:\nWHILE N < 10\nIF KB_HIT THEN\nRETURN\nENDIF\nWEND\nSUBEND",
        &[],
    );
    // Whoever runs the program may assign what a loop waits for.
    check("WHILE N == 0\nWEND\nWAIT: IF N == 0 GOTO WAIT:", &[]);
    // Flags change by themselves; a choice in an endless loop is a setting.
    check(
        "WHILE N < 10\nN += 1\nWEND\nWHILE !KB_HIT\nWEND\nREPEAT\nUNTIL INPOS_ALL",
        &[],
    );
    check("LOOP: IF N == 1 THEN\nALL_STOP\nENDIF\nGOTO LOOP:", &[]);
    // The condition is tested again after the way round.
    check("LOOP: N = 0\nWHILE N < 10\nIF KB_HIT GOTO LOOP:\nWEND", &[]);
}

#[test]
fn a_pause_takes_a_cycle_at_least() {
    check("SLEEP 1", &["W118 3:7"]);
    check("SLEEP 19.9", &["W118 3:7"]);
    check("SLEEP 0\nSLEEP 20", &[]);
    check("SET_SAMPLING_TIME 10\nSLEEP 10", &[]);
    assert_eq!(found("SLEEP 2", Robot::Hand), [""; 0]);
    assert_eq!(found("SLEEP 1", Robot::Hand), ["W118 3:7"]);
}

#[test]
fn a_sign_behind_equals_is_no_update() {
    check("DEF_VAR N\nN = 1\nN =+1\nSLEEP N", &["W119 5:3"]);
    check("DEF_VAR N\nN = +1\nN=+1\nN =-1\nN += 1\nSLEEP N", &[]);
}

#[test]
fn relative_is_said_of_each_number() {
    check("PTP F1 R 10 0 0", &["W120 3:8"]);
    check("PTP HS F1 R 10 0 0", &["W120 3:11"]);
    check("PTP_ANGLE F1 R 10 20 30", &["W120 3:14"]);
    check("PTP F1 R 10 R 0 R 0\nPTP F1 R 10 A 251 A -150", &[]);
    check("PTP F1 R 0 251 -150\nPTP F1 -391 R 10 -150", &[]);
    check("PTP F1 R 0 0 50", &["W120 3:8"]);
    check(
        "DEF_POS P\nTEACH_POSITION F1 P\nPTP F1 R P\nPTP_ANGLE J11 R 10",
        &[],
    );
}

#[test]
fn a_comment_silences_warnings_of_its_line() {
    check("SLEEP 1 // tip: allow(W118)", &[]);
    check("SLEEP 1 //TIP:ALLOW( w118 ) one cycle", &[]);
    check(
        "SLEEP 1 // tip: allow(W118); SLEEP 1\nSLEEP 1",
        &["W118 4:7"],
    );
    check(
        "SLEEP 1; N =+1 // tip: allow(W118, W119)\nSLEEP N\nDEF_VAR N",
        &[],
    );
}

#[test]
fn a_comment_on_its_own_line_is_for_the_next_statement() {
    check(
        "ALL_STOP\n// tip: allow(W118)\n\n// why\nSLEEP 1\nSLEEP 1",
        &["W118 8:7"],
    );
    // Two of them for one statement.
    check(
        "DEF_VAR N\n// tip: allow(W118)\n  // tip: allow(W119)\nSLEEP 1; N =+1\nSLEEP N",
        &[],
    );
}

#[test]
fn a_comment_above_all_statements_is_for_the_whole_program() {
    check("// tip: allow(W118)\nSLEEP 1\nSLEEP 1", &[]);
    check(
        "\n// A walk\n// tip: allow(W102)\nDEF_VAR N\nDEF_VAR M\nN = 1\nM = 1",
        &[],
    );
}

#[test]
fn a_comment_that_silences_nothing_is_a_warning() {
    check("SLEEP 20 // tip: allow(W118)", &["W121 3:24"]);
    check(
        "ALL_STOP // tip: allow(W118, W999)",
        &["W121 3:24", "W121 3:30"],
    );
    check("ALL_STOP // tip: allow(E205)", &["W121 3:24"]);
    check("ALL_STOP // tip: allow W118", &["W121 3:10"]);
    check("ALL_STOP // tip: allow()", &["W121 3:24"]);
    check("// tip: allow(W121)\nALL_STOP // tip: allow(W118)", &[]);
    // Other comments, and those behind END.
    check("ALL_STOP // tip: lift first\nALL_STOP // allow(W118)", &[]);
    check(
        "END // tip: allow(W999)\n// tip: allow(W999)\nNot a statement",
        &["W121 3:19", "W131 6:1"],
    );
    // Errors stay, and are enough to read.
    check("FOO // tip: allow(E204, W999)", &["E204 3:1"]);
}

// clauses: 1.5
#[test]
fn a_statement_after_end_does_not_run() {
    // `check` puts one more END below.
    check("END\nPTP F9 1 2 3\nPTP F9 1 2 3", &["W131 4:1"]);
    check("END ; ALL_STOP", &["W131 3:7"]);
    check("END ALL_STOP // twice", &["W131 3:5"]);
    check("END\n\n// notes\nL1:\n\tL2: X = 1", &["W131 6:1"]);
    check("END\nDEF_VAR X", &["W131 4:1"]);
    check("END\nSUBROUTINE S:\nSUBEND", &["W131 4:1"]);
    check("END\nA note ; IF KB_HIT THEN", &["W131 4:10"]);
    check("END", &["W131 4:1"]);
    // A command that this robot lacks.
    check("END\nDETECT_OBJECT V", &["W131 4:1"]);
    // A comment silences it.
    check("// tip: allow(W131)\nEND\nALL_STOP", &[]);
    check("END\nALL_STOP // tip: allow(W131)", &[]);
    check("END\n// tip: allow(W131)\n// why\n\nALL_STOP", &[]);
    check("END ; ALL_STOP // tip: allow(W131)", &[]);
    check(
        "END // tip: allow(W131)\nALL_STOP",
        &["W121 3:19", "W131 4:1"],
    );
    let ends = |rest: &str| {
        let text = format!("3.1\nA title\nEND{rest}");
        let loaded = load("warnings.prg", text.as_bytes(), &Options::default());
        loaded.diagnostics.len()
    };
    assert_eq!(ends("\nALL_STOP"), 1);
    for note in [
        "",
        "\n\n// ALL_STOP\n;;\n",
        "\r\n\x1A",
        "\nso here is room for notes",
        " of the program; if you need more, call me\nNote: for each leg, repeat it",
        "\n全部で3歩\nEND of file\nREM ALL_STOP\nIF = = 1\n/* ALL_STOP\nALL_STOP */",
        "\n// tip: allow(W999)",
    ] {
        assert_eq!(ends(note), 0, "{note}");
    }
    // Longer than lines may be.
    assert_eq!(ends(&format!("\nX = 1 {}", ";".repeat(1100))), 0);
}

#[test]
fn a_wait_for_what_nothing_moves() {
    check("PTP F1 R 0 R 0 R 10\nWAIT_INPOS F2", &["W126 4:12"]);
    check("PTP F1 R 0 R 0 R 10\nWAIT_NEAR F2", &["W126 4:11"]);
    check("PTP_ANGLE J11 30\nWAIT_INPOS J12", &["W126 4:12"]);
    check("PTP_ANGLE J11 30\nREPEAT\nUNTIL NEAR_F3", &["W126 5:7"]);
    check("PTP_ANGLE J11 30\nWHILE !INPOS_J21\nWEND", &["W126 4:8"]);
    // A foot with its joints, all feet, and what moves everything.
    check(
        "PTP F1 R 0 R 0 R 10\nWAIT_INPOS J13\nWAIT_INPOS F1\nWAIT_INPOS ALL",
        &[],
    );
    check("PTP_ANGLE J11 30\nWAIT_INPOS F1", &[]);
    check("INITIAL_POSTURE\nWAIT_INPOS F4", &[]);
    // Elsewhere in the program is enough: a loop may come by.
    check(
        "LOOP:\nIF INPOS_F2 THEN\nPTP F2 R 0 R 0 R 10\nENDIF\nGOTO LOOP:",
        &[],
    );
    // Native code may move anything; nothing moves before it, and ALL is a habit.
    check("SPECIAL 1\nWAIT_INPOS F2 // tip: allow(W123)", &[]);
    check("WAIT_INPOS ALL", &[]);
    // A sketch in which nothing moves; a question, of which the other answer is dealt with, too.
    check("WAIT_INPOS F2", &[]);
    check(
        "PTP_ANGLE J11 30\nIF INPOS_F2 THEN\nMESSAGE still\nENDIF",
        &[],
    );
    check("WAIT_NEAR F2", &[]);
}

#[test]
fn a_flag_that_no_special_sets() {
    check("REPEAT\nUNTIL SPECIAL_FLAG0", &["W126 4:7"]);
    check("SPECIAL 1\nREPEAT\nUNTIL SPECIAL_FLAG0", &[]);
}
