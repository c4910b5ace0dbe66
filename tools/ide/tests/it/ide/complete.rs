//! Completion and signature help.

use super::{cursor, on};
use tip_ide::CompletionItem;
use tipc::Robot;

fn labels(offers: &[CompletionItem]) -> Vec<&str> {
    offers.iter().map(|offer| offer.label.as_str()).collect()
}

/// Offers that are there, and some that are not.
#[track_caller]
fn check(statements: &str, there: &[&str], not: &[&str]) {
    let (document, at) = cursor(statements);
    let offers = document.complete(at);
    let labels = labels(&offers);
    for one in there {
        assert!(labels.contains(one), "{one} in {labels:?}");
    }
    for one in not {
        assert!(!labels.contains(one), "no {one} in {labels:?}");
    }
}

#[track_caller]
fn check_none(statements: &str) {
    let (document, at) = cursor(statements);
    assert_eq!(labels(&document.complete(at)), [""; 0], "{statements}");
}

#[test]
fn a_statement_begins_with_a_command_of_the_robot_or_a_variable() {
    let expected = ["PTP", "FOR", "IF", "MESSAGE", "A", "VAR_KEY"];
    check(
        "DEF_VAR A\n$0",
        &expected,
        &["TEACH_TORQUE", "THEN", "SQRT"],
    );
    check("DEF_VAR A\nREM; P$0\nEND\n", &expected, &[]);
    check("DEF_VAR A\nL1: $0\nEND\n", &expected, &[]);
    let (document, at) = on(Robot::Hand, "$0\nEND\n");
    assert!(labels(&document.complete(at)).contains(&"TEACH_TORQUE"));
}

#[test]
fn arguments_follow_the_form_of_the_command() {
    check(
        "DEF_VAR A\nDEF_POS P\nPTP $0\nEND\n",
        &["F1", "F4", "HS"],
        &["F5", "J11", "ALL", "A"],
    );
    check(
        "DEF_VAR A\nDEF_POS P\nPTP F1 $0\nEND\n",
        &["A", "P", "R"],
        &["F1", "HS"],
    );
    check(
        "DEF_VAR A\nDEF_POS P\nSLEEP $0\nEND\n",
        &["A"],
        &["P", "F1", "R"],
    );
    check(
        "DEF_VAR A\nAD_IN $0\nEND\n",
        &["VR1", "PAW4", "ANTENNA", "J11"],
        &["A"],
    );
    check("DEF_VAR A\nAD_IN VR1 $0\nEND\n", &["A"], &["VR1"]);
    check(
        "DEF_VAR A\nWAIT_INPOS $0\nEND\n",
        &["ALL", "F1", "J43"],
        &["A"],
    );
}

#[test]
fn conditions_have_the_flags_of_the_robot() {
    let flags = [
        "KB_HIT",
        "INPOS_ALL",
        "INPOS_F4",
        "NEAR_J11",
        "SPECIAL_FLAG9",
        "A",
    ];
    check(
        "DEF_VAR A\nIF $0\nEND\n",
        &flags,
        &["ANTENNA_ON", "INPOS_F5"],
    );
    check("DEF_VAR A\nIF !K$0\nEND\n", &["KB_HIT"], &["THEN", "A"]);
    check("IF !KB_HIT $0\nEND\n", &["THEN", "GOTO"], &["KB_HIT"]);
    check("WHILE $0\nEND\n", &["KB_HIT"], &["THEN"]);
    check_none("IF KB_HIT THEN $0\nEND\n");
}

#[test]
fn jumps_lead_to_labels() {
    let program = |jump: &str| format!("L1:\n{jump} $0\nSUBROUTINE LIFT:\nSUBEND\nEND\n");
    check(&program("GOTO"), &["L1"], &["LIFT"]);
    check(&program("GOSUB"), &["L1", "LIFT"], &[]);
    check(&program("CALL"), &["LIFT"], &["L1"]);
    check(&program("IF KB_HIT GOTO"), &["L1"], &["LIFT"]);
    let (document, at) = cursor("L1:\nGOTO L$0\nEND\n");
    assert_eq!(document.complete(at)[0].text, "L1:");
}

#[test]
fn jumps_into_a_subroutine_and_calls_of_loop_are_not_offered() {
    let program = |main: &str, inside: &str| {
        format!("LOOP:\n{main}\nEXIT\nSUBROUTINE LIFT:\nIN:\n{inside}\nSUBEND\nEND\n")
    };
    check(&program("GOTO $0", ""), &["LOOP"], &["IN", "LIFT"]);
    check(&program("GOSUB $0", ""), &["LIFT"], &["IN", "LOOP"]);
    check(&program("", "GOTO $0"), &["IN"], &["LOOP", "LIFT"]);
    check(
        &program("", "IF KB_HIT GOSUB $0"),
        &["IN", "LIFT"],
        &["LOOP"],
    );
}

#[test]
fn variables_are_those_of_the_types_that_fit() {
    let program =
        |statement: &str| format!("DEF_VAR A\nDEF_POS P\nDEF_JOINT Q\n{statement}\nEND\n");
    for only in [
        "FOR $0",
        "FOR A = 1 TO 3\nNEXT $0",
        "MESSAGE %$0",
        "KEY_IN $0",
        "AD_IN VR1 $0",
    ] {
        check(&program(only), &["A"], &["P", "Q"]);
    }
    check(&program("TEACH_POSITION F1 $0"), &["P"], &["A", "Q"]);
    check(&program("TEACH_ANGLE J11 $0"), &["A", "Q"], &["P"]);
    // Members are numbers.
    check(&program("A = $0"), &["A", "P", "Q"], &[]);
    check(&program("IF $0"), &["A", "P", "Q"], &[]);
}

#[test]
fn members_are_those_of_the_type_on_the_robot() {
    check("DEF_POS P\nP.$0\nEND\n", &["X", "Y", "Z"], &["J1"]);
    check("DEF_JOINT Q\nQ.$0\nEND\n", &["J1", "J3"], &["J4", "X"]);
    check("DEF_POS P\nSLEEP 歩p.Z$0\nEND\n", &["X"], &[]);
    check_none("DEF_VAR A\nA.$0\nEND\n");
}

#[test]
fn equations_and_counting_have_their_words() {
    check(
        "DEF_VAR A\nA = $0\nEND\n",
        &["SQRT", "NORM", "A", "CHAR_SPC"],
        &["PTP", "ROT_Z"],
    );
    check(
        "DEF_POS P\nP = $0\nEND\n",
        &["ROT_Z", "UNIT_VECT", "P"],
        &["SQRT", "CHAR_SPC", "VAR_KEY"],
    );
    check("DEF_VAR A\nA += $0\nEND\n", &["A"], &[]);
    check("DEF_VAR N\nFOR $0\nNEXT\nEND\n", &["N"], &["TO"]);
    check("DEF_VAR N\nFOR N = 1 $0\nNEXT\nEND\n", &["TO"], &["STEP"]);
    check(
        "DEF_VAR N\nFOR N = 1 TO 3 $0\nNEXT\nEND\n",
        &["STEP"],
        &["TO"],
    );
    check("DEF_VAR N\nFOR N = 1 TO 3\nNEXT $0\nEND\n", &["N"], &[]);
}

#[test]
fn texts_comments_and_titles_offer_nothing() {
    check_none("REM $0\nEND\n");
    check_none("MESSAGE $0\nEND\n");
    check_none("REM // $0\nEND\n");
    check_none("DEF_VAR $0\nEND\n");
    check_none("END\n$0");
    check("DEF_VAR A\nMESSAGE 歩数%$0\nEND\n", &["A"], &["PTP"]);
    check_none("DEF_VAR A\nMESSAGE 歩数%A% $0\nEND\n");
}

#[test]
fn the_word_that_is_begun_goes() {
    let (document, at) = cursor("DEF_VAR A\nSLEE$0P 10\nEND\n");
    let offer = document.complete(at).swap_remove(0);
    assert_eq!(document.source().slice(offer.span), "SLEEP");
}

/// Checks the snippet of a word.
#[track_caller]
fn check_snippet(robot: Robot, word: &str, expected: Option<&str>) {
    let (document, at) = on(robot, "$0\nEND\n");
    let offers = document.complete(at);
    let offer = offers.iter().find(|offer| offer.label == word);
    let offer = offer.expect("it is offered");
    assert_eq!(offer.snippet.as_deref(), expected, "{word}");
}

#[test]
fn commands_are_snippets_with_their_arguments() {
    check_snippet(
        Robot::Titan8,
        "PTP",
        Some("PTP ${1:F1} ${2:x} ${3:y} ${4:z}"),
    );
    check_snippet(Robot::Titan8, "SLEEP", Some("SLEEP ${1:number}"));
    check_snippet(
        Robot::Titan8,
        "WAIT_INPOS",
        Some("WAIT_INPOS ${1|F1,J11,ALL|}"),
    );
    check_snippet(Robot::Titan8, "FLUSH_BUF", None);
    let block = "FOR ${1:VAR} = ${2:1} TO ${3:10}\n\t$0\nNEXT";
    check_snippet(Robot::Titan8, "FOR", Some(block));
    check_snippet(
        Robot::Titan8,
        "IF",
        Some("IF ${1:condition} THEN\n\t$0\nENDIF"),
    );
    check_snippet(Robot::Titan8, "END", None);
}

/// The form that fits, and the argument in it.
#[track_caller]
fn check_signature(statements: &str, expected: Option<(&str, &str)>) {
    let (document, at) = cursor(statements);
    let found = document.signatures(at);
    let found = found.as_ref().map(|found| {
        let form = &found.forms[found.form];
        let argument = form.arguments.get(found.argument);
        let argument = argument.map_or("", |span| &form.text[span.start..span.end]);
        (form.text.as_str(), argument)
    });
    assert_eq!(found, expected, "{statements}");
}

#[test]
fn the_signature_follows_the_cursor() {
    let ptp = "PTP [HS] F1 [R] x [R] y [R] z";
    check_signature("PTP $0\nEND\n", Some((ptp, "[HS] F1")));
    check_signature("PTP HS F1 R 1$0\nEND\n", Some((ptp, "[R] x")));
    check_signature("PTP F1 1 2 $0\nEND\n", Some((ptp, "[R] z")));
    check_signature("SLEEP 1; PTP F1 $0\nEND\n", Some((ptp, "[R] x")));
    check_signature("DEF_VAR A\nA = ATAN2 1 $0\nEND\n", Some(("ATAN2 y x", "x")));
    check_signature("PT$0P F1\nEND\n", None);
    check_signature("PTP F1; $0\nEND\n", None);
    check_signature("SLEEP 1 // $0\nEND\n", None);
    check_signature("$0\nEND\n", None);
}
