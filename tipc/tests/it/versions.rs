//! Differences between versions: what 3.1 refuses of its predecessors and of its announced successor, and fixes for
//! both.

use tipc::code::Code;
use tipc::language::Edition;
use tipc::message::Lang;
use tipc::program::VariableKind;
use tipc::{Loaded, Options, Robot};

fn load(robot: Robot, version: &str, statements: &str) -> Loaded {
    let text = format!("{version}\ntitle\n{statements}\nEND\n");
    let options = Options {
        robot,
        ..Options::default()
    };
    tipc::load("test.prg", text.as_bytes(), &options)
}

/// Returns the errors of one statement after declarations of N, P and Q.
fn errors(robot: Robot, statement: &str) -> Vec<Code> {
    let declared = "DEF_VAR N\nDEF_POS P\nDEF_JOINT Q\nN = 1\nP.X = N\nQ.J1 = N\nMESSAGE %N%\n";
    let loaded = load(robot, "3.1", &format!("{declared}{statement}"));
    let errors = loaded.diagnostics.iter().map(|found| found.code);
    errors.filter(|code| code.kind().is_some()).collect()
}

// clauses: 10.1 1.3
#[test]
fn a_program_of_an_older_version_is_refused_by_its_first_line() {
    for version in ["1.0", "2.0", "2.1", "3.0", "4.0"] {
        let loaded = load(Robot::Titan8, version, "VAR01 = 1");
        let codes: Vec<_> = loaded.diagnostics.iter().map(|found| found.code).collect();
        assert_eq!(codes, [Code::Version], "{version}");
    }
}

// clauses: 1.3
#[test]
fn line_1_chooses_the_edition_and_a_number_of_none_is_read_by_the_rules_of_3_1() {
    for (version, tip_version) in [
        ("3.1", None),
        ("3.1", Some(3.1)),
        ("3.10", Some(3.1)),
        ("2.0", Some(2.0)),
        ("9", Some(9.0)),
    ] {
        let text = format!("{version}\ntitle\nDEF_VAR N\nN = SQRT 4\nSLEEP N\nEND\n");
        let options = Options {
            tip_version,
            ..Options::default()
        };
        let loaded = tipc::load("test.prg", text.as_bytes(), &options);
        assert_eq!(loaded.diagnostics, [], "{version}");
        let program = loaded.program.expect("a sound program");
        assert_eq!(program.edition(), Edition::V3_1, "{version}");
        assert_eq!(loaded.module.edition, Edition::V3_1, "{version}");
    }
}

// clauses: 12.1
#[test]
fn line_1_chooses_3_2_unless_another_version_is_demanded() {
    let found = |version: &str, tip_version: Option<f64>| {
        let text = format!("{version} // the next edition\ntitle\nDIRECT ALL\nEND\n");
        let options = Options {
            tip_version,
            ..Options::default()
        };
        let loaded = tipc::load("test.prg", text.as_bytes(), &options);
        let codes = loaded.diagnostics.iter().map(|found| found.code);
        (codes.collect::<Vec<_>>(), loaded.module.edition)
    };
    assert_eq!(found("3.2", None), (vec![], Edition::V3_2));
    assert_eq!(found("3.20", Some(3.2)), (vec![], Edition::V3_2));
    assert_eq!(
        found("3.1", None),
        (vec![Code::UnknownCommand], Edition::V3_1)
    );
    assert_eq!(
        found("9", Some(9.0)),
        (vec![Code::UnknownCommand], Edition::V3_1)
    );
    for (version, demanded) in [
        ("3.2", Some(3.1)),
        ("3.1", Some(3.2)),
        ("3.3", None),
        ("3", None),
    ] {
        assert_eq!(found(version, demanded).0, [Code::Version], "{version}");
    }
}

// clauses: 10.1
#[test]
fn older_statements_are_errors_and_their_successors_are_not() {
    let titan = Robot::Titan8;
    for (older, code, newer) in [
        ("VAR01 = 1", Code::UnknownVariable, "N = 1"),
        ("A_MAX ALL 500", Code::UnknownCommand, "SET_A_MAX ALL 500"),
        (
            "SET_INPOS ALL 5",
            Code::UnknownCommand,
            "SET_JUST_POSITION ALL 5",
        ),
        (
            "SET_NEAR ALL 5",
            Code::UnknownCommand,
            "SET_NEAR_POSITION ALL 5",
        ),
        ("WAIT_NEAR F1 5", Code::Argument, "WAIT_NEAR F1"),
        ("N = - N", Code::Equation, "N = -N"),
    ] {
        assert_eq!(errors(titan, older), [code], "{older}");
        assert_eq!(errors(titan, newer), [], "{newer}");
    }
    let hand = Robot::Hand;
    assert_eq!(errors(hand, "COMPLIANCE J11 5"), [Code::UnknownCommand]);
    assert_eq!(errors(hand, "COMPLIANCE_ANGLE J11 5"), []);
    assert!(!errors(titan, "FOR N 1 TO 3\nNEXT").is_empty());
    assert_eq!(errors(titan, "FOR N = 1 TO 3\nNEXT"), []);
}

// clauses: 11.1
#[test]
fn what_the_next_version_announces_is_not_there_yet() {
    for statement in [
        "DIRECT ALL",
        "TRAJECTORY ALL",
        "TIP_SPEED_UP 2",
        "F_MESSAGE text",
        "LOCK F1",
        "UNLOCK F1",
        "DEFINE TEN 10",
        "START_TIMER",
        "STOP_TIMER",
    ] {
        assert_eq!(
            errors(Robot::Titan8, statement),
            [Code::UnknownCommand],
            "{statement}"
        );
    }
    assert!(!errors(Robot::Titan8, "N = @TIMER1").is_empty());
    assert!(!errors(Robot::Titan8, "P = @POS_F1").is_empty());
    assert_eq!(
        errors(Robot::Titan8, "N = VAR_SPECIAL_1"),
        [Code::UnknownVariable]
    );
    assert_eq!(
        errors(Robot::Hand, "SET_POSITION_STIFFNESS F1 P"),
        [Code::Argument]
    );
    assert_eq!(errors(Robot::Hand, "SET_POSITION_STIFFNESS F1 1 1 1"), []);
}

// clauses: 7.46
#[test]
fn detect_object_is_for_the_hand_and_warns_of_its_missing_ways() {
    for way in ["1", "2", "3", "N"] {
        assert_eq!(
            errors(Robot::Hand, &format!("DETECT_OBJECT {way}")),
            [],
            "{way}"
        );
    }
    for robot in [Robot::Titan8, Robot::Generic] {
        assert_eq!(errors(robot, "DETECT_OBJECT 1"), [Code::UnknownCommand]);
    }
    for wrong in ["DETECT_OBJECT", "DETECT_OBJECT 1 2", "DETECT_OBJECT P.X"] {
        assert_eq!(errors(Robot::Hand, wrong), [Code::Argument], "{wrong}");
    }
    // It takes no target: F1 stands where its operand belongs.
    assert_eq!(
        errors(Robot::Hand, "DETECT_OBJECT F1 1"),
        [Code::UnknownVariable]
    );
    for (way, warned) in [("3", false), ("3.9", false), ("4", true), ("0", true)] {
        let loaded = load(Robot::Hand, "3.1", &format!("DETECT_OBJECT {way}"));
        let warns = loaded
            .diagnostics
            .iter()
            .any(|found| found.code == Code::OutOfRange);
        assert_eq!(warns, warned, "{way}");
        assert!(loaded.program.is_some(), "{way}");
    }
}

// clauses: 9.4 3.3
#[test]
fn variables_keep_their_place_of_declaration_and_var_key_is_the_first() {
    let statements = "DEF_VAR B\nDEF_POS P\nDEF_VAR C\nDEF_JOINT Q\nDEF_POS R2";
    let program = load(Robot::Titan8, "3.1", statements)
        .program
        .expect("it loads");
    let of = |kind| {
        let variables = program.variables().iter();
        let names = variables.filter(|variable| variable.kind == kind);
        names
            .map(|variable| variable.name.clone())
            .collect::<Vec<_>>()
    };
    assert_eq!(of(VariableKind::Var), ["VAR_KEY", "B", "C"]);
    assert_eq!(of(VariableKind::Pos), ["P", "R2"]);
    assert_eq!(of(VariableKind::Joint), ["Q"]);
}

#[test]
fn a_wrong_version_is_told_which_numbers_are_right() {
    let reported = |version: &str, tip_version: Option<f64>, lang: Lang| {
        let options = Options {
            tip_version,
            ..Options::default()
        };
        let loaded = tipc::load(
            "test.prg",
            format!("{version}\nx\nEND\n").as_bytes(),
            &options,
        );
        loaded.diagnostics[0].headline(lang)
    };
    let english = |wanted: &str| format!("line 1 must name version {wanted} of the language");
    assert_eq!(reported("3.3", None, Lang::English), english("3.1 or 3.2"));
    assert_eq!(reported("3.3", Some(3.2), Lang::English), english("3.2"));
    assert_eq!(reported("3.3", Some(9.0), Lang::English), english("9.0"));
    assert_eq!(
        reported("3.3", None, Lang::Japanese),
        "1行目には言語のバージョン3.1か3.2を書きます"
    );
}
