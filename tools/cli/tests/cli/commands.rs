//! The lines of docs/commands.md that a reader is invited to try.

use crate::support::{Folder, Outcome};
use std::path::Path;
use std::{env, fs};

/// An entry's names, the line to try, and the program that it runs.
struct Entry {
    names: Vec<String>,
    line: String,
    file: String,
    program: String,
}

#[test]
fn every_line_to_try_shows_what_its_words_do() {
    let folder = Folder::new("commands");
    let entries = entries();
    assert!(entries.len() > 80, "{} entries", entries.len());
    for Entry {
        names,
        line,
        file,
        program,
    } in entries
    {
        let shown = |program: &str| tried(&folder, &line, &file, program);
        let outcome = shown(&program).expect(0);
        assert!(!outcome.out.trim().is_empty(), "{line} shows nothing");
        let without = shown(&without(&names, &program));
        assert_ne!(
            outcome.out, without.out,
            "{line} shows as much without {names:?}"
        );
    }
}

/// Returns the output of the line with this text as its program.
fn tried(folder: &Folder, line: &str, file: &str, program: &str) -> Outcome {
    let path = folder.path(file);
    path.parent().map(fs::create_dir_all);
    fs::write(&path, program).expect("the folder is writable");
    let beside = Path::new(env!("CARGO_BIN_EXE_tip"))
        .parent()
        .expect("a folder");
    let paths = env::var_os("PATH").unwrap_or_default();
    let paths = [beside.to_owned()]
        .into_iter()
        .chain(env::split_paths(&paths));
    let output = std::process::Command::new("sh")
        .args(["-c", line])
        .current_dir(folder.path(""))
        .env("PATH", env::join_paths(paths).expect("folders"))
        .output();
    Outcome::of(output.expect("sh starts"))
}

/// The program without the statements that have one of these words. One that does not load any more shows nothing.
fn without(names: &[String], program: &str) -> String {
    let has_one = |line: &str| {
        let code = line.split("//").next().unwrap_or_default();
        let words = code.split(|c: char| !c.is_ascii_alphanumeric() && !matches!(c, '_' | '@'));
        let tokens = code.split_whitespace();
        words
            .chain(tokens)
            .any(|word| names.iter().any(|name| name == word))
    };
    let kept = program
        .lines()
        .enumerate()
        .filter(|(number, line)| *number < 2 || !has_one(line));
    kept.map(|(_, line)| format!("{line}\n")).collect()
}

/// A heading is a word of the language, but for two.
fn words(heading: &str) -> Vec<&str> {
    match heading {
        "Assignment" => vec!["+=", "-=", "*=", "/="],
        "Operators" => vec!["+", "-", "*", "/"],
        word => vec![word],
    }
}

fn entries() -> Vec<Entry> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |path: &str| {
        fs::read_to_string(root.join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
    };
    let mut names = Vec::new();
    let mut entries = Vec::new();
    for line in read("docs/commands.md").lines() {
        if let Some(heading) = line.strip_prefix("### ") {
            names = heading
                .split(", ")
                .flat_map(words)
                .map(str::to_owned)
                .collect();
        } else if let Some(line) = line
            .strip_prefix("- Try it: `")
            .and_then(|rest| rest.strip_suffix('`'))
        {
            let file = line
                .split_whitespace()
                .nth(2)
                .expect("tip run FILE")
                .to_owned();
            entries.push(Entry {
                names: std::mem::take(&mut names),
                line: line.to_owned(),
                program: read(&file),
                file,
            });
        }
    }
    entries
}
