//! A statement's line of FORMAL.TMP: its fields separated by tabs (T.I.P. 3.1 §10-4-2).

use crate::source::Source;
use crate::syntax::{
    Arithmetic, Condition, Expression, Jump, Relation, Span, Statement, StatementKind, Then,
};

/// The line of one statement.
pub(super) fn line(source: &Source, statement: &Statement) -> String {
    let fields = Fields { source };
    match &statement.kind {
        StatementKind::Label(name) => format!("{}:", name.node),
        StatementKind::Message { text } if text.node.is_empty() => "MESSAGE".to_owned(),
        StatementKind::Message { text } => format!("MESSAGE\t{}", text.node),
        StatementKind::Rem => "REM".to_owned(),
        kind => fields.of(kind, statement.span).join("\t"),
    }
}

struct Fields<'a> {
    source: &'a Source,
}

impl Fields<'_> {
    fn of(&self, kind: &StatementKind, span: Span) -> Vec<String> {
        match kind {
            StatementKind::Equation(equation) => {
                let mut fields = vec![
                    self.text(equation.target.span),
                    self.text(equation.operator),
                ];
                fields.extend(self.expression(&equation.value));
                fields
            }
            StatementKind::If {
                condition, then, ..
            } => {
                let mut fields = self.with_condition("IF", condition);
                match then {
                    Then::Block => fields.push("THEN".to_owned()),
                    Then::Goto(jump) => fields.extend(self.jump("GOTO", jump)),
                    Then::Gosub(jump) => fields.extend(self.jump("GOSUB", jump)),
                }
                fields
            }
            StatementKind::ElseIf { condition, .. } => {
                let mut fields = self.with_condition("ELSEIF", condition);
                fields.push("THEN".to_owned());
                fields
            }
            StatementKind::While { condition, .. } => self.with_condition("WHILE", condition),
            StatementKind::Until { condition, .. } => self.with_condition("UNTIL", condition),
            StatementKind::For {
                variable,
                from,
                to,
                step,
                ..
            } => {
                let mut fields = vec![
                    "FOR".to_owned(),
                    self.text(variable.span),
                    "=".to_owned(),
                    self.text(from.span),
                    "TO".to_owned(),
                    self.text(to.span),
                ];
                if let Some(step) = step {
                    fields.extend(["STEP".to_owned(), self.text(step.span)]);
                }
                fields
            }
            StatementKind::Next {
                variable: Some(variable),
                ..
            } => vec!["NEXT".to_owned(), self.text(variable.span)],
            StatementKind::Next { variable: None, .. } => vec!["NEXT".to_owned()],
            StatementKind::Subroutine { name, .. } => {
                vec!["SUBROUTINE".to_owned(), format!("{}:", name.node)]
            }
            StatementKind::Call(jump) => self.jump("CALL", jump),
            StatementKind::Goto(jump) => self.jump("GOTO", jump),
            StatementKind::Gosub(jump) => self.jump("GOSUB", jump),
            StatementKind::Command {
                name, arguments, ..
            } => std::iter::once(name.node.clone())
                .chain(arguments.iter().map(|argument| self.text(argument.span)))
                .collect(),
            _ => vec![self.text(span)],
        }
    }

    fn text(&self, span: Span) -> String {
        self.source.slice(span).to_ascii_uppercase()
    }

    fn jump(&self, word: &str, jump: &Jump) -> Vec<String> {
        let label = jump.label.iter().map(|label| format!("{}:", label.node));
        std::iter::once(word.to_owned()).chain(label).collect()
    }

    fn with_condition(&self, word: &str, condition: &Condition) -> Vec<String> {
        let mut fields = vec![word.to_owned()];
        match condition {
            Condition::Compare {
                left,
                relation,
                right,
            } => fields.extend([
                self.text(left.span),
                relation_sign(*relation).to_owned(),
                self.text(right.span),
            ]),
            Condition::Flag { name, negated } => {
                let sign = if *negated { "!" } else { "" };
                fields.push(format!("{sign}{}", name.node));
            }
        }
        fields
    }

    fn expression(&self, expression: &Expression) -> Vec<String> {
        match expression {
            Expression::Operand(operand) => vec![self.text(operand.span)],
            Expression::Binary {
                left,
                operation,
                right,
            } => vec![
                self.text(left.span),
                operation_sign(*operation).to_owned(),
                self.text(right.span),
            ],
            Expression::Function { name, operands } => std::iter::once(name.node.clone())
                .chain(operands.iter().map(|operand| self.text(operand.span)))
                .collect(),
        }
    }
}

const fn relation_sign(relation: Relation) -> &'static str {
    match relation {
        Relation::Eq => "==",
        Relation::Ne => "<>",
        Relation::Lt => "<",
        Relation::Gt => ">",
        Relation::Le => "<=",
        Relation::Ge => ">=",
    }
}

const fn operation_sign(operation: Arithmetic) -> &'static str {
    match operation {
        Arithmetic::Add => "+",
        Arithmetic::Sub => "-",
        Arithmetic::Mul => "*",
        Arithmetic::Div => "/",
    }
}
