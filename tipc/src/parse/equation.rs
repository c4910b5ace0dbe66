//! Equations (T.I.P. 3.1 §5).
//!
//! ```text
//! equation = variable ("=" | "+=" | "-=" | "*=" | "/=") value
//! value    = operand | operand ("+" | "-" | "*" | "/") operand | FUNCTION {operand}
//! ```
//!
//! [`recover::equation`](super::recover::equation) words the diagnostic of anything else.

use super::reader::{Parsed, Reader};
use super::recover::equation::in_function;
use crate::code::Code;
use crate::language::{Edition, functions};
use crate::lex::{Kind, Token};
use crate::message::Parsing;
use crate::syntax::{Arithmetic, Equation, Expression, Operand, OperandKind};

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
        read.map_err(in_function)?;
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
        Some(token) => return Err(reader.behind_operand(&left, token)),
    };
    if operation == Arithmetic::Mul
        && let Some(fault) = reader.power()
    {
        return Err(fault);
    }
    let right = reader.operand()?;
    refuse_function(reader, &right, edition)?;
    match reader.left() {
        0 => Ok(Expression::Binary {
            left,
            operation,
            right,
        }),
        _ => Err(reader.behind_operation()),
    }
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
