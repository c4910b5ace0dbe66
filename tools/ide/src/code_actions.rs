//! Edits of the text: fixes of diagnostics, each tried before it is offered, and formatting.

use crate::Document;
use crate::message::Editing;
use tip_lint::format::{Refusal, format};
use tip_lint::message::Formatting;
use tip_lint::repair::{confirm, repair};
use tipc::diagnostic::{Applicability, Edit};
use tipc::message::Message;
use tipc::source::{Encoding, Source, Span};

/// A fix of a diagnostic, or of the whole file.
#[derive(Clone, Debug, PartialEq)]
pub struct CodeAction {
    /// Its title.
    pub title: Message,
    /// The index in `Loaded::diagnostics` of the diagnostic that it fixes; `None` for the whole file.
    pub diagnostic: Option<usize>,
    /// True if the fix is certainly what the author meant.
    pub is_certain: bool,
    /// The edits, in order and without overlaps.
    pub edits: Vec<Edit>,
}

impl Document {
    /// Returns the fixes of the diagnostics that touch a span. Each was tried: its diagnostic is gone afterwards, and no new one
    /// appears.
    pub fn code_actions(&self, span: Span) -> Vec<CodeAction> {
        let touches = |other: Span| other.start <= span.end && span.start <= other.end;
        let mut trial = self.loaded.clone();
        for one in &mut trial.diagnostics {
            if !touches(one.span) {
                one.fixes.clear();
            }
        }
        let confirmed = confirm(trial, &self.options);
        let mut actions = Vec::new();
        for (index, one) in confirmed.diagnostics.into_iter().enumerate() {
            actions.extend(one.fixes.into_iter().map(|fix| {
                let mut edits = fix.edits;
                edits.sort_by_key(|edit| edit.span);
                CodeAction {
                    title: fix.title,
                    diagnostic: Some(index),
                    is_certain: fix.applicability == Applicability::Certain,
                    edits,
                }
            }));
        }
        actions
    }

    /// Returns all certain fixes of the file as one action; `None` if there are none.
    pub fn fix_all(&self) -> Option<CodeAction> {
        let repaired = repair(self.loaded.clone(), &self.options, Applicability::Certain);
        if repaired.applied.is_empty() {
            return None;
        }
        Some(CodeAction {
            title: Editing::FixAll.into(),
            diagnostic: None,
            is_certain: true,
            edits: line_edits(&self.loaded.source, &repaired.loaded.source),
        })
    }
}

impl Document {
    /// Returns the edits that format the text, one for each line that changes.
    ///
    /// # Errors
    ///
    /// The program has errors, or cannot be written in the style.
    pub fn format(&self) -> Result<Vec<Edit>, Formatting> {
        let source = &self.loaded.source;
        let bytes = source.bytes();
        let formatted = match format(source.name(), &bytes, &self.options) {
            Ok(formatted) => formatted,
            Err(Refusal::Diagnostics(_)) => return Err(Formatting::DoesNotLoad),
            Err(Refusal::Because(reason)) => return Err(reason),
        };
        let (after, _) = Source::decode(source.name(), &formatted, Encoding::Utf8);
        Ok(line_edits(source, &after))
    }
}

/// Returns an edit for each line that differs. Formatting and fixes neither join nor split lines.
fn line_edits(before: &Source, after: &Source) -> Vec<Edit> {
    if before.line_count() != after.line_count() {
        return difference(before.text(), after.text());
    }
    let lines = before.lines().zip(after.lines());
    let whole = |line: tipc::source::Line| Span::new(line.span.start, line.end.end);
    let changed = lines.flat_map(|(old, new)| {
        let (old, new) = (whole(old), whole(new));
        let edits = difference(before.slice(old), after.slice(new));
        edits.into_iter().map(move |edit| Edit {
            span: Span::new(edit.span.start + old.start, edit.span.end + old.start),
            ..edit
        })
    });
    changed.collect()
}

/// Returns the edit that turns a text into another: the part between their common prefix and suffix. It does not split a CR LF.
fn difference(before: &str, after: &str) -> Vec<Edit> {
    if before == after {
        return Vec::new();
    }
    let pairs = || before.char_indices().zip(after.chars());
    let start = pairs()
        .find(|((_, old), new)| old != new)
        .map_or(before.len().min(after.len()), |((at, _), _)| at);
    let start = before_line_end(before, after, start);
    let (old, new) = (&before[start..], &after[start..]);
    let same = old.chars().rev().zip(new.chars().rev());
    let same: usize = same
        .take_while(|(old, new)| old == new)
        .map(|(char, _)| char.len_utf8())
        .sum();
    let (end_old, end_new) = (before.len() - same, after.len() - same);
    let is_cut = |text: &str, at: usize| text[..at].ends_with('\r') && text[at..].starts_with('\n');
    let more = usize::from(is_cut(before, end_old) || is_cut(after, end_new));
    let span = Span::new(start, end_old + more);
    vec![Edit::replace(span, &after[start..end_new + more])]
}

fn before_line_end(before: &str, after: &str, start: usize) -> usize {
    let is_after_return = before[..start].ends_with('\r');
    let has_feed = before[start..].starts_with('\n') || after[start..].starts_with('\n');
    start - usize::from(is_after_return && has_feed)
}
