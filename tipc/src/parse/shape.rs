//! What a broken statement was going to be.

use crate::language::Keyword;
use crate::lex::{Kind, Token};
use crate::syntax::Shape;

/// The shape of a statement that starts with `keyword`.
pub(super) fn shape(keyword: Option<Keyword>, text: &str, tokens: &[Token]) -> Shape {
    match keyword {
        Some(Keyword::If) if opens_block(text, tokens) => Shape::If,
        Some(Keyword::ElseIf) => Shape::ElseIf,
        Some(Keyword::While) => Shape::While,
        Some(Keyword::Until) => Shape::Until,
        Some(Keyword::For) => Shape::For,
        Some(Keyword::Next) => Shape::Next,
        Some(Keyword::Subroutine) => Shape::Subroutine,
        Some(Keyword::SubEnd) => Shape::SubEnd,
        _ => Shape::Plain,
    }
}

/// An IF opens a block if it contains THEN, or if nothing in it looks like a jump.
fn opens_block(text: &str, tokens: &[Token]) -> bool {
    let is = |token: &Token, keyword: Keyword| {
        let span = token.span;
        text[span.start..span.end].eq_ignore_ascii_case(keyword.word())
    };
    let jumps = |token: &Token| {
        token.kind == Kind::Colon
            || [Keyword::Goto, Keyword::Gosub, Keyword::Call]
                .iter()
                .any(|word| is(token, *word))
    };
    tokens.iter().any(|token| is(token, Keyword::Then)) || !tokens.iter().any(jumps)
}
