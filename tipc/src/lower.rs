//! The only maker of [`Program`]: decides what a statement does.

use crate::check::{
    Arguments, Assignment, Counting, DeclaredLabel, Receiver, Resolved, ResolvedModule, StatementId,
};
use crate::language::reserved::POSITION;
use crate::program::{
    Action, Argument, End, Label, LabelKind, Mark, Op, Operand, Program, Reading, Step, StepId,
    StructOperand, Target, Teach, Thread, Variable,
};
use crate::robot::Robot;
use crate::source::Source;
use crate::syntax::Module;

/// Lowers a module in which nothing was found wrong.
pub(crate) fn lower(
    source: &Source,
    module: &Module,
    resolved: ResolvedModule<'_>,
    robot: Robot,
) -> Program {
    let ResolvedModule {
        variables,
        constants,
        labels,
        statements,
    } = resolved;
    let constants = constants.into_iter();
    let constants = constants.filter_map(|constant| Some((constant.name, constant.value?)));
    let is_thread = |label: &&DeclaredLabel<'_>| label.kind == LabelKind::Thread;
    let threads: Vec<_> = labels.iter().filter(is_thread).copied().collect();
    let lowering = Lowering {
        module,
        variables: &variables,
        threads: threads.iter().map(|label| label.statement).collect(),
        joints: usize::from(robot.signature().joints),
    };
    let mut steps = Vec::with_capacity(statements.len());
    for (statement, resolved) in module.statements.iter().zip(statements) {
        if let Some(action) = lowering.action(resolved) {
            steps.push(Step {
                action,
                line: statement.line,
                column: source.column(statement.span.start),
                text: source.slice(statement.span).into(),
            });
        }
    }
    let labels = labels.iter().map(|label| Label {
        name: label.name.node.to_string(),
        step: lowering.step(label.statement),
        kind: label.kind,
    });
    let labels = labels.collect();
    let threads = threads.iter().filter_map(|label| {
        let first = lowering.step(label.statement);
        let ends = |step: &Step| step.action == Action::ThreadEnd;
        let length = steps[first as usize..].iter().position(ends)?;
        Some(Thread {
            name: label.name.node.to_string(),
            first,
            last: first + length as StepId,
        })
    });
    let threads = threads.collect();
    Program {
        source_name: base_name(source.name()).to_owned(),
        source_hash: source.hash(),
        edition: module.edition,
        title: module.title.clone(),
        signature: robot.signature(),
        variables,
        constants: constants.collect(),
        labels,
        threads,
        steps,
    }
}

fn base_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

struct Lowering<'a> {
    module: &'a Module,
    variables: &'a [Variable],
    /// The statements of THREAD.
    threads: Vec<StatementId>,
    /// Number of joints of a leg.
    joints: usize,
}

impl Lowering<'_> {
    /// Returns the action of a statement; `None` for a declaration, which is not a step.
    fn action(&self, resolved: Resolved) -> Option<Action> {
        Some(match resolved {
            Resolved::Define => return None,
            Resolved::Label
            | Resolved::EndIf
            | Resolved::Repeat
            | Resolved::Subroutine
            | Resolved::Thread
            | Resolved::Rem => Action::Nothing,
            Resolved::ThreadEnd => Action::ThreadEnd,
            Resolved::StartThread(thread) => Action::StartThread {
                thread: self.thread(thread),
            },
            Resolved::StopThread(thread) => Action::StopThread {
                thread: self.thread(thread),
            },
            Resolved::WaitThread(thread) => Action::WaitThread {
                thread: self.thread(thread),
            },
            Resolved::Equation(assignment) => equation(assignment),
            Resolved::If(condition, next) => Action::If {
                condition,
                otherwise: self.step(next),
            },
            Resolved::ElseIf(condition, next) => Action::ElseIf {
                condition,
                otherwise: self.step(next),
            },
            Resolved::Else(end) => Action::Else {
                end: self.step(end),
            },
            Resolved::While(condition, wend) => Action::While {
                condition,
                exit: self.step(wend) + 1,
            },
            Resolved::Until(condition, repeat) => Action::Until {
                condition,
                back: self.step(repeat),
            },
            Resolved::For(counting, next) => Action::For {
                variable: counting.variable,
                from: counting.from,
                to: counting.to,
                step: increment(counting),
                exit: self.step(next) + 1,
            },
            Resolved::Next(counting, opener) => Action::Next {
                variable: counting.variable,
                to: counting.to,
                step: increment(counting),
                body: self.step(opener) + 1,
            },
            Resolved::IfGoto(condition, to) => Action::IfGoto {
                condition,
                to: self.step(to),
            },
            Resolved::IfGosub(condition, to) => Action::IfGosub {
                condition,
                to: self.step(to),
            },
            Resolved::Wend(to) | Resolved::Goto(to) => Action::Goto { to: self.step(to) },
            Resolved::Call(to) | Resolved::Gosub(to) => Action::Gosub { to: self.step(to) },
            Resolved::SubEnd | Resolved::Return => Action::Return,
            Resolved::End => Action::Finish(End::End),
            Resolved::Exit => Action::Finish(End::Exit),
            Resolved::Message(parts) => Action::Message { parts },
            Resolved::FileMessage(parts) => Action::FileMessage { parts },
            Resolved::MessageClear => Action::Message { parts: Vec::new() },
            Resolved::Command {
                op,
                hs,
                target,
                arguments,
            } => Action::Command {
                op,
                hs,
                target,
                arguments: self.arguments(arguments),
            },
            Resolved::Special(number, values) => special(number, values),
            Resolved::Teach(what, target, Receiver::Scalar(into)) => {
                Action::TeachScalar { what, target, into }
            }
            Resolved::Teach(what, target, Receiver::Struct(into)) => {
                Action::TeachStruct { what, target, into }
            }
            Resolved::AdIn(port, into) => Action::AdIn { port, into },
            Resolved::KeyIn(into) => Action::KeyIn { into },
        })
    }

    fn arguments(&self, arguments: Arguments) -> Vec<Argument> {
        match arguments {
            Arguments::Each(arguments) => arguments,
            Arguments::Whole { operand, mark } => self.members(operand, mark).collect(),
            Arguments::Two(both) => both
                .into_iter()
                .flat_map(|operand| self.members(operand, Mark::None))
                .collect(),
        }
    }

    /// Returns the members of a struct as arguments.
    fn members(&self, operand: StructOperand, mark: Mark) -> impl Iterator<Item = Argument> {
        let size = match operand {
            StructOperand::Variable(variable) => self.variables[variable].size(),
            StructOperand::Reading(reading) => self.size(reading),
        };
        (0..size).map(move |member| Argument {
            operand: operand.member(member),
            mark,
        })
    }

    /// Returns the number of members of a special variable.
    fn size(&self, reading: Reading) -> usize {
        match reading {
            Reading::Measured(Teach::Position | Teach::Force, _) => POSITION.len(),
            Reading::Measured(Teach::Angle | Teach::Torque, _) | Reading::Timer(_) => self.joints,
        }
    }

    /// Returns the index of the thread that a statement opens.
    fn thread(&self, statement: StatementId) -> usize {
        self.threads.partition_point(|first| *first < statement)
    }

    fn step(&self, statement: StatementId) -> StepId {
        self.module.statements[statement].step
    }
}

fn equation(assignment: Assignment) -> Action {
    match assignment {
        Assignment::Scalar {
            target,
            update,
            value,
        } => Action::SetScalar {
            target,
            update,
            value,
        },
        Assignment::Struct {
            target,
            update,
            value,
        } => Action::SetStruct {
            target,
            update,
            value,
        },
    }
}

/// Returns the increment of a FOR: 1 if it names no other number.
fn increment(counting: Counting) -> Operand {
    counting.step.unwrap_or(Operand::Constant(1.0))
}

/// Puts the number of the native command before its values.
fn special(number: f64, values: Vec<Operand>) -> Action {
    let operands = std::iter::once(Operand::Constant(number)).chain(values);
    let argument = |operand| Argument {
        operand,
        mark: Mark::None,
    };
    Action::Command {
        op: Op::Special,
        hs: false,
        target: Target::None,
        arguments: operands.map(argument).collect(),
    }
}
