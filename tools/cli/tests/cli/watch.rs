//! `tip check --watch`

use crate::support::Folder;
use rustix::process::{Pid, Signal, kill_process};
use std::fs;
use std::io::{BufRead, BufReader};
use std::process::{Child, ChildStderr, Stdio};

/// A check that goes on.
struct Watching {
    child: Child,
    lines: BufReader<ChildStderr>,
}

impl Watching {
    fn begin(folder: &Folder, arguments: &[&str]) -> Self {
        let mut command = folder.command(&[&["check", "--watch"], arguments].concat());
        command.stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = command.spawn().expect("tip starts");
        let lines = BufReader::new(child.stderr.take().expect("piped"));
        Watching { child, lines }
    }

    /// Its lines up to the one that says that it watches again.
    fn check(&mut self) -> Vec<String> {
        let mut lines = Vec::new();
        loop {
            let mut line = String::new();
            assert_ne!(
                self.lines.read_line(&mut line).expect("UTF-8"),
                0,
                "{lines:#?}"
            );
            if line.contains("watching ") {
                return lines;
            }
            lines.push(line.trim_end().to_owned());
        }
    }

    /// Ends it by Ctrl-C, and returns the exit status.
    fn end(mut self) -> Option<i32> {
        kill_process(Pid::from_child(&self.child), Signal::INT).expect("it runs");
        self.child.wait().expect("it ends").code()
    }
}

#[test]
fn a_change_is_checked_and_ctrl_c_ends() {
    let folder = Folder::new("watch")
        .program("p.prg", "END")
        .program("other.prg", "END");
    let mut watching = Watching::begin(&folder, &["p.prg"]);
    assert_eq!(watching.check(), ["p.prg: 1 step for titan8, 0 warnings"]);
    // Written in place; what another file says does not matter.
    fs::write(folder.path("other.prg"), "3.1\nt\nFOO\nEND\n").expect("writable");
    fs::write(folder.path("p.prg"), "3.1\nt\nFOO\nEND\n").expect("writable");
    let lines = watching.check();
    assert_eq!(lines[0], "──────── check 2 ────────");
    let last: Vec<&str> = lines.iter().rev().take(2).map(String::as_str).collect();
    assert_eq!(
        last,
        [
            "to learn more: tip explain E204-01",
            "p.prg: 1 error, 0 warnings"
        ]
    );
    // Another file in its place, as editors do it.
    fs::write(folder.path("new"), "3.1\nt\nREM\nEND\n").expect("writable");
    fs::rename(folder.path("new"), folder.path("p.prg")).expect("writable");
    let expected = [
        "──────── check 3 ────────",
        "p.prg: 2 steps for titan8, 0 warnings",
    ];
    assert_eq!(watching.check(), expected);
    assert_eq!(watching.end(), Some(130));
}

#[test]
fn what_tip_toml_gives_is_watched_with_the_program() {
    let folder = Folder::new("watch-project")
        .file("tip.toml", "robot = \"hand\"\n")
        .program("far/p.prg", "END");
    let mut watching = Watching::begin(&folder, &["far/p.prg"]);
    assert_eq!(watching.check(), ["far/p.prg: 1 step for hand, 0 warnings"]);
    fs::write(folder.path("tip.toml"), "robot = \"titan8\"\n").expect("writable");
    let again = watching.check().join("\n");
    assert!(again.contains("1 step for titan8"), "{again}");
    // A nearer one that is new.
    fs::write(folder.path("far/tip.toml"), "robot = \"generic\"\n").expect("writable");
    let nearer = watching.check().join("\n");
    assert!(nearer.contains("1 step for generic"), "{nearer}");
    assert_eq!(watching.end(), Some(130));
}

#[test]
fn a_file_may_come_and_go() {
    let folder = Folder::new("watch-comes").program("p.prg", "END");
    let mut watching = Watching::begin(&folder, &["p.prg", "late.prg", "--lang", "en"]);
    let first = watching.check().join("\n");
    assert!(first.contains("File not found(late.prg)"), "{first}");
    fs::write(folder.path("late.prg"), "3.1\nt\nEND\n").expect("writable");
    let second = watching.check().join("\n");
    assert!(second.contains("late.prg: 1 step"), "{second}");
    fs::remove_file(folder.path("late.prg")).expect("writable");
    let third = watching.check().join("\n");
    assert!(third.contains("File not found(late.prg)"), "{third}");
    assert_eq!(watching.end(), Some(130));
}

#[test]
fn what_cannot_change_is_not_watched() {
    let folder = Folder::new("watch-input");
    let outcome = folder.tip(&["check", "--watch", "-"]).expect(2);
    assert_eq!(
        outcome.err,
        "error: --watch needs files: standard input does not change\n"
    );
    let outcome = folder.tip(&["check", "--watch", "none/p.prg"]).expect(1);
    assert!(
        outcome.err.starts_with("error: none/p.prg: "),
        "{outcome:#?}"
    );
}
