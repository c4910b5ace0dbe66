//! Variables that are typed by their names: `VAR01`, `POS01`, `AGL01`, `TRQ01`.
//!
//! Old programs know a variable by its number: `VAR1` and `VAR01` are one.

use super::Migrator;
use super::lines::Piece;
use crate::message::Migrating;
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, HashSet};
use tipc::diagnostic::Edit;
use tipc::language::names;
use tipc::source::{Source, Span};
use tipc::syntax::VariableKind;

/// The types of old variables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Prefix {
    Var,
    Pos,
    Agl,
    Trq,
}

impl Prefix {
    const ALL: [(Prefix, &'static str); 4] = [
        (Prefix::Var, "VAR"),
        (Prefix::Pos, "POS"),
        (Prefix::Agl, "AGL"),
        (Prefix::Trq, "TRQ"),
    ];

    pub(super) fn kind(self) -> VariableKind {
        match self {
            Prefix::Var => VariableKind::Var,
            Prefix::Pos => VariableKind::Pos,
            Prefix::Agl | Prefix::Trq => VariableKind::Joint,
        }
    }
}

/// Type and number: the length of its digits, then the digits, so that keys sort by number.
type Key = (Prefix, usize, String);

/// Every old variable of a program.
#[derive(Debug, Default)]
pub(super) struct Variables {
    /// Spelling of each where it first appears.
    spelling: BTreeMap<Key, String>,
    /// Locations with another spelling of a variable, and the spelling to use.
    respelt: Vec<(Span, String)>,
    /// Type names without a number.
    numberless: Vec<Span>,
    /// First locations of names that are too long for a declaration.
    too_long: Vec<(Span, String)>,
    /// Spellings of VARs.
    vars: HashSet<String>,
    /// Names that the program declares itself.
    declared: HashSet<String>,
}

impl Variables {
    /// Finds them all; there are none in a program that declares its variables.
    pub(super) fn collect(source: &Source, pieces: &[Piece], is_typed: bool) -> Self {
        let mut variables = Variables::default();
        if !is_typed {
            return variables;
        }
        let statements = || pieces.iter().filter_map(Piece::statement);
        for statement in statements().filter(|it| it.keyword.starts_with("DEF_")) {
            let names = statement.words().skip(1);
            let names = names.map(|name| source.slice(name).to_ascii_uppercase());
            variables.declared.extend(names);
        }
        for word in statements().flat_map(|statement| statement.words()) {
            variables.word(source, word);
        }
        for message in statements().filter(|statement| statement.keyword == "MESSAGE") {
            for placeholder in old_placeholders(source.slice(message.text)) {
                variables.name_of(Prefix::Var, &placeholder.digits, message.text);
            }
        }
        variables
    }

    fn word(&mut self, source: &Source, word: Span) {
        let text = source.slice(word);
        let base = text.split('.').next().unwrap_or_default();
        let span = Span::new(word.start, word.start + base.len());
        let name = base.to_ascii_uppercase();
        if self.declared.contains(&name) {
            return;
        }
        if Prefix::ALL.iter().any(|(_, prefix)| *prefix == name) {
            self.numberless.push(span);
            return;
        }
        let Some((prefix, digits)) = split(&name) else {
            return;
        };
        let known = self.name_of(prefix, digits, span);
        if known != name {
            self.respelt.push((span, known));
        }
    }

    /// Returns the spelling of the variable at `location`, and records it if it is new.
    fn name_of(&mut self, prefix: Prefix, digits: &str, location: Span) -> String {
        let entry = match self.spelling.entry(key(prefix, digits)) {
            Entry::Occupied(known) => return known.get().clone(),
            Entry::Vacant(entry) => entry,
        };
        let (_, name) = Prefix::ALL[prefix as usize];
        let name = format!("{name}{digits}");
        if name.len() > names::LIMIT {
            self.too_long.push((location, name.clone()));
        }
        if prefix == Prefix::Var {
            self.vars.insert(name.clone());
        }
        entry.insert(name).clone()
    }

    /// Returns the spelling of the VAR of that number.
    pub(super) fn var(&self, digits: &str) -> Option<&str> {
        let name = self.spelling.get(&key(Prefix::Var, digits));
        name.map(String::as_str)
    }

    /// Returns the name that `word` gets.
    pub(super) fn spelt(&self, word: &str) -> String {
        let (base, member) = match word.split_once('.') {
            Some((base, member)) => (base, format!(".{member}")),
            None => (word, String::new()),
        };
        let known = split(&base.to_ascii_uppercase())
            .and_then(|(prefix, digits)| self.spelling.get(&key(prefix, digits)).cloned());
        known.unwrap_or_else(|| base.to_owned()) + &member
    }

    /// Returns the names of one type of today that can be declared, by number.
    pub(super) fn to_declare(&self, kind: VariableKind) -> Vec<&str> {
        let of_kind = |key: &Key| key.0.kind() == kind;
        self.spelling
            .iter()
            .filter(|(key, _)| of_kind(key))
            .map(|(_, name)| name.as_str())
            .filter(|name| name.len() <= names::LIMIT)
            .collect()
    }

    /// Returns true if a placeholder of today would name it.
    pub(super) fn is_var(&self, name: &str) -> bool {
        self.vars.contains(name) || self.declared.contains(name)
    }
}

fn key(prefix: Prefix, digits: &str) -> Key {
    let number = digits.trim_start_matches('0');
    (prefix, number.len(), number.to_owned())
}

/// Returns the type and the number of an upper-case name.
fn split(name: &str) -> Option<(Prefix, &str)> {
    let with = |(prefix, text): &(Prefix, &str)| Some((*prefix, name.strip_prefix(*text)?));
    let (prefix, digits) = Prefix::ALL.iter().find_map(with)?;
    let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then_some((prefix, digits))
}

impl Migrator<'_> {
    /// Gives each variable one spelling.
    pub(super) fn variables(&mut self, variables: &Variables) {
        for (span, name) in &variables.respelt {
            let old = self.slice(*span).to_ascii_uppercase();
            self.edits.push(Edit::replace(*span, name.as_str()));
            let name = name.clone();
            self.change(*span, Migrating::OneVariable { old, name });
        }
        for span in &variables.numberless {
            let name = self.slice(*span).to_ascii_uppercase();
            self.question(*span, Migrating::NoNumber { name });
        }
        for (span, name) in &variables.too_long {
            let text = Migrating::NameTooLong {
                most: names::LIMIT,
                name: name.clone(),
                length: name.len(),
            };
            self.question(*span, text);
        }
    }
}

/// `%fnn%` or `%dnn%`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Placeholder {
    /// Start in the text.
    pub(super) start: usize,
    /// End in the text.
    pub(super) end: usize,
    /// True if it is shown with decimals.
    pub(super) real: bool,
    /// The number of the VAR.
    pub(super) digits: String,
}

/// Returns the old placeholders of a text, from left to right.
pub(super) fn old_placeholders(text: &str) -> Vec<Placeholder> {
    let mut found = Vec::new();
    let mut start = 0;
    while let Some(percent) = text[start..].find('%') {
        start += percent;
        match placeholder(&text[start..]) {
            Some((real, digits)) => {
                let end = start + "%f%".len() + digits.len();
                found.push(Placeholder {
                    start,
                    end,
                    real,
                    digits: digits.to_owned(),
                });
                start = end;
            }
            None => start += 1,
        }
    }
    found
}

fn placeholder(text: &str) -> Option<(bool, &str)> {
    let (word, _) = text.strip_prefix('%')?.split_once('%')?;
    let (real, digits) = match (word.strip_prefix('f'), word.strip_prefix('d')) {
        (Some(digits), _) => (true, digits),
        (None, Some(digits)) => (false, digits),
        (None, None) => return None,
    };
    let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then_some((real, digits))
}
