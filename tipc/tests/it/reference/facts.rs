//! Facts of the table of commands about the commands of an entry.

use crate::reference::read;
use crate::reference::tables::{letters, syntax_of_targets};
use tip_runtime::command::Teach;
use tipc::Robot;
use tipc::language::Edition;
use tipc::language::commands::{
    Arguments, Command, Cycles, Form, Joints, Meaning, Targets, Values,
};

/// Robots with a letter in the reference.
const ROBOTS: [(&str, Robot); 3] = [
    ("T", Robot::Titan8),
    ("G", Robot::Generic),
    ("H", Robot::Hand),
];

/// Returns the list below an entry's words; empty for words that are not commands.
pub(crate) fn facts(commands: &[&Command]) -> String {
    let Some(first) = commands.first() else {
        return String::new();
    };
    let unit = of_all(commands, |command| command.unit.to_owned());
    let unit = if unit.is_empty() {
        unit
    } else {
        format!(" Unit: {unit}.")
    };
    let mut lines = vec![
        format!("Edition: {}.", of_all(commands, edition)),
        format!("Written: {}.", written(commands, |command| command.since)),
        format!("Robots: {}.{unit}", letters(first.robots)),
        format!("Cycles: {}.", of_all(commands, cycles)),
        format!("Refused: {}.", of_all(commands, refused)),
        format!("Stops the program: {}.", of_all(commands, failures)),
        format!("Rules: {}.", of_all(commands, rules)),
    ];
    let later = |command: &&&Command| command.later_form.is_some();
    let later: Vec<&Command> = commands.iter().filter(later).copied().collect();
    let newest = |_: &Command| Edition::V3_2;
    lines.insert(2, format!("Written in 3.2: {}.", written(&later, newest)));
    lines.retain(|line| !line.ends_with(": ."));
    lines.iter().map(|line| format!("- {line}\n")).collect()
}

/// Returns the fact that holds for all, or each one if they differ.
fn of_all(commands: &[&Command], fact: fn(&Command) -> String) -> String {
    let facts: Vec<String> = commands.iter().map(|command| fact(command)).collect();
    if facts.windows(2).all(|pair| pair[0] == pair[1]) {
        return facts.into_iter().next().unwrap_or_default();
    }
    let named = commands.iter().zip(&facts);
    let named: Vec<String> = named
        .filter(|(_, fact)| !fact.is_empty())
        .map(|(command, fact)| format!("{} – {fact}", command.name))
        .collect();
    named.join("; ")
}

/// Returns the edition that brought a command; nothing for the first one.
fn edition(command: &Command) -> String {
    match command.since {
        Edition::V3_1 => String::new(),
        since => since.to_string(),
    }
}

/// Returns every form in an edition, by robot where robots differ.
fn written(commands: &[&Command], edition: fn(&Command) -> Edition) -> String {
    let forms = commands
        .iter()
        .map(|command| forms(command, edition(command)));
    forms.collect::<Vec<String>>().join("; ")
}

fn forms(command: &Command, edition: Edition) -> String {
    let mut groups: Vec<(String, Vec<String>)> = Vec::new();
    for (letter, robot) in ROBOTS {
        if !command.robots.contains(robot) {
            continue;
        }
        let usage = command.usage(robot, edition);
        match groups.iter_mut().find(|(_, forms)| *forms == usage) {
            Some((letters, _)) => *letters += &format!(" {letter}"),
            None => groups.push((letter.to_owned(), usage)),
        }
    }
    let joined = |forms: &[String]| {
        let forms: Vec<String> = forms.iter().map(|form| format!("`{form}`")).collect();
        forms.join(", ")
    };
    match &groups[..] {
        [(_, forms)] => joined(forms),
        groups => {
            let groups: Vec<String> = groups
                .iter()
                .map(|(letters, forms)| format!("{letters}: {}", joined(forms)))
                .collect();
            groups.join("; ")
        }
    }
}

fn cycles(command: &Command) -> String {
    match command.cycles {
        Cycles::Zero => "none".to_owned(),
        Cycles::One => "1".to_owned(),
        Cycles::Until(what) => format!("at least 1, until {}", what.english),
    }
}

fn failures(command: &Command) -> String {
    let failures = command.failures();
    let failures: Vec<String> = failures
        .iter()
        .map(|(fault, when)| format!("`{fault}` ({})", when.english))
        .collect();
    failures.join(", ")
}

fn refused(command: &Command) -> String {
    let lacking: Vec<&str> = ROBOTS
        .into_iter()
        .filter(|(_, robot)| !command.robots.contains(*robot))
        .map(|(letter, _)| letter)
        .collect();
    let unknown = match &lacking[..] {
        [] => String::new(),
        letters => format!("`Unknown command` ({})", letters.join(" ")),
    };
    let wrong = match wrong_arguments(command) {
        wrong if wrong.is_empty() => String::new(),
        wrong => format!("`Wrong argument` ({})", wrong.join("; ")),
    };
    let parts: Vec<String> = [unknown, wrong]
        .into_iter()
        .filter(|part| !part.is_empty())
        .collect();
    parts.join(", ")
}

fn wrong_arguments(command: &Command) -> Vec<String> {
    match command.form {
        Form::Robot(arguments) => wrong_operands(arguments),
        Form::Special => {
            vec!["a number that is not a constant from 0 to 255; more than two values".to_owned()]
        }
        Form::Teach(targets) => {
            let into = match command.meaning {
                Meaning::Teach(Teach::Angle | Teach::Torque) => {
                    "a receiver other than a JOINT for F, a VAR or a member for J"
                }
                _ => "a receiver other than a POS",
            };
            vec![other_target(targets), into.to_owned()]
        }
        Form::AdIn => vec![
            "a board other than 0, a channel outside 0 to 15, or either not a constant".to_owned(),
            "a receiver other than a VAR".to_owned(),
        ],
        Form::KeyIn => vec!["a receiver other than a VAR".to_owned()],
        Form::Words("") => vec!["words after it".to_owned()],
        Form::Words(_) => Vec::new(),
    }
}

fn wrong_operands(arguments: Arguments) -> Vec<String> {
    let has_target = arguments.targets != Targets::NONE;
    let joint = match arguments.targets.joints {
        Joints::None => "",
        _ => ", for J other than one scalar",
    };
    let values = match arguments.values {
        Values::None if has_target => "words after the target".to_owned(),
        Values::None => "words after it".to_owned(),
        Values::One => "other than one constant or VAR".to_owned(),
        Values::Three => "other than three constants or VARs".to_owned(),
        Values::Position => "other than three scalars or one POS".to_owned(),
        Values::Angles => {
            format!("for F other than a scalar for each joint or one JOINT{joint}")
        }
        Values::PerLeg => "for F other than a scalar for each joint or one JOINT, for J and ALL other than one constant or VAR".to_owned(),
        Values::ThreeOrPos => "other than three constants or VARs or one POS".to_owned(),
        Values::Limits => "for F other than two JOINTs, for J other than two scalars".to_owned(),
        Values::PerJoint => "for F other than a scalar for each joint or one JOINT, for J other than one constant or VAR, for ALL other than any of these".to_owned(),
    };
    let flags = match (arguments.motion, arguments.relative, arguments.hs) {
        (true, false, true) => Some("`R` or `A`"),
        (true, true, false) => Some("`HS`"),
        _ => None,
    };
    let target = has_target.then(|| other_target(arguments.targets));
    let parts = [target, Some(values), flags.map(str::to_owned)];
    parts.into_iter().flatten().collect()
}

fn other_target(targets: Targets) -> String {
    format!(
        "a target other than {}",
        syntax_of_targets(targets).replace(" | ", ", ")
    )
}

fn rules(command: &Command) -> String {
    let Command {
        clause, section, ..
    } = command;
    format!("[{clause}](language.md#{}), {section}", place(clause))
}

/// Returns the anchor of the heading above a clause.
fn place(clause: &str) -> String {
    let text = read("docs/language.md");
    let at = text.find(&format!("**[{clause}]**"));
    let before = &text[..at.unwrap_or_else(|| panic!("no clause {clause}"))];
    let heading = before.lines().rfind(|line| line.starts_with('#'));
    crate::reference::links::anchor(heading.expect("a heading"))
}
