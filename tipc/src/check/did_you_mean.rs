//! Suggestions for an unknown first word of a statement.

use super::resolve::Resolver;
use crate::foreign;
use crate::language::commands::{self, COMMANDS};
use crate::language::{flags, names};
use crate::lex::DELIMITERS;
use crate::message::{Commanding, ForeignWord, Message, Parsing, Suggestion};
use crate::suggest::nearest;
use crate::syntax::{Word, upper_case};
use tip_runtime::command::{FAST, Flag, Target};

/// The most words that a command may have been taken apart into.
const PARTS: usize = 4;

impl Resolver<'_> {
    pub(super) fn suggest_for(&self, name: &Word) -> Message {
        if self.found.are_many() {
            return Commanding::LabelOrEquation.into();
        }
        let word = name.node.as_str();
        if let Some(command) = self.in_one_word(name) {
            let word = command.into();
            return ForeignWord::InOneWord { word }.into();
        }
        if let Some(help) = self.call_of(word) {
            return help;
        }
        if let Some(command) = commands::renamed(word) {
            return Commanding::CalledNow { command }.into();
        }
        let name = foreign::name(word);
        let last = name.rsplit('.').next().unwrap_or(name);
        let rows = [word, name, last].into_iter();
        if let Some(row) = rows.filter_map(foreign::statement).next() {
            return row.advice.clone().into();
        }
        if foreign::begins_label(name) && name.len() < word.len() {
            let digits: String = word.chars().filter(char::is_ascii_digit).collect();
            let name = format!("L{digits}").into();
            return Parsing::WriteLabel { name }.into();
        }
        if let Ok(target) = word.parse::<Target>() {
            let target = target.to_string().into();
            return ForeignWord::TargetFirst { target }.into();
        }
        if flags::find(word, self.names.edition).is_some() {
            return ForeignWord::FlagAlone { flag: word.into() }.into();
        }
        if let Some(command) = called(word, last) {
            return ForeignWord::Glued { command }.into();
        }
        if let Some(near) = foreign::command(word) {
            return Suggestion::DidYouMean { near: near.into() }.into();
        }
        if let Some(command) = glued(word) {
            return Suggestion::BlankAfter { command }.into();
        }
        match nearest(word, commands::names(self.names.edition)) {
            Some(near) => Suggestion::DidYouMean { near: near.into() }.into(),
            None => match begun(word).or_else(|| cut_short(word)) {
                Some(near) => Suggestion::DidYouMean { near: near.into() }.into(),
                None if is_called(word) => ForeignWord::NoParameters { name: name.into() }.into(),
                None => Commanding::LabelOrEquation.into(),
            },
        }
    }

    /// `ALL STOP`: the command whose name is in several words.
    pub(super) fn in_one_word(&self, first: &Word) -> Option<&'static str> {
        let rest = self.rest_of_statement(first.span);
        let rest = rest.split(DELIMITERS).filter(|word| !word.is_empty());
        let words: Vec<&str> = rest.take(PARTS - 1).collect();
        let mut counts = (1..=words.len()).rev();
        counts.find_map(|count| {
            let parts = [first.node.as_str()].into_iter();
            let whole: Vec<&str> = parts.chain(words[..count].iter().copied()).collect();
            let command = commands::find_in(&upper_case(&whole.join("_")), self.names.edition)?;
            Some(command.name)
        })
    }

    /// Suggests a CALL or GOTO to a SUBROUTINE or label of that name.
    fn call_of(&self, word: &str) -> Option<Message> {
        let name = word.strip_suffix("()").unwrap_or(word);
        let is_subroutine = self.is_subroutine(name)?;
        let name = name.into();
        Some(match is_subroutine {
            true => Suggestion::Call { name }.into(),
            false => Suggestion::JumpTo { name }.into(),
        })
    }
}

/// Returns the command that a word calls as another language does: `PTP(F1`, `MESSAGE"…"`, `robot.ptp(1`.
fn called(word: &str, name: &str) -> Option<&'static str> {
    let command = commands::find(name).filter(|_| name.len() < word.len())?;
    Some(command.name)
}

/// `LIFT(1)`: whether a word calls a routine as another language does.
fn is_called(word: &str) -> bool {
    let (name, rest) = word.split_once('(').unwrap_or_default();
    names::is_variable(name) && !rest.is_empty()
}

/// Returns the command that the first parts of a word are: `TORQUE_CONTROL`.
fn begun(word: &str) -> Option<&'static str> {
    let ends = word.match_indices('_').map(|(at, _)| at);
    let mut parts = ends.rev().filter_map(|end| commands::find(&word[..end]));
    parts.next().map(|command| command.name)
}

/// Returns the only command that a word is the first part of: `SIT`.
fn cut_short(word: &str) -> Option<&'static str> {
    let goes_on = |name: &&str| {
        name.strip_prefix(word)
            .is_some_and(|rest| rest.starts_with('_'))
    };
    let mut longer = COMMANDS.iter().map(|command| command.name).filter(goes_on);
    longer.next().filter(|_| longer.next().is_none())
}

/// Returns the command that a word begins with, if an argument follows it at once: `SLEEP100`, `PTPF1`.
fn glued(word: &str) -> Option<&'static str> {
    let is_argument = |rest: &str| {
        let is_number = !rest.is_empty() && rest.bytes().all(|it| it.is_ascii_digit());
        is_number || rest == FAST || rest.parse::<Target>().is_ok() || rest.parse::<Flag>().is_ok()
    };
    let begins = |name: &&str| word.strip_prefix(*name).is_some_and(is_argument);
    let names = COMMANDS.iter().map(|command| command.name);
    names.filter(begins).max_by_key(|name| name.len())
}
