//! `tip sweep`, and `tip view` of its tables.

use crate::support::{Folder, Outcome};
use rustix::process::{Pid, Signal, kill_process};
use std::io::Read;
use std::process::Stdio;
use std::thread;
use std::time::Duration;

/// Lifts a foot by some millimetres.
const LIFT: &str = "DEF_VAR Z\nZ = 20\nREL_PTP F1 0 0 Z\nWAIT_INPOS F1\nEND";

/// Lifts two feet, which a height above 0 makes a fall.
const TOPPLES: &str = "DEF_VAR Z\nZ = 0\nSTAND_UP 60\nWAIT_INPOS ALL\nREL_PTP F1 0 0 Z\nREL_PTP F2 0 0 Z\nWAIT_INPOS ALL\nEND";

fn folder(name: &str) -> Folder {
    Folder::new(name)
        .program("lift.prg", LIFT)
        .program("topples.prg", TOPPLES)
        .program(
            "on.prg",
            "DEF_VAR A\nA = 1\nAGAIN:\nA += 1\nGOTO AGAIN:\nEND",
        )
        .program("bad.prg", "PTPP F1\nEND")
}

#[test]
fn a_table_has_a_row_for_each_case_and_a_summary() {
    let folder = folder("sweep-table");
    let arguments = [
        "sweep",
        "lift.prg",
        "--vary",
        "Z=10..30/10",
        "--repeat",
        "2",
        "-o",
        "runs.csv",
    ];
    let outcome = folder.tip(&arguments).expect(0);
    assert_eq!(outcome.out, "");
    let table = folder.read("runs.csv");
    let mut lines = table.lines();
    assert!(
        lines
            .next()
            .expect("a header")
            .starts_with("case,Z,end,line,cycles,time [s],forward [mm],")
    );
    let starts: Vec<String> = lines
        .map(|line| line.split(',').take(3).collect::<Vec<_>>().join(","))
        .collect();
    assert_eq!(
        starts,
        [
            "0,10,END", "1,10,END", "2,20,END", "3,20,END", "4,30,END", "5,30,END"
        ]
    );
    assert!(
        outcome
            .err
            .starts_with("runs.csv: 6 runs, 6 of them now in "),
        "{}",
        outcome.err
    );
    assert!(
        outcome.err.contains("\n  falls   0 of 6, 0.0 %\n"),
        "{}",
        outcome.err
    );
    assert!(
        outcome
            .err
            .contains("\n          tip view runs.csv --case 0\n"),
        "{}",
        outcome.err
    );
    assert_eq!(
        folder.names(),
        [
            "bad.prg",
            "lift.prg",
            "on.prg",
            "runs.csv",
            "runs.sweep.json",
            "topples.prg"
        ]
    );

    // Threads, quiet, and standard output change nothing.
    let printed = folder
        .tip(&[&arguments[..6], &["-q", "--jobs", "1", "-o", "-"]].concat())
        .expect(0);
    assert_eq!((printed.out, printed.err.as_str()), (table.clone(), ""));
    let again = folder
        .tip(&[&arguments[..], &["--resume"]].concat())
        .expect(0);
    assert!(again.err.contains("6 runs, 0 of them now"), "{}", again.err);
    let other = folder
        .tip(&[
            "sweep",
            "lift.prg",
            "--vary",
            "Z=10..30/5",
            "-o",
            "runs.csv",
            "--resume",
        ])
        .expect(1);
    assert!(
        other.err.contains("belongs to another sweep"),
        "{}",
        other.err
    );
    assert_eq!(folder.read("runs.csv"), table);
}

#[test]
fn falls_are_counted_and_denied() {
    let folder = folder("sweep-falls");
    let arguments = ["sweep", "topples.prg", "--vary", "Z=0,60", "-o", "runs.csv"];
    let outcome = folder.tip(&arguments).expect(0);
    assert!(
        outcome.err.contains("falls   1 of 2, 50.0 %"),
        "{}",
        outcome.err
    );
    assert!(
        outcome.err.contains("worst   a fall after "),
        "{}",
        outcome.err
    );
    assert!(
        outcome
            .err
            .contains(" s: case 1, Z=60\n          tip view runs.csv --case 1\n"),
        "{}",
        outcome.err
    );
    folder
        .tip(&[&arguments[..], &["--deny", "falls"]].concat())
        .expect(4);
    let outcome = folder
        .tip(&[&arguments[..], &["--lang", "ja"]].concat())
        .expect(0);
    assert!(
        outcome.err.contains("転倒    2回中1回、50.0%"),
        "{}",
        outcome.err
    );
}

#[test]
fn a_program_that_never_ends_is_cut_off() {
    let folder = folder("sweep-endless");
    let sweep = ["sweep", "on.prg", "--vary", "A=1,2", "-o", "runs.csv"];
    let outcome = folder
        .tip(&[&sweep[..], &["--until", "500ms"]].concat())
        .expect(0);
    assert!(
        outcome.err.contains("cut off 2 of 2, after 0.5 s"),
        "{}",
        outcome.err
    );
    folder
        .tip(&[&sweep[..], &["--cycles", "7", "-q"]].concat())
        .expect(0);
    let table = folder.read("runs.csv");
    assert!(
        table
            .lines()
            .skip(1)
            .all(|row| row.contains(",limit,") && row.contains(",7,0.14,")),
        "{table}"
    );
}

#[test]
fn what_is_wrong_is_refused_before_the_first_run() {
    let folder = folder("sweep-wrong");
    for (arguments, status, expected) in [
        (
            &["lift.prg", "--vary", "Y=1"][..],
            2,
            "cannot vary 'Y': this is neither",
        ),
        (
            &["lift.prg", "--vary", "frictoin=1"],
            2,
            "did you mean friction?",
        ),
        (&["lift.prg", "--vary", "Z=3..1"], 2, "the range is empty"),
        (
            &[
                "lift.prg",
                "--vary",
                "Z=1..1e6",
                "--vary",
                "friction=1..1e6",
            ],
            2,
            "these are 1000000000000 cases",
        ),
        (
            &["lift.prg", "--vary", "Z"],
            2,
            "`Z` is not a quantity with values",
        ),
        (
            &["lift.prg", "--until", "-3"],
            2,
            "`-3` is not a time above 0",
        ),
        (&["lift.prg", "--record", "Y"], 2, "cannot record 'Y'"),
        (
            &["lift.prg", "--vary", "push.x=1"],
            2,
            "is for walking robots with mass",
        ),
        (
            &["lift.prg", "--plant", "exec:sim"],
            2,
            "`tip sweep` repeats or rewinds runs",
        ),
        (&["bad.prg", "--vary", "Z=1"], 1, "bad.prg:3"),
        (&["none.prg", "--vary", "Z=1"], 1, "none.prg"),
    ] {
        let outcome = folder.tip(&[&["sweep"], arguments, &["-o", "runs.csv"]].concat());
        assert!(outcome.err.contains(expected), "{outcome:#?}");
        outcome.expect(status);
    }
    let outcome = folder
        .tip(&["sweep", "lift.prg", "-o", "nowhere/runs.csv"])
        .expect(1);
    assert!(
        outcome.err.contains("nowhere/runs.csv: "),
        "{}",
        outcome.err
    );
    folder
        .tip(&["sweep", "lift.prg", "-o", "-", "--resume"])
        .expect(2);
    assert_eq!(
        folder.names(),
        ["bad.prg", "lift.prg", "on.prg", "topples.prg"]
    );
    let outcome = folder
        .tip(&[
            "sweep", "lift.prg", "--vary", "Y=1", "-o", "runs.csv", "--lang", "ja",
        ])
        .expect(2);
    assert!(
        outcome.err.contains("'Y' を変えられません"),
        "{}",
        outcome.err
    );
}

/// Sweeps until the table has rows, sends a signal, and goes on until the table is complete.
fn resumed(folder: &Folder, signal: Signal) -> String {
    let sweep = [
        "sweep",
        "lift.prg",
        "--vary",
        "Z=10..40/0.01",
        "-q",
        "-o",
        "runs.csv",
    ];
    let mut command = folder.command(&sweep);
    let mut child = command.stderr(Stdio::piped()).spawn().expect("tip starts");
    while folder
        .path("runs.csv.part")
        .metadata()
        .map_or(0, |file| file.len())
        < 20_000
    {
        thread::sleep(Duration::from_millis(2));
        assert!(
            child.try_wait().expect("it was started").is_none(),
            "it is too fast"
        );
    }
    kill_process(Pid::from_child(&child), signal).expect("it runs");
    let status = child.wait().expect("it ends");
    let mut said = String::new();
    let mut pipe = child.stderr.take().expect("a pipe");
    pipe.read_to_string(&mut said).expect("UTF-8");
    assert!(!folder.has("runs.csv"));
    if signal == Signal::INT {
        assert_eq!(status.code(), Some(130));
        assert!(
            said.contains(
                " of 3001 runs are in runs.csv.part; the same command with --resume goes on"
            ),
            "{said}"
        );
    }
    let refused = folder.tip(&sweep).expect(1);
    assert!(
        refused.err.contains("unfinished table: add --resume"),
        "{}",
        refused.err
    );
    // A kill may come in the middle of a row.
    let part = folder.read("runs.csv.part");
    std::fs::write(folder.path("runs.csv.part"), part + "99,12").expect("it is ours");
    folder.tip(&[&sweep[..], &["--resume"]].concat()).expect(0);
    assert!(!folder.has("runs.csv.part"));
    folder.read("runs.csv")
}

#[test]
fn an_interrupted_sweep_goes_on_to_the_same_table() {
    let whole = folder("sweep-whole");
    whole
        .tip(&[
            "sweep",
            "lift.prg",
            "--vary",
            "Z=10..40/0.01",
            "-q",
            "-o",
            "runs.csv",
        ])
        .expect(0);
    let expected = whole.read("runs.csv");
    assert_eq!(expected.lines().count(), 3002);
    assert!(resumed(&folder("sweep-interrupted"), Signal::INT) == expected);
    assert!(resumed(&folder("sweep-killed"), Signal::KILL) == expected);
}

#[test]
fn a_table_and_its_runs_have_pages() {
    let folder = folder("sweep-view");
    folder
        .tip(&[
            "sweep", "lift.prg", "--vary", "Z=10,30", "-q", "-o", "runs.csv",
        ])
        .expect(0);
    let outcome = folder.tip(&["view", "runs.csv"]).expect(0);
    assert!(
        outcome.err.starts_with("runs.html: 2 runs, "),
        "{}",
        outcome.err
    );
    let page = folder.read("runs.html");
    assert!(
        page.contains("<title>runs.csv</title>")
            && page.contains(r#""command":"tip view runs.csv""#)
    );
    assert!(page.contains(r"0,10,END,7,"), "the rows are in it");

    // The page of a case is that of a program with its constant, but for the constant in its text.
    let outcome = folder.tip(&["view", "runs.csv", "--case", "1"]).expect(0);
    let lasted = |outcome: &Outcome| {
        outcome
            .err
            .split_once(": ")
            .expect("a summary")
            .1
            .split(", ")
            .take(2)
            .collect::<Vec<_>>()
            .join(", ")
    };
    assert!(folder.has("runs.1.html"));
    let folder = folder.program("lift30.prg", &LIFT.replace("Z = 20", "Z = 30"));
    assert_eq!(
        lasted(&outcome),
        lasted(&folder.tip(&["view", "lift30.prg"]).expect(0))
    );

    folder.tip(&["view", "runs.csv", "--case", "2"]).expect(2);
    folder.tip(&["view", "lift.prg", "--case", "0"]).expect(2);
    let folder = folder.file("other.csv", "a,b\n1,2\n");
    let outcome = folder.tip(&["view", "other.csv"]).expect(1);
    assert!(
        outcome.err.contains("not a table of `tip sweep`"),
        "{}",
        outcome.err
    );
    let outcome = folder.tip(&["view", "other.csv", "--case", "0"]).expect(1);
    assert!(outcome.err.contains("other.sweep.json"), "{}", outcome.err);
}

#[test]
fn an_unfinished_table_that_something_has_changed_is_cut_or_refused() {
    let folder = folder("sweep-changed");
    let sweep = |options: &[&str]| {
        let sweep = [
            "sweep",
            "lift.prg",
            "--vary",
            "Z=10..50/10",
            "-o",
            "runs.csv",
        ];
        folder.tip(&[&sweep[..], options].concat())
    };
    sweep(&[]).expect(0);
    let whole = folder.read("runs.csv");
    let lines: Vec<&str> = whole.split_inclusive('\n').collect();
    let gap = [&lines[..3], &lines[4..]].concat().concat();
    let zeros = lines[..4].concat() + &"\0".repeat(300) + "\n";
    let short = lines[..4].concat() + "3,40,END\n";
    for part in [gap, zeros, short] {
        std::fs::remove_file(folder.path("runs.csv")).expect("a table");
        std::fs::write(folder.path("runs.csv.part"), part).expect("it is ours");
        sweep(&["--resume"]).expect(0);
        assert_eq!(folder.read("runs.csv"), whole);
    }
    std::fs::write(folder.path("runs.csv.part"), "my notes\n").expect("it is ours");
    let outcome = sweep(&["--resume"]).expect(1);
    assert!(outcome.err.contains("another sweep"), "{}", outcome.err);
    assert_eq!(folder.read("runs.csv.part"), "my notes\n");
    std::fs::remove_file(folder.path("runs.csv.part")).expect("it is ours");
    std::fs::write(folder.path("runs.csv"), lines[..3].concat() + "x\n").expect("it is ours");
    sweep(&["--resume"]).expect(1);
}

#[test]
fn a_table_takes_the_place_of_files_only() {
    let folder = folder("sweep-places")
        .file("far/table.csv", "old")
        .file("foreign.sweep.json", "{\"mine\": 1}");
    std::os::unix::fs::symlink("far/table.csv", folder.path("link.csv")).expect("a link");
    let sweep = |out: &str| folder.tip(&["sweep", "lift.prg", "--vary", "Z=10,20", "-o", out]);
    sweep("link.csv").expect(0);
    assert!(folder.path("link.csv").is_symlink());
    assert!(folder.read("far/table.csv").starts_with("case,"));
    for out in ["/dev/null", "far"] {
        let outcome = sweep(out).expect(1);
        assert!(outcome.err.contains("is not a file"), "{}", outcome.err);
    }
    let outcome = sweep("foreign.csv").expect(1);
    assert!(outcome.err.contains("something else"), "{}", outcome.err);
    assert_eq!(folder.read("foreign.sweep.json"), "{\"mine\": 1}");
    sweep("runs.csv").expect(0);
    for arguments in [
        &["runs.csv", "-o", "runs.sweep.json"][..],
        &["runs.csv", "lift.prg"],
    ] {
        let outcome = folder.tip(&[&["view"], arguments].concat());
        assert_ne!(outcome.status, 0, "{outcome:#?}");
    }
    folder.tip(&["view", "runs.csv", "--case", "1"]).expect(0);
}

#[test]
fn friction_without_mass_is_warned_of() {
    let folder = folder("sweep-idle");
    let sweep = |options: &[&str]| {
        let sweep = ["sweep", "lift.prg", "--vary", "friction=0.4,0.9", "-o", "-"];
        folder.tip(&[&sweep[..], options].concat()).expect(0).err
    };
    let warning = "warning: friction changes nothing";
    assert!(sweep(&[]).contains(warning));
    assert!(!sweep(&["-q"]).contains(warning));
    assert!(!sweep(&["--plant", "dynamic", "--until", "0.1s"]).contains(warning));
}
