//! The one style, as changes of the text.

use crate::Document;
use tip_lint::format::{Refusal, format};
use tip_lint::message::Formatting;
use tipc::diagnostic::Edit;
use tipc::source::{Encoding, Source, Span};

impl Document {
    /// What brings the text into the one style: a change for each line that is not in it.
    ///
    /// # Errors
    ///
    /// The program has errors, or cannot be written in the style.
    pub fn format(&self) -> Result<Vec<Edit>, Formatting> {
        let source = &self.loaded.source;
        let bytes = source.bytes();
        let formatted = match format(source.name(), &bytes, &self.options) {
            Ok(formatted) => formatted,
            Err(Refusal::Findings(_)) => return Err(Formatting::DoesNotLoad),
            Err(Refusal::Because(reason)) => return Err(reason),
        };
        let (after, _) = Source::decode(source.name(), &formatted, Encoding::Utf8);
        Ok(by_lines(source, &after))
    }
}

/// A change for each line that differs; lines are neither joined nor parted.
pub(crate) fn by_lines(before: &Source, after: &Source) -> Vec<Edit> {
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

/// One change that turns a text into another: what is between their common beginning and end. A line end is not cut.
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
