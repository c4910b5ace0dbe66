//! One mistake, one finding: what follows from another finding joins it.

use crate::code::Code;
use crate::diagnostic::{Diagnostic, Label};
use crate::language::keywords::{self, Keyword};
use crate::lex::{Kind, lex};
use crate::message::{Habit, Message, Naming, Parsing, Structuring};
use crate::source::{Source, Span};
use crate::syntax::{Module, StatementKind, upper_case};
use std::collections::{HashMap, HashSet};

/// Lets findings about one name be one finding, at the first place.
pub(super) fn join(source: &Source, module: &Module, found: &mut Vec<Diagnostic>) {
    found.sort_by_key(|finding| finding.span);
    labels_without_colon(module, found);
    undeclared(source, module, found);
}

/// `START` where `START:` was meant: the jumps to it are not wrong.
fn labels_without_colon(module: &Module, found: &mut Vec<Diagnostic>) {
    let mut jumps: HashMap<String, Vec<Span>> = HashMap::new();
    for finding in found.iter().filter(|it| it.code == Code::UnknownLabel) {
        let name = finding.subject.clone().unwrap_or_default();
        jumps.entry(name).or_default().push(finding.span);
    }
    let mut meant = HashSet::new();
    for finding in found
        .iter_mut()
        .filter(|it| it.code == Code::UnknownCommand)
    {
        let name = finding.subject.as_deref().unwrap_or_default();
        // The first word of that name is the label, so that no jump is listed twice.
        let is_alone = is_alone(module, finding.span);
        let Some(places) = is_alone.then(|| jumps.remove(name)).flatten() else {
            continue;
        };
        meant.insert(name.to_owned());
        finding.reason = Parsing::LabelColonMissing.into();
        finding.help = Some(Parsing::WriteLabel { name: name.into() }.into());
        let labels = places
            .iter()
            .map(|span| label(*span, Structuring::JumpsHere));
        finding.labels.extend(labels);
    }
    found.retain(|finding| {
        let name = finding.subject.as_ref();
        finding.code != Code::UnknownLabel || !name.is_some_and(|name| meant.contains(name))
    });
}

/// Whether a statement at this place is this word alone.
fn is_alone(module: &Module, place: Span) -> bool {
    let statement = module
        .statement_at(place.start)
        .map(|at| &module.statements[at]);
    statement.is_some_and(|it| {
        it.span == place
            && matches!(&it.kind, StatementKind::Command { arguments, .. } if arguments.is_empty())
    })
}

/// A name that is not declared is one finding; the others become its labels, and the best guess of its type its help.
fn undeclared(source: &Source, module: &Module, found: &mut Vec<Diagnostic>) {
    let in_title = declared_in_title(source, module);
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
            if !is_guess(first.help.as_ref()) && is_guess(finding.help.as_ref()) {
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
    *found = kept;
}

fn label(span: Span, text: impl Into<Message>) -> Label {
    Label {
        span,
        text: text.into(),
    }
}

/// Whether a help names one type.
fn is_guess(help: Option<&Message>) -> bool {
    matches!(help, Some(Message::Naming(Naming::DeclareAs { .. })))
}

/// The names that line 2 would declare, if it were not the title.
fn declared_in_title(source: &Source, module: &Module) -> HashMap<String, Span> {
    let mut tokens = Vec::new();
    if module.title.is_empty() || lex(source.text(), source.line(2).span, &mut tokens).is_some() {
        return HashMap::new();
    }
    let word = |span: Span| upper_case(source.slice(span));
    let declares = |keyword: Keyword| {
        matches!(
            keyword,
            Keyword::DefVar | Keyword::DefPos | Keyword::DefJoint
        )
    };
    let first = tokens
        .first()
        .and_then(|token| keywords::find(&word(token.span), module.edition));
    match first.is_some_and(declares) {
        true => tokens[1..]
            .iter()
            .filter(|token| token.kind == Kind::Word)
            .map(|token| (word(token.span).to_string(), token.span))
            .collect(),
        false => HashMap::new(),
    }
}
