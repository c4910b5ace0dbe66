//! Commands that another thread certainly overrides in the same cycle.
//!
//! The turns of a program are followed from its start for as long as constants tell what each of them does. At the first
//! open condition and the first command that waits for the robot, for a key or for native code nothing is certain any
//! more, and the rest of the program stays silent. So does a command that counts from the one before it.

use super::LintContext;
use crate::message::Linting;
use std::collections::BTreeSet;
use tip_runtime::command::Target;
use tip_runtime::program::CallStack;
use tipc::analysis::flow::NodeId;
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::language::commands::{self, Moves};
use tipc::program::{Action, Argument, Mark, Op, Operand, StepId};

/// The most cycles that are followed.
const CYCLES: u32 = 1000;

pub(super) fn warn(context: &LintContext<'_>, found: &mut Diagnostics) {
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
    /// What runs next.
    node: NodeId,
    calls: Vec<NodeId>,
    /// The cycles of SLEEP that are left.
    sleeps: Option<u64>,
}

/// What follows a step of a turn.
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
        if !op.name().starts_with("REL_") && !arguments.iter().any(is_relative) {
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
        let row = commands::COMMANDS
            .iter()
            .find(|row| row.name == op.name())?;
        // NO_COMPLIANCE changes only joints that are compliant.
        if row.moves != Moves::Target || op == Op::NoCompliance {
            return None;
        }
        // The position of a joint is a matter of those before it.
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
