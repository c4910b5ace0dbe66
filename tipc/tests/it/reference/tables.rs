//! docs/language.md holds what the compiler's tables say, and keeps its clause ids.

use crate::reference::links::anchor;
use crate::reference::{hold, read};
use std::fmt::Write as _;
use tipc::Robot;
use tipc::code::{Code, Mistake};
use tipc::language::Edition;
use tipc::language::commands::{
    Arguments, COMMANDS, Command, Cycles, Form, Joints, Robots, Targets, Values,
};
use tipc::language::flags::FLAGS;
use tipc::language::functions::FUNCTIONS;
use tipc::language::inputs::INPUTS;
use tipc::language::keywords::KEYWORDS;
use tipc::language::reserved::RESERVED;
use tipc::message::Lang;

/// Number of clauses of each chapter.
const CLAUSES: [usize; 17] = [12, 25, 6, 9, 1, 7, 48, 1, 5, 1, 1, 6, 3, 4, 5, 5, 4];

fn reference() -> String {
    read("docs/language.md")
}

#[test]
fn the_tables_of_the_reference_are_those_of_the_compiler() {
    let text = reference();
    let fresh = replace(&text, "codes", &codes());
    let fresh = replace(&fresh, "finer codes", &finer_codes());
    let fresh = replace(&fresh, "commands", &commands());
    hold("docs/language.md", &text, &fresh);
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
        let described = describes(clause_of(&text, clause), name);
        assert!(described, "{name} is not in clause {clause}");
    }
}

#[test]
fn every_other_word_is_described_in_the_clause_that_its_row_names() {
    let text = reference();
    let keywords = KEYWORDS.iter().map(|row| (row.word, row.clause));
    let functions = FUNCTIONS.iter().map(|row| (row.word, row.clause));
    let flags = FLAGS.iter().map(|row| (row.word(), row.clause));
    let inputs = INPUTS.iter().map(|row| (row.port.stem(), row.clause));
    let reserved = RESERVED.iter().map(|row| (row.word, row.clause));
    let words = keywords.chain(functions).chain(flags).chain(inputs);
    for (word, clause) in words.chain(reserved) {
        assert!(clause_of(&text, clause).contains(word), "{word}: {clause}");
    }
}

/// Returns a clause of the reference; it ends where the next one begins.
fn clause_of<'a>(text: &'a str, clause: &str) -> &'a str {
    let begin = text.find(&format!("**[{clause}]**"));
    let text = &text[begin.unwrap_or_else(|| panic!("no clause {clause}"))..];
    let end = text[1..].find("**[").map_or(text.len(), |end| end + 1);
    &text[..end]
}

/// Returns true if a clause names a command, possibly as `…_SLOW` for a family that shares its endings.
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

/// Returns the text with the part between a pair of markers replaced.
pub(crate) fn replace(text: &str, name: &str, content: &str) -> String {
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
        let level = code.level(Edition::default()).name();
        let message = code.template().replace("{}", "…");
        let _ = writeln!(table, "| {} | {level} | `{message}` |", code.id());
    }
    table + "\n"
}

fn finer_codes() -> String {
    let mut table = String::from("\n| code | kind of mistake |\n|---|---|\n");
    for mistake in Mistake::ALL {
        let title = mistake.title(Lang::English);
        let _ = writeln!(table, "| {} | {title} |", mistake.id);
    }
    table + "\n"
}

fn commands() -> String {
    let mut table = String::from(
        "\n| command | arguments | unit | robots | values that stop the program | cycles | what it does | section | clause |\n\
         |---|---|---|---|---|---|---|---|---|\n",
    );
    let entries = read("docs/commands.md");
    for command in COMMANDS {
        let _ = writeln!(
            table,
            "| {} | {} | {} | {} | {} | {} | {} | {} | [{}] |",
            names(command, &entries),
            code(&syntax(command.form_in(Edition::V3_2))),
            dash(command.unit),
            letters(command.robots),
            command.limit().map_or("–", |limit| limit.english),
            cycles(command),
            command.description.english,
            command.section,
            command.clause
        );
    }
    table + "\n"
}

/// Returns the letters T, H, G of the robots that have a command.
pub(crate) fn letters(robots: Robots) -> String {
    let letters = [
        (Robot::Titan8, "T"),
        (Robot::Hand, "H"),
        (Robot::Generic, "G"),
    ];
    let letters = letters.into_iter();
    let letters = letters.filter(|(robot, _)| robots.contains(*robot));
    let letters: Vec<&str> = letters.map(|(_, letter)| letter).collect();
    letters.join(" ")
}

/// Returns the arguments of a command as the reference writes them.
fn syntax(form: Form) -> String {
    match form {
        Form::Robot(arguments) => syntax_of_arguments(arguments),
        Form::Special => "number [V] [V]".to_owned(),
        Form::Teach(targets) => format!("{} variable", syntax_of_targets(targets)),
        Form::AdIn => "board channel VAR, or id VAR".to_owned(),
        Form::KeyIn => "[VAR]".to_owned(),
        Form::Words(text) => text.to_owned(),
    }
}

fn syntax_of_arguments(arguments: Arguments) -> String {
    let Arguments {
        hs,
        targets,
        values,
        relative,
        from_target,
        ..
    } = arguments;
    let mark = match (relative, from_target) {
        (false, _) => "",
        (true, false) => "†",
        (true, true) => "‡",
    };
    let values = match values {
        Values::None => String::new(),
        Values::One => "V".to_owned(),
        Values::Three => "V V V".to_owned(),
        Values::Position => format!("S³{mark}"),
        Values::Angles if targets.joints == Joints::None => format!("Sⁿ{mark}"),
        Values::Angles => format!("Sⁿ{mark}, one S{mark} for J"),
        Values::PerJoint => "Sⁿ, one V for J, V or Sⁿ for ALL".to_owned(),
        Values::PerLeg => "Sⁿ, one V for J and ALL".to_owned(),
        Values::ThreeOrPos => "V V V, or P".to_owned(),
        Values::Limits => "Q Q, S S for J".to_owned(),
    };
    let hs = if hs { "[HS]" } else { "" };
    let parts = [hs.to_owned(), syntax_of_targets(targets), values];
    let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    parts.join(" ")
}

/// Returns the targets of a command as the reference writes them.
pub(crate) fn syntax_of_targets(targets: Targets) -> String {
    let joints = match targets.joints {
        Joints::None => "",
        Joints::Every => "J",
        Joints::Second => "Jn2",
        Joints::Third => "Jn3",
        Joints::ThirdOfHand => "Jn3 (H)",
    };
    let parts = [
        (targets.foot, "F"),
        (!joints.is_empty(), joints),
        (targets.floor, "FLOOR (H)"),
        (targets.all, "ALL"),
    ];
    let names: Vec<&str> = parts
        .iter()
        .filter(|(member, _)| *member)
        .map(|(_, name)| *name)
        .collect();
    names.join(" | ")
}

/// Returns its names, with a link to its entry.
fn names(command: &Command, entries: &str) -> String {
    let name = command.name;
    let headings = entries.lines().filter_map(|line| line.strip_prefix("### "));
    let of_entry = |heading: &&str| heading.split(", ").any(|word| word == name);
    let heading = headings.into_iter().find(of_entry);
    let heading = heading.unwrap_or_else(|| panic!("{name} has no entry"));
    let link = format!("[`{name}`](commands.md#{})", anchor(heading));
    match command.alias {
        Some(alias) => format!("{link}, `{alias}`"),
        None => link,
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
    match command.cycles {
        Cycles::Zero => "0",
        Cycles::One => "1",
        Cycles::Until(_) => "≥ 1",
    }
}
