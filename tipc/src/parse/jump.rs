//! Jumps and the labels they name (T.I.P. 3.1 §7-7).

use super::reader::{Parsed, Reader};
use crate::language::Keyword;
use crate::lex::Kind;
use crate::message::{Habit, Message, Parsing};
use crate::source::Span;
use crate::syntax::{Jump, Word};

impl Reader<'_> {
    /// `GOTO [NAME:]`; the jump's word is already taken.
    pub(super) fn goto(&mut self, keyword: Span) -> Parsed<Jump> {
        if self.left() == 0 {
            return Ok(Jump {
                keyword,
                label: None,
            });
        }
        self.jump(keyword, Keyword::Goto)
    }

    /// `GOSUB NAME:` or `CALL NAME:`; the jump's word is already taken.
    pub(super) fn jump(&mut self, keyword: Span, name: Keyword) -> Parsed<Jump> {
        let label = self.jump_label(name)?;
        Ok(Jump {
            keyword,
            label: Some(label),
        })
    }

    fn jump_label(&mut self, jump: Keyword) -> Parsed<Word> {
        let word = match self.take() {
            Some(token) if token.kind == Kind::Word => self.word(token.span),
            Some(token) => {
                let reason = Parsing::LabelBelongsHere;
                let help = Parsing::WriteJump { jump: jump.into() };
                return Err(self.fault_with_help(token.span, reason, help));
            }
            None => {
                let help = Parsing::WriteJump { jump: jump.into() };
                return Err(self.fault_with_help(self.here(), Parsing::LabelMissing, help));
            }
        };
        match self.peek() {
            Some(token) if token.kind == Kind::Colon && !token.spaced => {
                self.take();
                Ok(word)
            }
            Some(token) if token.kind == Kind::Colon => {
                let gap = Span::new(word.span.end, token.span.end);
                let help = Parsing::WriteLabel { name: word.node };
                Err(self.fault_with_help(gap, Parsing::BlankBeforeColon, help))
            }
            _ => {
                let name = word.node;
                let is_number = name.chars().all(|c| c.is_ascii_digit());
                let help: Message = match is_number {
                    true => Habit::NoLineNumbers { name }.into(),
                    false => Parsing::WriteLabel { name }.into(),
                };
                Err(self.fault_with_help(word.span, Parsing::LabelColonMissing, help))
            }
        }
    }
}
