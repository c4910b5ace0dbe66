//! Counts of what was compared.

use crate::compare::Run;
use std::collections::BTreeMap;
use std::fmt;
use tipc::Robot;
use tipc::language::{Edition, commands, flags, functions};

/// Counts by name. As text it is a line for each: the name, a tab, the count.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Figures(BTreeMap<String, u64>);

impl Figures {
    /// Adds to a count.
    pub fn add(&mut self, name: String, count: u64) {
        *self.0.entry(name).or_default() += count;
    }

    /// Adds all counts of another.
    pub fn merge(&mut self, other: &Figures) {
        for (name, count) in &other.0 {
            self.add(name.clone(), *count);
        }
    }

    /// A count; 0 if there is none of that name.
    pub fn get(&self, name: &str) -> u64 {
        self.0.get(name).copied().unwrap_or_default()
    }

    /// The counts whose name begins so, by the rest of it.
    pub fn under<'a>(&'a self, prefix: &'a str) -> impl Iterator<Item = (&'a str, u64)> {
        self.0
            .iter()
            .filter_map(move |(name, count)| Some((name.strip_prefix(prefix)?, *count)))
    }

    /// Reads what `Display` wrote; other lines are none of it.
    pub fn parse(text: &str) -> Self {
        let mut figures = Figures::default();
        for line in text.lines() {
            if let Some((name, count)) = line.split_once('\t')
                && let Ok(count) = count.parse()
            {
                figures.add(name.to_owned(), count);
            }
        }
        figures
    }

    /// Counts what a run showed. `formal` is the program's FORMAL.TMP, a line for each step.
    pub(crate) fn count_run(&mut self, robot: Robot, formal: &str, run: &Run) {
        let robot = robot.name();
        self.add("runs".to_owned(), 1);
        self.add("cycles".to_owned(), run.cycles);
        self.add(format!("cycles on {robot}"), run.cycles);
        self.add(format!("end {robot}/{}", kind_of_end(&run.end)), 1);
        for (line, visits) in formal.lines().zip(&run.visits) {
            self.add("steps".to_owned(), *visits);
            if *visits > 0 {
                for feature in features(line) {
                    self.add(format!("ran {robot}/{feature}"), *visits);
                }
            }
        }
    }
}

impl fmt::Display for Figures {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0
            .iter()
            .try_for_each(|(name, count)| writeln!(f, "{name}\t{count}"))
    }
}

/// An end without the number of its leg, joint or input.
fn kind_of_end(end: &str) -> &str {
    let with_target = ["Joint limit", "Out of reach", "Sensor fault"];
    with_target
        .into_iter()
        .find(|kind| end.starts_with(kind))
        .unwrap_or(end)
}

/// Returns the words that a step covers: its command, and the functions, operators and flags in it.
fn features(formal: &str) -> Vec<String> {
    let fields: Vec<&str> = formal.split('\t').collect();
    let first = fields.first().copied().unwrap_or_default();
    let Some(command) = commands::find_in(first, Edition::V3_2) else {
        return match first.ends_with(':') {
            true => vec!["label".to_owned()],
            false => equation(&fields),
        };
    };
    let mut features = vec![command.name.to_owned()];
    if command.name == "IF" {
        features.extend(
            fields
                .iter()
                .filter(|word| matches!(**word, "THEN" | "GOTO" | "GOSUB"))
                .map(|word| format!("IF {word}")),
        );
    }
    let flags = fields
        .iter()
        .skip(1)
        .map(|word| word.trim_start_matches('!'));
    features.extend(flags.filter_map(flag));
    features.extend(readings(&fields));
    features
}

/// The kinds of readings, without their targets and numbers.
fn readings(fields: &[&str]) -> impl Iterator<Item = String> {
    let words = fields.iter().filter_map(|word| word.split_once('@'));
    words.map(|(_, word)| {
        let end = word.find(|char: char| !char.is_ascii_uppercase());
        format!("reading @{}", &word[..end.unwrap_or(word.len())])
    })
}

fn equation(fields: &[&str]) -> Vec<String> {
    let words = fields
        .iter()
        .filter(|word| functions::words().any(|function| function == **word) || is_operator(word));
    let words = words.map(|word| format!("equation {word}"));
    words.chain(readings(fields)).collect()
}

fn is_operator(word: &str) -> bool {
    matches!(
        word,
        "=" | "+=" | "-=" | "*=" | "/=" | "+" | "-" | "*" | "/"
    )
}

/// The kind of an event flag, without its target or number.
fn flag(word: &str) -> Option<String> {
    let family = flags::families().find(|family| word.starts_with(*family));
    let name = family.or_else(|| flags::words().find(|name| *name == word))?;
    Some(format!("flag {}", name.trim_end_matches('_')))
}
