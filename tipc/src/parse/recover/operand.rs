//! Diagnostics of operands in other languages: signs, numbers and names.

use super::comment::is_comment;
use crate::diagnostic::MistakeId;
use crate::language::commands::Meaning;
use crate::language::functions::Operation;
use crate::language::{Edition, commands, functions};
use crate::lex::{Kind, Token};
use crate::message::list::List;
use crate::message::{Message, Parsing, Suggestion};
use crate::parse::operand::STOPS;
use crate::parse::reader::{Broken, Fault, Reader};
use crate::source::Span;
use crate::suggest::nearest;
use crate::syntax::upper_case;
use smol_str::SmolStr;
use tip_runtime::command::Reading;
use tip_runtime::function::Function;

impl Reader<'_> {
    /// Returns the fault of an operator in place of an operand: `SLEEP = 100`, `A = * 2`.
    pub(in crate::parse) fn no_operand(&self, token: Token) -> Fault {
        let reason = Parsing::NoOperand {
            text: self.slice(token.span).into(),
        };
        self.with_argument_help(self.fault(token.span, reason), token)
    }

    pub(in crate::parse) fn missing_operand(&self) -> Fault {
        let fault = self.fault(self.here(), Parsing::OperandMissing);
        match self.is_equation() {
            true => fault.help(Parsing::WriteEquation),
            false => fault,
        }
    }

    /// Returns the fault of a sign that no operand follows directly: `- 5`, `--5`, `N =+ 5`.
    pub(in crate::parse) fn sign_alone(&self, location: Span, next: Option<Token>) -> Fault {
        let reason = Parsing::SignStandsBefore;
        match next {
            Some(word) if word.kind == Kind::Word => {
                self.turned_update(location, word.span).unwrap_or_else(|| {
                    let (sign, word) = (self.slice(location), self.slice(word.span));
                    let text = format!("{sign}{word}").into();
                    self.fault_with_help(location, reason, Suggestion::WriteSigned { text })
                        .of(Broken::Sign)
                })
            }
            Some(Token {
                kind: Kind::Arithmetic(_),
                span,
                ..
            }) if self.left() > 2 => self.two_signs(location, span),
            _ => self.fault(location, reason).of(Broken::Sign),
        }
    }

    /// Returns the fault of a word that begins as a number: `0x1F`, `2O1`, `100ms`.
    pub(in crate::parse) fn no_number(&self, word: &str, location: Span) -> Fault {
        let reason = Parsing::NoNumber { word: word.into() };
        self.fault(location, reason)
            .once(MistakeId::Word(upper_case(word)))
            .help(suggest_for_number(word))
    }

    /// Adds a help to the fault of an operator among the arguments of a command: arguments are not calculated, or the
    /// operator begins a comment of another language.
    pub(in crate::parse) fn with_argument_help(&self, fault: Fault, token: Token) -> Fault {
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

    /// Returns the help for a statement that needs no `=`: `AD_IN VR1 = V`.
    pub(in crate::parse) fn without_equals(&self) -> Suggestion {
        let parts: Vec<&str> = self.slice(self.whole()).split('=').map(str::trim).collect();
        let written = parts.join(" ").into();
        Suggestion::WithoutEquals { written }
    }

    /// Returns the fault of a name with a character that no name has: `WALK(3)`, `P[1]`, `A$`.
    pub(in crate::parse) fn foreign_in_name(&self, word: &str, location: Span) -> Fault {
        let character = self.slice(location).into();
        let reason = Parsing::ForeignInName { character };
        let in_equation = self.is_equation();
        let help: Message = match (word.as_bytes(), foreign_name(word)) {
            // `P = (391, 201, -150)`
            ([b'(' | b'{', b'0'..=b'9' | b'-', ..], _)
                if in_equation && self.peek().is_some_and(|it| it.kind == Kind::Word) =>
            {
                Suggestion::EachMember.into()
            }
            ([b'~', _, ..], _) if !in_equation => Suggestion::WriteNot.into(),
            (_, ForeignName::Parentheses) if in_equation => Parsing::NoParentheses.into(),
            (_, ForeignName::Parentheses) => self
                .condition_in_parentheses()
                .unwrap_or_else(|| Suggestion::NoParentheses.into()),
            (_, ForeignName::Brackets) if in_equation => Suggestion::NoBrackets.into(),
            (_, ForeignName::Brackets) => self
                .condition_in_parentheses()
                .unwrap_or_else(|| Suggestion::NoBrackets.into()),
            (_, ForeignName::Other(help)) => help,
        };
        let fault = self.fault_with_help(location, reason, help);
        let name = word.split(['(', '[']).next().unwrap_or_default();
        match !name.is_empty() && (name.len() < word.len() || word.ends_with('$')) {
            true => fault.once(MistakeId::Word(upper_case(name))),
            false => fault,
        }
    }

    /// Returns the fault of `N =+ 5`, where `N += 5` was meant.
    pub(in crate::parse) fn turned_update(&self, sign: Span, operand: Span) -> Option<Fault> {
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

    /// Returns the fault of two signs: `--391`.
    pub(in crate::parse) fn two_signs(&self, first: Span, second: Span) -> Fault {
        let both = first.to(second);
        let third = self.left_tokens().get(2);
        let operand = third.map_or("", |it| self.slice(it.span));
        let text = format!("{}{operand}", self.slice(second)).into();
        let reason = Suggestion::NoOperator {
            sign: self.slice(both).into(),
        };
        self.fault_with_help(both, reason, Suggestion::Write { text })
    }

    pub(in crate::parse) fn glued(&self, token: Token) -> Fault {
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

/// Returns true if a word is a unit, which no number has.
pub(crate) fn is_unit(word: &str) -> bool {
    const UNITS: &str =
        "% MM CM M DEG RAD S SEC MS MSEC N NM V HZ KHZ ° 度 ㎜ ㎝ 秒 ミリ ミリ秒 ℃ ％";
    UNITS.split(' ').any(|one| one.eq_ignore_ascii_case(word))
}

/// Returns true if a text stands between the ends of a range: `1〜10`.
pub(in crate::parse) fn is_range(text: &str) -> bool {
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

/// Returns the number that a word was meant to be: `2O1` and `l0` have letters that look like digits, `1_000` separates
/// groups.
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

/// A word with characters that no name has.
enum ForeignName {
    /// `(A`, `SIN(A)`: parentheses of a calculation or condition.
    Parentheses,
    /// `(391`, `[1`, `{`: brackets around values.
    Brackets,
    /// Anything else, and what to write.
    Other(Message),
}

impl<M: Into<Message>> From<M> for ForeignName {
    fn from(help: M) -> Self {
        ForeignName::Other(help.into())
    }
}

/// Recognises a word with characters that no name has.
fn foreign_name(word: &str) -> ForeignName {
    let is_number = |text: &str| text.starts_with(|c: char| c.is_ascii_digit());
    if word.strip_prefix(['(', '[']).is_some_and(is_number) || word.starts_with('{') {
        return ForeignName::Brackets;
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
            return ForeignName::Parentheses;
        }
        let name = upper_case(name);
        match commands::find(&name).map(|command| (command.meaning, command.name)) {
            // `V = AD_IN(VR1)`
            Some((Meaning::AdIn, _)) => return Suggestion::AdIn.into(),
            Some((Meaning::KeyIn, _)) => return Suggestion::KeyIn.into(),
            Some((_, command)) => return Suggestion::CommandFirst { command }.into(),
            None => {}
        }
        // `MAX(A, B)` is a function; a single operand in parentheses is probably the index of an array.
        let is_index = inside.len() > 1 && inside.ends_with([')', ']']);
        return match is_index {
            true => Suggestion::NoArray { name }.into(),
            false => no_function(&name).1.into(),
        };
    }
    let name = upper_case(word.trim_start_matches(['-', '+']));
    if name.parse::<Reading>().is_ok() {
        let (word, edition) = (name, Edition::V3_2);
        return Suggestion::OfEdition { word, edition }.into();
    }
    match word.contains(['(', ')']) {
        true => ForeignName::Parentheses,
        false => Parsing::NameCharacters.into(),
    }
}

/// Returns reason and help for a function that the language lacks.
pub(in crate::parse) fn no_function(word: &str) -> (Message, Message) {
    let help = match nearest(word, functions::words()) {
        Some(near) => Suggestion::DidYouMean { near: near.into() }.into(),
        None => {
            let functions = List(functions::words().map(str::to_owned).collect());
            Suggestion::Functions { functions }.into()
        }
    };
    (Parsing::NoSuchFunction { word: word.into() }.into(), help)
}
