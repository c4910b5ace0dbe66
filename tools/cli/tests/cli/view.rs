//! `tip view`.

use crate::support::Folder;

const WAVE: &str = "MESSAGE hello\nPTP_ANGLE J11 10\nWAIT_INPOS ALL\nEND";

#[test]
fn a_program_becomes_a_page_beside_it() {
    let folder = Folder::new("view").program("in/wave.prg", WAVE);
    let outcome = folder.tip(&["view", "in/wave.prg"]).expect(0);
    assert!(outcome.out.is_empty());
    assert!(outcome.err.starts_with("in/wave.html: "), "{}", outcome.err);
    let page = folder.read("in/wave.html");
    assert!(page.contains("<title>test</title>"));
    folder
        .tip(&[
            "view",
            "in/wave.prg",
            "-q",
            "-o",
            "other.html",
            "--keys",
            "2:F",
        ])
        .expect(0);
    assert_ne!(folder.read("other.html"), page, "the key is in it");
}

#[test]
fn a_run_without_end_stops_after_ten_minutes_and_says_so() {
    let folder =
        Folder::new("view-endless").program(
            "on.prg",
            "AGAIN:\nPTP F1 R 0 R 0 R 10\nSLEEP 30000\nPTP F1 R 0 R 0 R -10\nSLEEP 30000\nGOTO AGAIN:\nEND",
        );
    let outcome = folder.tip(&["view", "on.prg"]).expect(0);
    assert!(
        outcome
            .err
            .contains("600.000 s of robot time, 30000 cycles"),
        "{}",
        outcome.err
    );
    assert!(
        outcome.err.contains("stopped after 10 minutes"),
        "{}",
        outcome.err
    );
    let outcome = folder.tip(&["view", "on.prg", "--cycles", "50"]).expect(0);
    assert!(
        outcome.err.contains("50 cycles") && !outcome.err.contains("stopped"),
        "{}",
        outcome.err
    );
}

#[test]
fn a_trace_with_motion_becomes_a_page_and_another_one_does_not() {
    let folder = Folder::new("view-trace").program("wave.prg", WAVE);
    folder
        .tip(&[
            "run",
            "-q",
            "wave.prg",
            "--trace",
            "with.jsonl",
            "--trace-motion",
        ])
        .expect(0);
    folder
        .tip(&["run", "-q", "wave.prg", "--trace", "without.jsonl"])
        .expect(0);
    folder
        .tip(&["view", "with.jsonl", "--program", "wave.prg"])
        .expect(0);
    assert!(folder.has("with.html"));
    let outcome = folder
        .tip(&["view", "without.jsonl", "--program", "wave.prg"])
        .expect(1);
    assert!(outcome.err.contains("--trace-motion"), "{}", outcome.err);
    assert!(!folder.has("without.html"));
    folder
        .tip(&[
            "view",
            "with.jsonl",
            "--program",
            "wave.prg",
            "--cycles",
            "5",
        ])
        .expect(2);
    folder
        .tip(&["view", "missing.jsonl", "--program", "wave.prg"])
        .expect(1);
}

#[test]
fn an_emergency_has_a_page_and_a_bad_program_has_none() {
    let folder = Folder::new("view-bad")
        .program("far.prg", "REM\nPTP F1 9999 0 0\nEND")
        .program("bad.prg", "PTTP F1\nEND");
    folder.tip(&["view", "far.prg"]).expect(0);
    assert!(folder.has("far.html"));
    let outcome = folder.tip(&["view", "bad.prg"]).expect(1);
    assert!(outcome.err.contains("bad.prg:3"), "{}", outcome.err);
    assert!(!folder.has("bad.html"));
    let outcome = folder.tip(&["view", "far.prg", "-o", "far.prg"]).expect(1);
    assert!(
        outcome.err.contains("which is being read"),
        "{}",
        outcome.err
    );
}

#[test]
fn a_sensor_that_the_robot_lacks_is_refused() {
    let folder = Folder::new("view-sensor").program("wave.prg", WAVE);
    let outcome = folder
        .tip(&[
            "view", "wave.prg", "--robot", "hand", "--sensor", "PAW1=1@0",
        ])
        .expect(2);
    assert!(outcome.err.contains("has no input PAW1"), "{}", outcome.err);
    assert!(!folder.has("wave.html"));
}
