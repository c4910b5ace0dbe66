//! Operands: constants, names, members, and their signs; and what follows the word of a command: operands in a row, or
//! a text.

use super::Parser;
use super::comment::is_comment;
use super::reader::{Broken, Fault, Parsed, Reader};
use crate::code::Code;
use crate::diagnostic::{Diagnostic, MistakeId};
use crate::language::commands::Meaning;
use crate::language::functions::Operation;
use crate::language::{Edition, Keyword, commands, functions};
use crate::lex::{BLANKS, Kind, Token, delimiter};
use crate::message::list::List;
use crate::message::{Message, Parsing, Suggestion};
use crate::source::{Span, first_beyond};
use crate::suggest::nearest;
use crate::syntax::{
    Arithmetic, Operand, OperandKind, Shape, Spanned, StatementKind, Word, upper_case,
};
use smol_str::SmolStr;
use tip_runtime::command::Reading;
use tip_runtime::function::Function;

/// Words that end an operand list in conditions and FOR; no variable has such a name.
const STOPS: &[Keyword] = &[
    Keyword::Then,
    Keyword::Goto,
    Keyword::Gosub,
    Keyword::Call,
    Keyword::To,
    Keyword::Step,
];

impl Reader<'_> {
    /// Reads an operand with its sign.
    pub(super) fn operand(&mut self) -> Parsed<Operand> {
        match self.peek() {
            Some(Token {
                kind: Kind::Arithmetic(sign @ (Arithmetic::Add | Arithmetic::Sub)),
                span,
                ..
            }) => self.signed(sign, span),
            Some(token) if token.kind == Kind::Word => {
                self.take();
                self.value(token.span)
            }
            Some(token) => {
                let reason = Parsing::NoOperand {
                    text: self.slice(token.span).into(),
                };
                let fault = self.fault(token.span, reason);
                Err(self.with_argument_help(fault, token))
            }
            None => {
                let fault = self.fault(self.here(), Parsing::OperandMissing);
                Err(match self.is_equation() {
                    true => fault.help(Parsing::WriteEquation),
                    false => fault,
                })
            }
        }
    }

    /// Adds a help to the fault of an operator among the arguments of a command: it calculates nothing, or was to
    /// begin a comment.
    fn with_argument_help(&self, fault: Fault, token: Token) -> Fault {
        let calculates = matches!(token.kind, Kind::Arithmetic(_)) && !self.is_equation();
        let rest = self.slice(self.rest());
        if is_comment(rest) && rest.len() > token.span.end - token.span.start {
            fault.help(Suggestion::Comment)
        } else if calculates {
            fault.help(Suggestion::CalculateArgument)
        } else if token.kind == Kind::Colon {
            fault.help(Suggestion::NextStatement)
        } else if token.kind == Kind::Assign(None) && self.is_equation() {
            // `N = = 1`
            let (name, rest) = self.slice(self.whole()).split_once('=').unwrap_or_default();
            let rest = rest.trim_start_matches([' ', '\t', '=']);
            let text = upper_case(&format!("{} = {rest}", name.trim()));
            fault.help(Suggestion::Write { text })
        } else if matches!(token.kind, Kind::Assign(_)) {
            fault.help(self.without_equals())
        } else if self.is_equation() {
            fault.help(Parsing::WriteEquation)
        } else {
            fault
        }
    }

    /// `AD_IN VR1 = V`
    fn without_equals(&self) -> Suggestion {
        let parts: Vec<&str> = self.slice(self.whole()).split('=').map(str::trim).collect();
        let written = parts.join(" ").into();
        Suggestion::WithoutEquals { written }
    }

    /// Reads an operand of a condition or of FOR.
    pub(super) fn operand_before_keyword(&mut self) -> Parsed<Operand> {
        match STOPS.iter().find(|stop| self.at_word(**stop)) {
            Some(stop) => {
                let reason = Parsing::OperandMissingBefore {
                    word: (*stop).into(),
                };
                Err(self.fault(self.here(), reason))
            }
            None => self.operand(),
        }
    }

    fn signed(&mut self, sign: Arithmetic, location: Span) -> Parsed<Operand> {
        let operand = match self.peek_second() {
            Some(word) if word.kind == Kind::Word && !word.spaced => word.span,
            Some(word) if word.kind == Kind::Word => {
                if let Some(fault) = self.turned_update(location, word.span) {
                    return Err(fault);
                }
                let (sign, word) = (self.slice(location), self.slice(word.span));
                let text = format!("{sign}{word}").into();
                let reason = Parsing::SignStandsBefore;
                let fault =
                    self.fault_with_help(location, reason, Suggestion::WriteSigned { text });
                return Err(fault.of(Broken::Sign));
            }
            Some(Token {
                kind: Kind::Arithmetic(_),
                span,
                ..
            }) if self.left() > 2 => return Err(self.two_signs(location, span)),
            _ => {
                let reason = Parsing::SignStandsBefore;
                return Err(self.fault(location, reason).of(Broken::Sign));
            }
        };
        self.take();
        self.take();
        let operand = self.value(operand)?;
        let span = location.to(operand.span);
        match (operand.kind, sign) {
            (OperandKind::Number(number), Arithmetic::Sub) => Ok(Operand {
                kind: OperandKind::Number(-number),
                negative: false,
                span,
            }),
            (kind @ OperandKind::Number(_), _) => Ok(Operand {
                kind,
                negative: false,
                span,
            }),
            (kind, Arithmetic::Sub) => Ok(Operand {
                kind,
                negative: true,
                span,
            }),
            _ => Err(self.fault_with_help(
                location,
                Parsing::PlusBeforeConstants,
                Parsing::LeavePlusOut,
            )),
        }
    }

    /// Reads a word as constant, name or member.
    pub(super) fn value(&self, span: Span) -> Parsed<Operand> {
        let word = self.slice(span);
        let kind = match word.as_bytes().first() {
            Some(b'0'..=b'9' | b'.') => OperandKind::Number(self.number(word, span)?),
            _ => self.name(word, span)?,
        };
        Ok(Operand {
            kind,
            negative: false,
            span,
        })
    }

    fn number(&self, word: &str, span: Span) -> Parsed<f64> {
        match word.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            Ok(_) => {
                let reason = Parsing::ConstantTooLarge;
                Err(self.fault_with_help(span, reason, Suggestion::LargestNumber))
            }
            Err(_) => {
                let reason = Parsing::NoNumber { word: word.into() };
                let fault = self
                    .fault(span, reason)
                    .once(MistakeId::Word(upper_case(word)));
                Err(fault.help(suggest_for_number(word)))
            }
        }
    }

    fn name(&self, word: &str, span: Span) -> Parsed<OperandKind> {
        let sign = usize::from(self.is_reading(word));
        let (name, member) = match word.split_once('.') {
            Some((name, member)) => (name, Some(member)),
            None => (word, None),
        };
        let is_odd = |char: char| !is_name_char(char) && char != '.';
        if let Some(at) = word[sign..].find(is_odd).map(|at| sign + at) {
            let character = word[at..].chars().next().map_or(0, char::len_utf8);
            let start = span.start + at;
            return Err(self.foreign_in_name(word, Span::new(start, start + character)));
        }
        if member.is_some_and(|member| member.is_empty() || member.contains('.')) {
            let help = Parsing::Members;
            return Err(self.fault_with_help(span, Parsing::NoMember { word: word.into() }, help));
        }
        let name = upper_case(name);
        Ok(match member {
            Some(member) => OperandKind::Member(Box::new((name, upper_case(member)))),
            None => OperandKind::Name(name),
        })
    }

    fn foreign_in_name(&self, word: &str, location: Span) -> Fault {
        let character = self.slice(location).into();
        let reason = Parsing::ForeignInName { character };
        let help = suggest_for_name(word);
        let is_calculation = help == Parsing::NoParentheses.into() && self.is_equation();
        let help: Message = match word.as_bytes() {
            // `P = (391, 201, -150)`
            [b'(' | b'{', b'0'..=b'9' | b'-', ..]
                if self.is_equation() && self.peek().is_some_and(|it| it.kind == Kind::Word) =>
            {
                Suggestion::EachMember.into()
            }
            [b'~', _, ..] if !self.is_equation() => Suggestion::WriteNot.into(),
            _ if help == Parsing::NoParentheses.into() && !is_calculation => self
                .condition_in_parentheses()
                .unwrap_or_else(|| Suggestion::NoParentheses.into()),
            _ if help == Suggestion::NoBrackets.into() && !self.is_equation() => {
                self.condition_in_parentheses().unwrap_or(help)
            }
            _ => help,
        };
        let fault = self.fault_with_help(location, reason, help);
        let name = word.split(['(', '[']).next().unwrap_or_default();
        match !name.is_empty() && (name.len() < word.len() || word.ends_with('$')) {
            true => fault.once(MistakeId::Word(upper_case(name))),
            false => fault,
        }
    }
}

/// Returns true if a word is a unit, which no number has.
pub(crate) fn is_unit(word: &str) -> bool {
    const UNITS: &str =
        "% MM CM M DEG RAD S SEC MS MSEC N NM V HZ KHZ ° 度 ㎜ ㎝ 秒 ミリ ミリ秒 ℃ ％";
    UNITS.split(' ').any(|one| one.eq_ignore_ascii_case(word))
}

/// Returns true if a text stands between the ends of a range: `1〜10`.
pub(super) fn is_range(text: &str) -> bool {
    matches!(text, "〜" | "～" | "~")
}

/// Suggests a replacement for a word that starts as a number.
fn suggest_for_number(word: &str) -> Message {
    let digits = word.find(|c: char| !(c.is_ascii_digit() || c == '.'));
    let (number, unit) = word.split_at(digits.unwrap_or(word.len()));
    let sign = unit.trim_end_matches(|c: char| c.is_ascii_digit());
    if is_range(sign) && sign.len() < unit.len() {
        return Suggestion::CountTo.into();
    }
    // `1TO 3`
    if let Some(stop) = STOPS.iter().find(|stop| stop.is(unit)) {
        let text = format!("{number} {stop}").into();
        return Suggestion::BlankMissing { text }.into();
    }
    let hex = word.strip_prefix("0x").or_else(|| word.strip_prefix("0X"));
    let binary = word.strip_prefix("0b").or_else(|| word.strip_prefix("0B"));
    let hex = hex.and_then(|hex| u32::from_str_radix(hex, 16).ok());
    let value = hex.or_else(|| u32::from_str_radix(binary?, 2).ok());
    if let Some(number) = misread(word) {
        return Suggestion::Digits { number }.into();
    }
    match value {
        Some(value) => Suggestion::NoHex { value }.into(),
        None if is_unit(unit) && !number.is_empty() => Suggestion::NoUnit.into(),
        None => Parsing::Constants.into(),
    }
}

/// `2O1`, `l0`, `1_000`: the number, if letters were typed that look like digits, or groups are set apart.
fn misread(word: &str) -> Option<SmolStr> {
    let digit = |c: char| match c {
        'O' | 'o' => Some('0'),
        'I' | 'l' => Some('1'),
        '_' => None,
        other => Some(other),
    };
    let number: String = word.chars().filter_map(digit).collect();
    let is_plain = number.bytes().all(|it| it.is_ascii_digit() || it == b'.');
    (is_plain && number.parse::<f64>().is_ok()).then(|| number.into())
}

/// Suggests a replacement for a word with characters that no name has.
fn suggest_for_name(word: &str) -> Message {
    let is_number = |text: &str| text.starts_with(|c: char| c.is_ascii_digit());
    if word.strip_prefix(['(', '[']).is_some_and(is_number) || word.starts_with('{') {
        return Suggestion::NoBrackets.into();
    }
    let quotes = ['\'', '"'];
    let within = word.trim_matches(quotes);
    let is_char = word.starts_with(quotes) && within.len() == 1 && word.len() == 3;
    if is_char && within.chars().all(|c| c.is_ascii_alphanumeric()) {
        let character = within.to_ascii_uppercase().into();
        return Suggestion::Character { character }.into();
    }
    if is_comment(word) {
        return Suggestion::Comment.into();
    }
    if word.starts_with('"') {
        return Suggestion::NoText.into();
    }
    if word.contains('^') {
        return Suggestion::Power.into();
    }
    if let Some(inside) = word.strip_prefix('|').and_then(|it| it.strip_suffix('|')) {
        let text = upper_case(&format!(
            "{} {inside}",
            Operation::Scalar(Function::Abs).word()
        ));
        return Suggestion::Write { text }.into();
    }
    if word.ends_with('$') {
        return Suggestion::NoText.into();
    }
    if let Some((name, inside)) = word
        .split_once(['(', '['])
        .filter(|(name, _)| !name.is_empty())
    {
        // `math.sin(30)`
        let name = name.rsplit('.').next().unwrap_or(name);
        if functions::words().any(|function| function.eq_ignore_ascii_case(name)) {
            return Parsing::NoParentheses.into();
        }
        let name = upper_case(name);
        match commands::find(&name).map(|command| (command.meaning, command.name)) {
            // `V = AD_IN(VR1)`
            Some((Meaning::AdIn, _)) => return Suggestion::AdIn.into(),
            Some((Meaning::KeyIn, _)) => return Suggestion::KeyIn.into(),
            Some((_, command)) => return Suggestion::CommandFirst { command }.into(),
            None => {}
        }
        // `MAX(A, B)`; what stands alone in parentheses is rather the number of an array.
        let is_index = inside.len() > 1 && inside.ends_with([')', ']']);
        return match is_index {
            true => Suggestion::NoArray { name }.into(),
            false => no_function(&name).1,
        };
    }
    let name = upper_case(word.trim_start_matches(['-', '+']));
    if name.parse::<Reading>().is_ok() {
        let (word, edition) = (name, Edition::V3_2);
        return Suggestion::OfEdition { word, edition }.into();
    }
    match word.contains(['(', ')']) {
        true => Parsing::NoParentheses.into(),
        false => Parsing::NameCharacters.into(),
    }
}

/// Returns reason and help for a function that the language lacks.
pub(super) fn no_function(word: &str) -> (Message, Message) {
    let help = match nearest(word, functions::words()) {
        Some(near) => Suggestion::DidYouMean { near: near.into() }.into(),
        None => {
            let functions = List(functions::words().map(str::to_owned).collect());
            Suggestion::Functions { functions }.into()
        }
    };
    (Parsing::NoSuchFunction { word: word.into() }.into(), help)
}

fn is_name_char(char: char) -> bool {
    char.is_ascii_alphanumeric() || char == '_'
}

impl Reader<'_> {
    /// `N =+ 5`, where `N += 5` was meant.
    fn turned_update(&self, sign: Span, operand: Span) -> Option<Fault> {
        let equals = self.before()?;
        let is_glued = equals.kind == Kind::Assign(None) && equals.span.end == sign.start;
        let name = self.slice(self.whole()).split('=').next()?.trim();
        let text = format!("{name} {}= {}", self.slice(sign), self.slice(operand));
        let both = equals.span.to(sign);
        let reason = Suggestion::NoOperator {
            sign: self.slice(both).into(),
        };
        let text = upper_case(&text);
        is_glued.then(|| self.fault_with_help(both, reason, Suggestion::Write { text }))
    }

    /// `--391`
    fn two_signs(&self, first: Span, second: Span) -> Fault {
        let both = first.to(second);
        let third = self.left_tokens().get(2);
        let operand = third.map_or("", |it| self.slice(it.span));
        let text = format!("{}{operand}", self.slice(second)).into();
        let reason = Suggestion::NoOperator {
            sign: self.slice(both).into(),
        };
        self.fault_with_help(both, reason, Suggestion::Write { text })
    }

    /// Operands up to the end; at the first bad one, those before it and what is wrong.
    ///
    /// After an operand a sign belongs to the next one and needs a delimiter before it.
    pub(super) fn operands(&mut self) -> (Vec<Operand>, Parsed<()>) {
        let mut operands = Vec::with_capacity(self.left());
        while let Some(token) = self.peek() {
            let is_sign = token.kind != Kind::Word;
            if is_sign && !token.spaced && !operands.is_empty() {
                return (operands, Err(self.glued(token)));
            }
            match self.operand() {
                Ok(operand) => operands.push(operand),
                Err(fault) => return (operands, Err(fault)),
            }
        }
        (operands, Ok(()))
    }

    fn glued(&self, token: Token) -> Fault {
        let text = self.slice(token.span).into();
        let reason = Parsing::BetweenArguments { text };
        let help: Message = match token.kind {
            // `50 mm/s`
            Kind::Arithmetic(_) if self.before().is_some_and(|it| is_unit(self.slice(it.span))) => {
                Suggestion::NoUnit.into()
            }
            Kind::Arithmetic(_) => Suggestion::CalculateArgument.into(),
            Kind::Assign(_) => Suggestion::ArgumentNames.into(),
            _ => Parsing::SeparateArguments.into(),
        };
        self.fault_with_help(token.span, reason, help)
    }
}

impl Parser<'_> {
    /// Reads a command word and its arguments. Whether the command exists is not known here, and a misspelt one is
    /// reported as such, whatever follows it: so faults in its arguments travel with it.
    pub(super) fn command(&self, keyword: Span, tokens: &[Token]) -> StatementKind {
        let mut reader = Reader::new(self.text, tokens, 1, Code::Argument, self.module.edition);
        let (arguments, read) = reader.operands();
        StatementKind::Command {
            name: self.command_word(keyword, tokens),
            arguments,
            malformed: read.err().map(|fault| fault.diagnostic),
        }
    }

    /// Returns the command word; an operator in its place is shown as one.
    fn command_word(&self, keyword: Span, tokens: &[Token]) -> Word {
        let span = tokens.first().map(|token| token.span).unwrap_or_default();
        let node = match tokens.first() {
            Some(token) if token.kind != Kind::Word => self.source.slice(span).into(),
            _ => upper_case(self.source.slice(keyword)),
        };
        Word { node, span }
    }
}

/// The most bytes that a MESSAGE text may have.
const TEXT_LIMIT: usize = 70;

/// The most bytes that an F_MESSAGE text may have.
const FILE_TEXT_LIMIT: usize = 200;

impl Parser<'_> {
    /// Reads MESSAGE or F_MESSAGE, whose word is at `keyword` and whose text may reach up to `end`.
    pub(super) fn message(
        &mut self,
        word: Keyword,
        keyword: Span,
        end: usize,
        comment: Option<Span>,
    ) {
        let first = delimiter(&self.text.as_bytes()[..end], keyword.end);
        let is_blank = |char: char| BLANKS.contains(&char);
        let location = self.trim(Span::new(keyword.end + first, end), is_blank);
        if first == 0 && keyword.end < end {
            return self.glued_message(keyword, location);
        }
        if let Some(comment) = comment.filter(|_| first > 0) {
            self.warn_of_comment(comment);
        }
        self.check_text(word, location);
        let text = Spanned {
            node: self.source.slice(location).replace('\u{3000}', "  "),
            span: location,
        };
        let end = if text.node.is_empty() {
            keyword.end
        } else {
            location.end
        };
        let kind = match word {
            Keyword::FileMessage => StatementKind::FileMessage { text },
            _ => StatementKind::Message { text },
        };
        self.push(kind, Span::new(keyword.start, end));
    }

    fn glued_message(&mut self, keyword: Span, text: Span) {
        let reason = Parsing::BlankBehindMessage;
        self.report(Diagnostic::new(Code::Argument, text, reason));
        self.push(StatementKind::Broken(Shape::Plain), keyword.to(text));
    }

    fn warn_of_comment(&mut self, comment: Span) {
        let reason = Parsing::TextEndsHere;
        let help = Parsing::CommentElsewhere;
        self.report(Diagnostic::new(Code::CommentInMessage, comment, reason).help(help));
    }

    fn check_text(&mut self, word: Keyword, location: Span) {
        let text = self.source.slice(location);
        let is_file = word == Keyword::FileMessage;
        if let Some(at) = line_break(text).filter(|_| !is_file) {
            let at = location.start + at;
            let length = text[at - location.start..]
                .chars()
                .take(2)
                .map(char::len_utf8);
            let escape = Span::new(at, at + length.sum::<usize>());
            let reason = Parsing::LineBreak;
            let help = Parsing::Escapes;
            self.report(Diagnostic::new(Code::Format, escape, reason).help(help));
        }
        let limit = if is_file { FILE_TEXT_LIMIT } else { TEXT_LIMIT };
        if let Some(at) = first_beyond(text, limit) {
            self.is_text_too_long = true;
            let rest = Span::new(location.start + at, location.end);
            let reason = match is_file {
                true => Parsing::FileTextTooLong { limit },
                false => Parsing::TextTooLong { limit },
            };
            let help = Parsing::FullWidthCounts;
            self.report(Diagnostic::new(Code::LongString, rest, reason).help(help));
        }
    }
}

/// Returns the location of `\n`; a backslash (or yen sign) and the character after it are read as one.
fn line_break(text: &str) -> Option<usize> {
    let mut chars = text.char_indices();
    while let Some((at, char)) = chars.next() {
        if matches!(char, '\\' | '\u{A5}') && chars.next().is_some_and(|(_, next)| next == 'n') {
            return Some(at);
        }
    }
    None
}
