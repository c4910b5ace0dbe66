//! Operators, numbers and parentheses.

use super::site::Site;
use crate::message::Fixing;
use tipc::diagnostic::{Edit, Fix};
use tipc::lex::{Kind, Token};
use tipc::message::{Message, Parsing, Suggestion};
use tipc::source::Span;

pub(super) fn fix(site: &Site<'_>) -> Option<Fix> {
    match (site.reason(), site.help()) {
        (
            Message::Parsing(Parsing::AssignsComparesNothing | Parsing::NoRelation)
            | Message::Suggestion(Suggestion::NotEqual),
            _,
        ) => relation(site),
        (Message::Suggestion(Suggestion::CompareAsStatement), _) => {
            let operator = site.tokens().get(1)?.span;
            Some(certain(site, operator, "="))
        }
        (_, Some(Message::Suggestion(Suggestion::Increment { sign, .. }))) => increment(site, sign),
        (_, Some(Message::Suggestion(Suggestion::WriteNot))) => not(site),
        (
            Message::Suggestion(Suggestion::NoOperator { .. }),
            Some(Message::Suggestion(Suggestion::Assign { .. })),
        ) => Some(certain(site, site.span(), "=")),
        (_, Some(Message::Suggestion(Suggestion::Comma { whole, point }))) => {
            comma(site, whole, point)
        }
        (_, Some(Message::Suggestion(Suggestion::BlankAfter { command }))) => {
            let title = Fixing::Insert { text: " ".into() };
            let edit = Edit::insert(site.span().start + command.len(), " ");
            Some(Fix::certain(title, [edit]))
        }
        (
            _,
            Some(
                Message::Parsing(Parsing::NoParentheses)
                | Message::Suggestion(
                    Suggestion::NoParentheses
                    | Suggestion::WithoutParentheses { .. }
                    | Suggestion::OpenBlock { .. },
                )
                | Message::Suggestion(Suggestion::Glued { .. } | Suggestion::NoBrackets),
            ),
        ) => parentheses(site),
        _ => None,
    }
}

fn certain(site: &Site<'_>, location: Span, new: &str) -> Fix {
    let title = Fixing::Replace {
        old: site.slice(location).into(),
        new: new.into(),
    };
    Fix::certain(title, [Edit::replace(location, new)])
}

/// `1,000` or `4,5`.
fn comma(site: &Site<'_>, whole: &str, point: &str) -> Option<Fix> {
    let after = site.text().len();
    let start = site.span().end.checked_sub(whole.len() + 1)?;
    let location = Span::new(start, site.span().end);
    // Three digits after a comma are thousands.
    let new = if after == 3 { whole } else { point };
    let fix = certain(site, location, new);
    Some(Fix::likely(fix.title, fix.edits))
}

/// Relations of other languages, and their spelling here.
const RELATIONS: &[(&str, &str)] = &[
    ("===", "=="),
    ("!==", "<>"),
    ("!=", "<>"),
    ("><", "<>"),
    ("=>", ">="),
    ("=<", "<="),
    ("=!", "<>"),
    ("=", "=="),
];

/// `!=`, `=>`, `=`: all signs that stand there together.
fn relation(site: &Site<'_>) -> Option<Fix> {
    let tokens = site.tokens();
    let is_sign = |token: &&Token| !matches!(token.kind, Kind::Word | Kind::Arithmetic(_));
    let start = site.span().start;
    let at = tokens.iter().position(|token| token.span.start == start)?;
    let before = tokens[..at].iter().rev().take_while(is_sign).last();
    let last = tokens[at..].iter().take_while(is_sign).last()?;
    let location = before.unwrap_or(&tokens[at]).span.to(last.span);
    let text = site.slice(location);
    let (_, new) = RELATIONS.iter().find(|(old, _)| *old == text)?;
    Some(certain(site, location, new))
}

/// `A++`
fn increment(site: &Site<'_>, sign: &str) -> Option<Fix> {
    let tokens = site.tokens();
    let location = tokens.get(1)?.span.to(tokens.get(2)?.span);
    let title = Fixing::Replace {
        old: site.slice(location).into(),
        new: format!("{sign}= 1").into(),
    };
    let gap = Span::new(tokens[0].span.end, location.end);
    Some(Fix::certain(
        title,
        [Edit::replace(gap, format!(" {sign}= 1"))],
    ))
}

/// `NOT KB_HIT`; a comparison is turned round by hand.
fn not(site: &Site<'_>) -> Option<Fix> {
    let tokens = site.tokens();
    let at = tokens.iter().position(|token| token.span == site.span())?;
    let next = tokens.get(at + 1)?;
    let is_flag = !matches!(tokens.get(at + 2), Some(it) if matches!(it.kind, Kind::Relation(_)));
    let new = format!("!{}", site.slice(next.span));
    is_flag.then(|| certain(site, site.span().to(next.span), &new))
}

/// Returns the only parentheses of a statement: `SIN(30)`, `(A + B)`, `PTP(F1, 1, 2, 3)`.
fn parentheses(site: &Site<'_>) -> Option<Fix> {
    let statement = site.statement()?.span;
    let text = site.slice(statement);
    let (opens, closes) = (text.find('(')?, text.rfind(')')?);
    let is_one = text.matches(['(', ')']).count() == 2 && opens < closes;
    let inside = Span::new(statement.start + opens + 1, statement.start + closes);
    if !is_one || calculates(site, statement, inside) {
        return None;
    }
    let glued = |char: Option<char>| char.is_some_and(|it| it.is_ascii_alphanumeric() || it == '_');
    let gap = |glued: bool| if glued { " " } else { "" };
    let before = gap(glued(text[..opens].chars().next_back()));
    let after = gap(glued(text[closes + 1..].chars().next()));
    let edits = [
        Edit::replace(Span::new(inside.start - 1, inside.start), before),
        Edit::replace(Span::new(inside.end, inside.end + 1), after),
    ];
    Some(Fix::certain(Fixing::RemoveParentheses, edits))
}

/// Returns true if parentheses hold a calculation that would be another one without them: all but the whole right
/// side.
fn calculates(site: &Site<'_>, statement: Span, inside: Span) -> bool {
    let (before, tokens, after) = (
        site.tokens_of(Span::new(statement.start, inside.start - 1)),
        site.tokens_of(inside),
        site.tokens_of(Span::new(inside.end + 1, statement.end)),
    );
    let is_operator = |token: &Token| matches!(token.kind, Kind::Arithmetic(_) | Kind::Not);
    // A sign follows a comma, or nothing.
    let is_sign = |at: usize| {
        at == 0
            || site
                .slice(tokens[at - 1].span.to(tokens[at].span))
                .contains(',')
    };
    let calculates = (0..tokens.len()).any(|at| is_operator(&tokens[at]) && !is_sign(at));
    let is_assigned = before
        .last()
        .is_some_and(|last| matches!(last.kind, Kind::Assign(_)));
    let is_whole = is_assigned && after.is_empty();
    let is_negated = before.last().is_some_and(is_operator) && tokens.len() > 1;
    let goes_on = !is_assigned && after.first().is_some_and(is_operator);
    calculates && !is_whole || is_negated || goes_on
}
