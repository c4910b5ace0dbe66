//! The parser, through one helper: a program's lines 3… in, statements and diagnostics out.

use super::parse;
use crate::source::{Encoding, Source};

mod conditions;
mod control;
mod equations;
mod header;
mod lines;
mod robustness;

/// Parses `body` after a good version line and title, END added, and compares what comes out.
///
/// One line for each statement but END, as [`dump`] writes it, then one for each diagnostic: `LINE:COLUMN: message`,
/// lines counted from 1 in `body`.
#[track_caller]
fn check(body: &str, expected: &[&str]) {
    assert_eq!(
        outcome(&format!("{body}\nEND")),
        expected,
        "program: {body}"
    );
}

/// As [`check`], without the END added.
#[track_caller]
fn check_whole(body: &str, expected: &[&str]) {
    assert_eq!(outcome(body), expected, "program: {body}");
}

fn outcome(body: &str) -> Vec<String> {
    let text = format!("3.1\ntitle\n{body}");
    let (source, bad) = Source::decode("test.prg", text.as_bytes(), Encoding::Utf8);
    assert_eq!(bad, None);
    let (module, diagnostics) = parse(&source, 3.1);
    let statements = module
        .statements
        .iter()
        .map(|one| dump::statement(&source, one));
    let found = diagnostics.iter().map(|diagnostic| {
        let (line, column) = source.line_column(diagnostic.span.start);
        format!("{}:{column}: {}", line - 2, diagnostic.message())
    });
    statements
        .filter(|line| line != "end")
        .chain(found)
        .collect()
}

mod dump {
    //! Statements in a short form of their own.

    use crate::source::Source;
    use crate::syntax::{
        Arithmetic, Condition, Counting, Expression, Jump, Operand, OperandKind, Relation,
        Statement, StatementKind, Then,
    };

    pub(super) fn statement(source: &Source, statement: &Statement) -> String {
        match &statement.kind {
            StatementKind::Define { kind, names, .. } => {
                let names: Vec<&str> = names.iter().map(|name| name.node.as_str()).collect();
                format!("define {kind:?} {}", names.join(" "))
            }
            StatementKind::Label(name) => format!("label {}", name.node),
            StatementKind::Equation(one) => format!(
                "set {} {}= {}",
                operand(&one.target),
                one.update.map_or("", arithmetic),
                expression(&one.value)
            ),
            StatementKind::If {
                condition: one,
                then,
                ..
            } => match then {
                Then::Block => format!("if {} then", condition(one)),
                Then::Goto(to) => format!("if {} goto {}", condition(one), jump(to)),
                Then::Gosub(to) => format!("if {} gosub {}", condition(one), jump(to)),
            },
            StatementKind::ElseIf { condition: one, .. } => format!("elseif {}", condition(one)),
            StatementKind::While { condition: one, .. } => format!("while {}", condition(one)),
            StatementKind::Until { condition: one, .. } => format!("until {}", condition(one)),
            StatementKind::For { counting, .. } => {
                let Counting {
                    variable,
                    from,
                    to,
                    step,
                } = counting.as_ref();
                let step = step.as_ref().map_or("-".to_owned(), operand);
                format!(
                    "for {} {} {} {step}",
                    operand(variable),
                    operand(from),
                    operand(to)
                )
            }
            StatementKind::Next { variable, .. } => {
                format!("next {}", variable.as_ref().map_or("-".to_owned(), operand))
            }
            StatementKind::Subroutine { name, .. } => format!("subroutine {}", name.node),
            StatementKind::Call(to) => format!("call {}", jump(to)),
            StatementKind::Goto(to) => format!("goto {}", jump(to)),
            StatementKind::Gosub(to) => format!("gosub {}", jump(to)),
            StatementKind::Message { text } => format!("message [{}]", text.node),
            StatementKind::Command {
                name,
                arguments,
                malformed,
            } => {
                let mut out = format!("command {}", name.node);
                for one in arguments {
                    out += &format!(" {}", operand(one));
                }
                if let Some(fault) = malformed {
                    let (_, column) = source.line_column(fault.span.start);
                    out += &format!(" ?{column}");
                }
                out
            }
            StatementKind::Broken(shape) => format!("broken {shape:?}"),
            other => format!("{other:?}").to_lowercase(),
        }
    }

    fn operand(one: &Operand) -> String {
        let sign = if one.negative { "-" } else { "" };
        match &one.kind {
            OperandKind::Number(number) => format!("{number:?}"),
            OperandKind::Name(name) => format!("{sign}{name}"),
            OperandKind::Member(words) => format!("{sign}{}.{}", words.0, words.1),
        }
    }

    fn arithmetic(operation: Arithmetic) -> &'static str {
        match operation {
            Arithmetic::Add => "+",
            Arithmetic::Sub => "-",
            Arithmetic::Mul => "*",
            Arithmetic::Div => "/",
        }
    }

    fn expression(value: &Expression) -> String {
        match value {
            Expression::Operand(one) => operand(one),
            Expression::Binary {
                left,
                operation,
                right,
            } => {
                format!(
                    "({} {} {})",
                    operand(left),
                    arithmetic(*operation),
                    operand(right)
                )
            }
            Expression::Function { name, operands } => {
                let operands: Vec<String> = operands.iter().map(operand).collect();
                format!("{}({})", name.node, operands.join(", "))
            }
        }
    }

    fn condition(condition: &Condition) -> String {
        match condition {
            Condition::Compare {
                left,
                relation,
                right,
            } => {
                let relation = match relation {
                    Relation::Eq => "==",
                    Relation::Ne => "<>",
                    Relation::Lt => "<",
                    Relation::Gt => ">",
                    Relation::Le => "<=",
                    Relation::Ge => ">=",
                };
                format!("({} {relation} {})", operand(left), operand(right))
            }
            Condition::Flag { name, negated } => {
                format!("{}{}", if *negated { "!" } else { "" }, name.node)
            }
        }
    }

    fn jump(jump: &Jump) -> String {
        jump.label
            .as_ref()
            .map_or("-".to_owned(), |label| label.node.to_string())
    }
}
