//! The guides of docs/, followed to the letter: their files are written, their commands are run, and what these say is
//! compared.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::{env, fs};

/// The guides, each followed from an empty folder.
const GUIDES: [&str; 2] = ["docs/tutorial.md", "docs/embedding.md"];

/// The workspace, and what the guides call `tip`.
fn workspace() -> PathBuf {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    path.canonicalize().expect("the workspace exists")
}

fn read(guide: &str) -> String {
    let path = workspace().join(guide);
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{guide}: {error}"))
}

/// A code block, and the file that the line before it names.
#[derive(Debug, PartialEq)]
struct Block {
    kind: String,
    file: Option<String>,
    text: String,
}

fn blocks(document: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut named = None;
    let mut lines = document.lines();
    while let Some(line) = lines.next() {
        if let Some(kind) = line.strip_prefix("```") {
            let inside = lines.by_ref().take_while(|line| *line != "```");
            blocks.push(Block {
                kind: kind.to_owned(),
                file: named.take(),
                text: inside.map(|line| format!("{line}\n")).collect(),
            });
        } else if !line.is_empty() {
            let bold = line.strip_prefix("**").and_then(|l| l.strip_suffix("**"));
            named = bold.map(str::to_owned);
        }
    }
    blocks
}

/// The commands of a block, each with the lines that it is to print.
fn commands(text: &str) -> Vec<(&str, Vec<&str>)> {
    let mut commands: Vec<(&str, Vec<&str>)> = Vec::new();
    for line in text.lines() {
        match (line.strip_prefix("$ "), commands.last_mut()) {
            (Some(command), _) => commands.push((command, Vec::new())),
            (None, Some((_, expected))) => expected.push(line),
            (None, None) => panic!("output without a command: {line}"),
        }
    }
    commands
}

/// A line `…` stands for any number of lines, a `…` at the end of a line for its rest.
fn is_as_expected(expected: &[&str], printed: &[&str]) -> bool {
    match (expected, printed) {
        ([], printed) => printed.is_empty(),
        (["…", rest @ ..], printed) => {
            (0..=printed.len()).any(|skipped| is_as_expected(rest, &printed[skipped..]))
        }
        ([line, rest @ ..], [other, others @ ..]) => {
            let same = match line.strip_suffix('…') {
                Some(start) => other.starts_with(start),
                None => line == other,
            };
            same && is_as_expected(rest, others)
        }
        (_, []) => false,
    }
}

/// A reader's terminal: a folder in which nothing but the project is at hand, as `tip`.
struct Terminal {
    start: PathBuf,
    here: PathBuf,
    /// One cargo at a time: it says that it waits for another one.
    _turn: MutexGuard<'static, ()>,
}

impl Terminal {
    /// Outside the workspace, of which a crate inside would be a part; always at the same place, so that cargo knows again
    /// what it has built.
    fn open() -> Self {
        static TURN: Mutex<()> = Mutex::new(());
        let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
        let mut hasher = DefaultHasher::new();
        workspace().hash(&mut hasher);
        let start = env::temp_dir().join(format!("tip-guides-{:x}", hasher.finish()));
        let _ = fs::remove_dir_all(&start);
        fs::create_dir_all(&start).expect("a folder for temporary files");
        std::os::unix::fs::symlink(workspace(), start.join("tip")).expect("a link");
        let here = start.clone();
        Terminal {
            start,
            here,
            _turn: turn,
        }
    }

    fn write(&self, file: &str, text: &str) {
        fs::write(self.here.join(file), text).expect("its folder exists");
        if file == "Cargo.toml" {
            // The versions of the workspace, so that nothing is downloaded.
            let lock = workspace().join("Cargo.lock");
            fs::copy(lock, self.here.join("Cargo.lock")).expect("a lock file");
        }
    }

    /// Everything that the command prints.
    fn run(&mut self, command: &str) -> String {
        if let Some(folder) = command.strip_prefix("cd ") {
            self.here.push(folder);
            return String::new();
        }
        let tip = Path::new(env!("CARGO_BIN_EXE_tip"));
        let beside = tip.parent().expect("a folder").to_owned();
        let path = env::var_os("PATH").unwrap_or_default();
        let path = [beside].into_iter().chain(env::split_paths(&path));
        let output = Command::new("sh")
            .args(["-c", &format!("exec 2>&1; {command}")])
            .current_dir(&self.here)
            .env("PATH", env::join_paths(path).expect("a search path"))
            // The language is English, whoever runs the tests.
            .env("LC_ALL", "C")
            .env("CARGO_NET_OFFLINE", "true")
            .env("CARGO_TERM_COLOR", "never")
            // Shared with the other crates outside the workspace that tests build, in tests/language/tests/it/outside.rs.
            .env(
                "CARGO_TARGET_DIR",
                Path::new(env!("CARGO_TARGET_TMPDIR")).join("nested"),
            )
            .env("CARGO_PROFILE_DEV_DEBUG", "false")
            .env("CARGO_INCREMENTAL", "0")
            .stdin(Stdio::null())
            .output()
            .expect("a shell");
        String::from_utf8(output.stdout).expect("output is UTF-8")
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.start);
    }
}

#[test]
fn what_the_guides_show_is_what_happens() {
    let mut terminal = Terminal::open();
    for guide in GUIDES {
        terminal.here = terminal.start.clone();
        let compared = follow(&mut terminal, guide);
        assert!(compared > 10, "{guide}: {compared} commands");
    }
    // The guides make a crate for titan8; what others do differently is compiled here.
    for (robot, ends) in [
        ("hand", "the cylinder is 39 mm above the floor"),
        ("hexapod", "1320 mm forward, 0 falls"),
        // A described robot has a gait, which keys steer ahead, then to the right.
        ("tip/tipc/tests/robots/hexapod.toml", ""),
    ] {
        made_for(&mut terminal, robot, ends);
    }
}

/// A crate that `tip new` makes moves its robot, and passes its test, without a warning.
fn made_for(terminal: &mut Terminal, robot: &str, ends: &str) {
    terminal.here = terminal.start.clone();
    let name = if robot.ends_with(".toml") {
        "ours"
    } else {
        robot
    };
    let made = terminal.run(&format!("tip new {name} --robot {robot} --workspace tip"));
    assert!(made.ends_with("  cargo run\n"), "{made}");
    terminal.run(&format!("cd {name}"));
    let run = terminal.run("cargo run --quiet");
    let last = run.lines().last().unwrap_or_default();
    if ends.is_empty() {
        let mut lines = run.lines();
        let forward =
            lines.find_map(|line| line.split_once(" mm forward, ")?.0.parse::<f64>().ok());
        assert!(forward.is_some_and(|mm| mm > 100.0), "{robot}: {run}");
        assert!(
            last.ends_with(" deg to the right, 0 falls"),
            "{robot}: {run}"
        );
    }
    assert!(
        last.starts_with(ends) && !run.contains("warning"),
        "{robot}: {run}"
    );
    let tested = terminal.run("cargo test --quiet");
    let passed = "test result: ok. 1 passed; 0 failed";
    assert!(
        tested.contains(passed) && !tested.contains("warning"),
        "{robot}: {tested}"
    );
}

/// The program that `tip new --hardware` writes for servos on a bus moves simulated ones to the end of the motion, passes its test, and
/// ends with the status of a signal.
#[test]
fn a_made_crate_moves_its_servos() {
    let mut terminal = Terminal::open();
    let made = terminal.run("tip new six --robot phantomx --hardware --workspace tip");
    assert!(made.contains("  src/bin/drive.rs\n"), "{made}");
    terminal.run("cd six");
    let tested = terminal.run("cargo test --quiet --test hardware");
    let passed = "test result: ok. 1 passed; 0 failed";
    assert!(
        tested.contains(passed) && !tested.contains("warning"),
        "{tested}"
    );
    let first = "3.1\nThe first posture\nINITIAL_POSTURE\nWAIT_INPOS ALL\n";
    terminal.write("motions/walk.prg", &format!("{first}SLEEP 2000\nEND\n"));
    let run = terminal.run("cargo run --quiet --bin drive; echo status $?");
    let lines: Vec<&str> = run.lines().collect();
    let [cycles, "status 0"] = lines[..] else {
        panic!("{run}");
    };
    let cycles = cycles
        .strip_suffix(" cycles")
        .and_then(|n| n.parse::<u32>().ok());
    assert!(cycles.is_some_and(|it| (100..500).contains(&it)), "{run}");
    terminal.write(
        "motions/walk.prg",
        &format!("{first}STAND:\nGOTO STAND:\nEND\n"),
    );
    terminal.run("cargo build --quiet --bin drive");
    let nowhere = terminal.run("$CARGO_TARGET_DIR/debug/drive /dev/nowhere; echo status $?");
    let said = "/dev/nowhere: No such file or directory (os error 2)\nstatus 1\n";
    assert_eq!(nowhere, said);
    for (signal, status) in [("TERM", 143), ("INT", 130), ("HUP", 129)] {
        // Long enough for the first posture on a busy machine.
        let limited = format!("timeout --preserve-status --signal {signal} 5");
        let run = terminal.run(&format!(
            "{limited} $CARGO_TARGET_DIR/debug/drive; echo status $?"
        ));
        let ended = format!(" cycles\nstatus {status}\n");
        assert!(run.ends_with(&ended), "{signal}: {run}");
    }
}

/// Does what a guide says; returns how many commands it has run.
fn follow(terminal: &mut Terminal, guide: &str) -> usize {
    let mut compared = 0;
    for block in blocks(&read(guide)) {
        match (&*block.kind, &block.file) {
            ("console", None) => {
                for (command, expected) in commands(&block.text) {
                    let printed = terminal.run(command);
                    let lines: Vec<&str> = printed.lines().collect();
                    assert!(
                        is_as_expected(&expected, &lines),
                        "{guide}:\n$ {command}\n{printed}\nexpected:\n{}",
                        expected.join("\n")
                    );
                    compared += 1;
                }
            }
            ("tip" | "toml" | "rust", Some(file)) => terminal.write(file, &block.text),
            // How to get the project, and drawings.
            ("sh" | "text", None) => {}
            _ => panic!("{guide}: neither a file nor a command: {block:#?}"),
        }
    }
    compared
}

/// A translation shows the same files and commands; drawings may hold words.
#[test]
fn the_japanese_pages_have_the_same_blocks() {
    let shown = |page: &str| {
        let mut blocks = blocks(&read(page));
        blocks.retain(|block| block.kind != "text");
        assert!(blocks.len() > 5, "{page}");
        blocks
    };
    for (page, translation) in [
        ("README.md", "README.ja.md"),
        ("docs/tutorial.md", "docs/tutorial.ja.md"),
    ] {
        assert_eq!(shown(translation), shown(page));
    }
}

/// Both front pages list the same examples, each of them with a page of its own.
#[test]
fn the_front_pages_list_the_same_examples() {
    let listed = |page: &str| -> Vec<String> {
        let text = read(page);
        let rows = text.lines().filter_map(|line| {
            let (name, rest) = line.strip_prefix("| [`")?.split_once("`](examples/")?;
            rest.starts_with(&format!("{name})"))
                .then(|| name.to_owned())
        });
        rows.collect()
    };
    let examples = listed("README.md");
    assert!(examples.len() > 8, "{examples:?}");
    assert_eq!(listed("README.ja.md"), examples);
    for example in examples {
        read(&format!("examples/{example}/README.md"));
    }
}

#[test]
fn left_out_lines_are_any_and_others_are_not() {
    let matches = |expected: &str, printed: &str| {
        let expected: Vec<_> = expected.lines().collect();
        is_as_expected(&expected, &printed.lines().collect::<Vec<_>>())
    };
    assert!(matches("a\n…\nd 1…", "a\nb\nc\nd 12"));
    assert!(matches("a\n…", "a"));
    for printed in ["a\nd 2", "b\nd 1", "a\nd 1\ne", ""] {
        assert!(!matches("a\n…\nd 1…", printed), "{printed}");
    }
}

#[test]
fn the_programs_of_the_tutorial_are_in_the_standard_style() {
    let folder = crate::support::Folder::new("guides-style");
    let mut count = 0;
    for guide in ["docs/tutorial.md", "docs/tutorial.ja.md"] {
        for block in blocks(&read(guide))
            .iter()
            .filter(|block| block.kind == "tip")
        {
            let Some(name) = block.file.as_deref().filter(|name| name.ends_with(".prg")) else {
                continue;
            };
            fs::create_dir_all(folder.path("motions")).expect("the folder is writable");
            fs::write(folder.path(name), &block.text).expect("the folder is writable");
            let outcome = folder.tip(&["fmt", "--check", name]);
            assert_eq!(
                (outcome.status, outcome.out.as_str()),
                (0, ""),
                "{guide}: {name}"
            );
            count += 1;
        }
    }
    assert_eq!(count, 12);
}
