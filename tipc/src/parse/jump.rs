//! Jumps and the labels they name (T.I.P. 3.1 §7-7).

use super::reader::{Parsed, Reader};
use crate::language::{Keyword, commands};
use crate::lex::{Kind, Token};
use crate::message::{Habit, Message, Naming, Parsing};
use crate::source::Span;
use crate::syntax::{Arithmetic, Jump, Word, upper_case};
use smol_str::SmolStr;

/// A label's name without quotes, parentheses and other signs around it.
pub(super) fn bare(name: &str) -> SmolStr {
    let is_sign = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
    match name.trim_matches(is_sign) {
        "" => name.into(),
        bare => bare.into(),
    }
}

/// A name in one piece: `MAIN_LOOP` of `MAIN-LOOP` and `MAIN LOOP`.
pub(super) fn joined(written: &str) -> SmolStr {
    let words = written.split(['-', ' ', '\t', ',', '\u{3000}']);
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    words.join("_").into()
}

/// Where the name of a label ends that has blanks or a `-` in it: the tokens after its first word, up to a colon.
pub(super) fn spread(text: &str, first: Span, rest: &[Token]) -> Option<Span> {
    let colon = rest.iter().position(|token| token.kind == Kind::Colon)?;
    let (between, colon) = (&rest[..colon], rest[colon]);
    let is_part = |token: &Token| {
        let word = &text[token.span.start..token.span.end];
        let is_word = token.kind == Kind::Word && commands::find(word).is_none();
        is_word || token.kind == Kind::Arithmetic(Arithmetic::Sub)
    };
    let last = between.last().filter(|last| last.kind == Kind::Word)?;
    (between.iter().all(is_part) && !colon.spaced).then(|| first.to(last.span))
}

impl Reader<'_> {
    /// The whole name of a label that is not in one piece.
    fn spread_label(&self, first: Span) -> Option<Span> {
        self.left_tokens()
            .split_last()
            .filter(|(last, _)| last.kind == Kind::Colon)
            .and_then(|_| spread(self.text(), first, self.left_tokens()))
    }

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
                let name = self.peek().filter(|name| name.kind == Kind::Word);
                let help = match name.filter(|name| !name.spaced) {
                    // `GOTO *L1`
                    Some(name) => Parsing::WriteLabel {
                        name: self.word(name.span).node,
                    },
                    None => Parsing::WriteJump { jump: jump.into() },
                };
                return Err(self.fault_with_help(token.span, reason, help));
            }
            None => {
                let help = Parsing::WriteJump { jump: jump.into() };
                return Err(self.fault_with_help(self.here(), Parsing::LabelMissing, help));
            }
        };
        if let Some(place) = self.spread_label(word.span) {
            let written = upper_case(self.slice(place));
            let help = Parsing::WriteLabel {
                name: joined(&written),
            };
            let reason = Naming::NoLabelName { word: written };
            return Err(self.fault_with_help(place, reason, help));
        }
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
                let name = bare(&word.node);
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
