//! Fixes of words of other languages, misspelled and renamed words, operators, numbers and parentheses.

use super::Site;
use super::statements::initial;
use crate::message::Fixing;
use tip_runtime::command::Op;
use tipc::diagnostic::{Edit, Fix};
use tipc::language::{Keyword, commands};
use tipc::lex::{Kind, Token};
use tipc::message::{Commanding, Message, Naming, Parsing, Structuring, Suggestion};
use tipc::source::Span;

/// Returns no fix.
pub(crate) fn none(_: &Site<'_>) -> Option<Fix> {
    None
}

pub(super) fn words(site: &Site<'_>) -> Option<Fix> {
    match (site.reason(), site.help()?) {
        (_, Message::Structuring(Structuring::DidYouMean { near })) => replace_by(site, near),
        (_, Message::Commanding(Commanding::CalledNow { command })) => {
            Some(certain(site, site.span(), command))
        }
        (Message::Commanding(Commanding::MovesFeet { other, .. }), _) => {
            let command = site.tokens().first()?.span;
            Some(likely(site, command, other))
        }
        (Message::Structuring(Structuring::PlainLabel { .. }), _) => {
            let call = *site.tokens().first()?;
            site.is(&call, Keyword::Call)
                .then(|| certain(site, call.span, Keyword::Gosub.word()))
        }
        (Message::Parsing(Parsing::IfCannotCall), _) => {
            Some(certain(site, site.span(), Keyword::Gosub.word()))
        }
        (_, Message::Suggestion(help)) => suggested(site, help),
        _ => None,
    }
}

fn suggested(site: &Site<'_>, help: &Suggestion) -> Option<Fix> {
    match help {
        Suggestion::DidYouMean { near } => replace_by(site, near),
        Suggestion::Wend => ended(site, Keyword::Wend),
        Suggestion::Next => ended(site, Keyword::Next),
        Suggestion::SubEnd => ended(site, Keyword::SubEnd),
        Suggestion::InOneWord { word } if word == Keyword::ElseIf.word() => branch(site),
        Suggestion::InOneWord { word } => {
            let location = match site.reason() {
                // The unknown word is the first one in `DEF VAR N`, and the second one in `PTP ANGLE`.
                Message::Commanding(_) => in_pieces(site, &site.tokens(), word)?,
                _ => site.span(),
            };
            Some(certain(site, location, word))
        }
        _ => None,
    }
}

/// Returns the location of the words of a statement that `whole` writes as one word.
fn in_pieces(site: &Site<'_>, tokens: &[Token], whole: &str) -> Option<Span> {
    let parts = 1 + whole.matches('_').count();
    (2..=parts.min(tokens.len())).find_map(|count| {
        let words = tokens[..count].iter().map(|token| site.slice(token.span));
        let joined = words.collect::<Vec<_>>().join("_");
        let location = tokens[0].span.to(tokens[count - 1].span);
        joined.eq_ignore_ascii_case(whole).then_some(location)
    })
}

/// Returns the fix of `END WHILE`.
fn ended(site: &Site<'_>, keyword: Keyword) -> Option<Fix> {
    let is_end = matches!(
        site.reason(),
        Message::Suggestion(Suggestion::EndInTwo { .. })
    );
    is_end.then(|| certain(site, site.span(), keyword.word()))
}

/// Returns the fix of `ENDWHILE`.
pub(crate) fn closer(site: &Site<'_>, keyword: Keyword) -> Option<Fix> {
    Some(certain(site, site.span(), keyword.word()))
}

/// Returns the fix of another word for a statement of one word: `RET`, `QUIT`.
pub(crate) fn alone(site: &Site<'_>, keyword: Keyword) -> Option<Fix> {
    (site.tokens().len() == 1).then(|| likely(site, site.span(), keyword.word()))
}

/// Returns the fix of `ELIF c` and `ELSE IF c`.
pub(crate) fn branch(site: &Site<'_>) -> Option<Fix> {
    let mut fix = certain(site, site.span(), Keyword::ElseIf.word());
    fix.edits.extend(then(site, &site.tokens()));
    Some(fix)
}

/// Returns the edit that adds a missing THEN to an ELSEIF of another language, or replaces its colon.
fn then(site: &Site<'_>, tokens: &[Token]) -> Option<Edit> {
    let last = tokens.last()?;
    match last.kind {
        Kind::Colon => Some(Edit::replace(
            last.span,
            format!(" {}", site.like(Keyword::Then.word())),
        )),
        _ if site.is(last, Keyword::Then) => None,
        _ => Some(site.append(last.span.end, Keyword::Then.word())),
    }
}

fn replaced(site: &Site<'_>, location: Span, new: &str) -> Fix {
    let title = Fixing::Replace {
        old: site.slice(location).into(),
        new: new.into(),
    };
    Fix::certain(title, [Edit::replace(location, new)])
}

/// Returns the fix that replaces a text by a word, in small letters if the statement begins with small letters.
fn certain(site: &Site<'_>, location: Span, word: &str) -> Fix {
    replaced(site, location, &site.like(word))
}

fn likely(site: &Site<'_>, location: Span, word: &str) -> Fix {
    let fix = certain(site, location, word);
    Fix::likely(fix.title, fix.edits)
}

/// Returns the fix that replaces a name by one that is near.
fn replace_by(site: &Site<'_>, near: &str) -> Option<Fix> {
    let is_name = matches!(
        site.reason(),
        Message::Naming(Naming::NotDeclared { .. })
            | Message::Structuring(Structuring::NoSuchLabel { .. })
    );
    match is_name {
        true => everywhere(site, near),
        false => Some(likely(site, site.span(), near)),
    }
}

/// Returns the fix that replaces an undeclared name by a word at each location of the diagnostic.
pub(crate) fn everywhere(site: &Site<'_>, word: &str) -> Option<Fix> {
    let name = site.diagnostic.subject.as_deref().unwrap_or_default();
    let locations = [site.span()].into_iter();
    let locations = locations.chain(site.diagnostic.labels.iter().map(|label| label.span));
    let edits = locations.filter_map(|location| {
        // A sign may precede the name, a member follow it.
        let text = site.slice(location);
        let start = location.start + text.len() - text.trim_start_matches(['+', '-']).len();
        let name = Span::new(start, start + name.len());
        let found = site.slice(name);
        let is_name = found.eq_ignore_ascii_case(site.diagnostic.subject.as_deref()?);
        is_name.then(|| site.write(name, word))
    });
    let title = Fixing::Replace {
        old: name.into(),
        new: word.into(),
    };
    Some(Fix::likely(title, edits.collect::<Vec<_>>()))
}

/// Returns the fix of `SUB WALK`, which may also lack its colon.
pub(crate) fn subroutine(site: &Site<'_>) -> Option<Fix> {
    let tokens = site.tokens();
    let mut fix = certain(site, site.span(), Keyword::Subroutine.word());
    match tokens.as_slice() {
        [_, name] if name.kind == Kind::Word => fix.edits.push(Edit::insert(name.span.end, ":")),
        [_, name, colon] if name.kind == Kind::Word && colon.kind == Kind::Colon => {}
        _ => return None,
    }
    Some(fix)
}

/// Returns the fix of `JUMP L1` and `GO TO L1:`.
pub(crate) fn goto(site: &Site<'_>) -> Option<Fix> {
    let tokens = site.tokens();
    let second = tokens.get(1).filter(|second| site.is(second, Keyword::To));
    let (location, rest) = match second {
        Some(second) => (site.span().to(second.span), &tokens[2..]),
        None => (site.span(), &tokens[1.min(tokens.len())..]),
    };
    let mut fix = certain(site, location, Keyword::Goto.word());
    match rest {
        [label] if label.kind == Kind::Word => fix.edits.push(Edit::insert(label.span.end, ":")),
        [_, colon] if colon.kind == Kind::Colon => {}
        _ => return None,
    }
    Some(fix)
}

/// Returns the fix of `LET A = 1`.
pub(crate) fn assignment(site: &Site<'_>) -> Option<Fix> {
    let [word, name, operator, ..] = *site.tokens() else {
        return None;
    };
    let is_equation = name.kind == Kind::Word && matches!(operator.kind, Kind::Assign(_));
    let title = Fixing::Remove { text: "LET".into() };
    let rest = Span::new(word.span.start, name.span.start);
    is_equation.then(|| Fix::certain(title, [Edit::remove(rest)]))
}

/// Returns the fix of `WAIT INPOS ALL` and `WAIT 200`.
pub(crate) fn wait(site: &Site<'_>) -> Option<Fix> {
    let tokens = site.tokens();
    let [word, second, rest @ ..] = tokens.as_slice() else {
        return None;
    };
    let joined = format!("{}_{}", site.slice(word.span), site.slice(second.span));
    if commands::find(&joined).is_some() {
        let location = word.span.to(second.span);
        return Some(certain(site, location, &joined));
    }
    let is_number = site.slice(second.span).parse::<f64>().is_ok();
    let is_alone = is_number && rest.is_empty();
    is_alone.then(|| likely(site, word.span, Op::Sleep.name()))
}

/// Returns the fix of `VAR N` and `DIM N = 0`.
pub(crate) fn declaration(site: &Site<'_>, keyword: Keyword) -> Option<Fix> {
    let tokens = site.tokens();
    if site.slice(site.statement()?.span).contains('(') {
        return None;
    }
    let mut fix = certain(site, site.span(), keyword.word());
    let are_names = tokens.iter().all(|token| token.kind == Kind::Word);
    if !are_names {
        fix.edits.push(initial(site, &tokens)?.1);
    }
    Some(fix)
}

/// Returns the fix of `CONST N = 3`: DEFINE has no `=`.
pub(crate) fn constant(site: &Site<'_>) -> Option<Fix> {
    let has_sign = site.tokens().iter().any(|it| it.kind != Kind::Word);
    has_sign.then(|| declaration(site, Keyword::DefVar))?
}

pub(super) fn operators(site: &Site<'_>) -> Option<Fix> {
    match (site.reason(), site.help()) {
        (
            Message::Parsing(Parsing::AssignsComparesNothing | Parsing::NoRelation)
            | Message::Suggestion(Suggestion::NotEqual),
            _,
        ) => relation(site),
        (Message::Suggestion(Suggestion::CompareAsStatement), _) => {
            let operator = site.tokens().get(1)?.span;
            Some(replaced(site, operator, "="))
        }
        (_, Some(Message::Suggestion(Suggestion::Increment { sign, .. }))) => increment(site, sign),
        (_, Some(Message::Suggestion(Suggestion::WriteNot))) => not(site),
        (
            Message::Suggestion(Suggestion::NoOperator { .. }),
            Some(Message::Suggestion(Suggestion::Assign { .. })),
        ) => Some(replaced(site, site.span(), "=")),
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

/// Returns the fix of `1,000` or `4,5`.
fn comma(site: &Site<'_>, whole: &str, point: &str) -> Option<Fix> {
    let after = site.text().len();
    let start = site.span().end.checked_sub(whole.len() + 1)?;
    let location = Span::new(start, site.span().end);
    // Three digits after a comma are thousands.
    let new = if after == 3 { whole } else { point };
    let fix = replaced(site, location, new);
    Some(Fix::likely(fix.title, fix.edits))
}

/// Relations of other languages, and their spelling in T.I.P.
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

/// Returns the fix of a relation of another language: `!=`, `=>`, `=`. Neighbouring signs are replaced together.
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
    Some(replaced(site, location, new))
}

/// Returns the fix of `A++`.
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

/// Returns the fix of `NOT KB_HIT`. A negated comparison has no fix.
fn not(site: &Site<'_>) -> Option<Fix> {
    let tokens = site.tokens();
    let at = tokens.iter().position(|token| token.span == site.span())?;
    let next = tokens.get(at + 1)?;
    let is_flag = !matches!(tokens.get(at + 2), Some(it) if matches!(it.kind, Kind::Relation(_)));
    let new = format!("!{}", site.slice(next.span));
    is_flag.then(|| replaced(site, site.span().to(next.span), &new))
}

/// Returns the fix that removes the only parentheses of a statement: `SIN(30)`, `(A + B)`, `PTP(F1, 1, 2, 3)`.
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

/// Returns true if parentheses change the result of a calculation: they hold an operation, and are not the whole right
/// side.
fn calculates(site: &Site<'_>, statement: Span, inside: Span) -> bool {
    let (before, tokens, after) = (
        site.tokens_of(Span::new(statement.start, inside.start - 1)),
        site.tokens_of(inside),
        site.tokens_of(Span::new(inside.end + 1, statement.end)),
    );
    let is_operator = |token: &Token| matches!(token.kind, Kind::Arithmetic(_) | Kind::Not);
    // A sign after a comma, or at the beginning, is not an operation.
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
