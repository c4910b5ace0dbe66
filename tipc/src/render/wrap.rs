//! Texts that fit a terminal.

use crate::source::first_beyond;

/// The fewest columns that a text is broken for.
const LEAST: usize = 20;

/// The text with line breaks, so that each line fits into what `used` columns leave of the width. It breaks at blanks and
/// beside full-width characters, not inside of code between backquotes.
pub(super) fn wrapped(text: &str, width: Option<usize>, used: usize) -> String {
    let room = width.and_then(|width| width.checked_sub(used));
    let Some(room) = room.filter(|room| *room >= LEAST) else {
        return text.to_owned();
    };
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(beyond) = first_beyond(rest, room) {
        let breaks = |at: &usize| rest.is_char_boundary(*at) && may_break(rest, *at);
        let at = (1..=beyond).rev().find(breaks).unwrap_or(beyond);
        let (line, after) = rest.split_at(at);
        out += line.trim_end();
        out.push('\n');
        rest = after.trim_start();
    }
    out + rest
}

/// Whether a line may end before the byte `at`.
fn may_break(text: &str, at: usize) -> bool {
    let (line, rest) = text.split_at(at);
    let is_in_code = line.matches('`').count() % 2 == 1;
    let (Some(before), Some(after)) = (line.chars().next_back(), rest.chars().next()) else {
        return false;
    };
    let is_wide = !before.is_ascii() || !after.is_ascii();
    let sticks = "、。)…".contains(after) || before == '(';
    !is_in_code && (before == ' ' || is_wide && !sticks)
}
