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
        .tip(&[&arguments[..], &["--deny", "falls", "--force"]].concat())
        .expect(4);
    let outcome = folder
        .tip(&[&arguments[..], &["--lang", "ja", "--force"]].concat())
        .expect(0);
    assert!(
        outcome.err.contains("転倒    2回中1回、50.0%"),
        "{}",
        outcome.err
    );
}

/// C is the quotient B / (A − 2): a run with A = 2 stops in an emergency.
const QUOTIENT: &str = "DEF_VAR A B C\nA = 1\nB = 1\nC = A - 2\nC = B / C\nEND";

#[test]
fn goals_rank_the_runs_that_did_not_fail() {
    let folder = folder("sweep-goals").program("quotient.prg", QUOTIENT);
    let sweep = |options: &[&str]| {
        let sweep = [
            "sweep",
            "quotient.prg",
            "--vary",
            "A=1,2,3",
            "--vary",
            "B=1,2",
            "--record",
            "C",
            "-o",
            "runs.csv",
        ];
        folder.tip(&[&sweep[..], options].concat())
    };
    let outcome = sweep(&["--maximize", "final_C"]).expect(0);
    let best = "\n  best    final_C 2: case 5, A=3, B=2\n          tip view runs.csv --case 5\n";
    assert!(outcome.err.contains(best), "{}", outcome.err);
    let table = folder.read("runs.csv");

    // Other goals rank the same table: C is −1, −2 for A = 1, and 1, 2 for A = 3.
    let goals = [
        "--maximize",
        "final_C",
        "--minimize",
        "B",
        "--where",
        "falls=0",
        "--resume",
    ];
    let outcome = sweep(&goals).expect(0);
    let front = "\n  best    2 of 6 runs are on the Pareto front\n          \
        final_C 2, B 2: case 5, A=3, B=2\n          final_C 1, B 1: case 4, A=3, B=1\n";
    assert!(outcome.err.contains(front), "{}", outcome.err);
    assert_eq!(folder.read("runs.csv"), table);
    assert!(!folder.has("runs.csv.part") && !folder.has("runs.sweep.json.part"));
    let outcome = sweep(&[
        "--maximize",
        "A",
        "--where",
        "A=2",
        "--resume",
        "--lang",
        "ja",
    ]);
    let outcome = outcome.expect(0);
    assert!(outcome.err.contains("最良    転倒も"), "{}", outcome.err);

    // The page has the goals of the last command, and marks the runs.
    sweep(&goals).expect(0);
    folder.tip(&["view", "runs.csv"]).expect(0);
    let page = folder.read("runs.html");
    let ranking =
        r#""ranking":{"goals":[{"maximize":"final_C"},{"minimize":"B"}],"where":["falls=0"]}"#;
    assert!(page.contains(ranking));
    // The worst first: the two that stopped.
    let (_, kinds) = page.split_once(r#""kinds":""#).expect("kinds");
    let (kinds, _) = kinds.split_once('"').expect("an end");
    assert!(kinds.starts_with("xx") && kinds.len() == 6, "{kinds}");
    assert_eq!(kinds.matches('f').count(), 2, "{kinds}");

    for (options, expected) in [
        (["--maximize", "sped"], "did you mean speed?"),
        (["--minimize", "end"], "the table has no numbers `end`"),
        (["--where", "falls"], "`falls` is not a condition"),
        (["--where", "fals=0"], "did you mean falls?"),
    ] {
        let outcome = sweep(&options).expect(2);
        assert!(outcome.err.contains(expected), "{}", outcome.err);
    }
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
        .tip(&[&sweep[..], &["--cycles", "7", "-q", "--force"]].concat())
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
    assert!(page.contains(r#"[0,10.0,"END",7,"#), "the rows are in it");

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
    for arguments in [&["other.csv"][..], &["other.csv", "--case", "0"]] {
        let outcome = folder.tip(&[&["view"], arguments].concat()).expect(1);
        assert!(outcome.err.contains("other.sweep.json"), "{}", outcome.err);
    }
    std::fs::copy(
        folder.path("runs.sweep.json"),
        folder.path("other.sweep.json"),
    )
    .expect("a copy");
    let refused = |table: &str, reason: &str| {
        std::fs::write(folder.path("other.csv"), table).expect("it is a file");
        let outcome = folder.tip(&["view", "other.csv"]).expect(1);
        assert!(outcome.err.contains(reason), "{}", outcome.err);
    };
    let table = folder.read("runs.csv");
    let lines: Vec<&str> = table.split_inclusive('\n').collect();
    let (rows, last) = (lines.len() - 1, lines[lines.len() - 1]);
    for other in ["a,b\n1,2\n", "", "garbage", lines[0].trim_end()] {
        refused(other, "not the table of its specification");
    }
    let doubled = format!("line {} of other.csv", rows + 2);
    refused(&(table.clone() + last), &doubled);
    let cut = format!("line {} of other.csv", rows + 1);
    refused(&table[..table.len() - 5], &cut);
    // Rows of a complete table may be in another order, as a spreadsheet sorts them.
    let turned = [lines[0]]
        .into_iter()
        .chain(lines[1..].iter().rev().copied());
    std::fs::write(folder.path("other.csv"), turned.collect::<String>()).expect("it is a file");
    folder.tip(&["view", "other.csv"]).expect(0);
    folder
        .tip(&["view", "other.csv", "--robot", "a1"])
        .expect(2);
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
    let error = &outcome.err;
    assert!(error.starts_with("error: line 1 of "), "{error}");
    assert!(error.contains("runs.csv.part is damaged"), "{error}");
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
    std::os::unix::fs::symlink("far/none.csv", folder.path("loose.csv")).expect("a link");
    // Neither a table nor its specification takes the place of a link, or of the file that it leads to.
    std::os::unix::fs::symlink("far/spec.json", folder.path("mine.sweep.json")).expect("a link");
    for (out, link) in [
        ("link.csv", "link.csv"),
        ("loose.csv", "loose.csv"),
        ("mine.csv", "mine.sweep.json"),
    ] {
        for option in [&[][..], &["--force"], &["--resume"]] {
            let arguments = ["sweep", "lift.prg", "--vary", "Z=10,20", "-o", out];
            let outcome = folder.tip(&[&arguments, option].concat()).expect(1);
            let expected = format!("{link} is a link: name the file itself");
            assert!(outcome.err.contains(&expected), "{}", outcome.err);
        }
        assert!(folder.path(link).is_symlink());
    }
    assert_eq!(folder.read("far/table.csv"), "old");
    assert_eq!(
        std::fs::read_dir(folder.path("far"))
            .expect("a folder")
            .count(),
        1
    );
    // A file stays, unless it is to be replaced.
    let outcome = sweep("far/table.csv").expect(1);
    assert!(
        outcome.err.contains("table.csv exists: --force"),
        "{}",
        outcome.err
    );
    assert_eq!(folder.read("far/table.csv"), "old");
    let replaced = [
        "sweep",
        "lift.prg",
        "--vary",
        "Z=10,20",
        "--force",
        "-o",
        "far/table.csv",
    ];
    folder.tip(&replaced).expect(0);
    assert!(folder.read("far/table.csv").starts_with("case,"));
    for out in ["/dev/null", "far"] {
        let outcome = sweep(out).expect(1);
        assert!(outcome.err.contains("is not a file"), "{}", outcome.err);
    }
    let outcome = sweep("foreign.csv").expect(1);
    assert!(outcome.err.contains("something else"), "{}", outcome.err);
    assert_eq!(folder.read("foreign.sweep.json"), "{\"mine\": 1}");
    for out in ["runs.tsv", "runs", "runs.csv.part", "RUNS.CSV"] {
        let outcome = sweep(out).expect(1);
        assert!(outcome.err.contains("ends in .csv"), "{}", outcome.err);
    }
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

/// Sweeps three heights into `runs.csv`.
fn heights(folder: &Folder, options: &[&str]) -> Outcome {
    let sweep = [
        "sweep",
        "lift.prg",
        "--vary",
        "Z=10..30/10",
        "-o",
        "runs.csv",
    ];
    folder.tip(&[&sweep[..], options].concat())
}

#[test]
fn a_table_and_another_specification_are_refused() {
    let folder = folder("sweep-pair");
    heights(&folder, &[]).expect(0);
    folder.tip(&["view", "runs.csv", "--case", "2"]).expect(0);
    let table = folder.read("runs.csv");
    // The specification of another sweep, of a killed newer one for example.
    folder
        .tip(&[
            "sweep",
            "lift.prg",
            "--vary",
            "Z=10..30/5",
            "-q",
            "-o",
            "other.csv",
        ])
        .expect(0);
    std::fs::copy(
        folder.path("other.sweep.json"),
        folder.path("runs.sweep.json"),
    )
    .expect("a copy");
    for arguments in [&["runs.csv"][..], &["runs.csv", "--case", "2"]] {
        let outcome = folder.tip(&[&["view"], arguments].concat()).expect(1);
        let reason = "line 2 of runs.csv is not a row of the sweep in runs.sweep.json";
        assert!(outcome.err.contains(reason), "{}", outcome.err);
    }
    heights(&folder, &["--resume"]).expect(1);
    assert_eq!(folder.read("runs.csv"), table);
}

/// A new sweep leaves the complete one as it is until the new one is complete, whenever it is killed.
#[test]
fn a_killed_sweep_leaves_the_complete_one() {
    let folder = folder("sweep-kept");
    heights(&folder, &[]).expect(0);
    let files = || ["runs.csv", "runs.sweep.json"].map(|name| folder.read(name));
    let complete = files();
    let newer = [
        "sweep", "on.prg", "--vary", "A=1,2", "--until", "1e9s", "-q", "--force", "-o", "runs.csv",
    ];
    let mut child = folder.command(&newer).spawn().expect("tip starts");
    while !folder.has("runs.sweep.json.part") {
        thread::sleep(Duration::from_millis(2));
    }
    // Nobody else writes the same table.
    let outcome = heights(&folder, &["--force"]).expect(1);
    assert!(
        outcome.err.contains("another process is writing"),
        "{}",
        outcome.err
    );
    let outcome = heights(&folder, &["--resume"]).expect(0);
    assert!(
        outcome.err.contains("3 runs, 0 of them now"),
        "{}",
        outcome.err
    );
    child.kill().expect("it runs");
    child.wait().expect("it ends");
    assert_eq!(files(), complete);
    folder.tip(&["view", "runs.csv", "--case", "2"]).expect(0);
    // Nothing of the killed one is worth keeping.
    heights(&folder, &["--force"]).expect(0);
    assert_eq!(files(), complete);
    assert!(!folder.has("runs.csv.part") && !folder.has("runs.sweep.json.part"));
}

/// Both files get their names one after the other: a kill in between loses nothing.
#[test]
fn a_sweep_that_is_killed_as_it_becomes_complete_goes_on() {
    let folder = folder("sweep-between");
    heights(&folder, &[]).expect(0);
    let complete = folder.read("runs.csv");
    std::fs::rename(folder.path("runs.csv"), folder.path("runs.csv.part")).expect("a table");
    folder.tip(&["view", "runs.csv.part", "-q"]).expect(0);
    let outcome = heights(&folder, &["--resume"]).expect(0);
    assert!(
        outcome.err.contains("3 runs, 0 of them now"),
        "{}",
        outcome.err
    );
    assert_eq!(folder.read("runs.csv"), complete);
}

#[test]
fn places_that_hold_something_else_are_refused() {
    use rustix::fs::{CWD, FileType, Mode, mknodat};
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = folder("sweep-planted").file("victim", "precious");
    let pipe = |name: &str| {
        let mode = Mode::RUSR | Mode::WUSR;
        mknodat(CWD, folder.path(name), FileType::Fifo, mode, 0).expect("a pipe");
    };
    let remove = |name: &str| std::fs::remove_file(folder.path(name)).expect("it is ours");
    // Neither a link is followed nor a pipe waited for.
    for name in ["runs.csv.part", "runs.sweep.json.part"] {
        for target in ["victim", "nothing"] {
            symlink(folder.path(target), folder.path(name)).expect("a link");
            let outcome = heights(&folder, &[]).expect(1);
            assert!(
                outcome.err.contains("is not a regular file"),
                "{}",
                outcome.err
            );
            remove(name);
        }
        pipe(name);
        heights(&folder, &[]).expect(1);
        heights(&folder, &["--resume"]).expect(1);
        remove(name);
    }
    assert_eq!(folder.read("victim"), "precious");
    pipe("runs.sweep.json");
    let outcome = heights(&folder, &[]).expect(1);
    assert!(
        outcome.err.contains("has something else"),
        "{}",
        outcome.err
    );
    let outcome = folder.tip(&["view", "runs.csv", "--case", "2"]).expect(1);
    assert!(outcome.err.contains("runs.sweep.json"), "{}", outcome.err);
    remove("runs.sweep.json");
    heights(&folder, &[]).expect(0);
    // Read-only files stay.
    let table = folder.read("runs.csv");
    for name in ["runs.csv", "runs.sweep.json"] {
        let set = |mode| {
            std::fs::set_permissions(folder.path(name), std::fs::Permissions::from_mode(mode))
        };
        set(0o444).expect("it is ours");
        let outcome = heights(&folder, &[]).expect(1);
        assert!(
            outcome.err.contains(&format!("{name}: permission denied")),
            "{}",
            outcome.err
        );
        set(0o644).expect("it is ours");
    }
    assert_eq!(folder.read("runs.csv"), table);
}

#[test]
fn an_empty_part_is_taken_and_a_full_disk_leaves_nothing() {
    let folder = folder("sweep-empty").file("runs.csv.part", "");
    heights(&folder, &[]).expect(0);
    let table = folder.read("runs.csv");
    std::fs::remove_file(folder.path("runs.csv")).expect("a table");
    std::fs::write(folder.path("runs.csv.part"), "").expect("it is ours");
    heights(&folder, &["--resume"]).expect(0);
    assert_eq!(folder.read("runs.csv"), table);
    // A limit of the file size is a full disk.
    let limited = |kilobytes: u32, arguments: &str| {
        let tip = env!("CARGO_BIN_EXE_tip");
        let script = format!("ulimit -f {kilobytes}; exec '{tip}' sweep lift.prg {arguments}");
        let mut shell = std::process::Command::new("bash");
        let output = shell
            .args(["-c", &script])
            .current_dir(folder.path("."))
            .output();
        let output = output.expect("bash");
        (
            output.status.code(),
            String::from_utf8_lossy(&output.stderr).into_owned(),
        )
    };
    let (status, said) = limited(0, "--vary Z=1,2 -o full.csv");
    assert_eq!(status, Some(1), "{said}");
    assert!(!folder.has("full.csv.part") && !folder.has("full.sweep.json.part"));
    // The rows that are said to be kept are those in the file.
    let (status, said) = limited(16, "--vary Z=1..2/0.001 -o full.csv");
    assert_eq!(status, Some(1), "{said}");
    let part = folder.read("full.csv.part");
    let kept = part.matches('\n').count() - 1;
    assert!(kept > 10, "{said}");
    assert!(
        said.contains(&format!("{kept} of 1001 runs are in full.csv.part")),
        "{said}"
    );
    folder
        .tip(&[
            "sweep",
            "lift.prg",
            "--vary",
            "Z=1..2/0.001",
            "-q",
            "-o",
            "full.csv",
            "--resume",
        ])
        .expect(0);
    assert_eq!(folder.read("full.csv").lines().count(), 1002);
}

#[test]
fn a_part_that_another_program_has_changed_is_not_believed() {
    let folder = folder("sweep-edited");
    heights(&folder, &[]).expect(0);
    let table = folder.read("runs.csv");
    let resume = |part: &[u8]| {
        let _ = std::fs::remove_file(folder.path("runs.csv"));
        std::fs::write(folder.path("runs.csv.part"), part).expect("it is ours");
        heights(&folder, &["--resume"])
    };
    // A changed value: the row and those after it are run again.
    let changed = table.replacen("1,20,END", "1,20,EXIT", 1);
    let outcome = resume(changed.as_bytes()).expect(0);
    assert!(
        outcome.err.contains("3 runs, 2 of them now"),
        "{}",
        outcome.err
    );
    assert_eq!(folder.read("runs.csv"), table);
    let lines = table.replace('\n', "\r\n");
    let marked = [b"\xef\xbb\xbf", table.as_bytes()].concat();
    for part in [lines.as_bytes(), &marked] {
        let outcome = resume(part).expect(1);
        assert!(
            outcome.err.contains("byte order mark or CR LF"),
            "{}",
            outcome.err
        );
        assert!(std::fs::read(folder.path("runs.csv.part")).expect("it is there") == part);
    }
    // The rows of a version without checks.
    let old: String = table
        .lines()
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            cells[..cells.len() - 1].join(",") + "\n"
        })
        .collect();
    let outcome = resume(old.as_bytes()).expect(1);
    assert!(outcome.err.contains("version of tip"), "{}", outcome.err);
}

#[test]
fn any_number_of_jobs_is_bounded() {
    let folder = folder("sweep-jobs");
    heights(&folder, &["--jobs", "1000000000000"]).expect(0);
    let outcome = heights(&folder, &["--jobs", "0"]).expect(2);
    assert!(
        outcome.err.contains("`0` is not a number of threads"),
        "{}",
        outcome.err
    );
}

#[test]
fn a_slope_varies_without_a_scene_file() {
    let folder = folder("sweep-slope");
    let sweep = [
        "sweep",
        "lift.prg",
        "--vary",
        "scene.floor.slope.1=0,0.1",
        "-q",
        "-o",
        "-",
    ];
    let table = folder.tip(&sweep).expect(0).out;
    assert_eq!(table.lines().count(), 3);
}

#[test]
fn a_variable_that_a_thread_assigns_varies() {
    let program = "3.2\nt\nDEF_VAR A B\nSTART_THREAD T:\nWAIT_THREAD T:\nB = A\nEXIT\nTHREAD T:\nA = 500\nTHREADEND\nEND\n";
    let folder = Folder::new("sweep-thread").file("thread.prg", program);
    let sweep = [
        "sweep",
        "thread.prg",
        "--vary",
        "A=100,500,1000",
        "--record",
        "B",
        "-q",
        "-o",
        "-",
    ];
    let table = folder.tip(&sweep).expect(0).out;
    let lines: Vec<Vec<&str>> = table
        .lines()
        .map(|line| line.split(',').collect())
        .collect();
    let column = lines[0]
        .iter()
        .position(|name| *name == "final_B")
        .expect("a column");
    let values: Vec<&str> = lines[1..].iter().map(|row| row[column]).collect();
    assert_eq!(values, ["100", "500", "1000"]);
}
