//! Every command line that help texts and documents print is run, and ends.

use crate::support::{Folder, process};
use rustix::process::{Pid, Signal, kill_process};
use std::collections::BTreeSet;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs, thread};

/// Nothing takes so long, on however busy a machine.
const PATIENCE: Duration = Duration::from_secs(300);

/// Documents that other tests follow line by line.
const FOLLOWED: [&str; 4] = [
    "docs/commands.md",
    "docs/embedding.md",
    "docs/tutorial.md",
    "docs/tutorial.ja.md",
];

/// A simulator of a robot that replaces Python.
const SIMULATOR: &str = r#"#!/bin/sh
readings='"loads":[10,20,30,40],"pose":[0,0,200,0,0,0]'
# The value of a field that is a list.
list() { value=${line#*"\"$1\":"}; value="${value%%]*}]"; }
while read -r line; do
  case $line in
    *'"type":"hello"'*)
      list initial
      echo "{\"version\":2,\"angles\":$value,$readings}" ;;
    *'"type":"cycle"'*)
      n=${line#*'"n":'}
      list targets
      echo "{\"n\":${n%%[,\}]*},\"angles\":$value,$readings}" ;;
    *'"type":"bye"'*) exit 0 ;;
  esac
done
"#;

fn workspace() -> PathBuf {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    path.canonicalize().expect("the workspace exists")
}

fn read(path: &str) -> String {
    fs::read_to_string(workspace().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The files that the lines name.
fn provide(folder: &Folder, line: &str) {
    let hexapod = read("examples/six-legs/hexapod.toml");
    let is_hexapod = line.contains("--hardware") || line.contains("--robot robot.toml");
    let walk = read(match is_hexapod {
        true => "examples/six-legs/motions/tripod.prg",
        false => "examples/walk/motions/walk.prg",
    });
    let march = match line.contains("phantomx") {
        // Its gait in `examples` is steered, and does not end.
        true => "3.1\nlift\nREL_PTP F1 0 0 30\nWAIT_INPOS F1\nEND\n".to_owned(),
        false => read("examples/six-legs/motions/tripod.prg"),
    };
    let files = [
        ("walk.prg", walk.as_str()),
        ("motions/walk.prg", &walk),
        ("turn.prg", "3.1\nturn\nSTAND_UP 60\nEND\n"),
        ("step.prg", &walk),
        ("faster.prg", &walk),
        ("ask.prg", "3.1\nask\nDEF_VAR K\nKEY_IN K\nKEY_IN K\nEND\n"),
        (
            "sense.prg",
            "3.1\nsense\nDEF_VAR V\nAD_IN VR1 V\nAD_IN PAW1 V\nEND\n",
        ),
        ("old.prg", "2.0\nwalk\nVAR01 = - 5\nSTAND_UP VAR01\nEND\n"),
        ("march.prg", &march),
        ("hexapod.toml", &hexapod),
        ("robots/ours.toml", &hexapod),
        ("robot.toml", &with_bus(&hexapod)),
        ("steps.toml", "[floor]\nfriction = 0.9\n"),
        ("grasp.prg", &read("examples/grasp/motions/grasp.prg")),
        (
            "motions/grasp.prg",
            &read("examples/grasp/motions/grasp.prg"),
        ),
        ("scene.toml", &read("examples/grasp/scene.toml")),
        ("bin/python3", SIMULATOR),
    ];
    for (name, text) in files {
        let path = folder.path(name);
        path.parent().map(fs::create_dir_all);
        fs::write(path, text).expect("the folder is writable");
    }
    for name in [
        ".local/share/bash-completion/completions",
        ".zfunc",
        ".config/fish/completions",
        ".local/share/man/man1",
    ] {
        fs::create_dir_all(folder.path(name)).expect("the folder is writable");
    }
    let mode = std::os::unix::fs::PermissionsExt::from_mode(0o755);
    fs::set_permissions(folder.path("bin/python3"), mode).expect("it is ours");
    for (shared, name) in [("examples", "examples"), ("tests", "tests"), ("", "../tip")] {
        let (target, link) = (workspace().join(shared), folder.path(name));
        // One from another checkout may be there.
        if fs::read_link(&link).is_ok_and(|found| found != target) {
            let _ = fs::remove_file(&link);
        }
        // Another test may make the same one.
        let _ = std::os::unix::fs::symlink(target, &link);
        assert!(link.exists(), "{name}");
    }
    if !folder.has("walk.jsonl") {
        let run =
            "run examples/walk/motions/walk.prg --cycles 100 -q --trace walk.jsonl --trace-motion";
        let words: Vec<&str> = run.split(' ').collect();
        folder.tip(&words).expect(0);
    }
    if !folder.has("runs.csv") {
        let sweep = "sweep examples/walk/motions/walk.prg --vary STRIDE=160..240/20 --cycles 1 -q -o runs.csv";
        let words: Vec<&str> = sweep.split(' ').collect();
        folder.tip(&words).expect(0);
    }
}

/// The hexapod with simulated servos.
fn with_bus(hexapod: &str) -> String {
    let mut text = format!("{hexapod}\n[bus]\nport = \"simulated\"\nservo = \"STS3215\"\n");
    for id in 0..18 {
        let joint = format!("J{}{}", id / 3 + 1, id % 3 + 1);
        text += &format!("[[drive]]\njoint = \"{joint}\"\nid = {id}\n");
    }
    text
}

/// Runs a line in a folder as a shell does; its exit status and all that it printed.
fn run(folder: &Folder, line: &str) -> (i32, String) {
    let tip = Path::new(env!("CARGO_BIN_EXE_tip"));
    let first = [
        folder.path("bin"),
        tip.parent().expect("a folder").to_owned(),
    ];
    let path = env::var_os("PATH").unwrap_or_default();
    let path = env::join_paths(first.into_iter().chain(env::split_paths(&path)));
    let mut command = process("sh");
    command
        .args(["-c", &format!("exec 2>&1; {line}")])
        .current_dir(folder.path(""))
        .env("PATH", path.expect("folders"))
        .env("HOME", folder.path(""))
        .env("LC_ALL", "C")
        .stdin(Stdio::null())
        .stdout(Stdio::piped());
    let mut child = command.spawn().expect("a shell");
    let mut output = BufReader::new(child.stdout.take().expect("a pipe"));
    let mut text = String::new();
    if goes_on(line) {
        output.read_line(&mut text).expect("UTF-8");
        kill_process(Pid::from_child(&child), Signal::INT).expect("it runs");
    }
    let rest = thread::spawn(move || {
        let mut rest = String::new();
        output.read_to_string(&mut rest).expect("UTF-8");
        rest
    });
    let status = end(&mut child, line);
    (status, text + &rest.join().expect("no panic"))
}

/// Waits for the end of a line that has one.
fn end(child: &mut Child, line: &str) -> i32 {
    let begin = Instant::now();
    loop {
        if let Some(status) = child.try_wait().expect("it was started") {
            return status.code().unwrap_or(130);
        }
        if begin.elapsed() > PATIENCE {
            let _ = child.kill();
            panic!("does not end: {line}");
        }
        thread::sleep(Duration::from_millis(5));
    }
}

/// Returns true if a line ends only by Ctrl-C.
fn goes_on(line: &str) -> bool {
    let is_bus =
        line.contains("tip drives simulate") || line.ends_with("tip drives monitor robot.toml");
    line.contains("tip serve") || line.contains("--watch") || is_bus
}

/// The exit statuses that a line may have.
fn statuses(line: &str) -> &'static [i32] {
    match line {
        _ if goes_on(line) => &[130],
        // Some of the files are not in order.
        _ if line.contains("*.prg") || line.contains("--diff") => &[0, 1],
        // Its client has gone.
        _ if line == "tip lsp" => &[0, 1],
        // There is no such port, or no keyboard, or nobody turns the joints.
        _ if [
            "/dev/tty",
            "tip drives jog",
            "tip drives record",
            "tip drives zero",
        ]
        .iter()
        .any(|it| line.contains(it)) =>
        {
            &[1]
        }
        // Only a release has the page.
        _ if line.contains("tip playground") => &[1],
        // It needs a terminal.
        _ if line.contains("tip debug") => &[1, 2],
        _ => &[0],
    }
}

/// Returns true if only the arguments of a line are checked: it would compile a crate, or names a file of the reader's own.
fn is_ours_to_parse(line: &str) -> bool {
    line.contains("tip verify")
        || (line.contains("tip robot import") && !line.contains("examples/"))
        || line.contains("go1.toml")
}

/// A line as it is run here: not for ever, at no port of anyone else's, without what is not tip.
fn prepared(line: &str) -> String {
    let line = line.split(" && cd ").next().unwrap_or_default();
    let line = line.replace("0.0.0.0:8000", "127.0.0.1:0");
    let line = line.replace("--realtime", "--realtime --cycles 20");
    // The table of another line may be there.
    let line = match line.contains("--resume") {
        true => line,
        false => line.replace("tip sweep ", "tip sweep --force "),
    };
    // The process is asked to end, not the shell.
    match goes_on(&line) {
        true => format!("exec {line}"),
        false => line,
    }
}

fn check(folder: &Folder, source: &str, line: &str) {
    provide(folder, line);
    let line = prepared(line);
    if is_ours_to_parse(&line) {
        let elsewhere = Folder::new(&format!("printed/nowhere-{}", source.ends_with(".md")));
        let (status, text) = run(&elsewhere, &line);
        assert_eq!(status, 1, "{source}: {line}\n{text}");
        return;
    }
    for made in ["demo", "grasper", "six", "ours", "drives", "hexa"] {
        let _ = fs::remove_dir_all(folder.path(made));
    }
    let (status, text) = run(folder, &line);
    assert!(
        statuses(&line).contains(&status),
        "{source}: {status} from {line}\n{text}"
    );
    assert!(
        !text.contains("without a motion"),
        "{source}: {line} waits\n{text}"
    );
}

/// Each command with those of its own.
fn commands() -> Vec<Vec<String>> {
    let folder = Folder::new("printed-commands");
    let listed = |words: &[&str]| -> Vec<String> {
        let outcome = folder.tip(&[words, &["--help"]].concat()).expect(0);
        if !outcome.out.contains("<COMMAND>") {
            return Vec::new();
        }
        // Groups of commands, each below its heading, are above the options.
        let rows = outcome.out.lines().take_while(|line| *line != "Options:");
        let names = rows.filter_map(|row| row.strip_prefix("  ")?.split(' ').next());
        let names = names.filter(|name| !name.is_empty() && *name != "help");
        names.map(str::to_owned).collect()
    };
    let mut all = vec![Vec::new()];
    for name in listed(&[]) {
        all.push(vec![name.clone()]);
        all.extend(
            listed(&[&name])
                .into_iter()
                .map(|own| vec![name.clone(), own]),
        );
    }
    all
}

#[test]
fn every_line_of_every_help_ends() {
    let mut seen = BTreeSet::new();
    let mut count = 0;
    for command in commands() {
        let words: Vec<&str> = command.iter().map(String::as_str).collect();
        let folder = Folder::new("printed/help");
        let help = folder.tip(&[&["help"], &words[..]].concat()).expect(0);
        let lines = help
            .out
            .lines()
            .filter_map(|line| line.strip_prefix("  tip "));
        for line in lines {
            // Two blanks begin a remark.
            let line = format!("tip {}", line.split("  ").next().unwrap_or_default());
            if seen.insert(line.clone()) {
                check(&folder, &command.join(" "), &line);
                count += 1;
            }
        }
    }
    assert!(count > 60, "{count} lines");
}

#[test]
fn every_line_of_every_document_ends() {
    let mut count = 0;
    for document in documents() {
        let text = read(&document);
        let folder = Folder::new("printed/document");
        for line in lines(&text) {
            check(&folder, &document, &line);
            count += 1;
        }
    }
    assert!(count > 30, "{count} lines");
}

fn documents() -> Vec<String> {
    let root = workspace();
    let mut all: Vec<String> = ["README.md", "README.ja.md", "tools/cli/README.md"]
        .map(str::to_owned)
        .to_vec();
    for folder in ["docs", "examples"] {
        let entries = fs::read_dir(root.join(folder)).expect("it is there");
        for entry in entries {
            let name = entry.expect("readable").file_name();
            let name = name.to_str().expect("UTF-8");
            let path = match folder {
                "docs" => format!("docs/{name}"),
                _ => format!("examples/{name}/README.md"),
            };
            if path.ends_with(".md") && root.join(&path).exists() {
                all.push(path);
            }
        }
    }
    all.retain(|path| !FOLLOWED.contains(&path.as_str()));
    all.sort();
    all
}

/// The lines of code blocks that are commands, and commands in the text that name a file.
fn lines(text: &str) -> Vec<String> {
    let mut all = Vec::new();
    let mut is_code = false;
    for line in text.lines() {
        if line.starts_with("```") {
            is_code = !is_code;
        } else if is_code {
            let line = line.strip_prefix("$ ").unwrap_or(line);
            let line = line.split(" #").next().unwrap_or_default().trim();
            if line.starts_with("tip ") {
                all.push(line.to_owned());
            }
        } else {
            let spans = line.split('`').skip(1).step_by(2);
            let spans = spans.filter(|span| span.starts_with("tip ") && names_a_file(span));
            all.extend(spans.map(str::to_owned));
        }
    }
    all
}

/// Returns true if a command names a program or a description that exists, not a placeholder such as FILE.toml.
fn names_a_file(line: &str) -> bool {
    let has_place = line.split(' ').any(|word| {
        let letters = word.chars().filter(char::is_ascii_alphabetic);
        !word.starts_with('-')
            && letters.clone().count() > 2
            && word.chars().take(3).all(|c| c.is_ascii_uppercase())
    });
    let second = line.split(' ').nth(2).unwrap_or_default();
    !has_place
        && !line.contains('…')
        && (second.ends_with(".prg") || line.contains(" robot check "))
}
