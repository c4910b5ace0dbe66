//! `LHS op RHS` (T.I.P. 3.1 §5).

use super::operand::{is_unit, no_function};
use super::reader::{Broken, Fault, Parsed, Reader};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::commands::{self, Meaning};
use crate::language::{Edition, functions};
use crate::lex::{Kind, Token};
use crate::message::{Message, Parsing, Suggestion};
use crate::suggest::nearest;
use crate::syntax::{Arithmetic, Equation, Expression, Operand, OperandKind, upper_case};

/// Returns true if the tokens are meant as an equation: an assignment follows the first word, or a non-word starts it.
pub(super) fn looks_like_one(tokens: &[Token]) -> bool {
    let is_assignment = |token: &Token| matches!(token.kind, Kind::Assign(_));
    match tokens {
        [first, second, ..] if first.kind == Kind::Word => is_assignment(second),
        [first, ..] if first.kind != Kind::Word => tokens.iter().any(is_assignment),
        _ => false,
    }
}

/// Reads an equation.
pub(super) fn equation(text: &str, tokens: &[Token], edition: Edition) -> Parsed<Equation> {
    let mut reader = Reader::new(text, tokens, 0, Code::Equation, edition);
    let target = target(&mut reader)?;
    let (update, operator) = match reader.take() {
        Some(Token {
            kind: Kind::Assign(update),
            span,
            ..
        }) => (update, span),
        _ => return Err(reader.fault(target.span, Parsing::OneVariableLeft)),
    };
    let value = right_side(&mut reader, edition)?;
    Ok(Equation {
        target,
        update,
        operator,
        value,
    })
}

fn target(reader: &mut Reader<'_>) -> Parsed<Operand> {
    let help = Parsing::LeftSide;
    match reader.peek() {
        Some(token) if token.kind == Kind::Word => {
            reader.take();
            let operand = reader.value(token.span)?;
            match operand.kind {
                OperandKind::Name(_) | OperandKind::Member(_) => Ok(operand),
                OperandKind::Number(_) => {
                    Err(reader.fault_with_help(token.span, Parsing::ConstantAssigned, help))
                }
            }
        }
        _ => Err(reader.fault_with_help(reader.here(), Parsing::StartsWithVariable, help)),
    }
}

fn right_side(reader: &mut Reader<'_>, edition: Edition) -> Parsed<Expression> {
    if let Some(function) = reader
        .peek()
        .filter(|token| is_function(reader, *token, edition))
    {
        reader.take();
        let (operands, read) = reader.operands();
        read.map_err(with_help)?;
        for operand in &operands {
            refuse_function(reader, operand, edition)?;
        }
        return Ok(Expression::Function {
            name: reader.word(function.span),
            operands,
        });
    }
    let left = reader.operand()?;
    refuse_function(reader, &left, edition)?;
    let operation = match reader.take() {
        None => return Ok(Expression::Operand(left)),
        Some(Token {
            kind: Kind::Arithmetic(operation),
            ..
        }) => operation,
        Some(token) => {
            if let Some(fault) = unknown_function(reader, &left, token) {
                return Err(fault);
            }
            let reason = Parsing::OperatorOrNothing;
            let help = suggest(reader, &left, token);
            return Err(reader.fault_with_help(token.span, reason, help));
        }
    };
    if let Some(second) = reader.peek().filter(|_| operation == Arithmetic::Mul)
        && second.kind == Kind::Arithmetic(Arithmetic::Mul)
    {
        let text = reader.slice(second.span).into();
        let reason = Parsing::NoOperand { text };
        return Err(reader.fault_with_help(second.span, reason, Suggestion::Power));
    }
    let right = reader.operand()?;
    refuse_function(reader, &right, edition)?;
    match reader.left() {
        0 => Ok(Expression::Binary {
            left,
            operation,
            right,
        }),
        left => {
            let ends_in_unit = left == 1 && is_unit(reader.slice(reader.here()));
            let help: Message = match ends_in_unit {
                true => Suggestion::NoUnit.into(),
                false => Parsing::OneOperation.into(),
            };
            Err(reader.fault_with_help(reader.rest(), Parsing::EquationEnds, help))
        }
    }
}

/// `MAX A B`, `ARCTAN A`: a word before an operand, that is known or near to a function.
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

/// Adds a help to a fault among the operands of a function: what looks like a sign there was to be a second operation.
fn with_help(fault: Fault) -> Fault {
    let fault = match fault.broken {
        Broken::Sign => {
            let location = fault.diagnostic.span;
            Diagnostic::new(Code::Equation, location, Parsing::EquationEnds).into()
        }
        _ => fault,
    };
    fault.or_help(Parsing::OneOperation)
}

fn is_function(reader: &Reader<'_>, token: Token, edition: Edition) -> bool {
    let word = reader.slice(token.span);
    token.kind == Kind::Word && functions::find(word, edition).is_some()
}

/// Refuses a function among operands: it is the whole right side, and appears nowhere else.
fn refuse_function(reader: &Reader<'_>, operand: &Operand, edition: Edition) -> Parsed<()> {
    match &operand.kind {
        OperandKind::Name(name) if functions::find(name, edition).is_some() => Err(reader
            .fault_with_help(
                operand.span,
                Parsing::FunctionCannotStandHere {
                    function: name.clone(),
                },
                Parsing::OneOperation,
            )),
        _ => Ok(()),
    }
}
