//! TIP.OBJ and WARNING.LOG. The expectations follow the memory layouts of T.I.P. 3.1 §5 to §7.

mod forms;
mod names;

use tip_lint::{listing, load};
use tipc::{Options, Robot};

/// Returns the steps of a program in TIP.OBJ, each as `Cmd Target Type=Value …` without empty arguments at its end.
fn records(robot: Robot, statements: &str) -> Vec<String> {
    let text = object(robot, statements);
    let mut records: Vec<Vec<&str>> = Vec::new();
    for line in text.lines() {
        if line.starts_with('[') {
            records.push(Vec::new());
        } else {
            let (_, value) = line.split_once(" = ").expect("a field");
            records.last_mut().expect("a step").push(value);
        }
    }
    records.iter().map(|fields| summary(fields)).collect()
}

fn summary(fields: &[&str]) -> String {
    let [command, target, arguments @ ..] = fields else {
        panic!("{fields:?}");
    };
    let (kinds, values) = arguments.split_at(arguments.len() / 2);
    let slots = kinds.iter().zip(values);
    let mut words = vec![(*command).to_owned(), (*target).to_owned()];
    words.extend(slots.map(|(kind, value)| format!("{kind}={value}")));
    while words.last().is_some_and(|word| word == "ARG_NONE=0.000000") {
        words.pop();
    }
    words.join(" ")
}

fn object(robot: Robot, statements: &str) -> String {
    let text = format!("3.1\ntitle\n{statements}\nEND\n");
    let options = Options {
        robot,
        ..Options::default()
    };
    let loaded = load("p.prg", text.as_bytes(), &options);
    let found = &loaded.diagnostics;
    let program = loaded.program.as_ref();
    let program = program.unwrap_or_else(|| panic!("{statements}: {found:#?}"));
    listing::object(&loaded.source, &loaded.module, program)
}

/// Declarations, then one step a line beside what it is in TIP.OBJ; VAR_KEY is VAR 0, so N is VAR 1.
fn check(robot: Robot, steps: &[(&str, &str)]) {
    let declarations = "DEF_VAR N, B\nDEF_POS P, Q\nDEF_JOINT U, V\n";
    let given = "P.X = 1\nP.Y = 1\nP.Z = 1\nU.J1 = 1\nN = 1\n";
    let lines: Vec<&str> = steps.iter().map(|(line, _)| *line).collect();
    let records = records(robot, &format!("{declarations}{given}{}", lines.join("\n")));
    let given = given.lines().count();
    for (index, (line, expected)) in steps.iter().enumerate() {
        assert_eq!(records[given + index], *expected, "{line}");
    }
    assert_eq!(records.len(), given + steps.len() + 1);
}

// clauses: 9.4
#[test]
fn a_step_is_written_as_the_original_shows() {
    assert_eq!(
        object(Robot::Titan8, "DEF_VAR N\nN = 30"),
        "[0Line]
Cmd      = EQUAL
Target   = NO_TARGET
ArgType 1 = VAR
ArgType 2 = CONSTANT
ArgType 3 = ARG_NONE
ArgType 4 = ARG_NONE
ArgType 5 = ARG_NONE
ArgValue1 = 1.000000
ArgValue2 = 30.000000
ArgValue3 = 0.000000
ArgValue4 = 0.000000
ArgValue5 = 0.000000
[1Line]
Cmd      = END
Target   = NO_TARGET
ArgType 1 = ARG_NONE
ArgType 2 = ARG_NONE
ArgType 3 = ARG_NONE
ArgType 4 = ARG_NONE
ArgType 5 = ARG_NONE
ArgValue1 = 0.000000
ArgValue2 = 0.000000
ArgValue3 = 0.000000
ArgValue4 = 0.000000
ArgValue5 = 0.000000
"
    );
}

// clauses: 9.4 4.1 4.2 4.3
#[test]
fn equations() {
    check(
        Robot::Titan8,
        &[
            ("B = -N", "EQUAL NO_TARGET VAR=2.000000 MINUS_VAR=1.000000"),
            ("B -= P.Y", "EQUAL CAL_LEFT_SUB VAR=2.000000 POS_Y=0.000000"),
            ("Q = P", "EQUAL NO_TARGET POS=1.000000 POS=0.000000"),
            (
                "V = U - U",
                "EQUAL_SUB NO_TARGET JNT=1.000000 JNT=0.000000 JNT=0.000000",
            ),
            (
                "V.J3 = -2.5 * N",
                "EQUAL_MULT NO_TARGET JNT_3=1.000000 CONSTANT=-2.500000 VAR=1.000000",
            ),
            (
                "B += N + 1",
                "EQUAL_ADD CAL_LEFT_ADD VAR=2.000000 VAR=1.000000 CONSTANT=1.000000",
            ),
            (
                "B /= N / 2",
                "EQUAL_DIV CAL_LEFT_DIV VAR=2.000000 VAR=1.000000 CONSTANT=2.000000",
            ),
        ],
    );
}

// clauses: 9.4 4.4 4.5 4.6 4.7 4.8
#[test]
fn functions() {
    check(
        Robot::Titan8,
        &[
            ("B = INT N", "EQUAL_INT NO_TARGET VAR=2.000000 VAR=1.000000"),
            (
                "B *= SQRT 4",
                "EQUAL_SQRT CAL_LEFT_MULT VAR=2.000000 CONSTANT=4.000000",
            ),
            (
                "B = ATAN2 N -U.J1",
                "EQUAL_ATAN2 NO_TARGET VAR=2.000000 VAR=1.000000 MINUS_JNT_1=0.000000",
            ),
            (
                "B = RAD2DEG N",
                "EQUAL_RAD2DEG NO_TARGET VAR=2.000000 VAR=1.000000",
            ),
            (
                "B = NORM U",
                "EQUAL_NORM NO_TARGET VAR=2.000000 JNT=0.000000",
            ),
            (
                "Q = UNIT_VECT P",
                "EQUAL_UNIT_VECT NO_TARGET POS=1.000000 POS=0.000000",
            ),
            (
                "Q = ROT_Z P 90",
                "EQUAL_ROT_Z NO_TARGET POS=1.000000 POS=0.000000 CONSTANT=90.000000",
            ),
        ],
    );
}

// clauses: 9.4 7.2 7.3 7.4 7.5 7.7
#[test]
fn motions() {
    check(
        Robot::Titan8,
        &[
            (
                "PTP F1 1 2 -3",
                "PTP TARGET_F1 CONSTANT=1.000000 CONSTANT=2.000000 CONSTANT=-3.000000",
            ),
            (
                "PTP HS F2 R 1 A N R -N",
                "PTP_HS TARGET_F2 REL_CONSTANT=1.000000 VAR=1.000000 REL_MINUS_VAR=1.000000",
            ),
            ("PTP F3 P", "PTP TARGET_F3 POS=0.000000"),
            ("PTP F3 R P", "PTP TARGET_F3 REL_POS=0.000000"),
            (
                "PTP F3 P.X P.Y P.Z",
                "PTP TARGET_F3 POS_X=0.000000 POS_Y=0.000000 POS_Z=0.000000",
            ),
            (
                "REL_PTP_ANGLE J43 N",
                "REL_PTP_ANGLE TARGET_J43 VAR=1.000000",
            ),
            ("PTP_ANGLE F4 U", "PTP_ANGLE TARGET_F4 JNT=0.000000"),
            (
                "VEL_CONTROL F1 0 0 R 5",
                "VEL_CONTROL TARGET_F1 CONSTANT=0.000000 CONSTANT=0.000000 REL_CONSTANT=5.000000",
            ),
            ("ALL_STOP", "ALL_STOP NO_TARGET"),
        ],
    );
}

// clauses: 9.4 7.9 7.11 7.12 7.13 7.19 7.27 7.28 7.43
#[test]
fn forces() {
    check(
        Robot::Hand,
        &[
            (
                "PTP FLOOR 0 -100 0",
                "PTP TARGET_FLOOR CONSTANT=0.000000 CONSTANT=-100.000000 CONSTANT=0.000000",
            ),
            ("TORQUE J11 R 5", "TORQUE TARGET_J11 REL_CONSTANT=5.000000"),
            (
                "COMPLIANCE_ANGLE HS ALL U",
                "COMPLIANCE_ANGLE_HS TARGET_ALL JNT=0.000000",
            ),
            (
                "COMPLIANCE_POSITION J13 P",
                "COMPLIANCE_POSITION TARGET_J13 POS=0.000000",
            ),
            ("NO_COMPLIANCE F1", "NO_COMPLIANCE TARGET_F1"),
            ("TEACH_FORCE J12 Q", "TEACH_FORCE TARGET_J12 POS=1.000000"),
            (
                "SET_POSITION_STIFFNESS F1 1 2 N",
                "SET_POSITION_STIFFNESS TARGET_F1 CONSTANT=1.000000 CONSTANT=2.000000 VAR=1.000000",
            ),
            (
                "SET_COMPLIANCE_TORQUE_LIMIT ALL 9",
                "SET_COMPLIANCE_TORQUE_LIMIT TARGET_ALL CONSTANT=9.000000",
            ),
            (
                "SPECIAL 11.0 4 N",
                "SPECIAL NO_TARGET CONSTANT=11.000000 CONSTANT=4.000000 VAR=1.000000",
            ),
            (
                "DETECT_OBJECT 1",
                "DETECT_OBJECT NO_TARGET CONSTANT=1.000000",
            ),
        ],
    );
}

// clauses: 9.4 7.14 7.15 7.17 7.18 7.21 7.24 7.25 7.31 7.44 7.45
#[test]
fn waiting_teaching_and_parameters() {
    check(
        Robot::Titan8,
        &[
            ("SLEEP N", "SLEEP NO_TARGET VAR=1.000000"),
            ("WAIT_IN_POS ALL", "WAIT_INPOS TARGET_ALL"),
            ("TEACH_POS F1 Q", "TEACH_POSITION TARGET_F1 POS=1.000000"),
            ("TEACH_ANGLE F1 V", "TEACH_ANGLE TARGET_F1 JNT=1.000000"),
            (
                "TEACH_ANGLE J12 V.J2",
                "TEACH_ANGLE TARGET_J12 JNT_2=1.000000",
            ),
            ("SET_V_MAX F1 5", "SET_V_MAX TARGET_F1 CONSTANT=5.000000"),
            ("SET_OMEGA_MAX_SLOW J11", "SET_OMEGA_MAX_SLOW TARGET_J11"),
            (
                "SET_NEAR_ANGLE ALL 3",
                "SET_NEAR_ANGLE TARGET_ALL CONSTANT=3.000000",
            ),
            (
                "SET_NEAR_ANGLE F1 U",
                "SET_NEAR_ANGLE TARGET_F1 JNT=0.000000",
            ),
            (
                "SET_SAMPLING_TIME 10",
                "SET_SAMPLING_TIME NO_TARGET CONSTANT=10.000000",
            ),
            ("STAND_UP -N", "STAND_UP NO_TARGET MINUS_VAR=1.000000"),
            (
                "DETECT_FLOOR ALL 2",
                "DETECT_FLOOR TARGET_ALL CONSTANT=2.000000",
            ),
        ],
    );
}

const INPUTS_AND_OUTPUTS: &[(&str, &str)] = &[
    (
        "AD_IN 0 13 B",
        "AD_IN NO_TARGET CONSTANT=0.000000 CONSTANT=13.000000 VAR=2.000000",
    ),
    (
        "AD_IN VR1 B",
        "AD_IN TARGET_VR1 ARG_NONE=0.000000 ARG_NONE=0.000000 VAR=2.000000",
    ),
    (
        "AD_IN PAW4 B",
        "AD_IN TARGET_PAW4 ARG_NONE=0.000000 ARG_NONE=0.000000 VAR=2.000000",
    ),
    (
        "AD_IN J21 B",
        "AD_IN TARGET_J21 ARG_NONE=0.000000 ARG_NONE=0.000000 VAR=2.000000",
    ),
    ("KEY_IN", "KEY_IN NO_TARGET"),
    ("KEY_IN B", "KEY_IN NO_TARGET VAR=2.000000"),
    ("KEY_IN VAR_KEY", "KEY_IN NO_TARGET VAR=0.000000"),
    ("MESSAGE one", "MESSAGE NO_TARGET STRING=0.000000"),
    ("MESSAGE_CLEAR", "MESSAGE_CLEAR NO_TARGET"),
    ("MESSAGE two", "MESSAGE NO_TARGET STRING=1.000000"),
    ("LAMP_ON 1", "LAMP_ON NO_TARGET CONSTANT=1.000000"),
    ("REM nothing", "REM NO_TARGET"),
    ("EXIT", "EXIT NO_TARGET"),
];

// clauses: 9.4 7.32 7.33 7.35 7.36 7.38
#[test]
fn inputs_and_outputs() {
    check(Robot::Titan8, INPUTS_AND_OUTPUTS);
}

const BLOCKS: &[(&str, &str)] = &[
    (
        "IF N == 1 THEN",
        "IF_THEN_EQ NO_TARGET VAR=1.000000 CONSTANT=1.000000 LABEL=7.000000",
    ),
    ("SLEEP 1", "SLEEP NO_TARGET CONSTANT=1.000000"),
    (
        "ELSEIF !KB_HIT THEN",
        "ELSEIF_EVENT NO_TARGET KB_HIT=-1.000000 ARG_NONE=0.000000 LABEL=8.000000 CONSTANT=0.000000",
    ),
    ("ELSE", "ELSE NO_TARGET LABEL=9.000000 CONSTANT=0.000000"),
    ("ENDIF", "ENDIF NO_TARGET"),
    (
        "WHILE INPOS_F1",
        "WHILE_EVENT NO_TARGET INPOS_F1=1.000000 ARG_NONE=0.000000 LABEL=12.000000",
    ),
    ("WEND", "WEND NO_TARGET LABEL=10.000000"),
    ("REPEAT", "REPEAT NO_TARGET"),
    (
        "UNTIL N >= -N",
        "UNTIL_GE NO_TARGET VAR=1.000000 MINUS_VAR=1.000000 LABEL=12.000000",
    ),
    (
        "FOR B = 1 TO N",
        "FOR NO_TARGET VAR=2.000000 CONSTANT=1.000000 VAR=1.000000 LABEL=16.000000 CONSTANT=1.000000",
    ),
    ("NEXT", "NEXT NO_TARGET VAR=2.000000 LABEL=14.000000"),
    (
        "FOR B = N TO P.X STEP -2",
        "FOR NO_TARGET VAR=2.000000 VAR=1.000000 POS_X=0.000000 LABEL=18.000000 CONSTANT=-2.000000",
    ),
    ("NEXT B", "NEXT NO_TARGET VAR=2.000000 LABEL=16.000000"),
];

// clauses: 9.4 7.20
#[test]
fn blocks() {
    check(Robot::Titan8, BLOCKS);
}

const JUMPS: &[(&str, &str)] = &[
    ("LOOP:", "LABEL_CMD NO_TARGET"),
    (
        "IF N <> B GOTO",
        "IF_GOTO_NE NO_TARGET VAR=1.000000 VAR=2.000000 LABEL=5.000000",
    ),
    (
        "IF SPECIAL_FLAG3 GOSUB S:",
        "IF_GOSUB_EVENT NO_TARGET SPECIAL_FLAG3=1.000000 ARG_NONE=0.000000 LABEL=12.000000",
    ),
    (
        "IF N < 2 GOTO LOOP:",
        "IF_GOTO_LT NO_TARGET VAR=1.000000 CONSTANT=2.000000 LABEL=5.000000",
    ),
    ("GOSUB S:", "GOSUB NO_TARGET LABEL=12.000000"),
    ("CALL S:", "CALL NO_TARGET LABEL=12.000000"),
    ("GOTO LOOP:", "GOTO NO_TARGET LABEL=5.000000"),
    ("SUBROUTINE S:", "SUBROUTINE NO_TARGET"),
    ("RETURN", "RETURN NO_TARGET"),
    (
        "B = 1 // assigned somewhere",
        "EQUAL NO_TARGET VAR=2.000000 CONSTANT=1.000000",
    ),
    ("SUBEND", "SUBEND NO_TARGET"),
];

// clauses: 9.4 7.20
#[test]
fn jumps() {
    check(Robot::Titan8, JUMPS);
}

// clauses: 9.3
#[test]
fn warnings_are_listed_one_a_line() {
    let text = b"3.1\nt\nDEF_VAR N, B\nN = 1\nEND\n";
    let loaded = load("p.prg", text, &Options::default());
    let log = listing::warnings(&loaded.source, &loaded.diagnostics);
    let lines: Vec<&str> = log.lines().collect();
    assert_eq!(lines.len(), 2, "{log}");
    assert!(lines[0].starts_with("p.prg:3:9: warning: "), "{log}");
    assert!(lines[0].contains("\"N\""), "{log}");
    assert!(lines[1].starts_with("p.prg:3:12: warning: "), "{log}");
    // Errors are not warnings.
    let loaded = load("p.prg", b"3.1\nt\nFOO\nEND\n", &Options::default());
    assert_eq!(listing::warnings(&loaded.source, &loaded.diagnostics), "");
}
