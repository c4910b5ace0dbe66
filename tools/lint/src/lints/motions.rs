//! Lints about motions: commands that another thread overrides, and waits for targets that nothing moves.

use super::LintContext;
use super::flow::{Unreachable, condition};
use crate::message::Linting;
use std::collections::BTreeSet;
use tip_runtime::program::CallStack;
use tipc::analysis::flow::NodeId;
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::language::commands::{self, Moves};
use tipc::program::{Action, Argument, Condition, Flag, Mark, Op, Operand, Step, StepId, Target};
use tipc::source::Span;
use tipc::syntax::{Statement, StatementKind};

/// Maximum number of cycles that are followed.
const CYCLES: u32 = 1000;

/// Warns of commands that another thread certainly overrides in the same cycle.
///
/// The turns of a program are followed from its start as long as constants decide what each of them does. They are
/// followed no further than the first condition that constants do not decide, and the first command that waits for the
/// robot, a key or native code. A command relative to the one before it is not reported.
pub(super) fn overridden(context: &LintContext<'_>, found: &mut Diagnostics) {
    if context.program.threads().is_empty() {
        return;
    }
    let mut turns = Turns::new(context);
    for _ in 0..CYCLES {
        if turns.cycle().is_none() {
            break;
        }
    }
    for (lost, stands) in turns.overridden {
        if let (Some(lost), Some(stands)) = (context.statement(lost), context.statement(stands)) {
            let warning = Diagnostic::new(Code::Overridden, lost.span, Linting::OtherThread);
            let warning = warning.label(stands.span, Linting::ThisStands);
            found.push(warning.help(Linting::OneCommands));
        }
    }
}

/// The main program or a thread.
#[derive(Clone, Default)]
struct Part {
    /// The step that runs next.
    node: NodeId,
    calls: Vec<NodeId>,
    /// The cycles of SLEEP that are left.
    sleeps: Option<u64>,
}

/// The state of a turn after one of its steps.
enum Turn {
    GoesOn,
    Ends,
}

/// A command of the present cycle.
struct Commanded {
    part: usize,
    step: StepId,
    joints: Joints,
}

/// The turns of a program, as far as they are certain.
struct Turns<'a> {
    context: &'a LintContext<'a>,
    /// The main program, then the threads.
    parts: Vec<Part>,
    running: BTreeSet<usize>,
    stopped: BTreeSet<usize>,
    started: BTreeSet<usize>,
    /// Number of steps in a turn, and from the next cycle on.
    speed: [u8; 2],
    /// The sampling time, ms; none if it is not certain.
    period: Option<f64>,
    commanded: Vec<Commanded>,
    /// Steps that are overridden, with those that stand.
    overridden: BTreeSet<(StepId, StepId)>,
}

impl<'a> Turns<'a> {
    fn new(context: &'a LintContext<'a>) -> Self {
        let starts = context.flow.starts().iter();
        let part = |node: &NodeId| Part {
            node: *node,
            ..Part::default()
        };
        Turns {
            context,
            parts: starts.map(part).collect(),
            running: [0].into(),
            stopped: BTreeSet::new(),
            started: BTreeSet::new(),
            speed: [1; 2],
            period: Some(context.robot.facts().period),
            commanded: Vec::new(),
            overridden: BTreeSet::new(),
        }
    }

    /// Follows a cycle; `None` if something in it is not certain, or the program ends.
    fn cycle(&mut self) -> Option<()> {
        self.commanded.clear();
        for part in self.running.clone() {
            for _ in 0..self.speed[0] {
                match self.step(part)? {
                    Turn::GoesOn => {}
                    Turn::Ends => break,
                }
            }
        }
        self.speed[0] = self.speed[1];
        for part in std::mem::take(&mut self.stopped) {
            self.running.remove(&part);
        }
        for part in std::mem::take(&mut self.started) {
            self.parts[part] = Part {
                node: *self.context.flow.starts().get(part)?,
                ..Part::default()
            };
            self.running.insert(part);
        }
        Some(())
    }

    fn step(&mut self, part: usize) -> Option<Turn> {
        let node = self.context.flow.nodes().get(self.parts[part].node)?;
        let action = &self.context.program.steps()[node.step as usize].action;
        let mut ends = false;
        match action {
            Action::Finish(_) | Action::KeyIn { .. } => return None,
            Action::ThreadEnd => return self.end(part),
            Action::Return => match self.parts[part].calls.pop() {
                Some(back) => {
                    self.parts[part].node = back;
                    return Some(Turn::GoesOn);
                }
                None => return self.end(part),
            },
            Action::StartThread { thread } => {
                let thread = thread + 1;
                let goes_on = self.running.contains(&thread) && !self.stopped.contains(&thread);
                if goes_on || !self.started.insert(thread) {
                    return None;
                }
            }
            Action::StopThread { thread } => {
                let thread = thread + 1;
                self.started.remove(&thread);
                if self.running.contains(&thread) {
                    self.stopped.insert(thread);
                }
            }
            Action::WaitThread { thread } => {
                let thread = thread + 1;
                if thread == part {
                    return None;
                }
                if self.running.contains(&thread) || self.started.contains(&thread) {
                    return Some(Turn::Ends);
                }
                ends = true;
            }
            Action::Message { .. } | Action::FileMessage { .. } | Action::AdIn { .. } => {
                ends = true;
            }
            Action::Command {
                op,
                target,
                arguments,
                ..
            } => {
                if *op == Op::Sleep && self.sleeps(part, arguments)? {
                    return Some(Turn::Ends);
                }
                self.command(part, node.step, (*op, *target), arguments)?;
                ends = op.ends_turn();
            }
            _ => {}
        }
        let here = &mut self.parts[part];
        here.node = match (node.call, &node.next[..]) {
            (Some(call), []) if here.calls.len() < CallStack::DEPTH => {
                here.calls.push(call.back);
                call.entry
            }
            (None, [next]) => *next,
            _ => return None,
        };
        Some(if ends { Turn::Ends } else { Turn::GoesOn })
    }

    /// Ends a thread; the main program fails.
    fn end(&mut self, part: usize) -> Option<Turn> {
        self.running.remove(&part);
        self.stopped.remove(&part);
        (part != 0).then_some(Turn::Ends)
    }

    /// Returns true if a part still sleeps after this cycle.
    fn sleeps(&mut self, part: usize, arguments: &[Argument]) -> Option<bool> {
        let time = constant(arguments)? / self.period?;
        let cycles = (time - 1e-9).ceil().max(1.0) as u64;
        let left = self.parts[part].sleeps.unwrap_or(cycles).checked_sub(1)?;
        self.parts[part].sleeps = (left > 0).then_some(left);
        Some(left > 0)
    }

    /// Notes a command that takes one cycle.
    fn command(
        &mut self,
        part: usize,
        step: StepId,
        (op, target): (Op, Target),
        arguments: &[Argument],
    ) -> Option<()> {
        match op {
            Op::Sleep => return Some(()),
            Op::SpeedUp => self.speed[1] = constant(arguments)? as u8,
            Op::SetSamplingTime | Op::SetSamplingFreq => self.period = None,
            op if commands::waits(op) => return None,
            _ => {}
        }
        let Some(joints) = Joints::of(op, target) else {
            return Some(());
        };
        let is_relative = |argument: &Argument| argument.mark == Mark::Relative;
        if !commands::is_relative(op) && !arguments.iter().any(is_relative) {
            let others = self.commanded.iter().filter(|other| other.part != part);
            let lost = others.filter(|other| other.joints.meet(joints));
            self.overridden.extend(lost.map(|other| (other.step, step)));
        }
        self.commanded.push(Commanded { part, step, joints });
        Some(())
    }
}

/// Returns the only operand, if it is a constant.
fn constant(arguments: &[Argument]) -> Option<f64> {
    match arguments {
        [argument] => match argument.operand {
            Operand::Constant(value) => Some(value),
            _ => None,
        },
        _ => None,
    }
}

/// Joints that a command moves: some of one leg, or all of all legs.
#[derive(Clone, Copy)]
struct Joints {
    leg: Option<u8>,
    first: u8,
    last: u8,
}

impl Joints {
    fn of(op: Op, target: Target) -> Option<Self> {
        let row = commands::find(op.name())?;
        // NO_COMPLIANCE changes only joints that are compliant.
        if row.moves != Moves::Target || op == Op::NoCompliance {
            return None;
        }
        // The position of a joint depends on the joints before it.
        let of_position = matches!(
            op,
            Op::Ptp | Op::RelPtp | Op::Force | Op::CompliancePosition | Op::RelCompliancePosition
        );
        let (leg, first, last) = match target {
            Target::All => (None, 1, u8::MAX),
            Target::Foot(leg) => (Some(leg), 1, u8::MAX),
            Target::Joint(leg, joint) if of_position => (Some(leg), 1, joint.checked_sub(1)?),
            Target::Joint(leg, joint) => (Some(leg), joint, joint),
            Target::Floor | Target::None => return None,
        };
        Some(Joints { leg, first, last })
    }

    /// Returns true if they have a joint in common.
    fn meet(self, other: Joints) -> bool {
        let one_leg = self.leg.is_none() || other.leg.is_none() || self.leg == other.leg;
        one_leg && self.first <= other.last && other.first <= self.last
    }
}

/// Warns of waits for a target that nothing in the program moves, or a flag that nothing sets: they end immediately,
/// never, or with an error.
///
/// Stays silent about a wait for ALL, a condition that is not of a loop, and a program with a SPECIAL, whose native
/// code may move anything.
pub(super) fn waits(context: &LintContext<'_>, unreachable: &Unreachable, found: &mut Diagnostics) {
    let steps = context.program.steps();
    if steps.iter().any(calls_native_code) {
        return;
    }
    let mut moved = Vec::new();
    for target in steps.iter().filter_map(moves) {
        // Robots have few targets, and programs many steps, so each target is kept once.
        if !moved.contains(&target) {
            moved.push(target);
        }
    }
    for (step, content) in (0..).zip(steps) {
        let reason = waits_for_nothing(&content.action, &moved);
        if let Some(reason) = reason.filter(|_| unreachable.is_live(step))
            && let Some(statement) = context.statement(step)
        {
            let help = match reason {
                Linting::NobodySets => Linting::CallSpecial,
                _ => Linting::WaitForMoved,
            };
            let diagnostic = Diagnostic::new(Code::WaitsForNothing, location(statement), reason);
            found.push(diagnostic.help(help));
        }
    }
}

fn calls_native_code(step: &Step) -> bool {
    matches!(
        step.action,
        Action::Command {
            op: Op::Special,
            ..
        }
    )
}

/// Returns the target that a step brings under control, if it moves anything.
fn moves(step: &Step) -> Option<Target> {
    let Action::Command { op, target, .. } = step.action else {
        return None;
    };
    match commands::find(op.name())?.moves {
        Moves::Nothing => None,
        Moves::Target => Some(target),
        Moves::Robot => Some(Target::All),
    }
}

fn waits_for_nothing(action: &Action, moved: &[Target]) -> Option<Linting> {
    let is_one = |target: Target| !matches!(target, Target::All | Target::None);
    // A program in which nothing moves at all is unfinished.
    let others_move =
        |target: Target| !moved.is_empty() && !moved.iter().any(|moved| meets(*moved, target));
    let rests = |target: Target| is_one(target) && others_move(target);
    match *action {
        Action::Command {
            op: Op::WaitInpos,
            target,
            ..
        } if rests(target) => Some(Linting::PassesAtOnce { target }),
        Action::Command {
            op: Op::WaitNear,
            target,
            ..
        } if rests(target) => Some(Linting::NeverControlled { target }),
        Action::While {
            condition: Condition::Flag { flag, .. },
            ..
        }
        | Action::Until {
            condition: Condition::Flag { flag, .. },
            ..
        } => match flag {
            Flag::Inpos(target) if rests(target) => Some(Linting::InposOfNothing { target }),
            Flag::Near(target) if rests(target) => Some(Linting::NearOfNothing { target }),
            Flag::Special(_) => Some(Linting::NobodySets),
            _ => None,
        },
        _ => None,
    }
}

/// Returns true if two targets have a joint in common.
fn meets(one: Target, other: Target) -> bool {
    match (one, other) {
        (Target::All, _) | (_, Target::All) => true,
        (Target::Foot(leg), Target::Joint(of, _)) | (Target::Joint(of, _), Target::Foot(leg)) => {
            leg == of
        }
        (one, other) => one == other,
    }
}

/// Returns the target of a command, or the flag.
fn location(statement: &Statement) -> Span {
    match &statement.kind {
        StatementKind::Command { arguments, .. } => {
            let target = arguments.first();
            target.map_or(statement.span, |target| target.span)
        }
        _ => condition(statement),
    }
}
