//! Judgement of a changed text. It is better if the mistake is gone, and nothing else is wrong that could be seen
//! before. A statement has one diagnostic at most, so that a second mistake shows when the first is fixed.

use crate::Loaded;
use std::collections::{HashMap, HashSet};
use std::hash::Hash;
use tipc::code::{Code, Level};
use tipc::diagnostic::{Diagnostic, Edit};
use tipc::syntax::StatementKind;

/// Returns the diagnostics that are new after these were to be put right. One that is still there counts as new.
pub(super) fn news(
    before: &Loaded,
    after: &Loaded,
    fixed: &[usize],
    edits: &[&Edit],
) -> Vec<usize> {
    let fixed: HashSet<usize> = fixed.iter().copied().collect();
    let ends = Ends::of(edits);
    let mut here: HashMap<(Key, usize), usize> = HashMap::new();
    let mut anywhere: HashMap<Key, usize> = HashMap::new();
    for (index, diagnostic) in before.diagnostics.iter().enumerate() {
        if !fixed.contains(&index) {
            let location = ends.moved(diagnostic.span.start);
            *here.entry((key(diagnostic), location)).or_default() += 1;
            *anywhere.entry(key(diagnostic)).or_default() += 1;
        }
    }
    let seen = Seen::of(before, &ends, edits);
    let found = after.diagnostics.iter().enumerate();
    let mut new: Vec<_> = found
        .filter(|(_, diagnostic)| seen.would_show(diagnostic))
        .collect();
    // What stands where it stood comes first: its like elsewhere may be new.
    new.retain(|(_, diagnostic)| {
        let stays = takes(&mut here, &(key(diagnostic), diagnostic.span.start));
        !(stays && takes(&mut anywhere, &key(diagnostic)))
    });
    new.retain(|(_, diagnostic)| !takes(&mut anywhere, &key(diagnostic)));
    new.into_iter().map(|(index, _)| index).collect()
}

/// Takes one of those that are left; whether there was one.
fn takes<K: Hash + Eq>(left: &mut HashMap<K, usize>, key: &K) -> bool {
    match left.get_mut(key) {
        Some(count) if *count > 0 => {
            *count -= 1;
            true
        }
        _ => false,
    }
}

/// Ends of edits, in the text before and in the changed one.
struct Ends(Vec<(usize, usize)>);

impl Ends {
    /// Computes the ends of edits in their order.
    fn of(edits: &[&Edit]) -> Ends {
        let (mut gone, mut new) = (0, 0);
        let ends = edits.iter().map(|edit| {
            gone += edit.span.end - edit.span.start;
            new += edit.text.len();
            (edit.span.end, edit.span.end + new - gone)
        });
        Ends(ends.collect())
    }

    /// Returns the offset after the change.
    fn moved(&self, at: usize) -> usize {
        let passed = self.0.partition_point(|(end, _)| *end <= at);
        let last = passed.checked_sub(1).map(|last| self.0[last]);
        last.map_or(at, |(before, after)| after + (at - before))
    }
}

/// Returns the diagnostics on lines that were not changed: no mistake before may have hidden them.
pub(super) fn not_hidden(
    before: &Loaded,
    after: &Loaded,
    diagnostics: &[usize],
    edits: &[&Edit],
) -> Vec<usize> {
    let same_lines = before.source.line_count() == after.source.line_count();
    let changed = edits.iter().filter(|_| same_lines);
    let changed = changed.map(|edit| before.source.line_column(edit.span.start).0);
    let changed: HashSet<u32> = changed.collect();
    let line = |index: usize| {
        let start = after.diagnostics[index].span.start;
        after.source.line_column(start).0
    };
    let diagnostics = diagnostics.iter().copied();
    diagnostics
        .filter(|index| !changed.contains(&line(*index)))
        .collect()
}

/// Returns the lines before the change that hold an edit, if a diagnostic stands there after it.
pub(super) fn lines(
    before: &Loaded,
    after: &Loaded,
    diagnostics: &[usize],
    edits: &[&Edit],
) -> HashSet<u32> {
    let line = |index: &usize| {
        let start = after.diagnostics[*index].span.start;
        after.source.line_column(start).0
    };
    let found: HashSet<u32> = diagnostics.iter().map(line).collect();
    let ends = Ends::of(edits);
    let is_found = |edit: &&&Edit| {
        let end = ends.moved(edit.span.end);
        found.contains(&after.source.line_column(end).0)
    };
    let edits = edits.iter().filter(is_found);
    edits
        .map(|edit| before.source.line_column(edit.span.start).0)
        .collect()
}

/// Key by which two diagnostics are the same, wherever they are.
type Key = (Code, String);

fn key(diagnostic: &Diagnostic) -> Key {
    (diagnostic.code, diagnostic.reason.to_string())
}

/// Facts of the text before the change.
struct Seen {
    /// End of the text that was read, as an offset of the changed text.
    read: usize,
    /// The blocks were whole, so that the use of variables was judged.
    usage: bool,
    /// There was a program, so that its warnings were known.
    program: bool,
    /// Offsets, in the changed text, of the last reported error and warning, if further ones were omitted.
    last: [Option<usize>; 2],
}

impl Seen {
    fn of(before: &Loaded, ends: &Ends, edits: &[&Edit]) -> Seen {
        let last = before.module.statements.last();
        let end = last.filter(|last| matches!(last.kind, StatementKind::End));
        let read = end.map_or(before.source.text().len(), |end| end.span.end);
        // No further than the start of a change across the end.
        let edits = edits.iter().filter(|edit| edit.span.start < read);
        let last = [Level::Error, Level::Warning].map(|level| {
            let omitted = before.omitted.of_level(level, before.module.edition);
            let of_level = |it: &&Diagnostic| it.level() == level;
            let last = before.diagnostics.iter().rfind(of_level);
            let last = last.map_or(0, |last| ends.moved(last.span.start));
            (omitted > 0).then_some(last)
        });
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
            last,
        }
    }

    /// Returns true if a diagnostic of the changed text would have been reported before.
    fn would_show(&self, diagnostic: &Diagnostic) -> bool {
        let is_usage = matches!(
            diagnostic.code,
            Code::NeverAssigned | Code::Unused | Code::NeverRead
        );
        let is_warning = diagnostic.level() == Level::Warning;
        let last = self.last[usize::from(is_warning)];
        last.is_none_or(|last| diagnostic.span.start < last)
            && diagnostic.span.start < self.read
            && (self.usage || !is_usage)
            && (self.program || !is_warning)
    }
}
