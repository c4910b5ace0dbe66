//! `tip run`: traces, messages and how runs end.

use crate::support::{Folder, Outcome};
use std::process::Stdio;

// clauses: 2.18 7.39
#[test]
fn end_and_exit_succeed() {
    let folder = Folder::new("run-end")
        .program("end.prg", "END")
        .program("exit.prg", "EXIT\nEND");
    let outcome = folder.tip(&["run", "end.prg", "--trace", "-"]).expect(0);
    assert_eq!(
        outcome.lines(),
        [r#"{"cycle":0,"step":0}"#, r#"{"end":"END","cycles":1}"#]
    );
    let outcome = folder.tip(&["run", "exit.prg", "--trace", "-"]).expect(0);
    assert_eq!(outcome.lines()[1], r#"{"end":"EXIT","cycles":1}"#);
}

#[test]
fn the_limit_counts_cycles() {
    let folder = Folder::new("run-limit").program("loop.prg", "L1:\nGOTO L1:\nEND");
    let outcome = folder
        .tip(&["run", "loop.prg", "--cycles", "3", "--trace", "-"])
        .expect(0);
    assert_eq!(
        outcome.lines(),
        [
            r#"{"cycle":0,"step":0,"next":1}"#,
            r#"{"cycle":1,"step":1,"next":0}"#,
            r#"{"cycle":2,"step":0,"next":1}"#,
            r#"{"end":"LIMIT","cycles":3}"#,
        ]
    );
    let outcome = folder
        .tip(&["run", "loop.prg", "--cycles", "0", "--trace", "-"])
        .expect(0);
    assert_eq!(outcome.lines(), [r#"{"end":"LIMIT","cycles":0}"#]);
}

// clauses: 15.3
#[test]
fn an_end_in_a_thread_is_told_with_its_line() {
    let program = "3.2\nt\nSTART_THREAD SIDE:\nWAIT_THREAD SIDE:\nEXIT\nTHREAD SIDE:\nREM\nEXIT\nTHREADEND\nEND\n";
    let folder = Folder::new("run-end-in-thread").file("t.prg", program);
    let outcome = folder.tip(&["run", "t.prg"]).expect(0);
    assert!(
        outcome.err.starts_with("t.prg: EXIT at line 8"),
        "{}",
        outcome.err
    );
    let outcome = folder.tip(&["run", "t.prg", "--cycles", "2"]).expect(0);
    let waits = "line 4: WAIT_THREAD SIDE:, which waits until thread SIDE ends";
    assert!(outcome.err.contains(waits), "{}", outcome.err);
}

// clauses: 15.1
// Thread A begins to wait in cycle 1, thread B in cycle 2.
#[test]
fn threads_that_wait_for_each_other_are_reported_once() {
    let program = "3.2\nt\nSTART_THREAD A:\nSTART_THREAD B:\nL: SLEEP 20\nGOTO L:\nTHREAD A:\nWAIT_THREAD B:\nTHREADEND\n\
        THREAD B:\nWAIT_THREAD A:\nTHREADEND\nEND\n";
    let folder = Folder::new("run-circle").file("t.prg", program);
    let run = |options: &[&str]| {
        let run = ["run", "t.prg", "--cycles", "50"];
        folder.tip(&[&run[..], options].concat()).expect(0).err
    };
    let reported = run(&[]);
    let found = "warning: threads wait for each other after 0.060 s, from cycle 3 on: A in line 8, B in line 11; only STOP_THREAD ends that\n --> t.prg:8:1\n";
    assert!(reported.starts_with(found), "{reported}");
    assert_eq!(
        reported.matches("wait for each other").count(),
        1,
        "{reported}"
    );
    assert_eq!(run(&["--quiet"]), "");
}

// clauses: 17.3
// 1048576 bytes hold the 23 of the first line and 5269 texts of 199 bytes; the program appends 5300.
#[test]
fn texts_that_fout_log_has_no_room_for_are_counted_at_the_end() {
    let text = "x".repeat(198);
    let program = format!("3.2\nt\nDEF_VAR I\nFOR I = 1 TO 5300\nF_MESSAGE {text}\\n\nNEXT\nEND\n");
    let folder = Folder::new("run-full-output").file("p.prg", &program);
    let outcome = folder.tip(&["run", "p.prg", "--out-dir", "logs"]).expect(0);
    let reported = "FOUT.LOG is full: 31 of F_MESSAGE's texts are left out";
    assert!(outcome.err.contains(reported), "{}", outcome.err);
    let log = folder.read("logs/FOUT.LOG");
    assert!(log.starts_with("# FOUT.LOG of ../p.prg\n"));
    assert_eq!((log.len(), log.lines().count()), (23 + 5269 * 199, 5270));
    // None is counted where no file is written.
    let outcome = folder.tip(&["run", "p.prg"]).expect(0);
    assert!(!outcome.err.contains("FOUT.LOG"), "{}", outcome.err);
}

// clauses: 8.1
#[test]
fn an_emergency_names_its_place() {
    let folder =
        Folder::new("run-emergency").program("bad.prg", "DEF_VAR A\nA = 0\n  A = 1 / A\nEND");
    let outcome = folder
        .tip(&["run", "bad.prg", "--trace", "t.jsonl"])
        .expect(3);
    assert_eq!(
        folder.read("t.jsonl").lines().last(),
        Some(
            r#"{"end":"EMERGENCY","error":"Domain error","kind":"RuntimeError","step":1,"cycles":1}"#
        )
    );
    for part in [
        "TIP_ERR:Domain error (RuntimeError)",
        "bad.prg:5:3",
        "A = 1 / A",
        "step 1, cycle 1",
    ] {
        assert!(outcome.err.contains(part), "{part} in {}", outcome.err);
    }
}

// clauses: 3.4
#[test]
fn an_unassigned_variable_is_named() {
    let program = "DEF_VAR A, B\nIF KB_HIT THEN\nA = 1\nENDIF\nB = A\nMESSAGE %B%\nEND";
    let folder = Folder::new("run-unassigned").program("u.prg", program);
    let outcome = folder.tip(&["run", "u.prg"]).expect(3);
    let expected = "TIP_ERR:Possible use of Variable before definition (RuntimeError)";
    assert!(outcome.err.contains(expected), "{outcome:#?}");
    assert!(outcome.err.contains("`A` has no value yet"), "{outcome:#?}");
}

#[test]
fn messages_go_to_standard_output_unless_the_trace_does() {
    let folder = Folder::new("run-messages")
        .program("m.prg", "MESSAGE one\nMESSAGE_CLEAR\nMESSAGE Two\nEND");
    let outcome = folder.tip(&["run", "m.prg"]).expect(0);
    assert_eq!(outcome.out, "one\nTwo\n");
    let outcome = folder.tip(&["run", "m.prg", "--trace", "-"]).expect(0);
    assert!(
        outcome.lines().iter().all(|line| line.starts_with('{')),
        "{outcome:#?}"
    );
    let outcome = folder
        .tip(&["run", "m.prg", "--trace", "t.jsonl"])
        .expect(0);
    assert_eq!(outcome.out, "one\nTwo\n");
    assert!(folder.read("t.jsonl").contains(r#""say":"Two""#));
}

#[test]
fn states_are_hashed_on_request_only() {
    let folder = Folder::new("run-state").program("p.prg", "PTP_ANGLE J11 5\nSLEEP 200\nEND");
    let with = folder
        .tip(&["run", "p.prg", "--trace", "-", "--trace-state"])
        .expect(0);
    let without = folder.tip(&["run", "p.prg", "--trace", "-"]).expect(0);
    let cycles = without.lines().len() - 1;
    for (with, without) in with.lines().iter().zip(&without.lines()[..cycles]) {
        let (record, state) = with.split_once(r#","state":""#).expect("a state");
        assert_eq!(format!("{record}}}"), **without);
        assert_eq!(state.len(), 18, "{state}");
    }
    let again = folder
        .tip(&["run", "p.prg", "--trace", "-", "--trace-state"])
        .expect(0);
    assert_eq!(with.out, again.out);
}

#[test]
fn states_and_motion_without_a_trace_are_refused() {
    let folder = Folder::new("run-state-alone").program("p.prg", "END");
    for extra in ["--trace-state", "--trace-motion"] {
        let refused = folder.tip(&["run", "p.prg", extra]).expect(2);
        assert!(refused.err.contains("--trace <"), "{refused:#?}");
    }
}

// clauses: 7.32
#[test]
fn a_sole_that_the_robot_lacks_is_refused() {
    let bolted = "name = \"bolted\"\njoint = [{ axis = \"y\", link = [0, 0, -100], limits = [-90, 90] }]\nleg = [{ base = [0, 0, 0] }]\n";
    let folder = Folder::new("run-soles")
        .program("p.prg", "END")
        .file("bolted.toml", bolted);
    for (robot, status) in [
        ("titan8", 0),
        ("generic", 0),
        ("hand", 2),
        ("bolted.toml", 2),
    ] {
        let arguments = ["run", "p.prg", "--robot", robot, "--sensor", "PAW1=1@0"];
        let outcome = folder.tip(&arguments).expect(status);
        let refused = outcome.err.contains("has no input PAW1");
        assert_eq!(refused, status == 2, "{robot}: {outcome:#?}");
    }
}

#[test]
fn the_generic_robot_and_the_hand_run() {
    let folder = Folder::new("run-robots").program("p.prg", "END");
    for robot in ["generic", "hand"] {
        folder.tip(&["run", "--robot", robot, "p.prg"]).expect(0);
    }
}

#[test]
fn a_scene_has_objects_for_a_hand_only() {
    let weigh = "DEF_VAR TORQUE1\nSLEEP 500\nTORQUE F1 60 60 60\nSLEEP 1000\nTEACH_TORQUE J13 TORQUE1\nMESSAGE %TORQUE1%\nEND";
    let folder = Folder::new("run-scene").program("p.prg", weigh);
    let hand = ["run", "--robot", "hand", "p.prg", "--scene"];
    // Without an object the finger closes until it is at its limit.
    folder.tip(&hand[..4]).expect(3);
    let held = folder.tip(&[&hand[..], &["cylinder"]].concat()).expect(0);
    assert!(held.out.contains("60"), "{held:#?}");
    let refused = folder.tip(&[&hand[..], &["moon"]].concat()).expect(2);
    assert!(refused.err.contains("cylinder"), "{refused:#?}");
    let refused = folder
        .tip(&["run", "p.prg", "--robot", "generic", "--scene", "cylinder"])
        .expect(2);
    assert!(refused.err.contains("--robot hand"), "{refused:#?}");
    // The same cylinder from a file, then one with a fault, then none.
    let own = "[[object]]\nsize = [200, 60]\nmass = 0.6\nfriction = 1.5\n";
    let folder = folder
        .file("own.toml", own)
        .file("bad.toml", own.replace("0.6", "0"));
    let same = folder.tip(&[&hand[..], &["own.toml"]].concat()).expect(0);
    assert_eq!(same.out, held.out);
    let bad = folder.tip(&[&hand[..], &["bad.toml"]].concat()).expect(1);
    assert!(bad.err.contains("bad.toml:3:8"), "{bad:#?}");
    folder.tip(&[&hand[..], &["none.toml"]].concat()).expect(1);
}

#[test]
fn a_program_that_does_not_load_does_not_run() {
    let folder = Folder::new("run-bad").program("bad.prg", "FOO\nEND");
    let outcome = folder
        .tip(&["run", "bad.prg", "--trace", "t.jsonl"])
        .expect(1);
    assert!(
        outcome.err.contains("Unknown command \"FOO\""),
        "{outcome:#?}"
    );
    assert!(!folder.has("t.jsonl"));
    let outcome = folder.tip(&["run", "nope.prg"]).expect(1);
    assert!(
        outcome
            .err
            .contains("TIP_ERR:File not found(nope.prg) (PreprocessError)"),
        "{outcome:#?}"
    );
}

// clauses: 3.4
#[test]
fn the_variable_without_value_is_named_among_very_many() {
    let positions: String = (0..22_000).map(|n| format!("DEF_POS P{n}\n")).collect();
    let text = format!("{positions}DEF_VAR LAST, A\nA = LAST\nLAST = A\nEND");
    let folder = Folder::new("run-many").program("many.prg", &text);
    let outcome = folder
        .tip(&["run", "many.prg", "--message-format", "short"])
        .expect(3);
    assert!(outcome.err.contains("`LAST` has no value yet"));
}

#[test]
fn the_program_itself_is_never_the_trace() {
    let folder = Folder::new("run-source").program("p.prg", "END");
    folder.tip(&["run", "p.prg", "--trace", "p.prg"]).expect(1);
    assert!(folder.read("p.prg").starts_with("3.1"));
}

#[test]
fn a_reader_of_messages_that_goes_away_ends_the_run() {
    let folder =
        Folder::new("run-pipe").program("talk.prg", "L1:\nMESSAGE still here\nGOTO L1:\nEND");
    let mut child = folder
        .command(&["run", "talk.prg", "--trace", "t.jsonl"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("tip starts");
    drop(child.stdout.take());
    let outcome = Outcome::of(child.wait_with_output().expect("tip ends")).expect(130);
    assert!(
        outcome.err.starts_with("talk.prg: interrupted at line "),
        "{outcome:#?}"
    );
    let trace = folder.read("t.jsonl");
    assert!(
        trace
            .lines()
            .last()
            .is_some_and(|line| line.starts_with(r#"{"end":"INTERRUPTED","#))
    );
}

#[cfg(target_os = "linux")]
#[test]
fn messages_that_cannot_be_written_end_the_run_with_a_reason() {
    let folder = Folder::new("run-full").program("talk.prg", "L1:\nMESSAGE hello\nGOTO L1:\nEND");
    let full = std::fs::File::options()
        .write(true)
        .open("/dev/full")
        .expect("the device that is always full");
    let output = folder
        .command(&["run", "talk.prg"])
        .stdout(full)
        .output()
        .expect("tip starts");
    let outcome = Outcome::of(output).expect(1);
    let reason = "error: cannot write standard output: ";
    assert!(outcome.err.contains(reason), "{outcome:#?}");
}

#[test]
fn a_reader_of_the_trace_that_goes_away_ends_the_run() {
    let folder = Folder::new("run-trace-pipe").program("loop.prg", "L1:\nGOTO L1:\nEND");
    let mut child = folder
        .command(&["run", "loop.prg", "--trace", "-"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("tip starts");
    drop(child.stdout.take());
    let outcome = Outcome::of(child.wait_with_output().expect("tip ends")).expect(130);
    assert!(
        outcome.err.starts_with("loop.prg: interrupted at line "),
        "{outcome:#?}"
    );
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_the_run_and_completes_the_trace() {
    use std::process::Command;
    use std::time::Duration;

    let folder = Folder::new("run-interrupt").program("loop.prg", "MESSAGE go\nL1:\nGOTO L1:\nEND");
    let mut child = folder
        .command(&["run", "loop.prg", "--trace", "t.jsonl"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("tip starts");
    // The first message proves that the run is under way, handlers and all.
    let mut first = [0; 3];
    let mut out = child.stdout.take().expect("piped");
    std::io::Read::read_exact(&mut out, &mut first).expect("the message");
    std::thread::sleep(Duration::from_millis(50));
    let killed = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status()
        .expect("kill starts");
    assert!(killed.success());
    Outcome::of(child.wait_with_output().expect("tip ends")).expect(130);
    let trace = folder.read("t.jsonl");
    let records = trace.lines().count() - 1;
    assert_eq!(
        trace.lines().last(),
        Some(format!(r#"{{"end":"INTERRUPTED","cycles":{records}}}"#).as_str())
    );
}
