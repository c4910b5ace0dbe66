//! Jumps and the labels they name (T.I.P. 3.1 §7-7).

use super::Parser;
use super::reader::{Parsed, Reader};
use crate::language::reserved::LOOP;
use crate::language::{Keyword, commands, names};
use crate::lex::{Kind, Token};
use crate::message::{Message, Naming, Parsing, Suggestion};
use crate::source::Span;
use crate::syntax::{Arithmetic, Jump, Shape, StatementKind, Word, upper_case};
use smol_str::SmolStr;

/// Returns a label's name without quotes, parentheses and other signs around it.
pub(super) fn bare(name: &str) -> SmolStr {
    let is_sign = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
    match name.trim_matches(is_sign) {
        "" => name.into(),
        bare => bare.into(),
    }
}

/// `GOTOL1`: a jump and its label without the blank between them.
pub fn glued(word: &str) -> Option<(Keyword, &str)> {
    let jumps = [Keyword::Goto, Keyword::Gosub, Keyword::Call];
    let parts = |jump: Keyword| Some((jump, word.strip_prefix(jump.word())?));
    let is_label = |(_, label): &(Keyword, &str)| names::is_label(label);
    jumps.into_iter().filter_map(parts).find(is_label)
}

/// Returns the name of a routine that another language gives arguments: `WALK` of `WALK(3)`.
pub(super) fn with_parameters(name: &str) -> Option<SmolStr> {
    let (name, rest) = name.split_once('(')?;
    (!name.is_empty() && rest != ")").then(|| name.into())
}

/// Returns a name in one piece: `MAIN_LOOP` of `MAIN-LOOP` and `MAIN LOOP`.
pub(super) fn joined(written: &str) -> SmolStr {
    let words = written.split(['-', ' ', '\t', ',', '\u{3000}']);
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    words.join("_").into()
}

/// Finds the end of a label's name that has blanks or a `-` in it: the tokens after its first word, up to a colon.
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

/// The marks of labels in other languages that are part of a word.
const MARKS: [char; 4] = ['@', '$', '&', '.'];

/// `*L1`, `@L1`, labels of other languages: where one stands, and its name here.
pub(super) fn marked(text: &str, tokens: &[Token]) -> Option<(Span, SmolStr)> {
    let tokens = match tokens {
        [rest @ .., colon] if colon.kind == Kind::Colon => rest,
        all => all,
    };
    let word = |token: &Token| &text[token.span.start..token.span.end];
    match tokens {
        [name] => {
            let bare = word(name).strip_prefix(MARKS)?;
            names::is_variable(bare).then(|| (name.span, upper_case(bare)))
        }
        [star, name] => {
            let is_label = star.kind != Kind::Word && name.kind == Kind::Word && !name.spaced;
            is_label.then(|| (star.span.to(name.span), upper_case(word(name))))
        }
        _ => None,
    }
}

/// Returns the mistake of a label in the form of another language: its jumps are wrong in the same way.
pub(crate) fn label_of(name: &str) -> String {
    format!("{name}:")
}

impl Reader<'_> {
    /// Returns the whole name of a label that is not in one piece.
    fn spread_label(&self, first: Span) -> Option<Span> {
        self.left_tokens()
            .split_last()
            .filter(|(last, _)| last.kind == Kind::Colon)
            .and_then(|_| spread(self.text(), first, self.left_tokens()))
    }

    /// `GOTO [NAME:]`; the jump's word is already taken.
    pub(super) fn goto(&mut self, keyword: Span) -> Parsed<(Jump, Parsed<()>)> {
        if self.left() == 0 {
            let jump = Jump {
                keyword,
                label: None,
                broken: false,
            };
            return Ok((jump, Ok(())));
        }
        self.jump(keyword, Keyword::Goto)
    }

    /// `GOSUB NAME:` or `CALL NAME:`; the jump's word is already taken. One without its colon leads there, too.
    pub(super) fn jump(&mut self, keyword: Span, name: Keyword) -> Parsed<(Jump, Parsed<()>)> {
        let (label, colon) = self.jump_label(name)?;
        let jump = Jump {
            keyword,
            label: Some(label),
            broken: colon.is_err(),
        };
        Ok((jump, colon))
    }

    /// Reads a label, and what is wrong with its colon.
    fn jump_label(&mut self, jump: Keyword) -> Parsed<(Word, Parsed<()>)> {
        // `GOTO *L1`
        if let Some((location, name)) = marked(self.text(), self.left_tokens()) {
            let reason = Naming::NoLabelName {
                word: upper_case(self.slice(location)),
            };
            let fault = self.fault(location, reason).once(label_of(&name));
            return Err(fault.help(Parsing::WriteLabel { name }).into());
        }
        let word = match self.take() {
            Some(token) if token.kind == Kind::Word => self.word(token.span),
            Some(token) => {
                let help = Parsing::WriteJump { jump: jump.into() };
                return Err(self.fault_with_help(token.span, Parsing::LabelBelongsHere, help));
            }
            None => {
                let help = Parsing::WriteJump { jump: jump.into() };
                return Err(self.fault_with_help(self.here(), Parsing::LabelMissing, help));
            }
        };
        if let Some(location) = self.spread_label(word.span) {
            let written = upper_case(self.slice(location));
            let name = joined(&written);
            let reason = Naming::NoLabelName { word: written };
            let fault = self.fault(location, reason).once(label_of(&name));
            return Err(fault.help(Parsing::WriteLabel { name }).into());
        }
        match self.peek() {
            Some(token) if token.kind == Kind::Colon && !token.spaced => {
                self.take();
                Ok((word, Ok(())))
            }
            Some(token) if token.kind == Kind::Colon => {
                let gap = Span::new(word.span.end, token.span.end);
                let name = word.node.clone();
                let help = Parsing::WriteLabel { name };
                let fault = self.fault_with_help(gap, Parsing::BlankBeforeColon, help);
                Ok((word, Err(fault)))
            }
            _ => {
                if let Some(name) = with_parameters(&word.node) {
                    let fault = self.fault(word.span, Parsing::LabelColonMissing);
                    let fault = fault.once(name.clone());
                    return Err(fault.help(Suggestion::NoParameters { name }).into());
                }
                let name = bare(&word.node);
                let is_number = name.chars().all(|c| c.is_ascii_digit());
                let help: Message = match is_number {
                    true => Suggestion::NoLineNumbers { name: name.clone() }.into(),
                    false => Parsing::WriteLabel { name: name.clone() }.into(),
                };
                let fault = self.fault_with_help(word.span, Parsing::LabelColonMissing, help);
                match is_number || !names::is_label(&name) {
                    true => Err(fault),
                    false => Ok((Word { node: name, ..word }, Err(fault))),
                }
            }
        }
    }
}

impl Parser<'_> {
    /// Reads a SUBROUTINE whose line is reported: what calls it is not wrong.
    pub(super) fn broken_subroutine(&self, word: Span, tokens: &[Token]) -> StatementKind {
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
