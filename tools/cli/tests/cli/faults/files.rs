//! Files and folders that cannot be written.

use super::bench::{Bench, FILES, RUN, Texts, replace};
use super::{Row, signals};
use crate::support::Outcome;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Stdio};

/// The expected outcome of a fault.
#[derive(Clone, Copy)]
enum Expected {
    /// It is found before the first cycle, and nothing changes.
    Refused,
    /// The run goes as if nothing was wrong.
    Whole,
}

const LOG: &str = "a log file";
const TRACE: &str = "the trace";
const REFUSED: &str = "refused";
const WHOLE: &str = "a new file takes the link's place; all files are new";

pub(super) fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    let mut of_each_file = |fault: Fault, logs: &[usize], trace: bool| {
        for (place, files) in [(LOG, logs), (TRACE, if trace { &[4][..] } else { &[] })] {
            for file in files {
                one_file(*file, &fault);
            }
            if !files.is_empty() {
                rows.push(Row {
                    place,
                    fault: fault.name,
                    outcome: fault.reported,
                    runs: files.len(),
                });
            }
        }
    };
    of_each_file(FOLDER, &[0, 1, 2, 3], true);
    of_each_file(FOREIGN, &[0, 1, 2, 3], false);
    of_each_file(READ_ONLY, &[0, 1, 2, 3], true);
    of_each_file(DANGLING, &[0, 1, 2, 3], true);
    of_each_file(PIPE, &[0, 1, 2, 3], false);
    rows.extend([inputs(), own_logs()]);
    rows.extend(FOLDERS.map(folder));
    rows.extend([logs_vanish(), trace_vanishes()]);
    rows.extend([disk_full(), trace_full(), device_full()]);
    rows
}

/// Something stands where a file belongs.
struct Fault {
    name: &'static str,
    arrange: fn(&Path),
    expected: Expected,
    reported: &'static str,
}

const FOLDER: Fault = Fault {
    name: "is a folder",
    arrange: |path| replace(path, |path| fs::create_dir(path)),
    expected: Expected::Refused,
    reported: REFUSED,
};

const FOREIGN: Fault = Fault {
    name: "is from another program, or not a log",
    arrange: |path| replace(path, |path| fs::write(path, "# TITAN.LOG of b.prg\n")),
    expected: Expected::Refused,
    reported: REFUSED,
};

/// The bit holds for everybody here: whoever set it wants to keep the file.
const READ_ONLY: Fault = Fault {
    name: "is read-only",
    arrange: |path| {
        let mut permissions = fs::metadata(path).expect("it exists").permissions();
        permissions.set_readonly(true);
        fs::set_permissions(path, permissions).expect("it is ours");
    },
    expected: Expected::Refused,
    reported: REFUSED,
};

const DANGLING: Fault = Fault {
    name: "is a link that leads nowhere",
    arrange: |path| replace(path, |path| symlink("no/such/file", path)),
    expected: Expected::Whole,
    reported: WHOLE,
};

/// Nobody writes into it: to read its first line would take for ever.
const PIPE: Fault = Fault {
    name: "is a pipe",
    arrange: |path| {
        replace(path, |path| {
            let made = Command::new("mkfifo").arg(path).status()?;
            assert!(made.success());
            Ok(())
        });
    },
    expected: Expected::Refused,
    reported: REFUSED,
};

const ROBOT: &str = "name = \"one\"\njoint = [{ axis = \"y\", link = [0, 0, -100], limits = [-90, 90] }]\n\
                     leg = [{ base = [0, 0, 0] }]\n";

/// Each input as the trace: by its name, by a symbolic link and by a second name.
fn inputs() -> Row {
    let mut runs = 0;
    for input in ["p.prg", "r.toml", "s.toml"] {
        for link in [None, Some("-s"), Some("-P")] {
            let mut bench = Bench::new("input");
            bench.folder = bench.folder.file("r.toml", ROBOT).file("s.toml", "");
            let mut arguments = RUN.to_vec();
            arguments.extend(["--robot", "r.toml", "--scene", "s.toml"]);
            arguments[5] = input;
            if let Some(kind) = link {
                let path = |name| bench.folder.path(name);
                let made = Command::new("ln")
                    .arg(kind)
                    .arg(path(input))
                    .arg(path("link"))
                    .status();
                assert!(made.expect("ln starts").success());
                arguments[5] = "link";
            }
            let before = bench.folder.read(input);
            let outcome = bench.folder.tip(&arguments);
            require_refused(&bench, outcome, &bench.earlier);
            assert_eq!(bench.folder.read(input), before);
            runs += 1;
        }
    }
    Row {
        place: TRACE,
        fault: "is the program, the robot or the scene, or a link to it",
        outcome: REFUSED,
        runs,
    }
}

/// Each log as the trace, there already or not.
fn own_logs() -> Row {
    let mut runs = 0;
    for log in &FILES[..4] {
        for is_there in [true, false] {
            let mut bench = Bench::new("own-log");
            if !is_there {
                fs::remove_file(bench.folder.path(log)).expect("the earlier run wrote it");
                bench.earlier = bench.texts();
            }
            let mut arguments = RUN;
            arguments[5] = log;
            let outcome = bench.folder.tip(&arguments);
            require_refused(&bench, outcome, &bench.earlier);
            runs += 1;
        }
    }
    Row {
        place: TRACE,
        fault: "is one of the run's own logs",
        outcome: REFUSED,
        runs,
    }
}

fn one_file(file: usize, fault: &Fault) {
    let bench = Bench::new("file");
    (fault.arrange)(&bench.folder.path(FILES[file]));
    let before = bench.texts();
    let outcome = bench.folder.tip(&RUN);
    match fault.expected {
        Expected::Refused => require_refused(&bench, outcome, &before),
        Expected::Whole => {
            outcome.expect(3);
            assert_eq!(bench.texts(), bench.later);
        }
    }
    bench.require_no_parts();
}

pub(super) fn require_refused(bench: &Bench, outcome: Outcome, before: &Texts) {
    let outcome = outcome.expect(1);
    require_told(&outcome);
    assert_eq!(outcome.out, "", "no cycle may run");
    assert_eq!(bench.texts(), *before);
}

fn require_told(outcome: &Outcome) {
    let reported = outcome.err.contains("error: cannot write ");
    assert!(reported, "{outcome:#?}");
}

/// A folder whose files nobody can write, not even an administrator.
const FOLDERS: [(&str, &str, [&str; 2]); 4] = [
    (
        "the folder of the logs",
        "cannot be written",
        ["--out-dir", "/proc/self"],
    ),
    (
        "the folder of the logs",
        "its path leads through a file",
        ["--out-dir", "p.prg/logs"],
    ),
    (
        "the folder of the trace",
        "cannot be written",
        ["--trace", "/proc/self/t.jsonl"],
    ),
    (
        "the folder of the trace",
        "is missing, or its path leads through a file",
        ["--trace", "p.prg/t.jsonl"],
    ),
];

fn folder((place, fault, [option, path]): (&'static str, &'static str, [&str; 2])) -> Row {
    let bench = Bench::new("folder");
    let mut arguments = RUN;
    let at = RUN.iter().position(|word| *word == option);
    arguments[at.expect("it is one of the options") + 1] = path;
    let outcome = bench.folder.tip(&arguments);
    require_refused(&bench, outcome, &bench.earlier);
    bench.require_no_parts();
    Row {
        place,
        fault,
        outcome: REFUSED,
        runs: 1,
    }
}

const VANISHES: &str = "is removed during the run";

fn logs_vanish() -> Row {
    let bench = signals::folder_vanishes("logs");
    signals::require_trace(&bench);
    assert!(bench.texts()[..4].iter().all(Option::is_none));
    Row {
        place: "the folder of the logs",
        fault: VANISHES,
        outcome: "reported at the end; the trace is new",
        runs: 1,
    }
}

fn trace_vanishes() -> Row {
    let bench = signals::folder_vanishes("traces");
    let [_, titan, .., trace] = bench.texts();
    assert_eq!(trace, None);
    assert!(titan.is_some_and(|titan| Some(titan) != bench.earlier[1]));
    Row {
        place: "the folder of the trace",
        fault: VANISHES,
        outcome: "reported at the end; the logs are new",
        runs: 1,
    }
}

/// The unit of the shell's `ulimit -f`: bytes.
const BLOCK: usize = 512;

/// A run that can write so many blocks into each file, as if the disk was full then.
fn limited(bench: &Bench, blocks: usize) -> Outcome {
    let mut command = Command::new("sh");
    command
        .args(["-c", &format!("ulimit -f {blocks}; exec \"$0\" \"$@\"")])
        .arg(env!("CARGO_BIN_EXE_tip"))
        .args(RUN)
        .current_dir(bench.folder.path(""))
        .stdin(Stdio::null());
    Outcome::of(command.output().expect("a shell"))
}

fn disk_full() -> Row {
    let healthy = Bench::new("full")
        .later
        .map(|text| text.map_or(0, |text| text.len()));
    let most = healthy.iter().max().expect("five files").div_ceil(BLOCK);
    for blocks in 0..=most {
        let bench = Bench::new("full");
        let outcome = limited(&bench, blocks);
        let fits = healthy.map(|size| size <= blocks * BLOCK);
        if !fits[0] {
            require_refused(&bench, outcome, &bench.earlier);
        } else {
            let all = fits.iter().all(|fits| *fits);
            let outcome = outcome.expect(if all { 3 } else { 1 });
            for (file, text) in bench.texts().iter().enumerate() {
                let wanted = if fits[file] {
                    &bench.later
                } else {
                    &bench.earlier
                };
                assert_eq!(*text, wanted[file], "{} in {blocks} blocks", FILES[file]);
            }
            assert!(
                outcome.err.contains("Invalid Return command"),
                "{outcome:#?}"
            );
            if !all {
                require_told(&outcome);
            }
        }
        bench.require_no_parts();
    }
    Row {
        place: "any file",
        fault: "the disk is full after 0, 512, 1024 … bytes of each",
        outcome: "WARNING.LOG does not fit: refused; any other: reported at the end, the earlier file stays",
        runs: most + 1,
    }
}

/// The trace of a run without end fills any disk.
fn trace_full() -> Row {
    let statements = "LOG_ONE_SHOT\nMESSAGE runs\nL1:\nGOTO L1:\nEND";
    let bench = Bench::endless("trace-full", statements);
    let outcome = limited(&bench, 100).expect(1);
    require_told(&outcome);
    let texts = bench.texts();
    assert_eq!(texts[4], bench.earlier[4]);
    // New logs, and none of those that this run has nothing for.
    let titan = texts[1].as_ref().expect("TITAN.LOG");
    assert_eq!(titan.lines().count(), 3, "{titan}");
    assert_eq!(texts[2..4], [None, None]);
    bench.require_no_parts();
    Row {
        place: TRACE,
        fault: "the disk fills up during the run",
        outcome: "the run ends there; the earlier trace stays, the logs are new; reported at the end",
        runs: 1,
    }
}

fn device_full() -> Row {
    let bench = Bench::new("device");
    let mut arguments = RUN;
    arguments[5] = "/dev/full";
    let outcome = bench.folder.tip(&arguments).expect(1);
    require_told(&outcome);
    assert_eq!(bench.texts()[..4], bench.later[..4]);
    assert_eq!(bench.texts()[4], bench.earlier[4]);
    bench.require_no_parts();
    Row {
        place: TRACE,
        fault: "is a device that accepts no data",
        outcome: "reported at the end; the logs are new",
        runs: 1,
    }
}
