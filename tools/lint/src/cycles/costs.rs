//! Costs of single steps.

use super::Sampling;
use super::count::Count;
use tipc::language::commands;
use tipc::program::{Action, Op, Operand, Program};

/// Returns the cost of a single step: one cycle, or the least of a step that waits.
pub(super) fn cost(action: &Action, longest_sampling: f64) -> Count {
    let least = match action {
        Action::KeyIn { .. } | Action::WaitThread { .. } => 1,
        Action::Command { op, arguments, .. } if commands::waits(*op) => {
            match (op, arguments.first().map(|argument| argument.operand)) {
                (Op::Sleep, Some(Operand::Constant(ms))) => slept(ms, longest_sampling),
                _ => 1,
            }
        }
        Action::Command { .. }
        | Action::Nothing
        | Action::SetScalar { .. }
        | Action::SetStruct { .. }
        | Action::If { .. }
        | Action::ElseIf { .. }
        | Action::Else { .. }
        | Action::While { .. }
        | Action::Goto { .. }
        | Action::Until { .. }
        | Action::For { .. }
        | Action::Next { .. }
        | Action::IfGoto { .. }
        | Action::Gosub { .. }
        | Action::IfGosub { .. }
        | Action::Return
        | Action::Finish(_)
        | Action::TeachStruct { .. }
        | Action::TeachScalar { .. }
        | Action::AdIn { .. }
        | Action::StartThread { .. }
        | Action::StopThread { .. }
        | Action::ThreadEnd
        | Action::FileMessage { .. }
        | Action::Message { .. } => return Count::exactly(1),
    };
    Count {
        waits: true,
        ..Count::exactly(least)
    }
}

/// Returns the cycles of SLEEP (clause 2.19).
fn slept(ms: f64, sampling: f64) -> u64 {
    // Out of range saturates; a negative time fails when it runs.
    ((ms / sampling - 1e-9).ceil() as u64).max(1)
}

/// Returns the longest sampling time that may be in force.
pub(super) fn longest_sampling(program: &Program, sampling: Sampling) -> f64 {
    let set = program
        .steps()
        .iter()
        .filter_map(|step| match &step.action {
            Action::Command {
                op: op @ (Op::SetSamplingTime | Op::SetSamplingFreq),
                arguments,
                ..
            } => Some((*op, arguments.first()?.operand)),
            _ => None,
        });
    let times = set.map(|(op, operand)| match (op, operand) {
        (Op::SetSamplingTime, Operand::Constant(ms)) => ms,
        (Op::SetSamplingFreq, Operand::Constant(hz)) if hz > 0.0 => 1000.0 / hz,
        _ => sampling.longest,
    });
    times
        .fold(sampling.standard, f64::max)
        .min(sampling.longest)
}
