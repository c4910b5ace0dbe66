//! The forms of equations.

use super::written::Names;
use tipc::language::functions;
use tipc::syntax::{Arithmetic, Equation, Expression, Operand, OperandKind, VariableKind};

const TYPES: [VariableKind; 3] = [VariableKind::Var, VariableKind::Pos, VariableKind::Joint];
const OPERATORS: [&str; 4] = ["+", "-", "*", "/"];

/// Every form.
pub fn all() -> Vec<String> {
    let mut equations = Vec::new();
    for kind in TYPES {
        for update in ["=", "+=", "-=", "*=", "/="] {
            for value in values(kind) {
                equations.push(format!("{} {update} {value}", type_name(kind)));
            }
        }
    }
    equations
}

/// The right sides for a type of left side.
fn values(kind: VariableKind) -> Vec<String> {
    let name = type_name(kind);
    let mut values = vec![name.to_owned()];
    values.extend(OPERATORS.map(|operator| format!("{name} {operator} {name}")));
    values.extend(
        functions::words()
            .filter(|function| result(function) == kind)
            .flat_map(|function| {
                let operands: &[&str] = match function {
                    "ATAN2" => &["S S"],
                    "NORM" => &["POS", "JOINT"],
                    "UNIT_VECT" => &["POS"],
                    "ROT_X" | "ROT_Y" | "ROT_Z" => &["POS V"],
                    _ => &["S"],
                };
                operands
                    .iter()
                    .map(move |operands| format!("{function} {operands}"))
            }),
    );
    values
}

/// The type of a function's value.
fn result(function: &str) -> VariableKind {
    match function {
        "UNIT_VECT" | "ROT_X" | "ROT_Y" | "ROT_Z" => VariableKind::Pos,
        _ => VariableKind::Var,
    }
}

fn type_name(kind: VariableKind) -> &'static str {
    match kind {
        VariableKind::Var => "S",
        VariableKind::Pos => "POS",
        VariableKind::Joint => "JOINT",
    }
}

/// The form of an equation.
pub fn of(equation: &Equation, names: &Names) -> String {
    let kind = |operand: &Operand| match &operand.kind {
        OperandKind::Name(name) => names.get(name.as_str()).copied(),
        _ => None,
    };
    let text = |operand| type_name(kind(operand).unwrap_or(VariableKind::Var));
    let left = text(&equation.target);
    let sign = |operation| match operation {
        Arithmetic::Add => "+",
        Arithmetic::Sub => "-",
        Arithmetic::Mul => "*",
        Arithmetic::Div => "/",
    };
    let value = match &equation.value {
        Expression::Operand(_) => left.to_owned(),
        Expression::Binary { operation, .. } => format!("{left} {} {left}", sign(*operation)),
        Expression::Function { name, operands } => {
            let wanted = values(result(&name.node));
            let forms: Vec<&String> = wanted
                .iter()
                .filter(|form| form.split(' ').next() == Some(name.node.as_str()))
                .collect();
            let with = operands.first().map_or("", |operand| text(operand));
            let form = forms.iter().find(|form| form.ends_with(with));
            form.or(forms.first())
                .map_or(String::new(), |form| (*form).clone())
        }
    };
    let update = equation.update.map_or("", sign);
    format!("{left} {update}= {value}")
}

/// The equations that have the left side and operator of a text, and its function or operation.
pub fn meant(text: &str, names: &Names) -> Vec<String> {
    let Some((left, right)) = text.split_once('=') else {
        return Vec::new();
    };
    let update: String = left
        .chars()
        .rev()
        .take_while(|char| "+-*/".contains(*char))
        .collect();
    let left = left
        .trim_end_matches(|char: char| "+-*/ ".contains(char))
        .trim();
    let left = type_name(names.get(left).copied().unwrap_or(VariableKind::Var));
    let first = right.split_whitespace().next().unwrap_or_default();
    let start = format!("{left} {update}= ");
    let mut forms = all();
    forms.retain(|form| form.starts_with(&start));
    let function = functions::words().any(|word| word == first);
    let operator = OPERATORS
        .iter()
        .find(|sign| right.trim().trim_start_matches('-').contains(**sign));
    forms.retain(|form| {
        let value = &form[start.len()..];
        match operator {
            _ if function => value.starts_with(first) && value[first.len()..].starts_with(' '),
            Some(sign) => value == format!("{left} {sign} {left}"),
            None => value == left,
        }
    });
    forms
}
