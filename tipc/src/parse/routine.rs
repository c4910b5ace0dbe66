//! Routines of other languages: `SUB WALK`, `DEF WALK():`, `VOID LOOP() {`.

use super::Parser;
use super::jump::bare;
use crate::foreign::{self, Means};
use crate::language::Keyword;
use crate::language::reserved::LOOP;
use crate::lex::{Kind, Token};
use crate::source::Span;
use crate::syntax::{Shape, StatementKind, Word};

impl Parser<'_> {
    /// `DEF WALK()`, `INT MAIN(VOID) {`: a routine, not a variable.
    pub(super) fn is_routine(&self, means: Means, tokens: &[Token]) -> bool {
        let word = |at: usize| tokens.get(at).map_or("", |it| self.source.slice(it.span));
        let name = word(1);
        let is_def = word(0).eq_ignore_ascii_case("DEF") && name.contains('(');
        means == Means::Keyword(Keyword::Subroutine)
            || is_def
            || name.contains("()")
            || name.contains('(') && self.names_main(tokens)
    }

    /// Whether a routine is the program itself in another language.
    pub(super) fn names_main(&self, tokens: &[Token]) -> bool {
        let name = tokens.get(1).map_or("", |it| self.source.slice(it.span));
        let (name, called) = name.split_once('(').unwrap_or((name, ""));
        foreign::is_main(name) && (!called.is_empty() || name.eq_ignore_ascii_case("MAIN"))
    }

    /// A routine that begins with another word: what calls it is not wrong.
    pub(super) fn subroutine_named(&self, word: Span, tokens: &[Token]) -> StatementKind {
        let name = tokens.get(1).filter(|token| token.kind == Kind::Word);
        let Some(name) = name.map(|name| self.narrow_word(name.span)) else {
            return StatementKind::Broken(Shape::Subroutine);
        };
        let written = name.node.split('(').next().unwrap_or_default();
        let node = bare(written);
        if node == LOOP {
            return StatementKind::Broken(Shape::Subroutine);
        }
        StatementKind::Subroutine {
            keyword: word,
            name: Word { node, ..name },
        }
    }
}
