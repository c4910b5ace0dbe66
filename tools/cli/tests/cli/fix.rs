//! `tip check --fix`

use crate::support::{Folder, Outcome};
use serde_json::Value;
use std::io::Write;
use std::process::Stdio;

const WRONG: &str = "IF KB_HIT\nSLEP 100\nEND IF\nEND";
const CERTAIN: &str = "3.1\ntest\nIF KB_HIT THEN\nSLEP 100\nENDIF\nEND\n";
const LIKELY: &str = "3.1\ntest\nIF KB_HIT THEN\nSLEEP 100\nENDIF\nEND\n";

#[test]
fn what_is_certain_is_written_and_the_rest_reported() {
    let folder = Folder::new("fix").program("walk.prg", WRONG);
    let outcome = folder.tip(&["check", "--fix", "walk.prg"]).expect(1);
    assert_eq!(folder.read("walk.prg"), CERTAIN);
    assert_eq!(outcome.out, "");
    assert!(
        outcome.err.starts_with("walk.prg: fixed 2 findings\n"),
        "{outcome:#?}"
    );
    assert!(
        outcome.err.contains("walk.prg: 1 error, 0 warnings\n"),
        "{outcome:#?}"
    );
    let left = "`tip check --fix --unsafe-fixes` fixes 1 finding: review what it writes\n";
    assert!(outcome.err.contains(left), "{outcome:#?}");
    let outcome = folder
        .tip(&["check", "--fix", "--unsafe-fixes", "walk.prg"])
        .expect(0);
    assert_eq!(folder.read("walk.prg"), LIKELY);
    assert_eq!(
        outcome.err,
        "walk.prg: fixed 1 finding\nwalk.prg: 4 steps for titan8, 0 warnings\n"
    );
    let outcome = folder.tip(&["check", "--fix", "walk.prg"]).expect(0);
    assert_eq!(outcome.err, "walk.prg: 4 steps for titan8, 0 warnings\n");
    assert_eq!(folder.names(), ["walk.prg"]);
}

#[test]
fn check_says_what_can_be_fixed_and_writes_nothing() {
    let folder = Folder::new("fixable").program("walk.prg", WRONG);
    let wrong = folder.read("walk.prg");
    let said = |lang: &str| {
        folder
            .tip(&["check", "--lang", lang, "walk.prg"])
            .expect(1)
            .err
    };
    let english = said("en");
    let line =
        "`tip check --fix` fixes 2 findings, with `--unsafe-fixes` 3: review what it writes\n";
    assert!(english.contains(line), "{english}");
    let japanese = said("ja");
    let line = "`tip check --fix` で2件、`--unsafe-fixes` も付けると3件を直せます。結果を確かめてください\n";
    assert!(japanese.contains(line), "{japanese}");
    assert_eq!(folder.read("walk.prg"), wrong);
    folder
        .tip(&["check", "--unsafe-fixes", "walk.prg"])
        .expect(2);
}

#[test]
fn tools_read_each_fix_in_a_line() {
    let program = |name: &str| Folder::new(name).program("walk.prg", WRONG);
    let folder = program("fix-short");
    let outcome = folder
        .tip(&["check", "--fix", "--message-format", "short", "walk.prg"])
        .expect(1);
    let lines = outcome.lines();
    let fixed = |line: &str| line.contains(": fixed[E");
    assert_eq!(
        lines.iter().filter(|line| fixed(line)).count(),
        2,
        "{outcome:#?}"
    );
    assert!(
        lines[0].starts_with("walk.prg:3:10: fixed[E205"),
        "{outcome:#?}"
    );
    assert!(lines[0].ends_with("]: insert `THEN`"), "{outcome:#?}");
    assert!(
        lines[2].starts_with("walk.prg:4:1: error[E204"),
        "{outcome:#?}"
    );
    let folder = program("fix-json");
    let outcome = folder
        .tip(&["check", "--fix", "--message-format", "json", "walk.prg"])
        .expect(1);
    let objects = outcome.lines().into_iter().map(serde_json::from_str);
    let objects: Vec<Value> = objects.collect::<Result<_, _>>().expect("valid JSON");
    let levels: Vec<&Value> = objects.iter().map(|object| &object["level"]).collect();
    assert_eq!(levels, ["fixed", "fixed", "error"], "{outcome:#?}");
    assert_eq!(objects[0]["message"], "insert `THEN`");
    assert_eq!(objects[0]["line"], 3);
    assert_eq!(objects[0]["applicability"], "certain");
    let fix = &objects[2]["fixes"][0];
    assert_eq!(fix["applicability"], "likely");
    assert_eq!(fix["edits"][0]["text"], "SLEEP");
    assert_eq!(fix["edits"][0]["range"]["start"]["line"], 4);
    assert_eq!(fix["edits"][0]["range"]["end"]["column"], 5);
}

/// JSON offers no fix that would only lead to another finding.
#[test]
fn what_does_not_help_is_not_offered() {
    let statements = "IF KB_HIT THEN\nELIF KB_HIT = THEN\nENDIF\nEND";
    let folder = Folder::new("fix-offered").program("walk.prg", statements);
    let outcome = folder
        .tip(&["check", "--message-format", "json", "walk.prg"])
        .expect(1);
    let object: Value = serde_json::from_str(outcome.lines()[0]).expect("valid JSON");
    assert_eq!(object["fixes"], Value::Array(Vec::new()));
}

#[test]
fn standard_input_goes_to_standard_output() {
    let folder = Folder::new("fix-standard");
    for format in ["human", "short", "json"] {
        let arguments = ["check", "--fix", "--message-format", format, "-"];
        let mut command = folder.command(&arguments);
        command.stdin(Stdio::piped());
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().expect("tip starts");
        let mut input = child.stdin.take().expect("a pipe");
        input
            .write_all(format!("3.1\ntest\n{WRONG}\n").as_bytes())
            .expect("it reads");
        drop(input);
        let outcome = Outcome::of(child.wait_with_output().expect("tip ends"));
        assert_eq!(
            (outcome.status, outcome.out.as_str()),
            (1, CERTAIN),
            "{format}"
        );
        assert!(outcome.err.contains("SLEP"), "{outcome:#?}");
    }
    assert_eq!(folder.names(), [""; 0]);
}

#[test]
fn a_file_that_cannot_be_decoded_or_written_stays() {
    let bytes = b"3.1\nt\nIF KB_HIT\n\x83\nENDIF\nEND\n";
    let folder = Folder::new("fix-undecodable").file("walk.prg", bytes);
    folder.tip(&["check", "--fix", "walk.prg"]).expect(1);
    let now = std::fs::read(folder.path("walk.prg")).expect("it is there");
    assert_eq!(now, bytes);
    folder.tip(&["check", "--fix", "nowhere.prg"]).expect(1);
    assert_eq!(folder.names(), ["walk.prg"]);
}

#[cfg(unix)]
#[test]
fn a_file_keeps_its_mode_and_one_that_is_read_only_stays() {
    use std::fs::{self, Permissions};
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new("fix-mode").program("walk.prg", WRONG);
    let path = folder.path("walk.prg");
    fs::set_permissions(&path, Permissions::from_mode(0o444)).expect("it is ours");
    let outcome = folder.tip(&["check", "--fix", "walk.prg"]).expect(1);
    assert!(outcome.err.contains("cannot write "), "{outcome:#?}");
    assert_eq!(folder.read("walk.prg"), format!("3.1\ntest\n{WRONG}\n"));
    fs::set_permissions(&path, Permissions::from_mode(0o640)).expect("it is ours");
    folder.tip(&["check", "--fix", "walk.prg"]).expect(1);
    assert_eq!(folder.read("walk.prg"), CERTAIN);
    let mode = fs::metadata(&path)
        .expect("it is there")
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o640);
}
