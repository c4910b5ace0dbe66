//! What a broken statement was going to be.

use crate::lex::{Kind, Token};
use crate::syntax::Shape;

/// The shape of a statement that starts with `keyword`.
pub(super) fn shape(keyword: &str, text: &str, tokens: &[Token]) -> Shape {
    match keyword {
        "IF" if opens_block(text, tokens) => Shape::If,
        "ELSEIF" => Shape::ElseIf,
        "WHILE" => Shape::While,
        "UNTIL" => Shape::Until,
        "FOR" => Shape::For,
        "NEXT" => Shape::Next,
        "SUBROUTINE" => Shape::Subroutine,
        "SUBEND" => Shape::SubEnd,
        _ => Shape::Plain,
    }
}

/// An IF opens a block if THEN stands in it, or if nothing in it looks like a jump.
fn opens_block(text: &str, tokens: &[Token]) -> bool {
    let is = |token: &Token, word: &str| {
        let span = token.span;
        text[span.start..span.end].eq_ignore_ascii_case(word)
    };
    let jumps = |token: &Token| {
        token.kind == Kind::Colon || ["GOTO", "GOSUB", "CALL"].iter().any(|word| is(token, word))
    };
    tokens.iter().any(|token| is(token, "THEN")) || !tokens.iter().any(jumps)
}
