//! Diagnostics of right sides of equations that the language lacks.

use super::operand::{is_unit, no_function};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::commands::{self, Meaning};
use crate::language::functions;
use crate::lex::{Kind, Token};
use crate::message::{Message, Parsing, Suggestion};
use crate::parse::reader::{Broken, Fault, Reader};
use crate::suggest::nearest;
use crate::syntax::{Arithmetic, Operand, OperandKind, upper_case};

impl Reader<'_> {
    /// Returns the fault of a token after the first operand: `A = B 2`, `A = MAX B C`, `A = B ^ 2`.
    pub(in crate::parse) fn behind_operand(&self, left: &Operand, token: Token) -> Fault {
        unknown_function(self, left, token).unwrap_or_else(|| {
            let help = suggest(self, left, token);
            self.fault_with_help(token.span, Parsing::OperatorOrNothing, help)
        })
    }

    /// Returns the fault of a second `*` after the first one: `A = B ** 2`.
    pub(in crate::parse) fn power(&self) -> Option<Fault> {
        let second = self.peek()?;
        (second.kind == Kind::Arithmetic(Arithmetic::Mul)).then(|| {
            let text = self.slice(second.span).into();
            self.fault_with_help(second.span, Parsing::NoOperand { text }, Suggestion::Power)
        })
    }

    /// Returns the fault of tokens after an operation: `A = B + C + D`, `A = B + 5 mm`.
    pub(in crate::parse) fn behind_operation(&self) -> Fault {
        let ends_in_unit = self.left() == 1 && is_unit(self.slice(self.here()));
        let help: Message = match ends_in_unit {
            true => Suggestion::NoUnit.into(),
            false => Parsing::OneOperation.into(),
        };
        self.fault_with_help(self.rest(), Parsing::EquationEnds, help)
    }
}

/// Returns the fault of a word before an operand that other languages have as a function or that is near to one: `MAX A
/// B`, `ARCTAN A`.
fn unknown_function(reader: &Reader<'_>, left: &Operand, next: Token) -> Option<Fault> {
    let word = upper_case(reader.slice(left.span));
    let is_name = matches!(left.kind, OperandKind::Name(_)) && next.kind == Kind::Word;
    let is_near =
        || nearest(&word, functions::words()).is_some() && commands::find(&word).is_none();
    let is_one = is_name && next.spaced && is_near();
    is_one.then(|| {
        let (reason, help) = no_function(&word);
        reader.fault_with_help(left.span, reason, help)
    })
}

/// Suggests a replacement for what follows the first operand.
fn suggest(reader: &Reader<'_>, left: &Operand, token: Token) -> Message {
    let word = upper_case(reader.slice(token.span));
    let first = upper_case(reader.slice(left.span));
    let next = reader.peek();
    match word.as_str() {
        "^" => return Suggestion::Power.into(),
        "%" | "MOD" => return Suggestion::Remainder.into(),
        "!" => return Suggestion::Comment.into(),
        _ => {}
    }
    if let Some(number) = reader.comma_number(left.span, token.span) {
        return number.into();
    }
    match commands::find(&first).map(|command| command.meaning) {
        Some(Meaning::AdIn) => return Suggestion::AdIn.into(),
        Some(Meaning::KeyIn) => return Suggestion::KeyIn.into(),
        _ => {}
    }
    if let Some(command) = commands::find(&first).map(|command| command.name) {
        return Suggestion::CommandFirst { command }.into();
    }
    if is_unit(&word) {
        return Suggestion::NoUnit.into();
    }
    if token.kind == Kind::Colon && next.is_some() {
        return Suggestion::ColonSeparates.into();
    }
    if token.kind == Kind::Assign(None) {
        let name = reader.first_word();
        return Suggestion::AssignEach { name }.into();
    }
    if matches!(token.kind, Kind::Relation(_)) {
        return Suggestion::ChooseByIf.into();
    }
    match next.map(|next| next.kind) {
        Some(Kind::Assign(_)) => Parsing::NextStatementElsewhere.into(),
        Some(_) if is_number(&first) && is_number(&word) => Suggestion::EachMember.into(),
        _ => Parsing::OneOperation.into(),
    }
}

fn is_number(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_digit() || c == '-')
}

/// Adds a help to a fault among the operands of a function: a sign there was meant as a second operation.
pub(in crate::parse) fn in_function(fault: Fault) -> Fault {
    let fault = match fault.broken {
        Broken::Sign => {
            let location = fault.diagnostic.span;
            Diagnostic::new(Code::Equation, location, Parsing::EquationEnds).into()
        }
        _ => fault,
    };
    fault.or_help(Parsing::OneOperation)
}
