//! Text of diagnostics: the locations that a mistake points at, the reason and the help.

use tipc::diagnostic::Diagnostic;
use tipc::message::Message;
use tipc::{Loaded, Options, Robot, load};

fn check(statements: &str, robot: Robot) -> Loaded {
    let text = format!("3.1\nreasons\n{statements}\nEND\n");
    let options = Options {
        robot,
        ..Options::default()
    };
    load("reasons.prg", text.as_bytes(), &options)
}

/// Returns the only diagnostic.
fn only(loaded: &Loaded) -> &Diagnostic {
    match loaded.diagnostics.as_slice() {
        [only] => only,
        found => panic!("{found:#?}"),
    }
}

/// Returns the lines that a diagnostic points at: its own, then its labels'.
fn lines(loaded: &Loaded) -> Vec<u32> {
    let diagnostic = only(loaded);
    let labels = diagnostic.labels.iter().map(|label| label.span);
    [diagnostic.span]
        .into_iter()
        .chain(labels)
        .map(|span| loaded.source.line_column(span.start).0)
        .collect()
}

fn help(statements: &str, robot: Robot) -> String {
    let loaded = check(statements, robot);
    let help = only(&loaded).help.as_ref();
    help.map(Message::to_string).unwrap_or_default()
}

// clauses: 6.5
#[test]
fn broken_blocks_are_shown_with_both_ends() {
    let shown = |statements| lines(&check(statements, Robot::Titan8));
    assert_eq!(shown("WHILE KB_HIT\nREM"), [3, 5]);
    assert_eq!(
        shown("IF KB_HIT THEN\nWHILE KB_HIT\nENDIF\nWEND"),
        [4, 5, 6]
    );
    assert_eq!(
        shown("IF KB_HIT THEN\nREPEAT\nELSE\nUNTIL KB_HIT\nENDIF"),
        [4, 5, 6]
    );
    assert_eq!(shown("IF KB_HIT THEN\nELSE\nELSE\nENDIF"), [5, 4]);
    assert_eq!(shown("IF KB_HIT THEN\nWEND\nENDIF"), [4, 3]);
    assert_eq!(shown("DEF_VAR I J\nJ = 1\nFOR I = J TO 3\nNEXT J"), [6, 5]);
    assert_eq!(
        shown("EXIT\nSUBROUTINE A:\nEXIT\nSUBROUTINE B:\nSUBEND\nSUBEND"),
        [6, 4]
    );
    assert_eq!(
        shown("EXIT\nSUBROUTINE A:\nEXIT\nSUBROUTINE B:\nSUBEND"),
        [4, 6, 8]
    );
}

// clauses: 6.5
#[test]
fn an_open_block_is_told_with_the_words_that_make_it() {
    for (opens, opener, closer) in [
        ("IF KB_HIT THEN", "IF", "ENDIF"),
        ("WHILE KB_HIT", "WHILE", "WEND"),
        ("REPEAT", "REPEAT", "UNTIL"),
        ("FOR VAR_KEY = 1 TO 2", "FOR", "NEXT"),
        ("EXIT\nSUBROUTINE S:", "SUBROUTINE", "SUBEND"),
    ] {
        let loaded = check(opens, Robot::Titan8);
        let fault = only(&loaded);
        assert_eq!(
            fault.reason.to_string(),
            format!("this {opener} is not closed")
        );
        let help = format!("close it with {closer}");
        assert_eq!(fault.help.as_ref().map(Message::to_string), Some(help));
    }
}

// clauses: 6.4 6.5
#[test]
fn forbidden_jumps_show_the_block_and_the_label() {
    let shown = |statements| lines(&check(statements, Robot::Titan8));
    assert_eq!(shown("GOTO L1:\nWHILE KB_HIT\nL1:\nWEND"), [3, 4, 5]);
    assert_eq!(
        shown("IF KB_HIT THEN\nELSE\nL1:\nENDIF\nGOTO L1:"),
        [7, 4, 5]
    );
    assert_eq!(
        shown("L1:\nEXIT\nSUBROUTINE S:\nGOTO L1:\nSUBEND"),
        [6, 5, 3]
    );
    assert_eq!(shown("GOTO S:\nSUBROUTINE S:\nSUBEND"), [3, 4]);
    assert_eq!(
        shown("DEF_VAR I\nI = 1\nGOTO L1:\nFOR I = 1 TO 2\nL1:\nNEXT"),
        [5, 6, 7]
    );
}

// clauses: 3.1 6.1 6.6
#[test]
fn second_declarations_show_the_first() {
    let shown = |statements| lines(&check(statements, Robot::Titan8));
    assert_eq!(shown("L1:\nREM\nL1:"), [5, 3]);
    assert_eq!(shown("DEF_VAR N\nN = 1\nSLEEP N\nDEF_POS N"), [6, 3]);
    assert_eq!(shown("CALL L1:\nL1:"), [3, 4]);
    assert_eq!(shown("DEF_VAR N\nSLEEP N"), [4, 3]);
}

// clauses: 8.1 7.1
#[test]
fn what_a_robot_lacks_is_told_with_its_name() {
    let force = check("FORCE F1 1 2 3", Robot::Titan8);
    assert!(only(&force).reason.to_string().contains("titan8"));
    assert_eq!(
        help("FORCE F1 1 2 3", Robot::Titan8),
        "FORCE is a command of hand and generic, which `--robot` or tip.toml chooses"
    );
    let leg = check("WAIT_INPOS F4", Robot::Hand);
    assert!(only(&leg).reason.to_string().contains("hand has no F4"));
    assert!(help("WAIT_INPOS F4", Robot::Hand).contains("F1…F3, J11…J33, FLOOR"));
    assert!(help("WAIT_INPOS F5", Robot::Generic).contains("generic has F1…F4, J11…J43"));
    assert!(help("DEF_VAR N\nN = 1\nAD_IN PAW1 N", Robot::Hand).contains("VR1…VR3"));
    assert!(help("SET_SAMPLING_TIME 500", Robot::Hand).contains("1 to 100 on hand"));
}

// clauses: 7.16
#[test]
fn a_tolerance_of_version_two_is_sent_where_it_belongs_now() {
    let reason = |statement| only(&check(statement, Robot::Titan8)).reason.to_string();
    assert!(reason("WAIT_NEAR F1 5").contains("SET_NEAR_POSITION"));
    assert!(reason("WAIT_INPOS F1 5").contains("one argument too many for WAIT_INPOS"));
}

// clauses: 4.9
#[test]
fn constants_without_a_result_are_told_what_would_have_one() {
    let help = |right| {
        help(
            &format!("DEF_VAR N\nN = 1\nN = N * 2\nN = {right}"),
            Robot::Titan8,
        )
    };
    assert_eq!(help("N / 0"), "divide by another number");
    assert_eq!(help("SQRT -1"), "SQRT takes 0 or more");
    assert_eq!(help("ASIN 2"), "ASIN takes -1 to 1");
    assert!(help("ATAN 2").contains("`ATAN2 y x` takes any ratio"));
    assert!(help("ATAN2 0 0").contains("another number than 0"));
    assert!(help("N\nFOR N = 1 TO 2 STEP 0\nNEXT").contains("leave STEP out"));
}

// clauses: 8.1
#[test]
fn misspelt_words_are_recognized() {
    let titan = |statements| help(statements, Robot::Titan8);
    assert_eq!(titan("WAIT_INPSO ALL"), "did you mean `WAIT_INPOS`?");
    assert_eq!(titan("A_MAX ALL 500"), "this language calls it `SET_A_MAX`");
    assert_eq!(
        titan("SET_INPOS F1 2"),
        "this language calls it `SET_JUST_POSITION`"
    );
    assert_eq!(titan("START:\nGOTO SATRT:"), "did you mean `START:`?");
    assert_eq!(
        titan("DEF_VAR SPEED\nSPEED = 1\nSLEEP SPEED\nSLEEP SPED"),
        "did you mean `SPEED`?"
    );
    assert_eq!(
        titan("IF HALT_REQEST GOTO L:\nL:"),
        "did you mean `HALT_REQUEST`?"
    );
    assert!(titan("DEF_VAR N\nN = 1\nSLEEP N\nIF N GOTO L:\nL:").contains("N <> 0"));
    assert!(titan("DEF_VAR N\nN = 1\nSLEEP N\nN 5").contains("N = 0"));
}

// clauses: 7.1
#[test]
fn missing_and_wrong_operands_are_named() {
    let reason = |statements| only(&check(statements, Robot::Titan8)).reason.to_string();
    assert_eq!(
        reason("PTP F1 1 2"),
        "PTP wants 3 numbers or a POS; there are 2 here"
    );
    assert_eq!(
        reason("SLEEP"),
        "SLEEP wants one number; there is none here"
    );
    assert_eq!(
        reason("PTP_ANGLE J11"),
        "PTP_ANGLE wants one number; there is none here"
    );
    assert_eq!(
        reason("PTP_ANGLE F1 1"),
        "PTP_ANGLE wants 3 numbers or a JOINT; there is one here"
    );
    assert_eq!(reason("SET_A_MAX"), "SET_A_MAX wants a target, as F1, ALL");
    assert_eq!(
        reason("DEF_VAR N\nKEY_IN N\nSLEEP N\nAD_IN N VAR_KEY"),
        "a constant belongs here"
    );
    assert_eq!(reason("SET_A_MAX 5"), "a target belongs here, as F1, ALL");
    let refused = "PTP is for feet; for a joint write PTP_ANGLE";
    assert_eq!(reason("PTP J13 1 2 3"), refused);
    let wrong = "DEF_JOINT Q\nTEACH_ANGLE F1 Q\nPTP F1 Q";
    assert_eq!(
        reason(wrong),
        "PTP wants 3 numbers or a POS here, not a JOINT"
    );
}

// clauses: 4.4 4.5 4.6 4.7 4.8 4.9
#[test]
fn a_function_with_other_operands_shows_how_it_is_written() {
    let reported = |right: &str| {
        let loaded = check(&format!("VAR_KEY = {right}"), Robot::Titan8);
        let fault = only(&loaded);
        let help = fault.help.as_ref().map(Message::to_string);
        (fault.reason.to_string(), help.unwrap_or_default())
    };
    for (right, reason, help) in [
        (
            "SIN",
            "SIN takes one operand, not 0",
            "write `A = SIN a`, a a number",
        ),
        (
            "ATAN2 1",
            "ATAN2 takes two operands, not 1",
            "write `A = ATAN2 y x`",
        ),
        (
            "NORM",
            "NORM takes one operand, not 0",
            "write `A = NORM P`, P a POS or JOINT",
        ),
        (
            "UNIT_VECT 1 2",
            "UNIT_VECT takes one operand, not 2",
            "write `P = UNIT_VECT P`",
        ),
        (
            "ROT_Y 1",
            "ROT_Y takes two operands, not 1",
            "write `P = ROT_Y P angle`",
        ),
    ] {
        assert_eq!(
            reported(right),
            (reason.to_owned(), help.to_owned()),
            "{right}"
        );
    }
}

// clauses: 4.9
#[test]
fn mixed_types_are_named_and_the_odd_one_is_pointed_at() {
    let reported = |equation: &str| {
        let text = format!("DEF_POS P\nTEACH_POSITION F1 P\n{equation}");
        let loaded = check(&text, Robot::Titan8);
        let fault = only(&loaded);
        let place = loaded.source.slice(fault.span).to_owned();
        (place, fault.reason.to_string())
    };
    for (equation, place, reason) in [
        ("P = P * 2", "2", "a POS and a number do not go together"),
        (
            "P = 2 * P",
            "2 * P",
            "a number and a POS do not go together",
        ),
        ("P.X = 2 * P", "P", "a number and a POS do not go together"),
        (
            "P = 2",
            "2",
            "the left side is a POS, the right side a number",
        ),
        (
            "P = NORM P",
            "NORM P",
            "the left side is a POS, the right side a number",
        ),
        (
            "VAR_KEY = P",
            "P",
            "the left side is a number, the right side a POS",
        ),
    ] {
        assert_eq!(
            reported(equation),
            (place.to_owned(), reason.to_owned()),
            "{equation}"
        );
    }
}

// clauses: 3.2
#[test]
fn a_name_without_a_value_is_told_why() {
    let titan = |statements| help(statements, Robot::Titan8);
    assert_eq!(
        titan("SLEEP KB_HIT"),
        "an event flag stands alone: `IF KB_HIT GOTO L1:`, or `!KB_HIT`"
    );
    assert_eq!(titan("SLEEP TIME"), "declare it: `DEF_VAR TIME`");
}

// clauses: 5.1
#[test]
fn flags_of_another_robot_are_not_suggested() {
    let titan = help("IF ANTENNA_ON GOTO L:\nL:", Robot::Titan8);
    assert!(
        titan.starts_with("flags are HALT_REQUEST, KB_HIT"),
        "{titan}"
    );
    assert!(!titan.contains("ANTENNA_ON"), "{titan}");
    let hand = help("IF GRIP GOTO L:\nL:", Robot::Hand);
    assert!(hand.contains("SPECIAL_FLAG0…9, ANTENNA_ON"), "{hand}");
}

// clauses: 7.47
#[test]
fn a_value_in_a_message_is_pointed_at() {
    let loaded = check("DEF_VAR N\nMESSAGE at %N% now\nREM", Robot::Titan8);
    assert_eq!(loaded.source.slice(only(&loaded).span), "%N%");
}

// clauses: 7.1 8.1
#[test]
fn the_usage_is_that_of_the_robot() {
    let short = "PTP F1 1 2";
    let titan = "write `PTP [HS] F1 [R] x [R] y [R] z`, or `PTP [HS] F1 [R] POS`";
    assert_eq!(help(short, Robot::Titan8), titan);
    let hand =
        "write `PTP [HS] F1|J13|FLOOR [R] x [R] y [R] z`, or `PTP [HS] F1|J13|FLOOR [R] POS`";
    assert_eq!(help(short, Robot::Hand), hand);
    assert_eq!(
        help("SET_A_MAX F1", Robot::Titan8),
        "write `SET_A_MAX F1|ALL number`"
    );
    assert_eq!(
        help("ALL_STOP ALL", Robot::Titan8),
        "ALL_STOP takes no target"
    );
}

// clauses: 8.1
#[test]
fn every_error_says_a_way_out() {
    let broken = [
        "SLEEP",
        "PTP F1 1 2",
        "PTP F1 1 2 3 4",
        "WAIT_INPOS F9",
        "TEACH_ANGLE F1",
        "AD_IN VR9 VAR_KEY",
        "AD_IN 0 16 VAR_KEY",
        "AD_IN 1 1 VAR_KEY",
        "SPECIAL 256",
        "SPECIAL",
        "SLEEP N",
        "N = 1",
        "CHAR_A = 1",
        "VAR_KEY = SIN",
        "VAR_KEY = SIN 1 2",
        "GOTO L1:",
        "GOSUB LOOP:",
        "GOTO",
        "ENDIF",
        "WHILE KB_HIT",
        "FOO",
        "IF FOO THEN\nENDIF",
        "KEY_IN 1",
        "DEF_VAR 1",
        "DEF_VAR",
        "DEF_VAR SIN",
        "SIN:",
        "REL_PTP F1 R 1 1 1",
        "PTP F1 R R 1 1 1",
        "FOR CHAR_A = 1 TO 2\nNEXT",
        "GOTO L1:\nWHILE KB_HIT\nL1:\nWEND",
        "DEF_POS P\nP = 1",
        "DEF_POS P\nP.X = 1\nP = -P",
        "DEF_POS P\nP.X = 1\nSLEEP P.X",
        "TEACH_ANGLE F1 VAR_KEY",
        "KEY_IN\nVAR_KEY = NORM VAR_KEY",
        "FORCE F1 1 1 1",
    ];
    let mut silent = Vec::new();
    for statements in broken {
        let loaded = check(statements, Robot::Titan8);
        assert!(loaded.program.is_none(), "{statements}");
        let lacking = loaded.diagnostics.iter().filter(|one| one.help.is_none());
        silent.extend(lacking.map(|one| format!("{statements}: {}", one.reason)));
    }
    assert!(silent.is_empty(), "{silent:#?}");
}
