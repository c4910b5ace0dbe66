//! Arguments: numbers as other languages and countries write them, flags, and what a command does not take.

use super::operators::certain;
use super::site::Site;
use crate::message::Fixing;
use tip_runtime::command::{ABSOLUTE, RELATIVE, Target};
use tipc::diagnostic::{Edit, Fix};
use tipc::message::{Habit, Message};
use tipc::source::Span;

pub(super) fn fix(site: &Site<'_>) -> Option<Fix> {
    let Message::Habit(habit) = site.help()? else {
        return None;
    };
    match habit {
        Habit::Comma { whole, point } => comma(site, whole, point),
        Habit::NoHex { value } => Some(certain(site, site.span(), &value.to_string())),
        Habit::NoUnit => unit(site),
        Habit::FlagApart { .. } => Some(flags(site)),
        Habit::FlagOfTarget { flag } => {
            let place = Span::new(before(site)?.start, site.span().end);
            Some(certain(site, place, &site.like(flag)))
        }
        Habit::NoTarget { .. } => no_target(site),
        Habit::NextStatement => {
            let gap = Span::new(before(site)?.end, site.span().start);
            let edit = Edit::replace(gap, site.next_line());
            Some(Fix::likely(Fixing::OwnLines, [edit]))
        }
        _ => None,
    }
}

/// `1,000` or `4,5`.
fn comma(site: &Site<'_>, whole: &str, point: &str) -> Option<Fix> {
    let after = site.text().len();
    let start = site.span().end.checked_sub(whole.len() + 1)?;
    let place = Span::new(start, site.span().end);
    // Three digits after a comma are thousands.
    let new = if after == 3 { whole } else { point };
    let fix = certain(site, place, new);
    Some(Fix::likely(fix.title, fix.edits))
}

/// The units that numbers are in.
const UNITS: &[&str] = &["MM", "DEG", "MS", "MSEC"];

/// `100ms`, `100 ms`.
fn unit(site: &Site<'_>) -> Option<Fix> {
    let text = site.text();
    let digits = text.len()
        - text
            .trim_start_matches(|c: char| c.is_ascii_digit() || c == '.')
            .len();
    let is_ours = UNITS
        .iter()
        .any(|unit| unit.eq_ignore_ascii_case(&text[digits..]));
    let start = match digits {
        0 => before(site)?.end,
        _ => site.span().start + digits,
    };
    let title = Fixing::Remove {
        text: text[digits..].into(),
    };
    let rest = Span::new(start, site.span().end);
    is_ours.then(|| Fix::certain(title, [Edit::remove(rest)]))
}

/// `R50 R0 R0`: all of the statement, since they are reported one by one.
fn flags(site: &Site<'_>) -> Fix {
    let glued = |word: &str| {
        let (flag, number) = word.split_at_checked(1)?;
        let is_flag = [RELATIVE, ABSOLUTE]
            .iter()
            .any(|it| it.eq_ignore_ascii_case(flag));
        let is_number = number.parse::<u32>().is_ok();
        (is_flag && is_number).then(|| format!("{flag} {number}"))
    };
    let edits = site.tokens().into_iter().filter_map(|token| {
        let apart = glued(site.slice(token.span))?;
        Some(Edit::replace(token.span, apart))
    });
    let edits: Vec<Edit> = edits.collect();
    let title = Fixing::Apart;
    Fix::certain(title, edits)
}

/// `ALL_STOP ALL`
fn no_target(site: &Site<'_>) -> Option<Fix> {
    let is_all = site.text().to_ascii_uppercase().parse() == Ok(Target::All);
    let gap = Span::new(before(site)?.end, site.span().end);
    let title = Fixing::Remove {
        text: site.text().into(),
    };
    is_all.then(|| Fix::certain(title, [Edit::remove(gap)]))
}

/// The word before the place of the finding.
fn before(site: &Site<'_>) -> Option<Span> {
    let tokens = site.tokens();
    let before = tokens
        .iter()
        .take_while(|it| it.span.start < site.span().start);
    before.last().map(|token| token.span)
}
