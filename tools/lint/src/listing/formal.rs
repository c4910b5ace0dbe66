//! A statement as its fields, in capital letters: a line of FORMAL.TMP has tabs between them (T.I.P. 3.1 §10-4-2), a
//! formatted program blanks.

use tipc::language::Keyword;
use tipc::source::{Source, Span};
use tipc::syntax::{
    Arithmetic, Condition, Expression, Jump, Relation, Statement, StatementKind, Then,
};

/// Writes the fields of one statement of a source in UTF-8, with a separator between them.
pub(crate) fn write(text: &mut Vec<u8>, source: &Source, statement: &Statement, separator: u8) {
    let mut line = Line {
        source,
        start: text.len(),
        text,
        separator,
    };
    line.statement(&statement.kind, statement.span);
}

/// A line as it grows, field by field.
struct Line<'a> {
    source: &'a Source,
    start: usize,
    text: &'a mut Vec<u8>,
    separator: u8,
}

impl Line<'_> {
    fn statement(&mut self, kind: &StatementKind, span: Span) {
        match kind {
            StatementKind::Label(name) => self.label(&name.node),
            StatementKind::Message { text } => {
                self.keyword(Keyword::Message);
                if !text.node.is_empty() {
                    self.field(&text.node);
                }
            }
            StatementKind::Rem => self.keyword(Keyword::Rem),
            StatementKind::Equation(equation) => {
                self.source(equation.target.span);
                self.source(equation.operator);
                self.expression(&equation.value);
            }
            StatementKind::If {
                condition, then, ..
            } => {
                self.with_condition(Keyword::If, condition);
                match then {
                    Then::Block => self.keyword(Keyword::Then),
                    Then::Goto(jump) => self.jump(Keyword::Goto, jump),
                    Then::Gosub(jump) => self.jump(Keyword::Gosub, jump),
                }
            }
            StatementKind::ElseIf { condition, .. } => {
                self.with_condition(Keyword::ElseIf, condition);
                self.keyword(Keyword::Then);
            }
            StatementKind::While { condition, .. } => {
                self.with_condition(Keyword::While, condition)
            }
            StatementKind::Until { condition, .. } => {
                self.with_condition(Keyword::Until, condition)
            }
            StatementKind::For { counting, .. } => {
                self.keyword(Keyword::For);
                self.source(counting.variable.span);
                self.field("=");
                self.source(counting.from.span);
                self.keyword(Keyword::To);
                self.source(counting.to.span);
                if let Some(step) = &counting.step {
                    self.keyword(Keyword::Step);
                    self.source(step.span);
                }
            }
            StatementKind::Next { variable, .. } => {
                self.keyword(Keyword::Next);
                if let Some(variable) = variable {
                    self.source(variable.span);
                }
            }
            StatementKind::Subroutine { name, .. } => {
                self.keyword(Keyword::Subroutine);
                self.label(&name.node);
            }
            StatementKind::Call(jump) => self.jump(Keyword::Call, jump),
            StatementKind::Goto(jump) => self.jump(Keyword::Goto, jump),
            StatementKind::Gosub(jump) => self.jump(Keyword::Gosub, jump),
            StatementKind::Command {
                name, arguments, ..
            } => {
                self.field(&name.node);
                for argument in arguments {
                    self.source(argument.span);
                }
            }
            StatementKind::Define { .. }
            | StatementKind::Else
            | StatementKind::EndIf
            | StatementKind::Wend
            | StatementKind::Repeat
            | StatementKind::SubEnd
            | StatementKind::Return
            | StatementKind::End
            | StatementKind::Exit
            | StatementKind::Broken(_) => self.source(span),
        }
    }

    fn separate(&mut self) {
        if self.text.len() > self.start {
            self.text.push(self.separator);
        }
    }

    fn field(&mut self, text: &str) {
        self.separate();
        self.text.extend_from_slice(text.as_bytes());
    }

    fn keyword(&mut self, keyword: Keyword) {
        self.field(keyword.word());
    }

    /// Writes a piece of the source in capital letters.
    fn source(&mut self, span: Span) {
        self.separate();
        let piece = self.source.slice(span).bytes();
        self.text
            .extend(piece.map(|byte| byte.to_ascii_uppercase()));
    }

    fn label(&mut self, name: &str) {
        self.field(name);
        self.text.push(b':');
    }

    fn jump(&mut self, keyword: Keyword, jump: &Jump) {
        self.keyword(keyword);
        if let Some(label) = &jump.label {
            self.label(&label.node);
        }
    }

    fn with_condition(&mut self, keyword: Keyword, condition: &Condition) {
        self.keyword(keyword);
        match condition {
            Condition::Compare {
                left,
                relation,
                right,
            } => {
                self.source(left.span);
                self.field(relation_sign(*relation));
                self.source(right.span);
            }
            Condition::Flag { name, negated } => {
                self.field(if *negated { "!" } else { "" });
                self.text.extend_from_slice(name.node.as_bytes());
            }
        }
    }

    fn expression(&mut self, expression: &Expression) {
        match expression {
            Expression::Operand(operand) => self.source(operand.span),
            Expression::Binary {
                left,
                operation,
                right,
            } => {
                self.source(left.span);
                self.field(operation_sign(*operation));
                self.source(right.span);
            }
            Expression::Function { name, operands } => {
                self.field(&name.node);
                for operand in operands {
                    self.source(operand.span);
                }
            }
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
