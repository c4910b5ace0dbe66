//! What a broken statement was going to be.

use crate::language::Keyword;
use crate::lex::{Kind, Token};
use crate::syntax::Shape;

/// The shape of a statement that starts with `keyword`.
pub(super) fn shape(keyword: Option<Keyword>, text: &str, tokens: &[Token]) -> Shape {
    let Some(keyword) = keyword else {
        return Shape::Plain;
    };
    match keyword {
        Keyword::If if has_statement_after_then(text, tokens) => Shape::OneLineIf,
        Keyword::If if opens_block(text, tokens) => Shape::If,
        Keyword::ElseIf => Shape::ElseIf,
        Keyword::While => Shape::While,
        Keyword::Until => Shape::Until,
        Keyword::For => Shape::For,
        Keyword::Next => Shape::Next,
        Keyword::Subroutine => Shape::Subroutine,
        Keyword::SubEnd => Shape::SubEnd,
        Keyword::If
        | Keyword::Then
        | Keyword::To
        | Keyword::Step
        | Keyword::DefVar
        | Keyword::DefPos
        | Keyword::DefJoint
        | Keyword::Call
        | Keyword::Gosub
        | Keyword::Goto
        | Keyword::Return
        | Keyword::Message
        | Keyword::Rem
        | Keyword::End
        | Keyword::Exit => Shape::Plain,
        // These are never broken: they keep their meaning whatever follows them.
        Keyword::Else | Keyword::EndIf | Keyword::Wend | Keyword::Repeat => Shape::Plain,
    }
}

/// The shape of a statement that was meant to begin with `keyword`.
pub(super) fn meant(keyword: Keyword, text: &str, tokens: &[Token]) -> Shape {
    match keyword {
        Keyword::Else => Shape::Else,
        Keyword::EndIf => Shape::EndIf,
        Keyword::Wend => Shape::Wend,
        Keyword::Repeat => Shape::Repeat,
        keyword => shape(Some(keyword), text, tokens),
    }
}

/// `IF … THEN` with its statement on the same line.
fn has_statement_after_then(text: &str, tokens: &[Token]) -> bool {
    let then = tokens.iter().position(|it| is(text, it, Keyword::Then));
    then.is_some_and(|at| at + 1 < tokens.len())
}

fn is(text: &str, token: &Token, keyword: Keyword) -> bool {
    let span = token.span;
    text[span.start..span.end].eq_ignore_ascii_case(keyword.word())
}

/// An IF opens a block if it contains THEN, or if nothing in it looks like a jump.
fn opens_block(text: &str, tokens: &[Token]) -> bool {
    let jumps = |token: &Token| {
        token.kind == Kind::Colon
            || [Keyword::Goto, Keyword::Gosub, Keyword::Call]
                .iter()
                .any(|word| is(text, token, *word))
    };
    tokens.iter().any(|token| is(text, token, Keyword::Then)) || !tokens.iter().any(jumps)
}
