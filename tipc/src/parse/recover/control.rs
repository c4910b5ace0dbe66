//! Jumps, labels and ends of statements as other languages write them.

use crate::diagnostic::MistakeId;
use crate::language::reserved::LOOP;
use crate::language::{Keyword, commands, keywords, names};
use crate::lex::{Kind, Token};
use crate::message::phrase::End;
use crate::message::{Message, Naming, Parsing, Suggestion};
use crate::parse::Parser;
use crate::parse::reader::{Broken, Fault, Parsed, Reader};
use crate::source::Span;
use crate::suggest::nearest;
use crate::syntax::{Arithmetic, Jump, Shape, StatementKind, Then, Word, upper_case};
use smol_str::SmolStr;
use tip_runtime::command::Flag;

impl Reader<'_> {
    /// Reads a statement after THEN, as in `IF A == 1 THEN SLEEP 100`. A jump, as in `IF A == 1 THEN GOTO L1:`, is read
    /// as if THEN were missing.
    pub(in crate::parse) fn statement_after_then(&mut self) -> Parsed<(Then, Parsed<()>)> {
        let location = self.rest();
        for word in [Keyword::Goto, Keyword::Gosub] {
            if let Some(keyword) = self.take_word(word) {
                let ((jump, _), then): (_, fn(Jump) -> Then) = match word {
                    Keyword::Goto => (self.goto(keyword)?, Then::Goto),
                    _ => (self.jump(keyword, word)?, Then::Gosub),
                };
                let reason = Suggestion::ThenJumps { jump: word.into() };
                let help = Suggestion::LeaveThenOut { jump: word.into() };
                let fault = self.fault_with_help(location, reason, help);
                return Ok((then(jump), Err(fault)));
            }
        }
        let jump = Keyword::Goto.into();
        let help = match self.goes_to_line() {
            true => Suggestion::LeaveThenOut { jump },
            false => Suggestion::CloseOneLineIf,
        };
        Err(self.fault_with_help(location, Suggestion::OneLineIf, help))
    }

    /// Returns the fault of ELSE or THEN after the jump of an IF: `IF A == 1 GOTO L1: ELSE …`.
    pub(in crate::parse) fn behind_jump(&self, jump: Keyword) -> Option<Fault> {
        if self.at_word(Keyword::Else) {
            let end = End::Label;
            let reason = Parsing::NothingBehind { end };
            let help: Message = match self.left_tokens() {
                [_, next, ..] if jump == Keyword::Goto => {
                    let next = Span::new(next.span.start, self.rest().end);
                    let statement = upper_case(self.slice(next));
                    Suggestion::ElseOnNextLine { statement }.into()
                }
                _ => Suggestion::ElseInBlock.into(),
            };
            return Some(self.fault_with_help(self.rest(), reason, help));
        }
        let ends_in_then = self.at_word(Keyword::Then) && self.left() == 1;
        ends_in_then.then(|| {
            let reason = Suggestion::ThenJumps { jump: jump.into() };
            let help = Suggestion::LeaveThenOut { jump: jump.into() };
            self.fault_with_help(self.here(), reason, help)
        })
    }

    /// Returns the fault of an ELSEIF without THEN: `ELSEIF A == 1`.
    pub(in crate::parse) fn missing_then_of_else_if(&self) -> Fault {
        self.joined().unwrap_or_else(|| {
            self.fault_with_help(self.here(), Parsing::ThenBelongsHere, Suggestion::ElseIf)
                .of(Broken::Then)
        })
    }

    /// Returns the fault of a flag in two words or a command in place of a condition: `WHILE INPOS ALL`, `UNTIL SLEEP
    /// 100`.
    pub(in crate::parse) fn half_a_flag(&self) -> Option<Fault> {
        let advice = self.flag_or_command()?;
        let end = End::Condition;
        Some(self.fault_with_help(self.rest(), Parsing::NothingBehind { end }, advice))
    }

    /// Returns the fault of a FOR without TO: `FOR I = 1, 3`, `FOR I = 1 TO3`.
    pub(in crate::parse) fn missing_to(&self) -> Fault {
        let help: Message = match self.peek().and_then(|to| self.glued_to(to.span)) {
            Some(text) => Suggestion::Write { text }.into(),
            None => Parsing::WriteFor.into(),
        };
        self.fault_with_help(self.here(), Parsing::ToBelongsHere, help)
    }

    /// Returns the fault of tokens after a FOR: `FOR I = 1 TO N - 1`.
    pub(in crate::parse) fn behind_for(&self) -> Fault {
        let calculates = |token: Token| matches!(token.kind, Kind::Arithmetic(_));
        let help: Message = match self.peek().is_some_and(calculates) {
            true => Suggestion::Limit.into(),
            false => Parsing::WriteFor.into(),
        };
        self.fault_with_help(self.rest(), Parsing::ForEnds, help)
    }

    /// Returns the help for tokens after a NEXT: `NEXT I J`, `NEXT I = I + 1`.
    pub(in crate::parse) fn next_help(&self, keyword: Span) -> Suggestion {
        match (self.peek().map(|next| next.kind), self.before()) {
            (Some(Kind::Word) | None, _) | (_, None) => Suggestion::NextEach,
            (_, Some(last)) => Suggestion::Write {
                text: upper_case(self.slice(keyword.to(last.span))),
            },
        }
    }

    /// Returns the name of a SUBROUTINE without its colon, and the fault: `SUBROUTINE WALK`, `SUBROUTINE WALK()`. The
    /// name is declared, so that calls of it are not reported.
    pub(in crate::parse) fn routine_without_colon(
        &self,
        word: Keyword,
        name: Word,
    ) -> (Word, Parsed<()>) {
        let alone = with_parameters(&name.node);
        let takes_some = alone.is_some();
        let node = alone.unwrap_or_else(|| bare(&name.node));
        let fault = self.fault(name.span, Parsing::NameColonMissing);
        let fault = match takes_some {
            true => fault
                .help(Suggestion::NoParameters { name: node.clone() })
                .once(MistakeId::Word(node.clone())),
            false => fault.help(written(word, node.clone())),
        };
        (Word { node, ..name }, Err(fault))
    }

    /// Returns the fault of a label that is marked as in another language: `GOTO *L1`.
    pub(in crate::parse) fn marked_label_of_jump(&self) -> Option<Fault> {
        let (location, name) = marked(self.text, self.left_tokens())?;
        Some(self.foreign_label(location, name))
    }

    /// Returns the fault of a label with blanks or a `-`: `GOTO MAIN-LOOP:`.
    pub(in crate::parse) fn label_in_pieces_of_jump(&self, first: Span) -> Option<Fault> {
        let location = self.spread_label(first)?;
        let name = joined(&upper_case(self.slice(location)));
        Some(self.foreign_label(location, name))
    }

    pub(in crate::parse) fn foreign_label(&self, location: Span, name: SmolStr) -> Fault {
        let reason = Naming::NoLabelName {
            word: upper_case(self.slice(location)),
        };
        self.fault(location, reason)
            .once(MistakeId::ForeignLabel(name.clone()))
            .help(Parsing::WriteLabel { name })
    }

    /// Returns a label that no colon follows directly, with the fault; only the fault if the word is no label: `GOTO
    /// L1`, `GOTO L1 :`, `GOTO 100`, `CALL WALK(3)`.
    pub(in crate::parse) fn label_without_colon(
        &self,
        word: Word,
        next: Option<Token>,
    ) -> Parsed<(Word, Parsed<()>)> {
        if let Some(colon) = next.filter(|next| next.kind == Kind::Colon) {
            let gap = Span::new(word.span.end, colon.span.end);
            let name = word.node.clone();
            let help = Parsing::WriteLabel { name };
            let fault = self.fault_with_help(gap, Parsing::BlankBeforeColon, help);
            return Ok((word, Err(fault)));
        }
        let fault = self.fault(word.span, Parsing::LabelColonMissing);
        if let Some(name) = with_parameters(&word.node) {
            let fault = fault.once(MistakeId::Word(name.clone()));
            return Err(fault.help(Suggestion::NoParameters { name }));
        }
        let name = bare(&word.node);
        if name.chars().all(|c| c.is_ascii_digit()) {
            return Err(fault.help(Suggestion::NoLineNumbers { name }));
        }
        let fault = fault.help(Parsing::WriteLabel { name: name.clone() });
        match names::is_label(&name) {
            true => Ok((Word { node: name, ..word }, Err(fault))),
            false => Err(fault),
        }
    }

    /// Returns true for a jump of BASIC: `THEN 100`, `THEN L1:`.
    pub(in crate::parse) fn goes_to_line(&self) -> bool {
        let is_line = |token: &Token| self.slice(token.span).bytes().all(|it| it.is_ascii_digit());
        match self.left_tokens() {
            [line] => is_line(line),
            [name, colon] => name.kind == Kind::Word && colon.kind == Kind::Colon,
            _ => false,
        }
    }

    pub(in crate::parse) fn missing_then(&self) -> Fault {
        if let Some(fault) = self.joined() {
            return fault;
        }
        if self.at_word(Keyword::Call) {
            let help = Parsing::GosubCalls;
            return self.fault_with_help(self.here(), Parsing::IfCannotCall, help);
        }
        if let Some(advice) = self.flag_or_command() {
            return self.other_than_then(advice);
        }
        if let Some(text) = self.glued_jump() {
            return self.other_than_then(Suggestion::Write { text });
        }
        // `IF A EQ 3 THEN`
        let goes_on = |token: &Token| AFTER_IF.iter().any(|it| it.is(self.slice(token.span)));
        if self.left_tokens().iter().skip(2).any(goes_on) {
            let help = Parsing::Relations;
            return self.fault_with_help(self.here(), Parsing::RelationBelongsHere, help);
        }
        let word = self.peek().map(|token| upper_case(self.slice(token.span)));
        let near = word.and_then(|word| nearest(&word, AFTER_IF.map(Keyword::word)));
        let help: Message = match near {
            Some(near) => Suggestion::DidYouMean { near: near.into() }.into(),
            None => Parsing::WriteThenOrJump.into(),
        };
        self.other_than_then(help)
    }

    /// Returns the fault of an IF at a place where neither THEN nor a jump stands.
    pub(in crate::parse) fn other_than_then(&self, help: impl Into<Message>) -> Fault {
        self.fault_with_help(self.here(), Parsing::ThenOrJumpBelongsHere, help)
            .of(Broken::Then)
    }

    /// Returns the jump with its blank, for a word such as `GOTOL1:` after a condition.
    pub(in crate::parse) fn glued_jump(&self) -> Option<SmolStr> {
        let [word, colon] = self.left_tokens() else {
            return None;
        };
        let written = upper_case(self.slice(word.span));
        let (jump, label) = glued(&written)?;
        let jump = if jump == Keyword::Call {
            Keyword::Gosub
        } else {
            jump
        };
        (colon.kind == Kind::Colon).then(|| format!("{jump} {label}:").into())
    }

    /// Returns the help for a flag in two words, such as `INPOS F1`, or for a command in place of a condition.
    pub(in crate::parse) fn flag_or_command(&self) -> Option<Suggestion> {
        let before = self
            .before()
            .map(|token| upper_case(self.slice(token.span)))?;
        let next = self
            .peek()
            .map(|token| upper_case(self.slice(token.span)))?;
        if before.parse::<Flag>().is_ok() && next.parse::<Flag>().is_ok() {
            return Some(Suggestion::Nest);
        }
        let flag = format!("{before}_{next}");
        if flag.parse::<Flag>().is_ok() {
            return Some(Suggestion::FlagOfTarget { flag: flag.into() });
        }
        let command = commands::find_in(&before, self.edition)?;
        Some(Suggestion::CommandNoCondition {
            command: command.name,
        })
    }

    /// Returns `TO 3` for `TO3`.
    pub(in crate::parse) fn glued_to(&self, location: Span) -> Option<SmolStr> {
        let word = upper_case(self.slice(location));
        let rest = word.strip_prefix(Keyword::To.word())?;
        Some(format!("{} {rest}", Keyword::To).into())
    }

    /// Suggests a replacement for words after one that is alone: `EXIT FOR`, `EXIT SUB`, `RETURN 0`.
    pub(in crate::parse) fn alone_help(&self, name: Keyword) -> Option<Message> {
        let next = upper_case(self.slice(self.here()));
        let keyword = keywords::find(&next, self.edition);
        Some(match (name, keyword) {
            (Keyword::Exit, Some(Keyword::For | Keyword::While | Keyword::Repeat)) => {
                Suggestion::Break.into()
            }
            (Keyword::Exit, Some(Keyword::Subroutine)) => Suggestion::LeaveSubroutine.into(),
            (Keyword::Exit, None) if next == "SUB" => Suggestion::LeaveSubroutine.into(),
            _ if commands::find_in(&next, self.edition).is_some() => return None,
            (Keyword::Return, _) => Suggestion::NoResult.into(),
            _ => Suggestion::Alone { word: name.into() }.into(),
        })
    }

    /// Returns the whole name of a label that is not in one piece.
    pub(in crate::parse) fn spread_label(&self, first: Span) -> Option<Span> {
        self.left_tokens()
            .split_last()
            .filter(|(last, _)| last.kind == Kind::Colon)
            .and_then(|_| spread(self.text, first, self.left_tokens()))
    }
}

/// The words that follow the condition of an IF.
const AFTER_IF: [Keyword; 3] = [Keyword::Then, Keyword::Goto, Keyword::Gosub];

/// Returns the form of a SUBROUTINE or THREAD.
pub(in crate::parse) fn written(word: Keyword, name: SmolStr) -> Parsing {
    match word {
        Keyword::Thread => Parsing::WriteThread { name },
        _ => Parsing::WriteSubroutine { name },
    }
}

/// Returns a label's name without quotes, parentheses and other signs around it.
pub(in crate::parse) fn bare(name: &str) -> SmolStr {
    let is_sign = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
    match name.trim_matches(is_sign) {
        "" => name.into(),
        bare => bare.into(),
    }
}

/// Splits a jump and its label without the blank between them: `GOTOL1`.
pub fn glued(word: &str) -> Option<(Keyword, &str)> {
    let jumps = [Keyword::Goto, Keyword::Gosub, Keyword::Call];
    let parts = |jump: Keyword| Some((jump, word.strip_prefix(jump.word())?));
    let is_label = |(_, label): &(Keyword, &str)| names::is_label(label);
    jumps.into_iter().filter_map(parts).find(is_label)
}

/// Returns the name of a routine that another language gives arguments: `WALK` of `WALK(3)`.
fn with_parameters(name: &str) -> Option<SmolStr> {
    let (name, rest) = name.split_once('(')?;
    (!name.is_empty() && rest != ")").then(|| name.into())
}

/// Returns a name in one piece: `MAIN_LOOP` of `MAIN-LOOP` and `MAIN LOOP`.
pub(in crate::parse) fn joined(written: &str) -> SmolStr {
    let words = written.split(['-', ' ', '\t', ',', '\u{3000}']);
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    words.join("_").into()
}

/// Finds the end of a label's name that has blanks or a `-` in it: the tokens after its first word, up to a colon.
pub(in crate::parse) fn spread(text: &str, first: Span, rest: &[Token]) -> Option<Span> {
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

/// Returns location and name of a label as another language marks it: `*L1`, `@L1`.
pub(in crate::parse) fn marked(text: &str, tokens: &[Token]) -> Option<(Span, SmolStr)> {
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

impl Parser<'_> {
    /// Reads a SUBROUTINE whose line is reported. Its name is declared, so that calls of it are not reported.
    pub(in crate::parse) fn broken_subroutine(
        &self,
        word: Span,
        tokens: &[Token],
    ) -> StatementKind {
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
