//! Findings about one name that are one mistake.

use super::label;
use crate::check::title;
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Findings};
use crate::message::{Commanding, Habit, Instead, Message, Naming, Parsing, Structuring};
use crate::source::{Source, Span};
use crate::syntax::Module;
use std::collections::{HashMap, HashSet};

/// A name that is not declared is one finding; the others become its labels, and the best guess of its type its help.
pub(super) fn undeclared(source: &Source, module: &Module, found: &mut Findings) {
    let in_title = title::declared(source, module);
    let mut first_of: HashMap<String, usize> = HashMap::new();
    let mut kept: Vec<Diagnostic> = Vec::with_capacity(found.len());
    for mut finding in found.drain(..) {
        if finding.code != Code::UnknownVariable {
            kept.push(finding);
            continue;
        }
        let name = finding.subject.clone().unwrap_or_default();
        if let Some(first) = first_of.get(&name).map(|at| &mut kept[*at]) {
            first.labels.push(label(finding.span, Naming::AlsoHere));
            if is_open(first.help.as_ref()) && is_guess(finding.help.as_ref()) {
                first.help = finding.help;
            }
            continue;
        }
        if let Some(place) = in_title.get(&name) {
            finding.labels.push(label(*place, Habit::TitleHere));
            finding.help = Some(Habit::Title.into());
        }
        first_of.insert(name, kept.len());
        kept.push(finding);
    }
    **found = kept;
}

/// Whether a help leaves the type open.
fn is_open(help: Option<&Message>) -> bool {
    matches!(help, Some(Message::Naming(Naming::Declare { .. })))
}

/// Whether a help names one type.
fn is_guess(help: Option<&Message>) -> bool {
    matches!(help, Some(Message::Naming(Naming::DeclareAs { .. })))
}

/// A label that is missing is one mistake, however many jumps name it.
pub(super) fn missing_labels(found: &mut Findings) {
    let mut first_of: HashMap<String, usize> = HashMap::new();
    let mut kept: Vec<Diagnostic> = Vec::with_capacity(found.len());
    for finding in found.drain(..) {
        let name = finding.subject.clone().unwrap_or_default();
        if finding.code == Code::UnknownLabel && !name.is_empty() {
            if let Some(first) = first_of.get(&name) {
                kept[*first]
                    .labels
                    .push(label(finding.span, Naming::AlsoHere));
                continue;
            }
            first_of.insert(name, kept.len());
        }
        kept.push(finding);
    }
    **found = kept;
}

/// What follows from a second declaration: the name is not of the type, or not the SUBROUTINE, that its uses mean.
pub(super) fn declared_again(source: &Source, module: &Module, found: &mut Findings) {
    let is_again =
        |it: &&Diagnostic| matches!(it.reason, Message::Naming(Naming::DeclaredAgain { .. }));
    let again: HashSet<String> = found
        .iter()
        .filter(is_again)
        .map(|it| source.slice(it.span).to_ascii_uppercase())
        .collect();
    if again.is_empty() {
        return;
    }
    let names_one = |place: Span| {
        let statement = module.statement_at(place.start)?;
        let text = source.slice(module.statements[statement].span);
        let is_end = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
        let mut words = text.split(is_end).map(str::to_ascii_uppercase);
        words.any(|word| again.contains(&word)).then_some(())
    };
    found.retain(|it| {
        let follows = match &it.reason {
            Message::Commanding(_) | Message::Calculating(_) => true,
            Message::Structuring(reason) => matches!(reason, Structuring::PlainLabel { .. }),
            _ => it.code == Code::RunsInto,
        };
        !follows || names_one(it.span).is_none()
    });
}

/// `DEF_VAR A$`, and wherever `A$` stands.
pub(super) fn with_sign(source: &Source, found: &mut Findings) {
    let mut first_of: HashMap<String, usize> = HashMap::new();
    let mut kept: Vec<Diagnostic> = Vec::with_capacity(found.len());
    for finding in found.drain(..) {
        match &finding.reason {
            Message::Naming(Naming::NoVariableName { word }) => {
                first_of.entry(word.to_string()).or_insert(kept.len());
            }
            Message::Parsing(Parsing::ForeignInName { .. }) => {
                let word = word_at(source, finding.span);
                let name = source.slice(word).to_ascii_uppercase();
                if let Some(first) = first_of.get(&name) {
                    kept[*first].labels.push(label(word, Naming::AlsoHere));
                    continue;
                }
            }
            _ => {}
        }
        kept.push(finding);
    }
    **found = kept;
}

/// The name that a sign ends.
fn word_at(source: &Source, sign: Span) -> Span {
    let before = &source.text()[..sign.start];
    let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let start = before.trim_end_matches(is_name).len();
    Span::new(start, sign.end)
}

/// `SUBROUTINE LOOP:` and its calls.
pub(super) fn called_loop(found: &mut Findings) {
    let is_named = |it: &Diagnostic| it.reason == Naming::SubroutineLoop.into();
    let is_called = |it: &Diagnostic| it.reason == Structuring::LoopForGoto.into();
    if !found.iter().any(is_named) {
        return;
    }
    let calls = found.iter().filter(|it| is_called(it));
    let labels: Vec<_> = calls.map(|it| label(it.span, Naming::AlsoHere)).collect();
    found.retain(|it| !is_called(it));
    if let Some(named) = found.iter_mut().find(|it| is_named(it)) {
        named.labels.extend(labels);
    }
}

/// `PTP F1 R 0 0` with a variable R: that R is a flag there explains the missing number.
pub(super) fn flags(source: &Source, module: &Module, found: &mut Findings) {
    let statement = |span: Span| module.statement_at(span.start);
    let mut explained = HashSet::new();
    for at in 0..found.len() {
        let (flag, used) = match (found[at].code, found[at].labels.first()) {
            (Code::FlagName, Some(used)) => (found[at].span, used.span),
            _ => continue,
        };
        let is_there = |it: &&mut Diagnostic| {
            let is_few = matches!(it.reason, Message::Commanding(Commanding::TooFew { .. }));
            is_few && it.span != used && statement(it.span) == statement(used)
        };
        if let Some(fault) = found.iter_mut().find(is_there) {
            let name = source.slice(used).to_ascii_uppercase().into();
            fault.labels.push(label(used, Instead::FlagHere));
            fault.help = Some(Instead::OtherName { name }.into());
            explained.insert(flag);
        }
    }
    found.retain(|it| it.code != Code::FlagName || !explained.contains(&it.span));
}
