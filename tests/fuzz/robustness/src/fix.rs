//! Fixes: what they write loads with no new finding, a program that loads goes on to, and nothing is left to be done.

use tip_lint::load;
use tip_lint::repair::{Applied, confirm, render_json, render_short, repair};
use tipc::code::{Code, Level};
use tipc::diagnostic::{Applicability, Diagnostic};
use tipc::message::{Lang, Message, Suggestion};
use tipc::{Loaded, Options};

/// Puts right what is certain in the bytes, then what is likely.
///
/// # Panics
/// A fix does other than it says, or has a new finding.
pub fn examine(bytes: &[u8]) {
    let options = Options::default();
    let before = load("random.prg", bytes, &options);
    for least in [Applicability::Certain, Applicability::Likely] {
        let repaired = repair(before.clone(), &options, least);
        for lang in Lang::ALL {
            render_short(&repaired, *lang);
            render_json(&repaired, *lang);
        }
        let (applied, after) = (repaired.applied, repaired.loaded);
        let written = after.source.bytes();
        let seen = String::from_utf8_lossy(bytes);
        assert_eq!(applied.is_empty(), written == bytes, "{seen}");
        let again = load("random.prg", &written, &options);
        assert_eq!(again.diagnostics, after.diagnostics, "{seen}");
        assert!(
            before.program.is_none() || after.program.is_some(),
            "{seen}"
        );
        if !applied.iter().any(shows_more) {
            let (old, new) = (errors(&before, &before), errors(&after, &before));
            let gone = seen_before(&applied, &before, &after);
            assert!(new + gone <= old, "{seen}\n{applied:#?}");
        }
    }
    confirm(before, &options);
}

/// Returns the number of errors, without those that `before` could not have had: without whole blocks, the use of variables
/// is not judged.
fn errors(loaded: &Loaded, before: &Loaded) -> usize {
    let is_broken = before
        .diagnostics
        .iter()
        .any(|it| it.code == Code::Structure);
    let could_be = |code: Code| !is_broken || code != Code::NeverAssigned;
    let errors = loaded
        .diagnostics
        .iter()
        .filter(|it| it.level() == Level::Error);
    errors.filter(|it| could_be(it.code)).count()
}

/// Returns how many of the fixed errors had been found before; the others hid behind those of their lines, and
/// have their like elsewhere: on another line or, where a fix has moved lines, in another column.
fn seen_before(applied: &[Applied], before: &Loaded, after: &Loaded) -> usize {
    let lines_stay = before.source.line_count() == after.source.line_count();
    let mut known: Vec<_> = before.diagnostics.iter().collect();
    let errors = applied.iter();
    let errors = errors.filter(|it| it.diagnostic.level() == Level::Error);
    let seen = errors.filter(|it| {
        let is_same = |other: &&Diagnostic| {
            let (line, column) = before.source.line_column(other.span.start);
            let is_here = if lines_stay {
                line == it.line
            } else {
                column == it.column
            };
            is_here && other.code == it.diagnostic.code && other.reason == it.diagnostic.reason
        };
        let place = known.iter().position(is_same);
        place.map(|place| known.swap_remove(place)).is_some()
    });
    seen.count()
}

/// Returns true if what was fixed hid the rest of the program.
fn shows_more(applied: &Applied) -> bool {
    matches!(
        applied.diagnostic.reason,
        Message::Suggestion(Suggestion::EndInTwo { .. })
    )
}
