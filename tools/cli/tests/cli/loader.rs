//! The commands that load a program find the same in it, and refuse the same events.

use crate::dap::Client;
use crate::support::Folder;
use serde_json::{Value, json};

/// The commands that use a program, each with what it needs besides. None of them goes on for long: `serve` is given an
/// address that no machine has, `debug` no terminal, and `verify` a crate without tip-runtime.
const RUNS: [&[&str]; 7] = [
    &["run", "walk.prg"],
    &["view", "walk.prg"],
    &["log", "walk.prg", "-o", "walk.csv"],
    &["plot", "walk.prg", "-o", "walk.svg"],
    &["serve", "walk.prg", "--listen", "192.0.2.1:1"],
    &["debug", "walk.prg"],
    &["verify", "walk.prg"],
];
const FORMS: [&[&str]; 2] = [&["emit", "rust", "walk.prg"], &["cycles", "walk.prg"]];

/// A program in a crate that compiles it for another robot.
fn folder(name: &str, statements: &str) -> Folder {
    Folder::new(name)
        .file("Cargo.toml", "[package]\nname = \"around\"\n")
        .file("tip.toml", "robot = \"titan8\"\n")
        .file(
            "src/lib.rs",
            "include_tip!(\"../walk.prg\", robot = \"hand\");",
        )
        .program("walk.prg", statements)
}

/// The lines that are warnings about the program.
fn warnings(text: &str) -> Vec<String> {
    let lines = text.lines().filter(|line| line.contains(": warning["));
    lines.map(str::to_owned).collect()
}

#[test]
fn every_command_finds_what_tip_check_finds() {
    let statements = "DEF_VAR UNUSED\nPTP F1 -2000 200 -200\nSPECIAL 30\nEND";
    let folder = folder("loader-warnings", statements);
    let short = |arguments: &[&str]| {
        let arguments = [arguments, &["--message-format", "short"]].concat();
        folder.tip(&arguments)
    };
    let checked = warnings(&short(&["check", "walk.prg"]).expect(0).out);
    // Of the robot: a target out of reach and an unanswered SPECIAL; of the crate: another robot.
    let require_each = |found: &[String]| {
        for code in ["W122", "W123", "W125"] {
            let count = found.iter().filter(|line| line.contains(code)).count();
            assert_eq!(count, 1, "{code}: {found:#?}");
        }
    };
    require_each(&checked);
    assert!(checked.len() > 3, "one of the program alone: {checked:#?}");
    for arguments in RUNS.iter().chain(&FORMS) {
        let outcome = short(arguments);
        assert_eq!(
            warnings(&outcome.err),
            checked,
            "{arguments:?}: {outcome:#?}"
        );
    }
    let program = folder.path("walk.prg").display().to_string();
    let mut client = Client::launched(&program, Value::Null);
    let said = client.event("output")["output"].take();
    let inside = folder.path("").display().to_string();
    let said = said.as_str().expect("a text").replace(&inside, "");
    assert_eq!(warnings(&said), checked);
    // The file may have changed: this comes last.
    let fixed = short(&["check", "--fix", "walk.prg"]).expect(0);
    require_each(&warnings(&fixed.out));
}

#[test]
fn every_command_refuses_an_event_that_cannot_happen() {
    let folder = Folder::new("loader-events").program("walk.prg", "DEF_VAR N\nN = 1\nEND");
    let program = folder.path("walk.prg").display().to_string();
    for (events, reason) in [
        ("0:J99=1", "the robot has no input J99"),
        ("0:set M=1", "M: the program has no variable of that name"),
        (
            "0:push 80 0 0 for 5",
            "'push 80 0 0 for 5' is for walking robots with mass: --plant dynamic",
        ),
    ] {
        for arguments in RUNS {
            let arguments = [arguments, &["--events", events]].concat();
            let outcome = folder.tip(&arguments).expect(2);
            let error = format!("error: {reason}\n");
            assert_eq!(outcome.err, error, "{arguments:?}");
        }
        let mut client = Client::new();
        client.ask("initialize", json!({ "adapterID": "tip" }));
        let launch = json!({ "program": program, "events": events });
        assert_eq!(client.refusal("launch", launch), reason);
    }
    assert!(!folder.has("walk.html") && !folder.has("walk.csv") && !folder.has("walk.svg"));
}
