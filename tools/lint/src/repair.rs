//! Applies fixes to a file until no working fix is left.
//!
//! A fix works if the changed text no longer has the diagnostic and has no new one. All other bytes of the file stay.
//!
//! ```
//! use tipc::diagnostic::Applicability;
//! use tip_lint::repair::repair;
//! use tip_lint::{Options, load};
//!
//! let bytes = b"3.1\r\nwait\r\nIF KB_HIT\r\nREM\r\nEND IF\r\nEND\r\n";
//! let options = Options::default();
//! let repaired = repair(load("wait.prg", bytes, &options), &options, Applicability::Certain);
//! assert_eq!(repaired.applied.len(), 2);
//! assert!(repaired.loaded.program.is_some());
//! let bytes = repaired.loaded.source.bytes();
//! assert_eq!(bytes, b"3.1\r\nwait\r\nIF KB_HIT THEN\r\nREM\r\nENDIF\r\nEND\r\n");
//! ```

use crate::{Loaded, Options, load_all_errors};
use std::collections::{BTreeMap, HashMap, HashSet};
use tip_runtime::printable::Printable;
use tipc::code::{Code, Level};
use tipc::diagnostic::{Applicability, Diagnostic, Edit, Fix};
use tipc::message::Lang;
use tipc::render::{push_member, push_number, push_string};
use tipc::syntax::StatementKind;

/// Maximum number of bytes that are read to try the fixes of a file, unless reading the file once takes more.
const MAX_READ_BYTES: usize = 1 << 18;

/// Maximum number of mistakes of a line that are fixed one after the other.
const MAX_HIDDEN: usize = 4;

/// Maximum number of times that a file is read again, even if it is short.
const MAX_READINGS: usize = 200;
/// Number of times that [`repair`] may read a file again, even if it is long.
const MIN_READINGS: usize = 8;

/// A diagnostic that was put right.
#[derive(Clone, Debug, PartialEq)]
pub struct Applied {
    /// Its line from 1, in the text that it was found in: fixes before it may have moved it.
    pub line: u32,
    /// Its column in characters from 1.
    pub column: u32,
    /// The diagnostic that was fixed.
    pub diagnostic: Diagnostic,
    /// The fix that removed it.
    pub fix: Fix,
}

/// A file after its fixes.
#[derive(Clone, Debug)]
pub struct Repaired {
    /// Applied fixes, in order.
    pub applied: Vec<Applied>,
    /// The fixed file with its remaining diagnostics.
    pub loaded: Loaded,
}

/// Applies the fixes that are at least as certain as `least` to a file that was loaded with `options`, then those of
/// diagnostics that show up, and so on.
pub fn repair(loaded: Loaded, options: &Options, least: Applicability) -> Repaired {
    apply(loaded, options, least, MIN_READINGS)
}

/// Returns a part of the result of [`repair`] in a short time.
pub fn preview(loaded: Loaded, options: &Options, least: Applicability) -> Repaired {
    apply(loaded, options, least, 1)
}

/// Applies all fixes that do not touch each other and reads the file again, until no fix works any more.
fn apply(loaded: Loaded, options: &Options, least: Applicability, readings: usize) -> Repaired {
    let mut trials = Trials::new(&loaded, options, least, readings);
    trials.hidden = MAX_HIDDEN;
    let mut repaired = Repaired {
        applied: Vec::new(),
        loaded,
    };
    let mut refused = HashSet::new();
    loop {
        let loaded = &repaired.loaded;
        let identity = |index: usize| {
            let diagnostic = &loaded.diagnostics[index];
            let line = loaded.source.line_column(diagnostic.span.start).0;
            let text = loaded.source.slice(loaded.source.line(line).span);
            (key(diagnostic), text.to_owned())
        };
        let batch = trials.candidates(loaded, |index| !refused.contains(&identity(index)));
        let Some(first) = batch.first() else {
            return repaired;
        };
        match trials.better(loaded, &batch) {
            Some((_, better)) => {
                repaired.applied.extend(better.applied);
                repaired.loaded = better.loaded;
            }
            None => _ = refused.insert(identity(*first)),
        }
    }
}

/// Keeps the fixes of a file that was loaded with `options` that work, applied alone or with others, and removes the
/// other fixes.
pub fn confirm(mut loaded: Loaded, options: &Options) -> Loaded {
    let mut trials = Trials::new(&loaded, options, Applicability::Likely, 1);
    let mut confirmed: HashSet<usize> = HashSet::new();
    let mut tried: HashSet<usize> = HashSet::new();
    loop {
        let batch = trials.candidates(&loaded, |index| !tried.contains(&index));
        if batch.is_empty() {
            break;
        }
        let better = trials.better(&loaded, &batch);
        let count = better.map_or(0, |(count, _)| count);
        confirmed.extend(&batch[..count]);
        tried.extend(&batch[..count.max(1)]);
    }
    for (index, diagnostic) in loaded.diagnostics.iter_mut().enumerate() {
        if !confirmed.contains(&index) {
            diagnostic.fixes.clear();
        }
    }
    loaded
}

/// Trials of fixes, and the number that is left.
struct Trials<'a> {
    options: &'a Options,
    least: Applicability,
    /// Maximum number of mistakes of a line that are fixed after the one that hid them.
    hidden: usize,
    /// Number of times that the file may still be read again.
    left: usize,
}

impl<'a> Trials<'a> {
    fn new(loaded: &Loaded, options: &'a Options, least: Applicability, readings: usize) -> Self {
        let length = loaded.source.text().len().max(1);
        Trials {
            options,
            least,
            hidden: 0,
            left: (MAX_READ_BYTES / length).clamp(readings, MAX_READINGS),
        }
    }

    /// Returns the fix of a diagnostic, if it is sure enough.
    fn fix<'d>(&self, diagnostic: &'d Diagnostic) -> Option<&'d Fix> {
        let mut fixes = diagnostic.fixes.iter();
        fixes.find(|fix| fix.applicability <= self.least)
    }

    /// Returns the wanted diagnostics whose fixes do not touch each other; nothing if no trial is left.
    fn candidates(&self, loaded: &Loaded, is_wanted: impl Fn(usize) -> bool) -> Vec<usize> {
        let mut taken = Taken::default();
        let found = loaded.diagnostics.iter().enumerate();
        let free = found.filter(|(index, diagnostic)| {
            let fix = self.fix(diagnostic).filter(|_| is_wanted(*index));
            self.left > 0 && fix.is_some_and(|fix| taken.take(&fix.edits))
        });
        free.map(|(index, _)| index).collect()
    }

    /// Tries to fix all diagnostics of a batch together, then the first half of it, and so on. Returns the number that
    /// works and the fixed file.
    fn better(&mut self, loaded: &Loaded, batch: &[usize]) -> Option<(usize, Repaired)> {
        let mut count = batch.len();
        while count > 0 {
            if let Some(better) = self.changed(loaded, &batch[..count], self.hidden) {
                return Some((count, better));
            }
            count /= 2;
        }
        None
    }

    /// Returns the file with the fixes of some diagnostics, if that removes them and adds none. Diagnostics that they
    /// hid on their lines are fixed as well, at most `hidden` times.
    fn changed(&mut self, before: &Loaded, indices: &[usize], hidden: usize) -> Option<Repaired> {
        self.left = self.left.checked_sub(1)?;
        let fixed: Vec<_> = indices.iter().map(|it| &before.diagnostics[*it]).collect();
        let fixes = fixed.iter().filter_map(|diagnostic| self.fix(diagnostic));
        let mut edits: Vec<&Edit> = fixes.flat_map(|fix| &fix.edits).collect();
        edits.sort_by_key(|edit| edit.span);
        let overlaps = |pair: &[&Edit]| pair[0].span.end > pair[1].span.start;
        if edits.windows(2).any(overlaps) {
            return None;
        }
        let source = &before.source;
        let bytes = source.changed(edits.iter().map(|edit| (edit.span, edit.text.as_str())));
        let after = load_all_errors(source.name(), &bytes, self.options);
        if after.source.text() != spliced(source.text(), &edits) {
            return None;
        }
        let new = self.revealed(before, &after, &fixed, &edits)?;
        let applied = indices.iter();
        let applied = applied.filter_map(|index| self.applied(before, *index));
        let mut repaired = Repaired {
            applied: applied.collect(),
            loaded: after,
        };
        if !new.is_empty() {
            let rest = self.changed(&repaired.loaded, &new, hidden.checked_sub(1)?)?;
            repaired.applied.extend(rest.applied);
            repaired.loaded = rest.loaded;
        }
        Some(repaired)
    }

    /// Returns the new diagnostics after some were fixed, if each may have been hidden before. A statement has at most
    /// one diagnostic, so a fixed statement may show another one. Diagnostics that could not be reported before do not
    /// count.
    fn revealed(
        &self,
        before: &Loaded,
        after: &Loaded,
        fixed: &[&Diagnostic],
        edits: &[&Edit],
    ) -> Option<Vec<usize>> {
        let visible = Visible::of(before, edits);
        let mut allowed: HashMap<Key, usize> = HashMap::new();
        for diagnostic in &before.diagnostics {
            *allowed.entry(key(diagnostic)).or_default() += 1;
        }
        for diagnostic in fixed {
            *allowed.entry(key(diagnostic)).or_default() -= 1;
        }
        let has_same_lines = before.source.line_count() == after.source.line_count();
        let changed = edits.iter().filter(|_| has_same_lines);
        let changed: HashSet<u32> = changed
            .map(|edit| before.source.line_column(edit.span.start).0)
            .collect();
        let mut new = Vec::new();
        for (index, diagnostic) in after.diagnostics.iter().enumerate() {
            if !visible.shows(diagnostic) {
                continue;
            }
            let count = allowed.entry(key(diagnostic)).or_default();
            let line = after.source.line_column(diagnostic.span.start).0;
            if *count > 0 {
                *count -= 1;
            } else if changed.contains(&line) && self.fix(diagnostic).is_some() {
                new.push(index);
            } else {
                return None;
            }
        }
        Some(new)
    }

    /// Returns a diagnostic with its fix, as applied.
    fn applied(&self, before: &Loaded, index: usize) -> Option<Applied> {
        let diagnostic = &before.diagnostics[index];
        let (line, column) = before.source.line_column(diagnostic.span.start);
        Some(Applied {
            line,
            column,
            diagnostic: diagnostic.clone(),
            fix: self.fix(diagnostic)?.clone(),
        })
    }
}

/// Key of a diagnostic without its location.
type Key = (Code, String);

fn key(diagnostic: &Diagnostic) -> Key {
    (diagnostic.code, diagnostic.reason.to_string())
}

/// The diagnostics that could be reported before a change.
struct Visible {
    /// End of the program text, as an offset of the changed text: nothing is read after END.
    end: usize,
    /// True if the blocks were whole, so that the use of variables was judged.
    has_usage: bool,
    /// True if there was a program, so that its warnings were known.
    has_warnings: bool,
    /// Offsets, in the changed text, of the last reported error and warning, if further ones were omitted.
    last: [Option<usize>; 2],
}

impl Visible {
    fn of(before: &Loaded, edits: &[&Edit]) -> Visible {
        // An edit that reaches beyond an offset counts up to the offset.
        let moved = |at: usize| {
            let passed = edits.iter().filter(|edit| edit.span.start < at);
            let change = |(gone, new), edit: &&Edit| {
                let gone = gone + edit.span.end.min(at) - edit.span.start;
                (gone, new + edit.text.len())
            };
            let (gone, new) = passed.fold((0, 0), change);
            at + new - gone
        };
        let last = before.module.statements.last();
        let end = last.filter(|last| matches!(last.kind, StatementKind::End));
        let last = [Level::Error, Level::Warning].map(|level| {
            let omitted = before.omitted.of_level(level, before.module.edition);
            let of_level = |it: &&Diagnostic| it.level() == level;
            let last = before.diagnostics.iter().rfind(of_level);
            (omitted > 0).then(|| last.map_or(0, |last| moved(last.span.start)))
        });
        Visible {
            end: end.map_or(usize::MAX, |end| moved(end.span.end)),
            has_usage: (before.diagnostics.iter()).all(|it| it.code != Code::Structure),
            has_warnings: before.program.is_some(),
            last,
        }
    }

    /// Returns true if a diagnostic of the changed text would have been reported before.
    fn shows(&self, diagnostic: &Diagnostic) -> bool {
        let is_usage = matches!(
            diagnostic.code,
            Code::NeverAssigned | Code::Unused | Code::NeverRead
        );
        let is_warning = diagnostic.level() == Level::Warning;
        let last = self.last[usize::from(is_warning)];
        last.is_none_or(|last| diagnostic.span.start < last)
            && diagnostic.span.start < self.end
            && (self.has_usage || !is_usage)
            && (self.has_warnings || !is_warning)
    }
}

/// Returns a text with some edits, in their order.
fn spliced(text: &str, edits: &[&Edit]) -> String {
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    for edit in edits {
        out += &text[at..edit.span.start];
        out += &edit.text;
        at = edit.span.end;
    }
    out + &text[at..]
}

/// Label in place of the level of a diagnostic.
const LEVEL: &str = "fixed";

/// Returns a line `FILE:LINE:COLUMN: fixed[CODE]: <title of the fix>` for each fix.
pub fn render_short(repaired: &Repaired, lang: Lang) -> String {
    let name = repaired.loaded.source.name();
    let line = |one: &Applied| {
        let (code, title) = (one.diagnostic.id(), one.fix.title.in_lang(lang));
        let (line, column) = (one.line, one.column);
        let text = format_args!("{name}:{line}:{column}: {LEVEL}[{code}]: {title}");
        Printable::line(text).to_string() + "\n"
    };
    repaired.applied.iter().map(line).collect()
}

/// Returns one object a line: `level` (`fixed`), `message` (what was done), `applicability`, `code`, `file`, `line`,
/// `column`.
pub fn render_json(repaired: &Repaired, lang: Lang) -> String {
    let name = repaired.loaded.source.name();
    let object = |one: &Applied| {
        let mut out = String::from("{\"level\":");
        push_string(&mut out, LEVEL);
        push_member(
            &mut out,
            "message",
            &one.fix.title.in_lang(lang).to_string(),
        );
        push_member(&mut out, "applicability", one.fix.applicability.name());
        push_member(&mut out, "code", one.diagnostic.id());
        push_member(&mut out, "file", name);
        push_number(&mut out, "line", one.line);
        push_number(&mut out, "column", one.column);
        out + "}\n"
    };
    repaired.applied.iter().map(object).collect()
}

/// The starts and ends of stretches that do not touch.
#[derive(Debug, Default)]
struct Taken(BTreeMap<usize, usize>);

impl Taken {
    /// Takes the stretches of some edits, unless one of them touches what is taken.
    fn take(&mut self, edits: &[Edit]) -> bool {
        let is_free = edits.iter().all(|edit| self.is_free(edit));
        if is_free {
            let stretches = edits.iter().map(|edit| (edit.span.start, edit.span.end));
            self.0.extend(stretches);
        }
        is_free
    }

    fn is_free(&self, edit: &Edit) -> bool {
        let before = self.0.range(..=edit.span.end).next_back();
        before.is_none_or(|(_, end)| *end < edit.span.start)
    }
}

#[cfg(test)]
mod tests {
    use super::Taken;
    use tipc::diagnostic::Edit;
    use tipc::source::Span;

    #[test]
    fn edits_that_touch_are_not_taken_together() {
        let edit = |start, end| Edit::remove(Span::new(start, end));
        let mut taken = Taken::default();
        assert!(taken.take(&[edit(10, 12), edit(20, 20)]));
        for touches in [
            edit(10, 12),
            edit(11, 11),
            edit(8, 10),
            edit(9, 30),
            edit(12, 15),
            edit(20, 20),
            edit(19, 20),
        ] {
            assert!(!taken.take(&[edit(40, 41), touches.clone()]), "{touches:?}");
        }
        assert!(taken.take(&[edit(13, 19), edit(40, 41)]));
        assert!(!taken.take(&[edit(41, 41)]));
        assert!(taken.take(&[edit(0, 9)]));
    }
}
