//! Unfinished files and others of their names: a run writes each file under another name first.

use super::Row;
use super::bench::{Bench, FILES, RUN};
use super::files::require_refused;
use std::fs::{self, Permissions};
use std::io::Write;
use std::os::unix::fs::PermissionsExt;
use std::process::Command;
use tip_runtime::record::AtomicFile;

const ANY: &str = "any file";
const TRACE: &str = "the trace";

pub(super) fn rows() -> Vec<Row> {
    vec![planted(), equal_ids(), modes(), long_name(), longer_name()]
}

/// A link to somebody's file at the name that the process id gives, made by the process itself before it becomes `tip`.
fn planted() -> Row {
    let bench = Bench::new("planted");
    bench_file(&bench, "victim");
    let plant = FILES.map(|file| {
        let (folder, name) = file.split_once('/').expect("in a folder");
        format!("ln -s ../victim {folder}/.{name}.$$.part; ln -s ../victim {folder}/.tip-$$.part")
    });
    let script = format!("{}; exec \"$0\" \"$@\"", plant.join("; "));
    let mut command = Command::new("sh");
    command
        .args(["-c", &script, env!("CARGO_BIN_EXE_tip")])
        .args(RUN);
    let status = command
        .current_dir(bench.folder.path("."))
        .output()
        .expect("a shell")
        .status;
    assert_eq!(status.code(), Some(3));
    assert_eq!(bench.folder.read("victim"), "victim");
    assert_eq!(bench.texts(), bench.later);
    Row {
        place: ANY,
        fault: "a link to somebody's file is planted at each name that its process id gives",
        outcome: "all files are new; the link and its file stay",
        runs: 1,
    }
}

fn bench_file(bench: &Bench, name: &str) {
    fs::write(bench.folder.path(name), name).expect("the folder is writable");
}

/// Two writers of one process have one id, as two containers may.
fn equal_ids() -> Row {
    let bench = Bench::new("equal-ids");
    let runs = FILES.len();
    for file in FILES {
        let path = bench.folder.path(file);
        let texts = ["one ".repeat(5_000), "two ".repeat(7_000)];
        let mut writers = [(); 2].map(|()| AtomicFile::create(&path).expect("it is writable"));
        for at in (0..28_000).step_by(1_000) {
            for (writer, text) in writers.iter_mut().zip(&texts) {
                let piece = text.get(at..at + 1_000).unwrap_or_default();
                writer.write_all(piece.as_bytes()).expect("it is writable");
            }
        }
        for (writer, text) in writers.into_iter().zip(&texts) {
            writer.commit().expect("it is writable");
            assert!(bench.folder.read(file) == *text, "{file} is torn");
        }
    }
    bench.require_no_parts();
    Row {
        place: ANY,
        fault: "is written by two at once whose process ids are equal",
        outcome: "the last one's, complete",
        runs,
    }
}

fn modes() -> Row {
    let modes = [0o600, 0o640, 0o755];
    for mode in modes {
        let bench = Bench::new("mode");
        for file in FILES {
            let path = bench.folder.path(file);
            fs::set_permissions(path, Permissions::from_mode(mode)).expect("it is ours");
        }
        bench.folder.tip(&RUN).expect(3);
        assert_eq!(bench.texts(), bench.later);
        for file in FILES {
            let found = fs::metadata(bench.folder.path(file)).expect("it is there");
            assert_eq!(found.permissions().mode() & 0o7777, mode, "{file}");
        }
    }
    Row {
        place: ANY,
        fault: "has mode 600, 640 or 755",
        outcome: "all files are new, with that mode",
        runs: modes.len(),
    }
}

fn named(length: usize) -> (Bench, String) {
    (Bench::new("long"), format!("traces/{}", "n".repeat(length)))
}

fn long_name() -> Row {
    let (bench, name) = named(255);
    let mut arguments = RUN;
    arguments[5] = &name;
    for _ in 0..2 {
        bench.folder.tip(&arguments).expect(3);
        assert_eq!(Some(bench.folder.read(&name)), bench.later[4]);
    }
    assert_eq!(bench.texts()[..4], bench.later[..4]);
    Row {
        place: TRACE,
        fault: "has a name of 255 bytes, which is as long as a name may be",
        outcome: "all files are new",
        runs: 2,
    }
}

fn longer_name() -> Row {
    let (bench, name) = named(256);
    let mut arguments = RUN;
    arguments[5] = &name;
    let outcome = bench.folder.tip(&arguments);
    require_refused(&bench, outcome, &bench.earlier);
    bench.require_no_parts();
    Row {
        place: TRACE,
        fault: "has a longer name",
        outcome: "refused",
        runs: 1,
    }
}
