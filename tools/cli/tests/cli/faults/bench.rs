//! A folder in which a program has run, and runs again when something is wrong.

use crate::support::Folder;
use std::fs;
use std::path::Path;
use std::sync::OnceLock;

/// The files of a run of the bench.
pub(super) const FILES: [&str; 5] = [
    "logs/WARNING.LOG",
    "logs/TITAN.LOG",
    "logs/VARIABLES.LOG",
    "logs/EMG.log",
    "traces/t.jsonl",
];

/// The command that writes them.
pub(super) const RUN: [&str; 6] = [
    "run",
    "p.prg",
    "--out-dir",
    "logs",
    "--trace",
    "traces/t.jsonl",
];

/// The text of each file; none of one that is no readable file.
pub(super) type Texts = [Option<String>; FILES.len()];

/// Ends by a fault, so that there is something to write into each file; other things for another name and time (ms).
fn short((name, time): (&str, u32)) -> String {
    format!(
        "DEF_VAR {name}, UNUSED_{name}\n{name} = 1\nLOG_START\nMESSAGE runs\nPTP_ANGLE J11 5\nSLEEP {time}\n\
         OUTPUT_VARIABLES\nRETURN\nEND"
    )
}

static TEXTS: OnceLock<(Texts, Texts)> = OnceLock::new();

const EARLIER: (&str, u32) = ("EARLIER", 100);
const LATER: (&str, u32) = ("LATER", 140);

pub(super) struct Bench {
    pub(super) folder: Folder,
    /// As the earlier run left them.
    pub(super) earlier: Texts,
    /// As the next run leaves them without a fault.
    pub(super) later: Texts,
}

impl Bench {
    pub(super) fn new(name: &str) -> Self {
        let (earlier, later) = TEXTS.get_or_init(written).clone();
        let mut folder = Folder::new(&format!("faults-{name}"));
        for (file, text) in FILES.iter().zip(&earlier) {
            folder = folder.file(file, text.as_deref().unwrap_or_default());
        }
        let folder = folder.program("p.prg", &short(LATER));
        Bench {
            folder,
            earlier,
            later,
        }
    }

    /// The next run is one of these statements, and never ends.
    pub(super) fn endless(name: &str, statements: &str) -> Self {
        let mut bench = Self::new(name);
        bench.folder = bench.folder.program("p.prg", statements);
        bench
    }

    pub(super) fn texts(&self) -> Texts {
        texts(&self.folder)
    }

    /// Nothing is in the folders but the five files.
    pub(super) fn require_no_parts(&self) {
        for folder in ["logs", "traces"] {
            let Ok(entries) = fs::read_dir(self.folder.path(folder)) else {
                continue;
            };
            for entry in entries {
                let entry = entry.expect("readable").path();
                let name = entry.file_name().unwrap_or_default().to_string_lossy();
                let name = format!("{folder}/{name}");
                assert!(FILES.contains(&name.as_str()), "{name} is left");
            }
        }
    }
}

/// Returns the files of runs without faults.
fn written() -> (Texts, Texts) {
    let texts = [EARLIER, LATER].map(|program| {
        let folder = Folder::new("faults-none").program("p.prg", &short(program));
        let folder = folder.file("traces/t.jsonl", "");
        folder.tip(&RUN).expect(3);
        texts(&folder)
    });
    let [earlier, later] = texts;
    for (earlier, later) in earlier.iter().zip(&later) {
        assert!(earlier.is_some() && later.is_some());
        assert_ne!(earlier, later, "they could not be told apart");
    }
    (earlier, later)
}

fn texts(folder: &Folder) -> Texts {
    // To open a pipe would take for ever.
    let text = |path: &Path| path.is_file().then(|| fs::read_to_string(path).ok());
    FILES.map(|file| text(&folder.path(file)).flatten())
}

/// Puts something else where a file of an earlier run was.
pub(super) fn replace(path: &Path, by: impl FnOnce(&Path) -> std::io::Result<()>) {
    fs::remove_file(path).expect("the earlier run wrote it");
    by(path).expect("the folder is writable");
}
