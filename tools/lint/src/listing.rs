//! The classical listing files (T.I.P. 3.1 §4-2, §10-4, §11). Statements are written as their fields in capital letters: a
//! line of FORMAL.TMP has tabs between them, a formatted program blanks.

mod object;

pub use object::object;

use smol_str::SmolStr;
use std::collections::HashMap;
use tipc::code::Level;
use tipc::diagnostic::Diagnostic;
use tipc::language::commands::{Form, find};
use tipc::language::reserved::{self, is_motion_flag};
use tipc::language::{Edition, Keyword};
use tipc::program::{Label, LabelKind, Program};
use tipc::render;
use tipc::source::{Source, Span};
use tipc::syntax::{
    Arithmetic, Condition, Expression, Jump, Module, Operand, OperandKind, Relation, Statement,
    StatementKind, Then,
};

/// Renders FORMAL.TMP of the module that a source was parsed to: one line a step, fields separated by tabs.
pub fn formal(source: &Source, module: &Module) -> String {
    let mut text = Vec::new();
    let constants = Constants::of(module);
    for statement in module.steps() {
        write(&mut text, source, statement, &constants, b'\t');
        text.push(b'\n');
    }
    String::from_utf8_lossy(&text).into_owned()
}

/// Renders LABEL.TMP: `L`, `S` (declared by SUBROUTINE) or `T` (by THREAD), name and step of each label.
pub fn label(program: &Program) -> String {
    let line = |label: &Label| {
        let kind = match label.kind {
            LabelKind::Plain => 'L',
            LabelKind::Subroutine => 'S',
            LabelKind::Thread => 'T',
        };
        format!("{kind}\t{}:\t{}\n", label.name, label.step)
    };
    program.labels().iter().map(line).collect()
}

/// Renders WARNING.LOG: the warnings among the diagnostics of a source, one a line.
pub fn warnings(source: &Source, diagnostics: &[Diagnostic]) -> String {
    let warnings = diagnostics.iter().filter(|it| it.level() == Level::Warning);
    warnings
        .map(|warning| render::classical(source, warning) + "\n")
        .collect()
}

/// The constants that DEFINE names, with their values.
#[derive(Debug, Default)]
pub(crate) struct Constants {
    values: HashMap<SmolStr, f64>,
    edition: Edition,
}

impl Constants {
    /// Evaluates the definitions of a module.
    pub(crate) fn of(module: &Module) -> Self {
        let mut constants = Constants {
            values: HashMap::new(),
            edition: module.edition,
        };
        for statement in &module.statements {
            if let StatementKind::Constant { name, value, .. } = &statement.kind
                && let Some(value) = constants.evaluate(value)
            {
                constants.values.entry(name.node.clone()).or_insert(value);
            }
        }
        constants
    }

    fn evaluate(&self, value: &Operand) -> Option<f64> {
        match &value.kind {
            OperandKind::Number(number) => Some(*number),
            OperandKind::Name(name) => {
                let known = reserved::constant(name, self.edition);
                let known = known.or_else(|| self.values.get(name).copied())?;
                Some(if value.negative { -known } else { known })
            }
            OperandKind::Member(_) => None,
        }
    }

    /// Returns the value of an operand that is such a name.
    fn named(&self, operand: &Operand) -> Option<f64> {
        match &operand.kind {
            OperandKind::Name(name) if self.values.contains_key(name) => self.evaluate(operand),
            _ => None,
        }
    }
}

/// Writes the fields of one statement of a source in UTF-8, with a separator between them; constants as their values.
pub(crate) fn write(
    text: &mut Vec<u8>,
    source: &Source,
    statement: &Statement,
    constants: &Constants,
    separator: u8,
) {
    let mut line = Line {
        source,
        constants,
        start: text.len(),
        text,
        separator,
    };
    line.statement(&statement.kind, statement.span);
}

/// A line as it grows, field by field.
struct Line<'a> {
    source: &'a Source,
    constants: &'a Constants,
    start: usize,
    text: &'a mut Vec<u8>,
    separator: u8,
}

impl Line<'_> {
    fn statement(&mut self, kind: &StatementKind, span: Span) {
        match kind {
            StatementKind::Label(name) => self.label(&name.node),
            StatementKind::Message { text } | StatementKind::FileMessage { text } => {
                self.keyword(match kind {
                    StatementKind::FileMessage { .. } => Keyword::FileMessage,
                    _ => Keyword::Message,
                });
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
                self.operand(&counting.from);
                self.keyword(Keyword::To);
                self.operand(&counting.to);
                if let Some(step) = &counting.step {
                    self.keyword(Keyword::Step);
                    self.operand(step);
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
            StatementKind::Thread { name, .. } => {
                self.keyword(Keyword::Thread);
                self.label(&name.node);
            }
            StatementKind::StartThread(jump) => self.jump(Keyword::StartThread, jump),
            StatementKind::StopThread(jump) => self.jump(Keyword::StopThread, jump),
            StatementKind::WaitThread(jump) => self.jump(Keyword::WaitThread, jump),
            StatementKind::Constant { name, value, .. } => {
                self.keyword(Keyword::Define);
                self.field(&name.node);
                self.source(value.span);
            }
            StatementKind::Call(jump) => self.jump(Keyword::Call, jump),
            StatementKind::Goto(jump) => self.jump(Keyword::Goto, jump),
            StatementKind::Gosub(jump) => self.jump(Keyword::Gosub, jump),
            StatementKind::Command {
                name, arguments, ..
            } => {
                self.field(&name.node);
                let flags = has_flags(&name.node);
                for argument in arguments {
                    match &argument.kind {
                        OperandKind::Name(word)
                            if flags && is_motion_flag(word, self.constants.edition) =>
                        {
                            self.source(argument.span);
                        }
                        _ => self.operand(argument),
                    }
                }
            }
            StatementKind::Define { .. }
            | StatementKind::Else
            | StatementKind::EndIf
            | StatementKind::Wend
            | StatementKind::Repeat
            | StatementKind::SubEnd
            | StatementKind::ThreadEnd
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

    /// Writes an operand; a constant with a name as its value.
    fn operand(&mut self, operand: &Operand) {
        match self.constants.named(operand) {
            Some(value) => self.field(&format!("{value:?}").to_ascii_uppercase()),
            None => self.source(operand.span),
        }
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
                self.operand(left);
                self.field(relation_sign(*relation));
                self.operand(right);
            }
            Condition::Flag { name, negated } => {
                self.field(if *negated { "!" } else { "" });
                self.text.extend_from_slice(name.node.as_bytes());
            }
        }
    }

    fn expression(&mut self, expression: &Expression) {
        match expression {
            Expression::Operand(operand) => self.operand(operand),
            Expression::Binary {
                left,
                operation,
                right,
            } => {
                self.operand(left);
                self.field(operation_sign(*operation));
                self.operand(right);
            }
            Expression::Function { name, operands } => {
                self.field(&name.node);
                for operand in operands {
                    self.operand(operand);
                }
            }
        }
    }
}

/// Returns true if the command reads `R`, `A` and `HS` as its flags.
fn has_flags(command: &str) -> bool {
    let form = find(command).map(|command| command.form);
    matches!(form, Some(Form::Robot(form)) if form.motion)
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
