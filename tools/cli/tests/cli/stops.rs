//! `tip run`: how it reports an emergency stop, in each form and language.

use crate::support::Folder;
use serde_json::{Value, json};

/// A program, its name, and what its report has to say in short.
const STOPS: &[(&str, &str, &str)] = &[
    (
        "divides.prg",
        "DEF_VAR N\nN = 0\n  N = 100 / -N\nEND",
        "divides.prg:5:3: error[E302]: nothing can be divided by 0 (TIP_ERR:Domain error)",
    ),
    (
        "sleeps.prg",
        "DEF_VAR N\nN = -2\nSLEEP N\nEND",
        "sleeps.prg:5:1: error[E302]: out of range (TIP_ERR:Domain error)",
    ),
    (
        "overflows.prg",
        "DEF_VAR N\nN = 1E300\nN *= N\nMESSAGE %N%\nEND",
        "overflows.prg:5:1: error[E302]: a value is out of range, or the result is not a finite number (TIP_ERR:Domain error)",
    ),
    (
        "returns.prg",
        "RETURN\nEND",
        "returns.prg:3:1: error[E303]: this returns from a subroutine that was not called (TIP_ERR:Invalid Return command)",
    ),
    (
        "reads.prg",
        "DEF_VAR N\nIF KB_HIT THEN\nN = 1\nENDIF\nSLEEP N\nEND",
        "reads.prg:7:1: error[E301]: `N` has no value yet (TIP_ERR:Possible use of Variable before definition)",
    ),
    (
        "waits.prg",
        "WAIT_NEAR F1\nEND",
        "waits.prg:3:1: error[E304]: the target is not in the control mode that this command needs (TIP_ERR:Invalid control mode)",
    ),
    (
        "reaches.prg",
        "PTP F1 -391 201 900\nWAIT_INPOS ALL\nEND",
        "reaches.prg:3:1: error[E404]: F1 cannot reach its target: it ends about 492.6 mm before it (TIP_ERR:Out of reach F1)",
    ),
];

#[test]
fn in_short_a_stop_is_one_line_with_its_place_and_reason() {
    let mut folder = Folder::new("stops-short");
    for (name, statements, _) in STOPS {
        folder = folder.program(name, statements);
    }
    for (name, _, expected) in STOPS {
        let run = ["run", name, "--quiet", "--message-format", "short"];
        assert_eq!(folder.tip(&run).expect(3).err.trim_end(), *expected);
    }
}

#[test]
fn as_json_a_stop_is_an_object_with_values_and_limits() {
    let (name, statements, _) = STOPS[0];
    let folder = Folder::new("stops-json").program(name, statements);
    let run = ["run", name, "--quiet", "--message-format", "json"];
    let outcome = folder.tip(&run).expect(3);
    let object: Value = serde_json::from_str(&outcome.err).expect("an object");
    for (key, expected) in [
        ("level", json!("error")),
        ("kind", json!("RuntimeError")),
        ("message", json!("Domain error")),
        ("code", json!("E302")),
        ("file", json!(name)),
        ("line", json!(5)),
        ("column", json!(3)),
        ("help", json!("divide by another number")),
        ("reason", json!("nothing can be divided by 0")),
        ("robot", json!("titan8")),
        ("page", json!("tip explain E302")),
        ("step", json!(1)),
        ("cycle", json!(1)),
        ("text", json!("N = 100 / -N")),
        ("values", json!({ "N": 0.0 })),
    ] {
        assert_eq!(object[key], expected, "{key} of {outcome:#?}");
    }
    // TITAN VIII has four legs of three joints; the first one turns by 45 deg to either side.
    let joints = object["joints"].as_array().expect("joints");
    assert_eq!(joints.len(), 12);
    assert_eq!(joints[0]["joint"], "J11");
    for joint in joints {
        let number = |key: &str| joint[key].as_f64().expect("a number");
        assert!((number("min")..=number("max")).contains(&number("angle")));
    }
}

#[test]
fn a_joint_at_its_limit_is_shown_with_its_angle_and_its_limits() {
    let statements = "MESSAGE 日本語\nOMEGA_CONTROL J11 30; SLEEP 60000\nEND";
    let folder = Folder::new("stops-limit").program("p.prg", statements);
    let outcome = folder
        .tip(&["run", "p.prg", "--quiet", "--message-format", "json"])
        .expect(3);
    let object: Value = serde_json::from_str(&outcome.err).expect("an object");
    let joint = &object["joints"][0];
    let (min, max) = (joint["min"].as_f64(), joint["max"].as_f64());
    let (min, max) = (min.expect("a limit"), max.expect("a limit"));
    let angle = joint["angle"].as_f64().expect("an angle");
    // It turned towards its upper limit, and the next cycle would have led beyond.
    assert!(angle <= max && angle > max - 2.0 * 30.0 * 0.02, "{joint}");
    assert_eq!(
        (&object["line"], &object["column"]),
        (&json!(4), &json!(23))
    );
    let japanese = folder
        .tip(&["run", "p.prg", "-q", "--lang", "ja"])
        .expect(3);
    let reason =
        format!("J11は現在{angle} degで、これ以上動けません。動作範囲は{min}から{max} degです");
    assert!(
        japanese
            .err
            .starts_with(&format!("エラー[E403]: {reason}\n")),
        "{japanese:#?}"
    );
    assert!(
        japanese
            .err
            .contains("TIP_ERR:Joint limit J11 (RobotError)"),
        "{japanese:#?}"
    );
}

// The legs have links of 50, 240 and 200 mm; J12 turns from -60 to 75 deg.
// clauses: 2.22 16.3
#[test]
fn a_target_out_of_reach_is_explained_by_the_joint_that_would_turn_too_far() {
    for (statements, expected) in [
        (
            "DEF_VAR H\nH = 400\nREL_PTP F1 0 0 H",
            "E404]: J12 would turn 4.6 deg beyond its limit of 75 deg",
        ),
        (
            "DEF_VAR H\nH = 100\nPTP_ANGLE J12 H",
            "E404]: J12 would turn 25 deg beyond its limit of 75 deg",
        ),
        (
            "DEF_VAR H\nSET_LIMIT J11 -20 20\nH = 32\nPTP_ANGLE J11 R H",
            "E404]: J11 would turn 12 deg beyond its limit of 20 deg",
        ),
        // The ends are within reach; the path between them is not.
        (
            "PTP F1 -408 93 235\nWAIT_INPOS ALL\nPTP F1 -199 183 -137\nWAIT_INPOS ALL",
            "E404]: F1 leaves its reach on the way to its target: J12 is ",
        ),
    ] {
        let text = format!("3.2\nt\n{statements}\nEND\n");
        let folder = Folder::new("stops-reach").file("p.prg", &text);
        let err = folder.tip(&["run", "p.prg", "-q"]).err;
        assert!(err.contains(expected), "{statements}: {err}");
    }
}

// clauses: 15.1 15.4 16.2
#[test]
fn what_another_thread_prevents_is_explained_with_thread_and_line() {
    for (main, thread, expected) in [
        (
            "START_THREAD ARM:\nSLEEP 100\nSTART_THREAD ARM:",
            "REM\nSLEEP 5000",
            "p.prg:5:1: error[E304]: thread ARM runs already: it is at line 9 (",
        ),
        (
            "START_THREAD ARM:\nSLEEP 100\nSTOP_THREAD ARM:\nSLEEP 20\nPTP F1 -391 201 -150",
            "LOCK J12\nSLEEP 5000",
            "p.prg:7:1: error[E304]: J12 is locked by LOCK in line 10, in thread ARM (",
        ),
        (
            "LOCK F1\nSTART_THREAD ARM:\nPTP_ANGLE J11 5",
            "SLEEP 5000",
            "p.prg:5:1: error[E304]: J11 is locked by LOCK in line 3 (",
        ),
        (
            "START_THREAD ARM:\nSLEEP 100\nINITIAL_POSTURE",
            "STAND_UP 20",
            "p.prg:5:1: error[E304]: thread ARM is executing STAND_UP in line 8; only one such command can run at a time (",
        ),
        // Nothing is locked, and nobody stands in the way: the mode is another one.
        (
            "START_THREAD ARM:\nWAIT_NEAR F1",
            "LOCK J21",
            "p.prg:4:1: error[E304]: the target is not in the control mode that this command needs (",
        ),
    ] {
        let text = format!("3.2\nt\n{main}\nEXIT\nTHREAD ARM:\n{thread}\nTHREADEND\nEND\n");
        let folder = Folder::new("stops-threads").file("p.prg", &text);
        let run = [
            "run",
            "p.prg",
            "-q",
            "--message-format",
            "short",
            "--cycles",
            "900",
        ];
        let err = folder.tip(&run).err;
        assert!(err.contains(expected), "{main}: {err}");
    }
}

// clauses: 16.3
#[test]
fn limits_are_those_that_the_program_set() {
    let folder = Folder::new("stops-set").file(
        "set.prg",
        "3.2\nt\nSET_LIMIT J11 -10 10\nOMEGA_CONTROL J11 30\nSLEEP 1000\nEND\n",
    );
    let err = folder.tip(&["run", "set.prg"]).expect(3).err;
    assert!(err.contains("its limits are -10 and 10 deg"), "{err}");
}

#[test]
fn people_see_the_values_at_their_places() {
    let statements = "DEF_VAR N\nDEF_POS P\nN = 900\nP.X = -391\nP.Y = 201\nP.Z = N\nPTP F1 P\nWAIT_INPOS ALL\nEND";
    let folder = Folder::new("stops-people").program("p.prg", statements);
    let outcome = folder.tip(&["run", "p.prg", "-q"]).expect(3);
    let lines: Vec<&str> = outcome.err.lines().map(str::trim_end).collect();
    assert_eq!(
        lines[..8],
        [
            "error[E404]: F1 cannot reach its target: it ends about 492.6 mm before it",
            " --> p.prg:9:1",
            "  |",
            "9 | PTP F1 P",
            "  | ^^^^^^^-",
            "  |        |",
            "  |        P.X = -391, P.Y = 201, P.Z = 900",
            "  |",
        ],
        "{outcome:#?}"
    );
    assert!(
        lines[8].starts_with("  = help: choose a place nearer to the base of the leg"),
        "{outcome:#?}"
    );
    assert_eq!(lines[9], "  = note: TIP_ERR:Out of reach F1 (RobotError)");
    assert!(lines[10].starts_with("step 4, cycle 4, 0."), "{outcome:#?}");
}

#[test]
fn the_logs_of_a_stop_stay_classical_english() {
    let (name, statements, _) = STOPS[0];
    let folder = Folder::new("stops-logs").program(name, statements);
    let run = [
        "run",
        name,
        "-q",
        "--lang",
        "ja",
        "--message-format",
        "json",
        "--out-dir",
        "logs",
    ];
    folder.tip(&run).expect(3);
    let log = folder.read("logs/EMG.log");
    assert_eq!(
        log.lines().nth(1),
        Some("TIP_ERR:Domain error (RuntimeError)")
    );
}

#[test]
fn the_moment_of_a_stop_has_its_unit() {
    let folder = Folder::new("stops-unit").program("returns.prg", "RETURN\nEND");
    for (lang, moment) in [
        ("en", "step 0, cycle 0, 0.000 s"),
        ("ja", "ステップ0、サイクル0、0.000 s"),
    ] {
        let outcome = folder
            .tip(&["run", "returns.prg", "--lang", lang])
            .expect(3);
        let mut lines = outcome.err.lines();
        assert!(lines.any(|line| line == moment), "{outcome:#?}");
    }
}
