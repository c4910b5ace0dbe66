//! Braces around blocks: `IF A == 1 {` … `} ELSE {` … `}`.

use super::site::Site;
use crate::message::Fixing;
use tipc::diagnostic::{Edit, Fix};
use tipc::language::Keyword;
use tipc::lex::Kind;
use tipc::message::{Habit, Message};
use tipc::source::Span;
use tipc::syntax::{Shape, Statement};

const CLOSE: &str = "}";

pub(super) fn fix(site: &Site<'_>) -> Option<Fix> {
    match site.reason() {
        Message::Habit(Habit::NoBraces) => block(site),
        _ => None,
    }
}

/// The words of this language for the brace that opens a block, and for those that go on with it or close it.
fn block(site: &Site<'_>) -> Option<Fix> {
    let index = site.index()?;
    let shape = site.module.statements[index].kind.shape();
    let (closer, opener) = match shape {
        Shape::If => (Keyword::EndIf, Some(Keyword::Then)),
        Shape::While => (Keyword::Wend, None),
        Shape::For => (Keyword::Next, None),
        _ => return None,
    };
    let mut edits = vec![opening(site, opener)?];
    let mut depth = 0;
    let after = site.module.statements[index + 1..].iter();
    for statement in after.take_while(|_| site.may_look_at(1)) {
        let text = site.slice(statement.span);
        match statement.kind.shape() {
            Shape::If | Shape::While | Shape::Repeat | Shape::For => depth += 1,
            Shape::EndIf | Shape::Wend | Shape::Until | Shape::Next if depth > 0 => depth -= 1,
            Shape::Close if depth > 0 => depth -= 1,
            Shape::Close => {
                edits.push(only(site, statement, text == CLOSE, closer)?);
                return Some(Fix::certain(Fixing::Words, edits));
            }
            Shape::Else if depth == 0 && text.starts_with(CLOSE) => {
                let braces = text.trim_matches(['{', '}', ' ', '\t']);
                let is_else = braces.eq_ignore_ascii_case(Keyword::Else.word());
                edits.push(only(site, statement, is_else, Keyword::Else)?);
            }
            Shape::ElseIf if depth == 0 && text.starts_with(CLOSE) => return None,
            _ => {}
        }
    }
    None
}

/// The brace at the end of the opening line: THEN, unless it is there or none belongs there.
fn opening(site: &Site<'_>, word: Option<Keyword>) -> Option<Edit> {
    let tokens = site.tokens();
    let before = tokens.len().checked_sub(2)?;
    let (before, brace) = (tokens[before], *tokens.last()?);
    let has_then = site.is(&before, Keyword::Then);
    match word.filter(|_| !has_then && before.kind == Kind::Word) {
        Some(word) => Some(site.write(brace.span, word.word())),
        None => Some(Edit::remove(Span::new(before.span.end, brace.span.end))),
    }
}

/// A keyword in the place of a whole statement, if that is all it was.
fn only(site: &Site<'_>, statement: &Statement, is_all: bool, word: Keyword) -> Option<Edit> {
    is_all.then(|| Edit::replace(statement.span, site.like(word.word())))
}
