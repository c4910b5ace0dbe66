//! Applies fixes to a file until none is left that does what it says.
//!
//! A fix counts only if the changed text, read again, no longer has the diagnostic and has no new one. All other bytes of the file stay
//! as they are.
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
use std::cell::Cell;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::hash::Hash;
use tip_runtime::printable::Printable;
use tipc::code::{Code, Level};
use tipc::diagnostic::{Applicability, Diagnostic, Edit, Fix};
use tipc::message::Lang;
use tipc::render::{push_member, push_number, push_string};
use tipc::source::Span;
use tipc::syntax::StatementKind;

/// The most times that a file is read again.
const MAX_READINGS: usize = 200;

/// The most bytes that are read again to try the fixes of a file: what is not tried is not offered.
const MIN_READ_BYTES: usize = 1 << 18;

/// Number of times that a file is read again, whatever its length, if its fixes are asked for.
const MIN_READINGS: usize = 8;

/// The most mistakes of one line that are put right one after the other.
const MAX_HIDDEN: usize = 4;

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
    /// The file as it is then, and what is left to say of it.
    pub loaded: Loaded,
}

/// Applies the fixes that are at least as sure as `least` to what was loaded with `options`, and those of what then is found.
pub fn repair(loaded: Loaded, options: &Options, least: Applicability) -> Repaired {
    apply(loaded, options, least, MIN_READINGS)
}

/// Returns what [`repair`] would do at least, as far as it takes little time.
pub fn preview(loaded: Loaded, options: &Options, least: Applicability) -> Repaired {
    apply(loaded, options, least, 1)
}

/// Applies fixes; the file may be read again this `often`, and a short one more often.
fn apply(loaded: Loaded, options: &Options, least: Applicability, often: usize) -> Repaired {
    let length = loaded.source.text().len();
    let mut repair = Repair {
        options,
        least,
        follows: true,
        readings: MAX_READINGS,
        bytes: Cell::new(MIN_READ_BYTES.max(often * length)),
        applied: Vec::new(),
        loaded,
    };
    while repair.round() {}
    Repaired {
        applied: repair.applied,
        loaded: repair.loaded,
    }
}

/// Keeps the fixes of what was loaded with `options` that do what they say: those that, applied alone or with others, put
/// their diagnostic right without a new one.
pub fn confirm(loaded: Loaded, options: &Options) -> Loaded {
    let mut repair = Repair {
        options,
        least: Applicability::Likely,
        follows: false,
        readings: MAX_READINGS,
        bytes: Cell::new(MIN_READ_BYTES.max(loaded.source.text().len())),
        applied: Vec::new(),
        loaded,
    };
    let mut confirmed = HashSet::new();
    let mut tried = HashSet::new();
    loop {
        let candidates = repair.candidates(&tried);
        if candidates.is_empty() {
            break;
        }
        let mut accepted = None;
        repair.accept(&candidates, &mut accepted);
        tried.extend(candidates);
        confirmed.extend(accepted.into_iter().flat_map(|it: Accepted| it.diagnostics));
    }
    for (index, diagnostic) in repair.loaded.diagnostics.iter_mut().enumerate() {
        if !confirmed.contains(&index) {
            diagnostic.fixes.clear();
        }
    }
    repair.loaded
}

struct Repair<'a> {
    options: &'a Options,
    least: Applicability,
    /// True if what another mistake hid on its line may be fixed along with it.
    follows: bool,
    readings: usize,
    /// Number of bytes that may still be read again.
    bytes: Cell<usize>,
    applied: Vec<Applied>,
    loaded: Loaded,
}

/// The diagnostics that are put right together, and what comes of the file.
struct Accepted {
    diagnostics: Vec<usize>,
    /// Hidden mistakes, which are fixed as well.
    hidden: Vec<Applied>,
    loaded: Loaded,
}

impl Repair<'_> {
    /// Applies the fixes that go together. Returns true if there were any.
    fn round(&mut self) -> bool {
        let candidates = self.candidates(&HashSet::new());
        let mut accepted = None;
        self.accept(&candidates, &mut accepted);
        let Some(accepted) = accepted else {
            return false;
        };
        let applied = self.applied(&self.loaded, &accepted.diagnostics);
        self.applied.extend(applied);
        self.applied.extend(accepted.hidden);
        self.loaded = accepted.loaded;
        true
    }

    /// Returns what the fixes of these diagnostics remove.
    fn applied(&self, before: &Loaded, diagnostics: &[usize]) -> Vec<Applied> {
        let applied = diagnostics.iter().filter_map(|index| {
            let diagnostic = &before.diagnostics[*index];
            let (line, column) = before.source.line_column(diagnostic.span.start);
            Some(Applied {
                line,
                column,
                diagnostic: diagnostic.clone(),
                fix: self.fix(diagnostic)?.clone(),
            })
        });
        applied.collect()
    }

    /// Returns the fix of a diagnostic, if it is sure enough.
    fn fix<'d>(&self, diagnostic: &'d Diagnostic) -> Option<&'d Fix> {
        let mut fixes = diagnostic.fixes.iter();
        fixes.find(|fix| fix.applicability <= self.least)
    }

    /// Returns the diagnostics, but for some, whose fixes do not touch each other.
    fn candidates(&self, tried: &HashSet<usize>) -> Vec<usize> {
        let mut taken = Taken::default();
        let found = self.loaded.diagnostics.iter().enumerate();
        let free = found.filter(|(index, diagnostic)| {
            let fix = self.fix(diagnostic).filter(|_| !tried.contains(index));
            fix.is_some_and(|fix| taken.take(&fix.edits))
        });
        free.map(|(index, _)| index).collect()
    }

    /// Adds these diagnostics to those that are put right; of several that do not go together, what does.
    fn accept(&mut self, diagnostics: &[usize], accepted: &mut Option<Accepted>) {
        if diagnostics.is_empty() || self.readings == 0 {
            return;
        }
        self.readings -= 1;
        let mut together = accepted
            .as_ref()
            .map_or(Vec::new(), |it| it.diagnostics.clone());
        together.extend(diagnostics);
        let lines = match self.attempt(together) {
            Ok(better) => {
                *accepted = Some(better);
                return;
            }
            Err(lines) => lines,
        };
        // What stands where something new was found comes last.
        let is_at = |index: &usize| {
            let fix = self.fix(&self.loaded.diagnostics[*index]);
            let mut edits = fix.into_iter().flat_map(|fix| &fix.edits);
            edits.any(|edit| lines.contains(&self.loaded.source.line_column(edit.span.start).0))
        };
        let (mut second, mut first): (Vec<usize>, Vec<usize>) =
            diagnostics.iter().copied().partition(is_at);
        if first.is_empty() || second.is_empty() {
            let (one, other) = diagnostics.split_at(diagnostics.len() / 2);
            (first, second) = (one.to_vec(), other.to_vec());
        }
        if !first.is_empty() {
            self.accept(&first, accepted);
            self.accept(&second, accepted);
        }
    }

    /// Returns the file with the fixes of these diagnostics, if it is better; else the changed lines on which something
    /// new is found. Mistakes hidden by these on their lines are fixed, too.
    fn attempt(&self, diagnostics: Vec<usize>) -> Result<Accepted, HashSet<u32>> {
        let (mut loaded, mut new) = self.changed(&self.loaded, &diagnostics)?;
        let mut hidden = Vec::new();
        for _ in 0..MAX_HIDDEN {
            if new.is_empty() {
                return Ok(Accepted {
                    diagnostics,
                    hidden,
                    loaded,
                });
            }
            let can_follow = |index: &usize| self.fix(&loaded.diagnostics[*index]).is_some();
            if !self.follows || !new.iter().all(can_follow) {
                // No line was put in or taken out.
                let follows = |index: &&usize| self.follows && can_follow(index);
                let rest = new.iter().filter(|index| !follows(index));
                let starts = rest.map(|index| loaded.diagnostics[*index].span.start);
                return Err(starts
                    .map(|start| loaded.source.line_column(start).0)
                    .collect());
            }
            hidden.extend(self.applied(&loaded, &new));
            (loaded, new) = self.changed(&loaded, &new)?;
        }
        Err(HashSet::new())
    }

    /// Returns a file with the fixes of some diagnostics, and the diagnostics that are new then, if all of them were hidden;
    /// else the changed lines on which the others are.
    fn changed(
        &self,
        before: &Loaded,
        diagnostics: &[usize],
    ) -> Result<(Loaded, Vec<usize>), HashSet<u32>> {
        let found = diagnostics.iter().map(|index| &before.diagnostics[*index]);
        let fixes: Vec<&Fix> = found
            .filter_map(|diagnostic| self.fix(diagnostic))
            .collect();
        let mut taken = Taken::default();
        if !fixes.iter().all(|fix| taken.take(&fix.edits)) {
            return Err(HashSet::new());
        }
        let mut edits: Vec<&Edit> = fixes.iter().flat_map(|fix| &fix.edits).collect();
        edits.sort_by_key(|edit| edit.span);
        let source = &before.source;
        let changes = edits.iter().map(|edit| (edit.span, edit.text.as_str()));
        let bytes = source.changed(changes.clone());
        let Some(left) = self.bytes.get().checked_sub(bytes.len()) else {
            return Err(HashSet::new());
        };
        self.bytes.set(left);
        let loaded = load_all_errors(source.name(), &bytes, self.options);
        if loaded.source.text() != spliced(source.text(), changes) {
            return Err(HashSet::new());
        }
        let new = news(before, &loaded, diagnostics, &edits);
        let is_shown = not_hidden(before, &loaded, &new, &edits);
        match is_shown.is_empty() {
            true => Ok((loaded, new)),
            false => Err(lines(before, &loaded, &is_shown, &edits)),
        }
    }
}

// Judgement of a changed text: it is better if the mistake is gone, and nothing else is wrong that could be seen before. A
// statement has one diagnostic at most, so that a second mistake shows when the first is fixed.

/// Returns the diagnostics that are new after these were to be put right. One that is still there counts as new.
fn news(before: &Loaded, after: &Loaded, fixed: &[usize], edits: &[&Edit]) -> Vec<usize> {
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
    // A diagnostic that stands where it stood comes first: an equal one elsewhere may be new.
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
fn not_hidden(
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
fn lines(before: &Loaded, after: &Loaded, diagnostics: &[usize], edits: &[&Edit]) -> HashSet<u32> {
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

/// Returns a text with others in the place of some spans.
fn spliced<'a>(text: &str, changes: impl Iterator<Item = (Span, &'a str)>) -> String {
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    for (span, new) in changes {
        out += &text[at..span.start];
        out += new;
        at = span.end;
    }
    out + &text[at..]
}

/// Label in place of the level of a diagnostic.
const LEVEL: &str = "fixed";

/// `FILE:LINE:COLUMN: fixed[CODE]: <what was done>`, one line each.
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
