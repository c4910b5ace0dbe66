//! Questions about what the text does not decide; nothing is written.

use super::{migrated, question, result};

fn about(statements: &str) -> (u32, String) {
    question(&format!("2.1\ntitle\n{statements}\nEND\n"))
}

// clauses: 10.1
#[test]
fn an_unknown_version() {
    for version in ["5.0", "0.9", "3.2", "4.1"] {
        let (line, text) = question(&format!("{version}\nt\nEND\n"));
        assert_eq!(line, 1);
        assert!(text.contains(version) && text.ends_with('?'), "{text}");
    }
    for version in ["", "T.I.P.", "2.0 walk"] {
        let (line, text) = question(&format!("{version}\nt\nEND\n"));
        assert_eq!(line, 1);
        assert!(text.contains("no version"), "{text}");
    }
}

// clauses: 10.1
#[test]
fn a_tolerance_of_a_target_moved_in_both_ways() {
    let moves = "PTP F1 1 2 3\nPTP_ANGLE F1 1 2 3\n";
    let (line, text) = about(&format!("{moves}WAIT_NEAR F1 5"));
    assert_eq!(line, 5);
    assert!(
        text.contains("SET_NEAR_POSITION") && text.contains("SET_NEAR_ANGLE"),
        "{text}"
    );
    assert_eq!(about(&format!("{moves}WAIT_NEAR ALL 5")).0, 5);
    // The initial posture is one of positions.
    let moves_all = "PTP_ANGLE F1 1 2 3\nINITIAL_POSTURE\n";
    assert_eq!(about(&format!("{moves_all}WAIT_NEAR ALL 5")).0, 5);
    // F2 is not moved at all.
    let decided = format!("2.1\nt\n{moves}WAIT_NEAR F2 5\nEND\n");
    assert!(result(&decided).contains("SET_NEAR_POSITION F2 5 ; WAIT_NEAR F2"));
}

// clauses: 10.1 7.21
#[test]
fn a_tolerance_in_mm_for_a_joint() {
    let (line, text) = about("PTP J13 1 2 3\nWAIT_NEAR J13 5");
    assert_eq!(line, 4);
    assert!(text.contains("SET_NEAR_POSITION F1"), "{text}");
    // Other joints turn.
    let decided = "2.1\nt\nPTP J13 1 2 3\nWAIT_NEAR J23 5\nEND\n";
    assert!(result(decided).contains("SET_NEAR_ANGLE J23 5 ; WAIT_NEAR J23"));
}

// clauses: 10.1
#[test]
fn a_tolerance_that_is_no_single_number() {
    assert_eq!(about("WAIT_NEAR F1 5 6").0, 3);
    assert_eq!(about("WAIT_NEAR F1 -VAR1").0, 3);
}

// clauses: 10.1
#[test]
fn tolerances_of_joints() {
    let (line, text) = about("SET_INPOS J11 5");
    assert_eq!(line, 3);
    assert!(text.contains("SET_JUST_ANGLE"), "{text}");
    assert!(about("SET_NEAR J11 5").1.contains("SET_NEAR_ANGLE"));
}

// clauses: 10.1
#[test]
fn compliance_with_more_than_angles() {
    let (line, text) = about("\nCOMPLIANCE F1 1 2 3 0.5");
    assert_eq!(line, 4);
    assert!(text.contains("stiffness"), "{text}");
    assert_eq!(about("COMPLIANCE J11 1 2").0, 3);
}

// clauses: 10.1
#[test]
fn variables_without_a_number() {
    let (line, text) = about("VAR1 = 1\nVAR1 = AGL.J1");
    assert_eq!(line, 4);
    assert!(text.starts_with("AGL has no number"), "{text}");
}

// clauses: 10.1 1.10
#[test]
fn a_semicolon_in_a_message() {
    let (line, text) = about("MESSAGE stop; wait");
    assert_eq!(line, 3);
    assert!(text.contains("`;`"), "{text}");
    // In a comment it is harmless.
    assert!(result("2.0\nt\nMESSAGE stop // ; wait\nEND\n").contains("stop // ; wait"));
}

// clauses: 10.1 7.47
#[test]
fn text_that_would_show_a_value_today() {
    let (line, text) = about("VAR1 = 1\nMESSAGE %VAR1%");
    assert_eq!(line, 4);
    assert!(text.contains("%VAR1%"), "{text}");
    assert!(result("2.0\nt\nVAR1 = 1\nMESSAGE %VAR2%, 50%\nEND\n").contains("%VAR2%, 50%"));
}

// clauses: 10.1 3.2
#[test]
fn variables_of_3_0_that_became_words() {
    let (line, text) = question("3.0\nt\nDEF_VAR A, FLOOR\nA = 1\nEND\n");
    assert_eq!(line, 3);
    assert!(text.starts_with("FLOOR"), "{text}");
    // R, A and HS are words inside motion arguments only.
    assert!(result("3.0\nt\nDEF_VAR A, HS\nA = 1\nEND\n").contains("DEF_VAR A, HS"));
}

// clauses: 10.1
#[test]
fn what_no_rule_knows() {
    let (line, text) = about("VAR1 = 1\nJUMP F1");
    assert_eq!(line, 4);
    assert!(text.starts_with("JUMP is not a command"), "{text}");
    assert_eq!(about("A_MAX_FIRMLY ALL").0, 3);
    assert_eq!(about("VAR1 = VAR2 + VAR3 + VAR4").0, 3);
    assert_eq!(about("IF VAR1 THEN_GO L1:").0, 3);
    let (line, text) = question("2.0\nt\nVAR1 = 1\n");
    assert_eq!(line, 3);
    assert!(text.contains("no END"), "{text}");
}

// clauses: 10.1 7.18 7.45
#[test]
fn a_command_with_arguments_of_no_version() {
    for (line, wanted) in [
        ("TEACH_ANGLE J11 AGL01", "a VAR or a member of a JOINT"),
        ("TEACH_TORQUE J11 TRQ01", "a VAR or a member of a JOINT"),
        // The generic robot has no such command at all.
        ("DETECT_FLOOR 1", "target"),
        ("STAND_UP", "STAND_UP wants"),
    ] {
        let (at, text) = about(&format!("SLEEP 1\n{line}"));
        assert_eq!(at, 4, "{line}");
        assert!(text.contains(wanted) && text.ends_with('?'), "{text}");
    }
    // Each of these is a command of some robot.
    let each = "2.1\nt\nTEACH_ANGLE F1 AGL01\nTEACH_TORQUE F1 TRQ1\nPTP J13 1 2 3\nSTAND_UP 50\nDETECT_OBJECT 1\nEND\n";
    assert!(result(each).contains("DETECT_OBJECT 1"));
}

// clauses: 1.2 10.1
#[test]
fn a_number_too_long_for_a_name_that_is_declared() {
    let [fits, too_long] = [29, 30].map(|digits| "1".repeat(digits));
    assert_eq!(format!("VAR{fits}").len(), 32);
    for version in ["2.0\nt\n", "1.0\n"] {
        let asked = |lines: &str| question(&format!("{version}{lines}\nEND\n"));
        let first = version.lines().count() as u32 + 1;
        let used_twice = format!("VAR2 = 1\nVAR{too_long} = 1\nvar{too_long} = 1");
        let (line, text) = asked(&used_twice);
        assert_eq!(line, first + 1);
        assert!(text.contains("32 bytes") && text.contains("33"), "{text}");
        let (line, text) = asked(&format!("SLEEP 1\nMESSAGE at %f{too_long}%"));
        assert_eq!(line, first + 1);
        assert!(text.contains(&format!("VAR{too_long} has 33")), "{text}");
        let decided = result(&format!("{version}VAR{fits} = 1\nEND\n"));
        assert!(
            decided.contains(&format!("DEF_VAR VAR{fits}\n")),
            "{decided}"
        );
    }
}

// clauses: 10.1
#[test]
fn all_questions_are_asked_at_once() {
    let migration = migrated("2.0\nt\nJUMP F1\nMESSAGE a;b\nVAR1 = VAR\nEND\n");
    let lines: Vec<u32> = migration.questions().map(|note| note.line).collect();
    assert_eq!(lines, [3, 4, 5]);
    assert_eq!(migration.bytes(), None);
}
