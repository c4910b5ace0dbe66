//! Each rule, and what it must leave alone.

use super::{check_lines, line_of, migrated, result};

// clauses: 10.1 1.3
#[test]
fn the_header_becomes_3_1() {
    for version in ["1.0", "1.1", "2.0", "2.1", "3.0", "4.0", "2", " 2.0\t"] {
        let new = result(&format!("{version}\ntitle\nEND\n"));
        assert_eq!(
            new.trim_start(),
            format!("3.1{}\ntitle\nEND\n", blanks(version))
        );
    }
    assert_eq!(
        result("2.0 // for the fair\nt\nEND\n"),
        "3.1 // for the fair\nt\nEND\n"
    );
}

fn blanks(version: &str) -> &str {
    &version[version.trim_end().len()..]
}

// clauses: 10.1
#[test]
fn a_program_of_3_1_stays_as_it_is() {
    let text = "3.1\nt\nA_MAX ALL 5\nFOR A 1 TO 2\nREM x\nMESSAGE %f01%\nEND\n";
    assert_eq!(result(text), text);
    assert_eq!(migrated(text).notes(), []);
}

// clauses: 10.1
#[test]
fn a_second_migration_changes_nothing() {
    let text = "1.1\nt\nVAR1 = - VAR01\nT_MAX_SOFT ALL\nREM x\nWAIT_NEAR F1 5\nMESSAGE %d1%\nEND\n";
    let once = result(text);
    assert_ne!(once, text);
    assert_eq!(migrated(&once).notes(), []);
    assert_eq!(result(&once), once);
}

// clauses: 10.1 3.1
#[test]
fn variables_are_declared_by_type_and_number() {
    let text =
        "2.0\nt\nvar10 = VAR2\nPOS03.X = Pos1.Y\nTEACH_ANGLE F1 AGL02\nTRQ01.J1 = AGL02.J2\nEND\n";
    let declared = "DEF_VAR VAR2, VAR10\nDEF_POS POS1, POS03\nDEF_JOINT AGL02, TRQ01\n";
    let statements = &text["2.0\nt\n".len()..];
    assert_eq!(result(text), format!("3.1\nt\n{declared}{statements}"));
}

// clauses: 10.1
#[test]
fn eight_names_are_declared_a_line() {
    let statements: String = (1..=9).map(|n| format!("VAR{n} = 0\n")).collect();
    let new = result(&format!("2.0\nt\n{statements}END\n"));
    let mut lines = new.lines().skip(2);
    let first = "DEF_VAR VAR1, VAR2, VAR3, VAR4, VAR5, VAR6, VAR7, VAR8";
    assert_eq!(lines.next(), Some(first));
    assert_eq!(lines.next(), Some("DEF_VAR VAR9"));
}

// clauses: 10.1
#[test]
fn a_number_is_one_variable_however_it_is_spelt() {
    let new = result("2.0\nt\nVAR01 = 1\nVAR2 = VAR1 + VAR001\nPOS1.X = VAR02\nEND\n");
    let declared = "DEF_VAR VAR01, VAR2\nDEF_POS POS1\n";
    assert_eq!(
        new,
        format!("3.1\nt\n{declared}VAR01 = 1\nVAR2 = VAR01 + VAR01\nPOS1.X = VAR2\nEND\n")
    );
    // Types have numbers of their own, and 10 is not 1.
    let new = result("2.0\nt\nAGL1 = TRQ1\nVAR1 = VAR10\nEND\n");
    assert_eq!(
        new,
        "3.1\nt\nDEF_VAR VAR1, VAR10\nDEF_JOINT AGL1, TRQ1\nAGL1 = TRQ1\nVAR1 = VAR10\nEND\n"
    );
}

// clauses: 10.1
#[test]
fn what_is_no_variable_is_not_declared() {
    // Comments, texts, labels and jumps to them, inputs, and names with more than a number after the type.
    let text = "2.0\nt\n// VAR1\nVAR2: // POS1\nGOTO VAR2:\nMESSAGE VAR3\nAD_IN VR1 VAR4\nREM VAR5\nEND\nVAR6 = 1\n";
    let new = result(text);
    assert_eq!(new.lines().nth(2), Some("DEF_VAR VAR4"));
    assert_eq!(new.matches("DEF_").count(), 1, "{new}");
}

// clauses: 10.1
#[test]
fn declared_programs_of_3_0_get_no_declarations() {
    let text = "3.0\nt\nDEF_VAR A\nA = 1\nVAR01 = A\nEND\n";
    assert_eq!(result(text), text.replace("3.0", "3.1"));
    // 4.0 is a style of its own only by its declarations.
    let text = "4.0\nt\nDEF_VAR A\nA = 1\nREM VAR01\nEND\n";
    assert_eq!(result(text), text.replace("4.0", "3.1"));
}

// clauses: 10.1
#[test]
fn parameter_commands_get_set() {
    check_lines(&[
        ("A_MAX ALL 5", "SET_A_MAX ALL 5"),
        ("v_max f1 VAR1", "set_v_max f1 VAR1"),
        ("OMEGA_MAX J11 5", "SET_OMEGA_MAX J11 5"),
        ("OMEGA_DOT_MAX J11 5", "SET_OMEGA_DOT_MAX J11 5"),
        ("T_MAX J11 5", "SET_TORQUE_MAX J11 5"),
        ("SET_T_MAX J11 5", "SET_TORQUE_MAX J11 5"),
        ("A_MAX_RATE ALL 5", "SET_A_MAX_RATE ALL 5"),
        ("V_MAX_SLOW ALL", "SET_V_MAX_SLOW ALL"),
        ("OMEGA_MAX_FAST ALL", "SET_OMEGA_MAX_FAST ALL"),
        ("OMEGA_DOT_MAX_NORMAL ALL", "SET_OMEGA_DOT_MAX_NORMAL ALL"),
        ("T_MAX_RATE ALL 5", "SET_TORQUE_MAX_RATE ALL 5"),
        ("T_MAX_FIRMLY ALL", "SET_TORQUE_MAX_FIRMLY ALL"),
        ("T_MAX_SOFT ALL", "SET_TORQUE_MAX_SOFT ALL"),
        ("T_MAX_NORMAL ALL", "SET_TORQUE_MAX_NORMAL ALL"),
        // Those of 2.0 keep their names.
        ("SET_A_MAX ALL 5", "SET_A_MAX ALL 5"),
        ("SET_TORQUE_MAX_SOFT ALL", "SET_TORQUE_MAX_SOFT ALL"),
        ("SET_JUST_POSITION ALL 5", "SET_JUST_POSITION ALL 5"),
    ]);
    // A variable may have the name where variables are declared.
    let text = "3.0\nt\nDEF_VAR A_MAX\nA_MAX = 1\nEND\n";
    assert_eq!(result(text), text.replace("3.0", "3.1"));
}

// clauses: 10.1
#[test]
fn tolerances_and_compliance_get_their_names() {
    check_lines(&[
        ("SET_INPOS ALL 5", "SET_JUST_POSITION ALL 5"),
        ("set_inpos F1 VAR1", "set_just_position F1 VAR1"),
        ("SET_NEAR F2 5", "SET_NEAR_POSITION F2 5"),
        ("COMPLIANCE F1 R 1 2 VAR1", "COMPLIANCE_ANGLE F1 R 1 2 VAR1"),
        ("COMPLIANCE F1 AGL01", "COMPLIANCE_ANGLE F1 AGL01"),
        ("COMPLIANCE J11 -5", "COMPLIANCE_ANGLE J11 -5"),
        ("NO_COMPLIANCE F1", "NO_COMPLIANCE F1"),
        (
            "COMPLIANCE_POSITION F1 1 2 3",
            "COMPLIANCE_POSITION F1 1 2 3",
        ),
    ]);
    assert_eq!(line_of("3.0", "SET_NEAR ALL 5"), "SET_NEAR_POSITION ALL 5");
}

// clauses: 10.1
#[test]
fn the_tolerance_of_wait_near_is_set_beforehand() {
    check_lines(&[
        (
            "WAIT_NEAR F1 5.0 // close",
            "SET_NEAR_POSITION F1 5.0 ; WAIT_NEAR F1 // close",
        ),
        (
            "wait_near J12 VAR1",
            "set_near_angle J12 VAR1 ; wait_near J12",
        ),
        ("WAIT_NEAR ALL 5", "SET_NEAR_POSITION ALL 5 ; WAIT_NEAR ALL"),
        ("WAIT_NEAR F1", "WAIT_NEAR F1"),
        ("WAIT_INPOS F1", "WAIT_INPOS F1"),
    ]);
}

// clauses: 10.1
#[test]
fn the_tolerance_is_measured_as_the_program_moves_the_target() {
    let near = |motion: &str, wait: &str| {
        let new = result(&format!("2.1\nt\n{motion}\n{wait}\nEND\n"));
        new.lines().nth(3).expect("line 4").to_owned()
    };
    assert_eq!(
        near("PTP_ANGLE F1 1 2 3", "WAIT_NEAR F1 5"),
        "SET_NEAR_ANGLE F1 5 5 5 ; WAIT_NEAR F1"
    );
    assert_eq!(
        near("PTP_ANGLE J11 1", "WAIT_NEAR ALL 5"),
        "SET_NEAR_ANGLE ALL 5 ; WAIT_NEAR ALL"
    );
    // A leg that only turns joints is measured in degrees.
    assert_eq!(
        near("PTP_ANGLE J12 1", "WAIT_NEAR F1 5"),
        "SET_NEAR_ANGLE F1 5 5 5 ; WAIT_NEAR F1"
    );
    // Another leg's motion does not matter.
    assert_eq!(
        near("PTP_ANGLE F2 1 2 3", "WAIT_NEAR F1 5"),
        "SET_NEAR_POSITION F1 5 ; WAIT_NEAR F1"
    );
}

// clauses: 10.1 2.12
#[test]
fn for_gets_its_sign() {
    let of_3_0 = |line: &str| line_of("3.0", line);
    assert_eq!(of_3_0("FOR A B TO C"), "FOR A = B TO C");
    assert_eq!(of_3_0("for A -1 to 5 // up"), "for A = -1 to 5 // up");
    assert_eq!(of_3_0("FOR A = 1 TO 5"), "FOR A = 1 TO 5");
    assert_eq!(of_3_0("FOR A=1 TO 5 STEP 2"), "FOR A=1 TO 5 STEP 2");
    let new = result("4.0\nt\nFOR VAR1 VAR02 TO 5\nNEXT\nEND\n");
    assert_eq!(new.lines().nth(3), Some("FOR VAR1 = VAR02 TO 5"));
}

// clauses: 10.1 3.5
#[test]
fn a_sign_stands_right_before_its_operand() {
    check_lines(&[
        ("VAR1 = - VAR2", "VAR1 = -VAR2"),
        ("VAR1 =-  5.0", "VAR1 =-5.0"),
        ("POS1.X = - POS1.Y // back", "POS1.X = -POS1.Y // back"),
        ("VAR1 = -VAR2", "VAR1 = -VAR2"),
        ("VAR1 = VAR2 - VAR3", "VAR1 = VAR2 - VAR3"),
        ("VAR1 -= 5", "VAR1 -= 5"),
        ("PTP F1 -VAR1 2 3", "PTP F1 -VAR1 2 3"),
    ]);
}

// clauses: 10.1 7.47
#[test]
fn messages_name_their_variables() {
    let message = |text: &str| line_of("2.0", &format!("MESSAGE {text}"));
    assert_eq!(message("at %f01% mm"), "MESSAGE at %VAR01.6% mm");
    assert_eq!(message("%d1%%d002%"), "MESSAGE %VAR1%%VAR002%");
    assert_eq!(
        message("100%, %d1 %, %x1%, %f%"),
        "MESSAGE 100%, %d1 %, %x1%, %f%"
    );
    assert_eq!(message("a %d1% // %d2%"), "MESSAGE a %VAR1% // %d2%");
    // The spelling is that of the statements.
    let new = result("2.0\nt\nMESSAGE %f01%\nVAR1 = 2\nEND\n");
    assert_eq!(
        new,
        "3.1\nt\nDEF_VAR VAR1\nMESSAGE %VAR1.6%\nVAR1 = 2\nEND\n"
    );
    // Since 3.0 this is text.
    assert_eq!(line_of("3.0", "MESSAGE %f01%"), "MESSAGE %f01%");
}

// clauses: 10.1 2.1
#[test]
fn rem_was_no_step() {
    check_lines(&[
        ("REM lift ; then go", "// lift ; then go"),
        ("  rem", "  //"),
        ("L1 : // REM", "L1 : // REM"),
    ]);
    assert_eq!(line_of("3.0", "REM lift"), "REM lift");
}

// clauses: 10.1 3.2
#[test]
fn labels_that_became_words_get_another_name() {
    let new = result("2.0\nt\nNEXT :\nNEXT_1:\nIF KB_HIT GOTO NEXT:\nGOSUB NEXT_1:\nEND\n");
    assert_eq!(
        new,
        "3.1\nt\nNEXT_2 :\nNEXT_1:\nIF KB_HIT GOTO NEXT_2:\nGOSUB NEXT_1:\nEND\n"
    );
    // Small letters stay small; a label declared twice is renamed twice.
    let new = result("2.0\nt\nwend:\nwend:\ngoto wend:\nEND\n");
    assert_eq!(new, "3.1\nt\nwend_1:\nwend_1:\ngoto wend_1:\nEND\n");
    let text = "2.0\nt\nLOOP:\nVR1_ORG :\nGOTO LOOP:\nGOTO VR1_ORG:\nEND\n";
    assert_eq!(result(text), text.replace("2.0", "3.1"));
}

// clauses: 10.1
#[test]
fn version_1_0_had_no_title() {
    assert_eq!(
        result("1.0\nVAR1 = 1\nEND\n"),
        "3.1\n\nDEF_VAR VAR1\nVAR1 = 1\nEND\n"
    );
    assert_eq!(
        result("1.0\nL1:\nGOTO L1:\nEND\n"),
        "3.1\n\nL1:\nGOTO L1:\nEND\n"
    );
    // What is not a statement can only be a title.
    assert_eq!(result("1.0\nslow gait\nEND\n"), "3.1\nslow gait\nEND\n");
    assert_eq!(result("1.0\n\nALL_STOP\nEND\n"), "3.1\n\nALL_STOP\nEND\n");
    // Since 1.1 line 2 is the title whatever it holds.
    assert_eq!(result("1.1\nSTAND_UP\nEND\n"), "3.1\nSTAND_UP\nEND\n");
}

// clauses: 10.1
#[test]
fn every_change_is_reported_with_its_line() {
    let migration = migrated("1.1\nt\n\n  A_MAX ALL 5 // fast\nVAR1 = - 2\nWAIT_NEAR F1 5\nEND\n");
    let changes: Vec<(u32, u32)> = migration
        .changes()
        .map(|note| (note.line, note.column))
        .collect();
    assert_eq!(changes, [(1, 1), (2, 1), (4, 3), (5, 8), (6, 1)]);
    let text: Vec<String> = migration
        .changes()
        .map(|note| note.text.to_string())
        .collect();
    assert_eq!(text[0], "version 1.1 becomes 3.1");
    assert!(text[1].contains("DEF_VAR VAR1"), "{text:#?}");
    assert!(text[2].contains("SET_A_MAX"), "{text:#?}");
    assert!(text[3].contains("-2"), "{text:#?}");
    assert!(text[4].contains("two steps"), "{text:#?}");
}
