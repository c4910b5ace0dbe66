//! docs/commands.md: an entry for every word of the language, with a program that is a test case.

use crate::reference::facts::facts;
use crate::reference::{hold, read, workspace};
use std::collections::BTreeSet;
use std::fs;
use tipc::Robot;
use tipc::language::commands::{COMMANDS, Command, find_in};
use tipc::language::keywords::KEYWORDS;
use tipc::language::reserved::{Kind, RESERVED, motion_flags};
use tipc::language::{Edition, Keyword, flags, functions, inputs};

const PATH: &str = "docs/commands.md";
const EXAMPLES: &str = "tests/language/cases/examples";

/// `### names` and, further down, `<!-- name.prg -->`.
struct Entry {
    names: Vec<String>,
    example: String,
}

#[test]
fn the_entries_hold_what_the_tables_and_the_examples_say() {
    let text = read(PATH);
    hold(PATH, &text, &rewritten(&text));
}

#[test]
fn every_word_has_one_entry() {
    let entries = entries(&read(PATH));
    let named = |test: &dyn Fn(&str) -> bool| {
        let of_entry = |entry: &&Entry| entry.names.iter().any(|name| test(name));
        entries.iter().filter(of_entry).count()
    };
    // An entry has a program that runs.
    let words = COMMANDS.iter().map(|command| command.name);
    let words = words
        .chain(functions::words())
        .chain(flags::words())
        .chain(motion_flags())
        .map(str::to_owned);
    for word in words.chain(inputs::named().map(|port| port.to_string())) {
        assert_eq!(named(&|name| name == word), 1, "entries of {word}");
    }
    let families = RESERVED.iter().filter_map(|row| match row.kind {
        Kind::Variables | Kind::Reading(_) => Some(row.word),
        _ => None,
    });
    for family in flags::families().chain(families) {
        assert_eq!(named(&|name| name.starts_with(family)), 1, "{family}");
    }
}

#[test]
fn every_example_uses_the_words_of_its_entry() {
    let mut used = BTreeSet::new();
    for Entry { names, example } in entries(&read(PATH)) {
        let words = words(&program(&example));
        for name in names.iter().filter(|name| is_word(name)) {
            assert!(words.contains(name), "{example} does without {name}");
        }
        used.extend(words);
    }
    for row in KEYWORDS
        .iter()
        .filter(|row| matches!(row.keyword, Keyword::Then | Keyword::To | Keyword::Step))
    {
        assert!(used.contains(row.word), "no example has {}", row.word);
    }
}

#[test]
fn every_example_is_a_case_and_is_shown_once() {
    let shown: Vec<String> = entries(&read(PATH))
        .into_iter()
        .map(|entry| entry.example)
        .collect();
    let folder = fs::read_dir(workspace().join(EXAMPLES)).expect("the examples");
    let files: BTreeSet<String> = folder
        .map(|file| {
            file.expect("a file")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    for file in files.iter().filter(|file| file.ends_with(".prg")) {
        let times = shown.iter().filter(|example| *example == file).count();
        assert_eq!(times, 1, "{file}");
        let trace = file.replace(".prg", ".trace");
        assert!(files.contains(&trace), "{file} is not run");
    }
}

fn entries(text: &str) -> Vec<Entry> {
    let mut entries = Vec::new();
    let mut names = Vec::new();
    for line in text.lines() {
        if let Some(heading) = line.strip_prefix("### ") {
            names = names_of(heading);
        } else if let Some(example) = example_of(line) {
            entries.push(Entry {
                names: std::mem::take(&mut names),
                example: example.to_owned(),
            });
        }
    }
    assert!(entries.len() > 80, "{} entries", entries.len());
    entries
}

fn names_of(heading: &str) -> Vec<String> {
    heading.split(", ").map(str::to_owned).collect()
}

/// Returns the file of a line `<!-- name.prg -->`.
fn example_of(line: &str) -> Option<&str> {
    let file = line.strip_prefix("<!-- ")?.strip_suffix(" -->")?;
    file.ends_with(".prg").then_some(file)
}

/// Returns the document with the text between `<!-- name.prg -->` and `<!-- end -->` generated again.
fn rewritten(text: &str) -> String {
    let mut fresh = String::new();
    let mut names = Vec::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        fresh += line;
        fresh.push('\n');
        if let Some(heading) = line.strip_prefix("### ") {
            names = names_of(heading);
        } else if let Some(example) = example_of(line) {
            fresh += &generated(&names, example);
            let end = lines.find(|line| *line == "<!-- end -->");
            fresh += end.unwrap_or_else(|| panic!("{example} has no end"));
            fresh.push('\n');
        }
    }
    fresh
}

fn generated(names: &[String], example: &str) -> String {
    let commands: Vec<&Command> = names
        .iter()
        .filter_map(|name| find_in(name, Edition::V3_2))
        .collect();
    let facts = facts(&commands);
    let options = header(example, "# args:");
    let shown = header(example, "# try:");
    let robot = match robot(&options) {
        Robot::Titan8 => String::new(),
        other => format!(" {}", other.name()),
    };
    let program = program(example);
    format!(
        "{facts}- Try it: `tip run {EXAMPLES}/{example}{options}{shown}`\n\n```tip{robot}\n{program}```\n"
    )
}

fn program(example: &str) -> String {
    read(&format!("{EXAMPLES}/{example}"))
}

/// Returns the header line of a case after this word: `# args:` has the options that it runs with, `# try:` what a
/// reader adds to see more.
fn header(example: &str, word: &str) -> String {
    let case = workspace().join(EXAMPLES).join(example);
    let expectation = fs::read_to_string(case.with_extension("trace"));
    let expectation = expectation.unwrap_or_else(|error| panic!("{example}: {error}"));
    let lines = expectation.lines().take_while(|line| line.starts_with('#'));
    lines.filter_map(|line| line.strip_prefix(word)).collect()
}

fn robot(options: &str) -> Robot {
    let name = options.split_once("--robot ").map(|(_, rest)| rest);
    let name = name.and_then(|rest| rest.split_whitespace().next());
    name.and_then(Robot::from_name).unwrap_or_default()
}

fn is_word(name: &str) -> bool {
    name.bytes()
        .all(|byte| byte.is_ascii_uppercase() || byte.is_ascii_digit() || byte == b'_')
}

/// Returns the words of a program, without its title and its comments.
fn words(program: &str) -> BTreeSet<String> {
    let statements = program.lines().skip(2);
    let code = statements.map(|line| line.split("//").next().unwrap_or_default());
    code.flat_map(|line| line.split(|c: char| !c.is_ascii_alphanumeric() && c != '_'))
        .map(str::to_owned)
        .collect()
}
