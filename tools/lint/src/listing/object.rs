//! TIP.OBJ: the record of each step in the memory of the original system, as text (T.I.P. 3.1 §11, layouts in §5 to
//! §7).

use super::{Constants, write};
use std::borrow::Cow;
use std::fmt::Write;
use tip_runtime::command::{Port, READING, Reading, Target, Teach};
use tipc::language::Keyword;
use tipc::language::commands::find_in;
use tipc::language::functions::Operation;
use tipc::language::reserved::POSITION;
use tipc::program::{
    Action, Argument, Arithmetic, Condition, Mark, Op, Operand, Program, Relation, Scalar,
    ScalarExpression, StepId, StructExpression, StructOperand, Variable, VariableId, VariableKind,
};
use tipc::source::Source;
use tipc::syntax::Module;

/// Renders TIP.OBJ of a program, and the source and module that it was lowered from: for each step its command, its
/// target, and the types and values of its arguments.
///
/// There are five arguments, or as many as a leg has joints if that is more.
pub fn object(source: &Source, module: &Module, program: &Program) -> String {
    let count = usize::from(program.signature().joints).max(5);
    let mut listing = Listing {
        variables: Variables::new(program),
        texts: 0,
    };
    let steps = module.steps().zip(program.steps()).enumerate();
    let mut line = Vec::new();
    let constants = Constants::of(module);
    steps
        .map(|(number, (statement, step))| {
            line.clear();
            write(&mut line, source, statement, &constants, b'\t');
            let formal = String::from_utf8_lossy(&line);
            listing.record(&formal, &step.action).text(number, count)
        })
        .collect()
}

/// A listing under construction.
struct Listing<'a> {
    variables: Variables<'a>,
    /// Number of MESSAGE texts so far.
    texts: u32,
}

impl Listing<'_> {
    /// Returns the record of a step. `formal` is its line of FORMAL.TMP, with the spelling of its operands.
    fn record(&mut self, formal: &str, action: &Action) -> Record {
        let mut fields = formal.split('\t');
        let word = fields.next().unwrap_or_default();
        let name =
            find_in(word, self.variables.program.edition()).map_or(word, |command| command.name);
        let last = fields.next_back();
        match action {
            Action::Nothing if word.ends_with(':') => Record::new("LABEL_CMD"),
            Action::Message { .. } if word == Keyword::Message.word() => self.message(name),
            Action::FileMessage { .. } => self.message(name),
            Action::StartThread { thread }
            | Action::StopThread { thread }
            | Action::WaitThread { thread } => {
                let thread = &self.variables.program.threads()[*thread];
                Record::new(name).with(label(thread.first))
            }
            Action::KeyIn { into } => {
                // A KEY_IN without an argument has no target in the listing, although VAR_KEY receives the key.
                let into = last.map(|_| self.variables.scalar(*into, false));
                Record::new(name).with(into.unwrap_or(Slot::NONE))
            }
            Action::AdIn { port, into } => {
                self.ad_in(name, *port, self.variables.scalar(*into, false))
            }
            Action::TeachStruct { target, into, .. } => Record::new(name)
                .to(target_name(*target))
                .with(self.variables.whole(*into)),
            Action::TeachScalar { target, into, .. } => Record::new(name)
                .to(target_name(*target))
                .with(self.variables.scalar(*into, false)),
            Action::Command {
                op: Op::SetLimit,
                target: target @ Target::Foot(_),
                arguments,
                ..
            } => {
                let record = Record::new(name).to(target_name(*target));
                let firsts = arguments.iter().step_by((arguments.len() / 2).max(1));
                let joints = firsts.filter_map(|first| self.variables.whole_of(first.operand));
                joints.fold(record, Record::with)
            }
            Action::Command {
                hs,
                target,
                arguments,
                ..
            } => {
                let fast = if *hs { "_HS" } else { "" };
                let record = Record::new(format!("{name}{fast}")).to(target_name(*target));
                let slots = self.arguments(arguments, last.unwrap_or_default());
                slots.into_iter().fold(record, Record::with)
            }
            Action::SetScalar {
                target,
                update,
                value,
            } => {
                let left = self.variables.scalar(*target, false);
                equation(self.scalar_value(value), *update, left)
            }
            Action::SetStruct {
                target,
                update,
                value,
            } => {
                let left = self.variables.whole(*target);
                equation(self.struct_value(value), *update, left)
            }
            Action::If {
                condition,
                otherwise,
            } => self.conditional("IF_THEN", condition, *otherwise),
            // The fourth argument is the cell that the block above writes.
            Action::ElseIf {
                condition,
                otherwise,
            } => self
                .conditional(Keyword::ElseIf.word(), condition, *otherwise)
                .with(Slot::constant(0.0)),
            Action::While { condition, exit } => {
                self.conditional(Keyword::While.word(), condition, *exit)
            }
            Action::Until { condition, back } => {
                self.conditional(Keyword::Until.word(), condition, *back)
            }
            Action::IfGoto { condition, to } => self.conditional("IF_GOTO", condition, *to),
            Action::IfGosub { condition, to } => self.conditional("IF_GOSUB", condition, *to),
            Action::Else { end } => Record::new(Keyword::Else.word())
                .with(label(*end))
                .with(Slot::constant(0.0)),
            Action::Goto { to } | Action::Gosub { to } => Record::new(name).with(label(*to)),
            Action::For {
                variable,
                from,
                to,
                step,
                exit,
            } => Record::new(Keyword::For.word())
                .with(self.variables.scalar(*variable, false))
                .with(self.variables.operand(*from))
                .with(self.variables.operand(*to))
                .with(label(*exit))
                .with(self.variables.operand(*step)),
            Action::Next { variable, body, .. } => Record::new(Keyword::Next.word())
                .with(self.variables.scalar(*variable, false))
                .with(label(body.saturating_sub(1))),
            Action::Nothing
            | Action::Return
            | Action::ThreadEnd
            | Action::Finish(_)
            | Action::Message { .. } => Record::new(name),
        }
    }

    /// Returns the index of the text among all texts.
    fn message(&mut self, name: &str) -> Record {
        let text = Slot::new("STRING", f64::from(self.texts));
        self.texts += 1;
        Record::new(name).with(text)
    }

    fn ad_in(&self, name: &str, port: Port, into: Slot) -> Record {
        let record = Record::new(name);
        let record = match port {
            Port::Channel(channel) => record
                .with(Slot::constant(0.0))
                .with(Slot::constant(f64::from(channel))),
            port => record
                .to(format!("TARGET_{port}"))
                .with(Slot::NONE)
                .with(Slot::NONE),
        };
        record.with(into)
    }

    /// Returns the arguments. A struct that was written as one operand, `last`, is one argument.
    fn arguments(&self, arguments: &[Argument], last: &str) -> Vec<Slot> {
        if let Some(whole) = self.variables.written_whole(arguments, last) {
            return vec![whole];
        }
        let slot = |argument: &Argument| {
            let operand = self.variables.operand(argument.operand);
            operand.marked(argument.mark)
        };
        arguments.iter().map(slot).collect()
    }

    fn scalar_value(&self, value: &ScalarExpression) -> (String, Vec<Slot>) {
        let slot = |operand: &Operand| self.variables.operand(*operand);
        match value {
            ScalarExpression::Operand(operand) => ("EQUAL".to_owned(), vec![slot(operand)]),
            ScalarExpression::Binary {
                left,
                operation,
                right,
            } => (
                equal(operation_name(*operation)),
                vec![slot(left), slot(right)],
            ),
            ScalarExpression::Function { function, operand } => (
                equal(Operation::Scalar(*function).word()),
                vec![slot(operand)],
            ),
            ScalarExpression::Atan2 { y, x } => {
                (equal(Operation::Atan2.word()), vec![slot(y), slot(x)])
            }
            ScalarExpression::Norm(whole) => (
                equal(Operation::Norm.word()),
                vec![self.variables.structure(*whole)],
            ),
        }
    }

    fn struct_value(&self, value: &StructExpression) -> (String, Vec<Slot>) {
        let whole = |operand: &StructOperand| self.variables.structure(*operand);
        match value {
            StructExpression::Copy(variable) => ("EQUAL".to_owned(), vec![whole(variable)]),
            StructExpression::Binary {
                left,
                operation,
                right,
            } => (
                equal(operation_name(*operation)),
                vec![whole(left), whole(right)],
            ),
            StructExpression::UnitVect(variable) => {
                (equal(Operation::UnitVect.word()), vec![whole(variable)])
            }
            StructExpression::Rotate {
                axis,
                operand,
                angle,
            } => {
                let name = equal(Operation::Rotate(*axis).word());
                (name, vec![whole(operand), self.variables.operand(*angle)])
            }
        }
    }

    fn conditional(&self, name: &str, condition: &Condition, to: StepId) -> Record {
        let (kind, left, right) = match condition {
            Condition::Compare {
                left,
                relation,
                right,
            } => (
                relation_name(*relation),
                self.variables.operand(*left),
                self.variables.operand(*right),
            ),
            Condition::Flag { flag, negated } => {
                let sign = if *negated { -1.0 } else { 1.0 };
                ("EVENT", Slot::new(flag.to_string(), sign), Slot::NONE)
            }
        };
        Record::new(format!("{name}_{kind}"))
            .with(left)
            .with(right)
            .with(label(to))
    }
}

fn equation((name, right): (String, Vec<Slot>), update: Option<Arithmetic>, left: Slot) -> Record {
    let record = Record::new(name).to(left_name(update)).with(left);
    right.into_iter().fold(record, Record::with)
}

fn label(step: StepId) -> Slot {
    Slot::new("LABEL", f64::from(step))
}

/// Returns the name of an update operation.
fn left_name(update: Option<Arithmetic>) -> String {
    match update {
        None => target_name(Target::None),
        Some(operation) => format!("CAL_LEFT_{}", operation_name(operation)),
    }
}

/// Returns the name of an equation with a function or an operation.
fn equal(name: &str) -> String {
    format!("EQUAL_{name}")
}

const fn operation_name(operation: Arithmetic) -> &'static str {
    match operation {
        Arithmetic::Add => "ADD",
        Arithmetic::Sub => "SUB",
        Arithmetic::Mul => "MULT",
        Arithmetic::Div => "DIV",
    }
}

const fn relation_name(relation: Relation) -> &'static str {
    match relation {
        Relation::Eq => "EQ",
        Relation::Ne => "NE",
        Relation::Gt => "GT",
        Relation::Lt => "LT",
        Relation::Ge => "GE",
        Relation::Le => "LE",
    }
}

/// A command, its target and its arguments.
#[derive(Debug)]
struct Record {
    command: String,
    target: String,
    arguments: Vec<Slot>,
}

impl Record {
    /// Creates a command without target and arguments.
    fn new(command: impl Into<String>) -> Self {
        Record {
            command: command.into(),
            target: target_name(Target::None),
            arguments: Vec::new(),
        }
    }

    fn to(self, target: String) -> Self {
        Record { target, ..self }
    }

    fn with(mut self, argument: Slot) -> Self {
        self.arguments.push(argument);
        self
    }

    /// Returns its lines, with `count` arguments.
    fn text(&self, number: usize, count: usize) -> String {
        let arguments = || {
            let empty = std::iter::repeat(&Slot::NONE);
            (1..=count).zip(self.arguments.iter().chain(empty))
        };
        let mut out = format!("[{number}Line]\n");
        // Writing to a string cannot fail.
        let _ = writeln!(out, "Cmd      = {}", self.command);
        let _ = writeln!(out, "Target   = {}", self.target);
        for (place, slot) in arguments() {
            let _ = writeln!(out, "ArgType {place} = {}", slot.kind);
        }
        for (place, slot) in arguments() {
            let _ = writeln!(out, "ArgValue{place} = {:.6}", slot.value);
        }
        out
    }
}

/// The type and the value of an argument.
#[derive(Clone, Debug, PartialEq)]
struct Slot {
    kind: Cow<'static, str>,
    value: f64,
}

impl Slot {
    /// No argument.
    const NONE: Slot = Slot {
        kind: Cow::Borrowed("ARG_NONE"),
        value: 0.0,
    };

    fn new(kind: impl Into<Cow<'static, str>>, value: f64) -> Self {
        Slot {
            kind: kind.into(),
            value,
        }
    }

    fn constant(value: f64) -> Self {
        Slot::new("CONSTANT", value)
    }

    /// Adds a mark. Only `R` is shown.
    fn marked(self, mark: Mark) -> Self {
        match mark {
            Mark::None | Mark::Absolute => self,
            Mark::Relative => Slot::new(format!("REL_{}", self.kind), self.value),
        }
    }
}

/// The index of each variable among those of its type.
struct Variables<'a> {
    program: &'a Program,
    places: Vec<u32>,
}

impl<'a> Variables<'a> {
    fn new(program: &'a Program) -> Self {
        let mut counts = [0; 3];
        let places = program.variables().iter().map(|variable| {
            if let Some(number) = variable.special {
                return u32::from(number);
            }
            let count = &mut counts[variable.kind as usize];
            let place = *count;
            *count += 1;
            place
        });
        Variables {
            places: places.collect(),
            program,
        }
    }

    /// Returns a struct as a whole; of a VAR, the VAR.
    fn whole(&self, variable: VariableId) -> Slot {
        let Variable { kind, special, .. } = &self.program.variables()[variable];
        let kind = match (kind, special) {
            (VariableKind::Var, None) => "VAR",
            (VariableKind::Pos, None) => "POS",
            (VariableKind::Joint, None) => "JNT",
            (VariableKind::Var, Some(_)) => "VAR_SPECIAL",
            (VariableKind::Pos, Some(_)) => "POS_SPECIAL",
            (VariableKind::Joint, Some(_)) => "JNT_SPECIAL",
        };
        Slot::new(kind, f64::from(self.places[variable]))
    }

    /// Returns a VAR or member, perhaps with a minus before it.
    fn scalar(&self, scalar: Scalar, negative: bool) -> Slot {
        let Slot { kind, value } = self.whole(scalar.variable);
        let sign = if negative { "MINUS_" } else { "" };
        let member = match self.program.variables()[scalar.variable].kind {
            VariableKind::Var => String::new(),
            VariableKind::Pos => format!("_{}", POSITION[scalar.member]),
            VariableKind::Joint => format!("_{}", scalar.member + 1),
        };
        Slot::new(format!("{sign}{kind}{member}"), value)
    }

    fn operand(&self, operand: Operand) -> Slot {
        match operand {
            Operand::Constant(value) => Slot::constant(value),
            Operand::Scalar { scalar, negative } => self.scalar(scalar, negative),
            Operand::Reading {
                reading,
                member,
                negative,
            } => {
                let sign = if negative { "MINUS_" } else { "" };
                let member = match reading {
                    Reading::Measured(Teach::Position | Teach::Force, _) => {
                        format!("_{}", POSITION[member])
                    }
                    Reading::Measured(_, Target::Foot(_)) => format!("_{}", member + 1),
                    Reading::Measured(..) | Reading::Timer(_) => String::new(),
                };
                Slot::new(format!("{sign}{}{member}", bare(reading)), 0.0)
            }
        }
    }

    /// Returns a struct, or a special variable, as a whole.
    fn structure(&self, whole: StructOperand) -> Slot {
        match whole {
            StructOperand::Variable(variable) => self.whole(variable),
            StructOperand::Reading(reading) => Slot::new(bare(reading), 0.0),
        }
    }

    /// Returns the struct that an operand is a member of.
    fn whole_of(&self, operand: Operand) -> Option<Slot> {
        match operand {
            Operand::Constant(_) => None,
            Operand::Scalar { scalar, .. } => Some(self.whole(scalar.variable)),
            Operand::Reading { reading, .. } => Some(Slot::new(bare(reading), 0.0)),
        }
    }

    /// Returns the struct that was written as `word` in the place of these arguments.
    fn written_whole(&self, arguments: &[Argument], word: &str) -> Option<Slot> {
        let first = arguments.first()?;
        let scalar = match first.operand {
            Operand::Scalar { scalar, .. } => scalar,
            Operand::Reading { reading, .. } => {
                let is_struct = matches!(reading, Reading::Measured(_, Target::Foot(_)));
                let slot = Slot::new(bare(reading), 0.0).marked(first.mark);
                return (is_struct && reading.to_string() == word).then_some(slot);
            }
            _ => return None,
        };
        let variable = &self.program.variables()[scalar.variable];
        let is_struct = variable.kind != VariableKind::Var && variable.name == word;
        is_struct.then(|| self.whole(scalar.variable).marked(first.mark))
    }
}

/// Returns the word of a special variable without its `@`.
fn bare(reading: Reading) -> String {
    reading.to_string().split_off(READING.len_utf8())
}

fn target_name(target: Target) -> String {
    match target {
        Target::None => "NO_TARGET".to_owned(),
        target => format!("TARGET_{target}"),
    }
}
