//! Control structure: IF, ELSEIF, WHILE, UNTIL, FOR, NEXT, SUBROUTINE, jumps and their labels (T.I.P. 3.1 §7-6, §7-7).

use super::Parser;
use super::reader::{Broken, Fault, Parsed, Reader};
use crate::diagnostic::MistakeId;
use crate::language::reserved::LOOP;
use crate::language::{Keyword, commands, keywords, names};
use crate::lex::{Kind, Token};
use crate::message::phrase::End;
use crate::message::{Message, Naming, Parsing, Suggestion};
use crate::source::Span;
use crate::suggest::nearest;
use crate::syntax::{
    Arithmetic, Condition, Counting, Jump, Operand, OperandKind, Shape, StatementKind, Then, Word,
    upper_case,
};
use smol_str::SmolStr;
use tip_runtime::command::Flag;

/// The words that follow the condition of an IF.
const AFTER_IF: [Keyword; 3] = [Keyword::Then, Keyword::Goto, Keyword::Gosub];

/// A statement and, if something after it is wrong, what; or only what is wrong.
pub(super) type Read = Parsed<(StatementKind, Parsed<()>)>;

impl Reader<'_> {
    pub(super) fn if_statement(&mut self, keyword: Span) -> Read {
        let condition = Box::new(self.condition()?);
        let (then, end) = self.then()?;
        let kind = StatementKind::If {
            keyword,
            condition,
            then,
        };
        Ok((kind, end))
    }

    fn then(&mut self) -> Parsed<(Then, Parsed<()>)> {
        if self.take_word(Keyword::Then).is_some() {
            return self.after_then();
        }
        if let Some(keyword) = self.take_word(Keyword::Goto) {
            let (jump, colon) = self.goto(keyword)?;
            let end = colon.and_then(|()| self.end_of_jump(Keyword::Goto));
            return Ok((Then::Goto(jump), end));
        }
        if let Some(keyword) = self.take_word(Keyword::Gosub) {
            let (jump, colon) = self.jump(keyword, Keyword::Gosub)?;
            let end = colon.and_then(|()| self.end_of_jump(Keyword::Gosub));
            return Ok((Then::Gosub(jump), end));
        }
        Err(self.missing_then())
    }

    /// Reads what follows THEN: a block, on the next line. A jump in its place is read as if THEN were not there.
    fn after_then(&mut self) -> Parsed<(Then, Parsed<()>)> {
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
        match self.left() {
            0 => Ok((Then::Block, Ok(()))),
            _ if self.goes_to_line() => {
                let jump = Keyword::Goto.into();
                Err(self.fault_with_help(
                    location,
                    Suggestion::OneLineIf,
                    Suggestion::LeaveThenOut { jump },
                ))
            }
            _ => Err(self.fault_with_help(
                location,
                Suggestion::OneLineIf,
                Suggestion::CloseOneLineIf,
            )),
        }
    }

    /// `THEN 100`, `THEN L1:`: a jump of BASIC.
    fn goes_to_line(&self) -> bool {
        let is_line = |token: &Token| self.slice(token.span).bytes().all(|it| it.is_ascii_digit());
        match self.left_tokens() {
            [line] => is_line(line),
            [name, colon] => name.kind == Kind::Word && colon.kind == Kind::Colon,
            _ => false,
        }
    }

    /// Checks that nothing follows a jump, not even THEN.
    fn end_of_jump(&self, jump: Keyword) -> Parsed<()> {
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
            return Err(self.fault_with_help(self.rest(), reason, help));
        }
        if self.at_word(Keyword::Then) && self.left() == 1 {
            let reason = Suggestion::ThenJumps { jump: jump.into() };
            let help = Suggestion::LeaveThenOut { jump: jump.into() };
            return Err(self.fault_with_help(self.here(), reason, help));
        }
        self.expect_end(End::Label)
    }

    fn missing_then(&self) -> Fault {
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
    fn other_than_then(&self, help: impl Into<Message>) -> Fault {
        self.fault_with_help(self.here(), Parsing::ThenOrJumpBelongsHere, help)
            .of(Broken::Then)
    }

    /// `GOTOL1:` after a condition: the jump with its blank.
    fn glued_jump(&self) -> Option<SmolStr> {
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

    /// `INPOS F1` for `INPOS_F1`, or a command in the place of a condition.
    fn flag_or_command(&self) -> Option<Suggestion> {
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

    pub(super) fn else_if(&mut self, keyword: Span) -> Read {
        let condition = Box::new(self.condition()?);
        let end = match self.take_word(Keyword::Then) {
            Some(_) => self.expect_end(End::Word {
                word: Keyword::Then.into(),
            }),
            None => Err(self.joined().unwrap_or_else(|| {
                let help = Suggestion::ElseIf;
                self.fault_with_help(self.here(), Parsing::ThenBelongsHere, help)
                    .of(Broken::Then)
            })),
        };
        Ok((StatementKind::ElseIf { keyword, condition }, end))
    }

    pub(super) fn while_statement(&mut self, keyword: Span) -> Read {
        let condition = Box::new(self.last_condition()?);
        let end = self.end_of_condition();
        Ok((StatementKind::While { keyword, condition }, end))
    }

    pub(super) fn until(&mut self, keyword: Span) -> Read {
        let condition = Box::new(self.last_condition()?);
        let end = self.end_of_condition();
        Ok((StatementKind::Until { keyword, condition }, end))
    }

    /// Reads a condition after which nothing may stand. In `INPOS ALL` half a flag is none.
    fn last_condition(&mut self) -> Parsed<Condition> {
        let condition = self.condition()?;
        match self.flag_or_command() {
            Some(advice) => {
                let end = End::Condition;
                Err(self.fault_with_help(self.rest(), Parsing::NothingBehind { end }, advice))
            }
            None => Ok(condition),
        }
    }

    fn end_of_condition(&self) -> Parsed<()> {
        match self.joined().or_else(|| self.opened()) {
            Some(fault) => Err(fault),
            None => self.expect_end(End::Condition),
        }
    }

    pub(super) fn for_statement(&mut self, keyword: Span) -> Read {
        let variable = self.loop_variable()?;
        self.expect_assignment()?;
        let from = self.operand_before_keyword().map_err(as_in_for)?;
        if self.take_word(Keyword::To).is_none() {
            if let Some(text) = self.peek().and_then(|to| self.glued_to(to.span)) {
                let help = Suggestion::Write { text };
                return Err(self.fault_with_help(self.here(), Parsing::ToBelongsHere, help));
            }
            return Err(self.fault_with_help(
                self.here(),
                Parsing::ToBelongsHere,
                Parsing::WriteFor,
            ));
        }
        let to = self.operand_before_keyword().map_err(as_in_for)?;
        let step = match self.take_word(Keyword::Step) {
            Some(_) => Some(self.operand_before_keyword().map_err(as_in_for)?),
            None => None,
        };
        let end = match self.left() {
            0 => Ok(()),
            _ => {
                let calculates = |token: Token| matches!(token.kind, Kind::Arithmetic(_));
                let help: Message = match self.peek().is_some_and(calculates) {
                    true => Suggestion::Limit.into(),
                    false => Parsing::WriteFor.into(),
                };
                Err(self.fault_with_help(self.rest(), Parsing::ForEnds, help))
            }
        };
        let kind = StatementKind::For {
            keyword,
            counting: Box::new(Counting {
                variable,
                from,
                to,
                step,
            }),
        };
        Ok((kind, end))
    }

    /// `TO3`: the word and what follows it, with the blank between them.
    fn glued_to(&self, location: Span) -> Option<SmolStr> {
        let word = upper_case(self.slice(location));
        let rest = word.strip_prefix(Keyword::To.word())?;
        Some(format!("{} {rest}", Keyword::To).into())
    }

    fn loop_variable(&mut self) -> Parsed<Operand> {
        let operand = self.operand_before_keyword()?;
        match operand.kind {
            OperandKind::Name(_) | OperandKind::Member(_) if !operand.negative => Ok(operand),
            _ => Err(self.fault_with_help(
                operand.span,
                Parsing::VariableBelongsHere,
                Parsing::WriteFor,
            )),
        }
    }

    fn expect_assignment(&mut self) -> Parsed<()> {
        match self.peek() {
            Some(Token {
                kind: Kind::Assign(None),
                ..
            }) => {
                self.take();
                Ok(())
            }
            _ => Err(self.fault_with_help(
                self.here(),
                Parsing::AssignmentBelongsHere,
                Parsing::WriteFor,
            )),
        }
    }

    pub(super) fn next_statement(&mut self, keyword: Span) -> Read {
        let variable = match self.left() {
            0 => None,
            _ => Some(self.loop_variable_of_next()?),
        };
        let help = match (self.peek().map(|next| next.kind), self.before()) {
            (Some(Kind::Word) | None, _) | (_, None) => Suggestion::NextEach,
            // `NEXT I:`, `NEXT I = I + 1`
            (_, Some(last)) => Suggestion::Write {
                text: upper_case(self.slice(keyword.to(last.span))),
            },
        };
        let end = self.expect_end_or(End::NextAndVariable, help);
        Ok((StatementKind::Next { keyword, variable }, end))
    }

    fn loop_variable_of_next(&mut self) -> Parsed<Operand> {
        let operand = self.operand()?;
        match operand.kind {
            OperandKind::Name(_) | OperandKind::Member(_) if !operand.negative => Ok(operand),
            _ => Err(self.fault(operand.span, Parsing::NextNamesItsVariable)),
        }
    }

    /// `SUBROUTINE NAME:` and `THREAD NAME:`.
    pub(super) fn routine(&mut self, word: Keyword, keyword: Span) -> Read {
        let written = |name: SmolStr| match word {
            Keyword::Thread => Parsing::WriteThread { name },
            _ => Parsing::WriteSubroutine { name },
        };
        let help = written("NAME".into());
        let mut name = match self.take() {
            Some(token) if token.kind == Kind::Word => self.word(token.span),
            Some(token) => {
                return Err(self.fault_with_help(token.span, Parsing::NameBelongsHere, help));
            }
            None => {
                return Err(self.fault_with_help(self.here(), Parsing::NameMissing, help));
            }
        };
        let end = match self.peek() {
            Some(token) if token.kind == Kind::Colon => {
                self.take();
                self.expect_end_or(routine_and_name(word), Suggestion::NoValues)
            }
            _ => {
                // `SUBROUTINE WALK()`: what calls it is not wrong.
                let alone = with_parameters(&name.node);
                let takes_some = alone.is_some();
                name.node = alone.unwrap_or_else(|| bare(&name.node));
                let alone = name.node.clone();
                let help: Message = match takes_some {
                    true => Suggestion::NoParameters { name: alone }.into(),
                    false => written(alone).into(),
                };
                let fault = self.fault_with_help(name.span, Parsing::NameColonMissing, help);
                Err(match takes_some {
                    true => fault.once(MistakeId::Word(name.node.clone())),
                    false => fault,
                })
            }
        };
        let kind = match word {
            Keyword::Thread => StatementKind::Thread { keyword, name },
            _ => StatementKind::Subroutine { keyword, name },
        };
        Ok((kind, end))
    }

    /// `DEFINE NAME value`
    pub(super) fn constant(&mut self, keyword: Span) -> Read {
        let help = || Parsing::WriteDefine;
        let name = match self.take() {
            Some(token) if token.kind == Kind::Word => self.word(token.span),
            Some(token) => {
                return Err(self.fault_with_help(token.span, Parsing::NameBelongsHere, help()));
            }
            None => {
                return Err(self.fault_with_help(self.here(), Parsing::NameMissing, help()));
            }
        };
        let value = self.operand().map_err(|fault| fault.or_help(help()))?;
        let end = self.expect_end_or(End::DefineAndValue, help());
        let kind = StatementKind::Constant {
            keyword,
            name,
            value,
        };
        Ok((kind, end))
    }

    /// `CALL NAME:` and `GOSUB NAME:`.
    pub(super) fn call(
        &mut self,
        keyword: Span,
        name: Keyword,
        make: fn(Jump) -> StatementKind,
    ) -> Read {
        let (jump, colon) = self.jump(keyword, name)?;
        let end = colon.and_then(|()| match name {
            Keyword::Call => self.expect_end_or(End::Label, Suggestion::NoValues),
            _ => self.expect_end(End::Label),
        });
        Ok((make(jump), end))
    }

    pub(super) fn goto_statement(&mut self, keyword: Span) -> Read {
        let (jump, colon) = self.goto(keyword)?;
        let end = colon.and_then(|()| self.expect_end(End::Label));
        Ok((StatementKind::Goto(jump), end))
    }

    /// Reads a word that is alone in its statement.
    pub(super) fn alone(&mut self, name: Keyword, kind: StatementKind) -> Read {
        let end = self.expect_end(End::Word { word: name.into() });
        let end = end.map_err(|fault| match self.alone_help(name) {
            Some(help) => fault.help(help),
            None => fault,
        });
        Ok((kind, end))
    }

    /// Suggests a replacement for words after one that is alone: `EXIT FOR`, `EXIT SUB`, `RETURN 0`.
    fn alone_help(&self, name: Keyword) -> Option<Message> {
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
}

fn routine_and_name(word: Keyword) -> End {
    match word {
        Keyword::Thread => End::ThreadAndName,
        _ => End::SubroutineAndName,
    }
}

/// Adds the form of FOR to the fault of an operand.
fn as_in_for(fault: Fault) -> Fault {
    fault.or_help(Parsing::WriteFor)
}

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
fn with_parameters(name: &str) -> Option<SmolStr> {
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

impl Reader<'_> {
    /// Returns the whole name of a label that is not in one piece.
    fn spread_label(&self, first: Span) -> Option<Span> {
        self.left_tokens()
            .split_last()
            .filter(|(last, _)| last.kind == Kind::Colon)
            .and_then(|_| spread(self.text, first, self.left_tokens()))
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
        if let Some((location, name)) = marked(self.text, self.left_tokens()) {
            let reason = Naming::NoLabelName {
                word: upper_case(self.slice(location)),
            };
            let fault = self
                .fault(location, reason)
                .once(MistakeId::ForeignLabel(name.clone()));
            return Err(fault.help(Parsing::WriteLabel { name }));
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
            let fault = self
                .fault(location, reason)
                .once(MistakeId::ForeignLabel(name.clone()));
            return Err(fault.help(Parsing::WriteLabel { name }));
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
                    let fault = fault.once(MistakeId::Word(name.clone()));
                    return Err(fault.help(Suggestion::NoParameters { name }));
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
