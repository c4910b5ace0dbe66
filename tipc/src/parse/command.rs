//! Any other command and its arguments.

use super::Parser;
use super::reader::Reader;
use crate::code::Code;
use crate::lex::{Kind, Token};
use crate::source::Span;
use crate::syntax::{StatementKind, Word, upper_case};

impl Parser<'_> {
    /// A command word and its arguments. Whether the command exists is not known here, and a misspelt one is
    /// reported as such, whatever follows it: so faults in its arguments travel with it.
    pub(super) fn command(&self, keyword: Span, tokens: &[Token]) -> StatementKind {
        let mut reader = Reader::new(self.text, tokens, 1, Code::Argument);
        let (arguments, read) = reader.operands();
        StatementKind::Command {
            name: self.command_word(keyword, tokens),
            arguments,
            malformed: read.err(),
        }
    }

    /// The command word; an operator in its place is shown as one.
    fn command_word(&self, keyword: Span, tokens: &[Token]) -> Word {
        let span = tokens.first().map(|token| token.span).unwrap_or_default();
        let node = match tokens.first() {
            Some(token) if token.kind != Kind::Word => self.source.slice(span).into(),
            _ => upper_case(self.source.slice(keyword)),
        };
        Word { node, span }
    }
}
