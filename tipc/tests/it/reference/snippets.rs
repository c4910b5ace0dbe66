//! Programs and shell lines in documents: a block ```` ```tip ```` loads without a diagnostic, for TITAN VIII or the robot
//! behind `tip`; a program in a Rust string too; and what a shell line names exists.

use crate::reference::{documents, read, workspace};
use tipc::{Options, Robot};

#[test]
fn programs_in_documents_load() {
    let mut programs = 0;
    for document in documents() {
        for Block { kind, text } in blocks(&read(&document)) {
            let mut words = kind.split_whitespace();
            let robot = match words.next() {
                Some("tip") => words.next().unwrap_or("titan8"),
                Some("rust") => {
                    programs += strings(&text)
                        .map(|text| loads(&document, &text, "titan8"))
                        .count();
                    continue;
                }
                _ => {
                    assert!(
                        !text.starts_with("3."),
                        "{document}: mark it as `tip`:\n{text}"
                    );
                    continue;
                }
            };
            loads(&document, &text, robot);
            programs += 1;
        }
    }
    assert!(programs > 80, "{programs} programs");
}

fn loads(document: &str, program: &str, robot: &str) {
    let robot = Robot::from_name(robot).unwrap_or_else(|| panic!("{document}: no robot {robot}"));
    let options = Options {
        robot,
        ..Options::default()
    };
    let loaded = tipc::load("document.prg", program.as_bytes(), &options);
    assert_eq!(loaded.diagnostics, [], "{document}:\n{program}");
}

#[test]
fn what_shell_lines_name_exists() {
    for document in documents() {
        let folder = match document.rsplit_once('/') {
            Some((folder, _)) if folder != "docs" => folder,
            _ => "",
        };
        let shell = blocks(&read(&document)).into_iter();
        for Block { text, .. } in shell.filter(|block| block.kind == "sh") {
            for line in text.lines() {
                let words: Vec<&str> = line.split_whitespace().collect();
                let pairs = words.windows(2);
                // The values of a range have a `/`, too; what is in target is built first.
                let pairs =
                    pairs.filter(|pair| pair[0] != "--vary" && !pair[1].starts_with("target/"));
                let named = pairs.filter(|pair| pair[0] == "--path" || pair[1].contains('/'));
                for path in named.map(|pair| pair[1]) {
                    let here = workspace().join(folder).join(path).exists();
                    assert!(
                        here || workspace().join(path).exists(),
                        "{document}: {line}"
                    );
                }
            }
        }
    }
}

struct Block {
    kind: String,
    text: String,
}

/// Returns the code blocks of a document.
fn blocks(document: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut lines = document.lines();
    while let Some(line) = lines.next() {
        if let Some(kind) = line.strip_prefix("```") {
            let inside = lines.by_ref().take_while(|line| *line != "```");
            blocks.push(Block {
                kind: kind.to_owned(),
                text: inside.map(|line| format!("{line}\n")).collect(),
            });
        }
    }
    blocks
}

/// Programs in the raw strings of a piece of Rust; one that is shown in part has a `…`.
fn strings(code: &str) -> impl Iterator<Item = String> {
    let strings = code.split("r#\"").skip(1);
    strings
        .filter_map(|rest| rest.split("\"#").next())
        .filter(|text| text.starts_with("3.") && !text.contains('…'))
        .map(str::to_owned)
}
