//! The language reference holds what the compiler's tables say, and keeps its clause ids.
//! `TIP_BLESS=1` rewrites the tables.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::{env, fs};
use tipc::codes::{Code, Level};
use tipc::commands::{COMMANDS, Command, Form, Limit};

/// How many clauses each chapter has.
const CLAUSES: [usize; 11] = [12, 25, 6, 9, 1, 7, 48, 1, 5, 1, 1];

fn path() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs/language.md")
}

fn reference() -> String {
    fs::read_to_string(path()).expect("docs/language.md is part of the repository")
}

#[test]
fn the_tables_of_the_reference_are_those_of_the_compiler() {
    let text = reference();
    let fresh = replace(&text, "codes", &codes());
    let fresh = replace(&fresh, "commands", &commands());
    if text == fresh {
        return;
    }
    if env::var_os("TIP_BLESS").is_some() {
        fs::write(path(), fresh).expect("docs/language.md can be written");
        return;
    }
    let differing = text
        .lines()
        .zip(fresh.lines())
        .find(|(old, new)| old != new);
    panic!("docs/language.md is out of date, set TIP_BLESS=1 to rewrite it: {differing:#?}");
}

#[test]
fn every_clause_stands_once() {
    let text = reference();
    for (chapter, clauses) in (1..).zip(CLAUSES) {
        for clause in 1..=clauses {
            let id = format!("**[{chapter}.{clause}]**");
            assert_eq!(text.matches(&id).count(), 1, "{id}");
        }
    }
    assert_eq!(text.matches("**[").count(), CLAUSES.iter().sum::<usize>());
}

#[test]
fn every_command_is_described_in_the_clause_that_its_row_names() {
    let text = reference();
    for Command { name, clause, .. } in COMMANDS {
        let begin = text.find(&format!("**[{clause}]**"));
        let clause_text = &text[begin.unwrap_or_else(|| panic!("{name}: no clause {clause}"))..];
        // A clause ends where the next one begins.
        let end = clause_text[1..]
            .find("**[")
            .map_or(clause_text.len(), |end| end + 1);
        let described = describes(&clause_text[..end], name);
        assert!(described, "{name} is not in clause {clause}");
    }
}

#[test]
fn programs_of_the_reference_load() {
    let text = reference();
    let programs: Vec<_> = text
        .split("```text\n")
        .skip(1)
        .filter_map(|rest| rest.split("```").next())
        .filter(|block| block.starts_with("3.1\n"))
        .collect();
    assert!(!programs.is_empty());
    for program in programs {
        let loaded = tipc::load(
            "reference.prg",
            program.as_bytes(),
            &tipc::Options::default(),
        );
        assert_eq!(loaded.diagnostics, [], "{program}");
    }
}

/// Whether a clause names a command, be it as `…_SLOW` for a family that shares its endings.
fn describes(clause: &str, name: &str) -> bool {
    let endings = [
        "_SLOW",
        "_FAST",
        "_NORMAL",
        "_SOFT",
        "_FIRMLY",
        "_FORCE_LIMIT",
    ];
    let family = endings.iter().any(|ending| {
        name.strip_suffix(ending).is_some_and(|stem| {
            let stem = stem.trim_start_matches("SET_");
            clause.contains(stem) && clause.contains(ending)
        })
    });
    clause.contains(name) || family
}

/// The text with the part between a pair of markers replaced.
fn replace(text: &str, name: &str, content: &str) -> String {
    let (begin, end) = (
        format!("<!-- {name}: begin -->\n"),
        format!("<!-- {name}: end -->"),
    );
    let (before, rest) = text
        .split_once(&begin)
        .expect("the marker of the beginning");
    let (_, after) = rest.split_once(&end).expect("the marker of the end");
    format!("{before}{begin}{content}{end}{after}")
}

fn codes() -> String {
    let mut table = String::from("\n| code | level | message |\n|---|---|---|\n");
    for code in Code::ALL {
        let level = match code.level() {
            Level::Error => "error",
            Level::Warning => "warning",
        };
        let message = code.template().replace("{}", "…");
        let _ = writeln!(table, "| {} | {level} | `{message}` |", code.id());
    }
    table + "\n"
}

fn commands() -> String {
    let mut table = String::from(
        "\n| command | arguments | unit | robots | values that stop the program | cycles | what it does | section | clause |\n\
         |---|---|---|---|---|---|---|---|---|\n",
    );
    for command in COMMANDS {
        let _ = writeln!(
            table,
            "| {} | {} | {} | {} | {} | {} | {} | {} | [{}] |",
            names(command),
            code(&command.form.syntax()),
            dash(command.unit),
            command.robots.letters(),
            limit(command.form),
            cycles(command),
            command.description,
            command.section,
            command.clause
        );
    }
    table + "\n"
}

fn names(command: &Command) -> String {
    match command.alias {
        Some(alias) => format!("`{}`, `{alias}`", command.name),
        None => format!("`{}`", command.name),
    }
}

fn dash(text: &str) -> &str {
    if text.is_empty() { "–" } else { text }
}

fn code(syntax: &str) -> String {
    match syntax {
        "" => "–".to_owned(),
        _ => format!("`{}`", syntax.replace('|', "\\|")),
    }
}

fn cycles(command: &Command) -> &'static str {
    match (command.name.starts_with("DEF_"), command.waits) {
        (true, _) => "0",
        (false, true) => "≥ 1",
        (false, false) => "1",
    }
}

fn limit(form: Form) -> &'static str {
    let Form::Robot(arguments) = form else {
        return "–";
    };
    match arguments.limit {
        Limit::Any => "–",
        Limit::NotNegative => "below 0",
        Limit::Positive => "0 and below",
        Limit::Percent => "0 and below, above 100",
        Limit::Period | Limit::Frequency => "outside the robot's range",
        Limit::Lamp => "a device that is not fitted",
        Limit::FloorType => "T: not 1–3; H: not 1–2",
        Limit::ObjectType => "not 1–3",
    }
}
