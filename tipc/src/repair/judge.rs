//! Whether a changed text is better: what was to be put right is gone, and nothing else is wrong that could be seen before.
//! A statement has one finding at most, so that a second mistake shows when the first is put right.

use crate::code::{Code, Level};
use crate::diagnostic::{Diagnostic, Edit};
use crate::load::Loaded;
use crate::syntax::StatementKind;

/// The findings that are new after these were to be put right. One that is still there counts as new.
pub(super) fn news(
    before: &Loaded,
    after: &Loaded,
    fixed: &[usize],
    edits: &[&Edit],
) -> Vec<usize> {
    let known = before.diagnostics.iter().enumerate();
    let left = known.filter(|(index, _)| !fixed.contains(index));
    let mut left: Vec<_> = left
        .map(|(_, finding)| (key(finding), moved(finding.span.start, edits)))
        .collect();
    let seen = Seen::of(before, edits);
    let found = after.diagnostics.iter().enumerate();
    let mut new: Vec<_> = found
        .filter(|(_, finding)| seen.would_show(finding))
        .map(|(index, finding)| (index, key(finding), finding.span.start))
        .collect();
    // What stands where it stood comes first: its like elsewhere may be new.
    new.retain(|(_, key, at)| !takes(&mut left, |it| (&it.0, it.1) == (key, *at)));
    new.retain(|(_, key, _)| !takes(&mut left, |it| it.0 == *key));
    new.into_iter().map(|(index, ..)| index).collect()
}

/// Takes the first that is alike from those that are left; whether there was one.
fn takes<T>(left: &mut Vec<T>, is_alike: impl Fn(&T) -> bool) -> bool {
    let place = left.iter().position(is_alike);
    place.map(|place| left.swap_remove(place)).is_some()
}

/// Where a place of the text is after a change.
fn moved(at: usize, edits: &[&Edit]) -> usize {
    let before = edits.iter().filter(|edit| edit.span.end <= at);
    before.fold(at, |at, edit| {
        at + edit.text.len() - (edit.span.end - edit.span.start)
    })
}

/// Whether a finding stands on a line that was changed, where the mistake before may have hidden it.
pub(super) fn was_hidden(
    before: &Loaded,
    finding: &Diagnostic,
    after: &Loaded,
    edits: &[&Edit],
) -> bool {
    let (line, _) = after.source.line_column(finding.span.start);
    let same_lines = before.source.line_count() == after.source.line_count();
    let changed = |edit: &&Edit| before.source.line_column(edit.span.start).0 == line;
    same_lines && edits.iter().any(changed)
}

/// What makes two findings the same, wherever they are.
fn key(finding: &Diagnostic) -> (Code, String) {
    (finding.code, finding.reason.to_string())
}

/// What was looked at before the change.
struct Seen {
    /// How far the text was read, as a place of the changed text.
    read: usize,
    /// The blocks were whole, so that the use of variables was judged.
    usage: bool,
    /// There was a program, so that its warnings were known.
    program: bool,
}

impl Seen {
    fn of(before: &Loaded, edits: &[&Edit]) -> Seen {
        let last = before.module.statements.last();
        let end = last.filter(|last| matches!(last.kind, StatementKind::End));
        let read = end.map_or(before.source.text().len(), |end| end.span.end);
        // No further than the start of a change across the end.
        let edits = edits.iter().filter(|edit| edit.span.start < read);
        let (gone, new) = edits.fold((0, 0), |(gone, new), edit| {
            let gone = gone + edit.span.end.min(read) - edit.span.start;
            (gone, new + edit.text.len())
        });
        Seen {
            read: if end.is_some() {
                read + new - gone
            } else {
                usize::MAX
            },
            usage: before
                .diagnostics
                .iter()
                .all(|it| it.code != Code::Structure),
            program: before.program.is_some(),
        }
    }

    /// Whether a finding of the changed text would have been reported before.
    fn would_show(&self, finding: &Diagnostic) -> bool {
        let is_usage = matches!(
            finding.code,
            Code::NeverAssigned | Code::Unused | Code::NeverRead
        );
        let is_warning = finding.level() == Level::Warning;
        finding.span.start < self.read && (self.usage || !is_usage) && (self.program || !is_warning)
    }
}
