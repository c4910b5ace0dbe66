//! Numbers of control cycles that parts of a program take (T.I.P. 3.1 §10-3: one command a cycle).
//!
//! The counts are exact over all paths of the control flow: the minimum is the shortest path, the maximum the longest
//! one, and there is none where a path can loop. A call counts with what its subroutine takes, a FOR over constants
//! with its turns. A step that waits counts as its minimum, and marks its part. A subroutine that calls itself has no
//! bound here, although ten open calls are one. Where the same steps belong to very many parts, counting ends early,
//! and says so. A part counts in steps of its own thread: that is in cycles if a cycle runs one step.

mod counted;
mod graph;
mod loops;
mod render;
mod search;

#[cfg(test)]
mod tests;

pub use render::{human, json, short};

use graph::Graph;
use search::{Place, Work};
use std::collections::BTreeSet;
use tipc::Robot;
use tipc::analysis::flow::{Flow, NodeId};
use tipc::program::{Action, Op, Program, StepId};

/// A part of a program, and how many cycles it takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Kind of part.
    pub span: Span,
    /// Number of cycles it takes.
    pub cycles: Count,
}

impl Part {
    /// Returns the step that names the part: the FOR for a turn of a FOR, which begins at the first step of its body.
    pub fn first_step(&self, program: &Program) -> StepId {
        match self.span {
            Span::Subroutine { entry } => entry,
            Span::Turn { head, .. } => {
                let before = head.saturating_sub(1);
                let is_for = matches!(program.steps()[before as usize].action, Action::For { .. });
                if is_for { before } else { head }
            }
            Span::Stretch { from, .. } => from,
        }
    }
}

/// A part of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Span {
    /// The steps from the target of a GOSUB or CALL up to and including its RETURN or SUBEND.
    Subroutine {
        /// The first step.
        entry: StepId,
    },
    /// One turn of a loop, from a step that a jump leads back to until that step is reached again.
    Turn {
        /// First step; for a FOR, the first one of its body.
        head: StepId,
        /// The steps that a turn can pass.
        steps: BTreeSet<StepId>,
        /// Number of turns of a FOR over constants.
        turns: Option<u64>,
    },
    /// The steps from a label, or the beginning, to the next label or the end, including calls.
    Stretch {
        /// The label's step, or 0.
        from: StepId,
        /// End of the stretch.
        to: Stop,
    },
}

/// End of a stretch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stop {
    /// Before the step of a label.
    Label(StepId),
    /// With RETURN or SUBEND.
    Return,
    /// END or EXIT.
    End,
    /// THREADEND.
    ThreadEnd,
}

/// Number of cycles that a part of a program takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// The minimum.
    pub min: u64,
    /// The maximum without waits; `None` if there is no bound.
    pub max: Option<u64>,
    /// True if a path through the part waits, and may take longer.
    pub waits: bool,
}

impl Count {
    const fn exactly(cycles: u64) -> Self {
        Count {
            min: cycles,
            max: Some(cycles),
            waits: false,
        }
    }

    /// Returns the number for this part followed by another one.
    fn then(self, other: Count) -> Count {
        Count {
            min: self.min.saturating_add(other.min),
            max: self.max.zip(other.max).map(|(a, b)| a.saturating_add(b)),
            waits: self.waits || other.waits,
        }
    }

    fn times(self, turns: u64) -> Count {
        Count {
            min: self.min.saturating_mul(turns),
            max: self.max.map(|max| max.saturating_mul(turns)),
            waits: self.waits,
        }
    }

    /// Returns the number for 0 to `turns` turns.
    fn at_most(self, turns: u64) -> Count {
        match turns {
            0 => Count::exactly(0),
            _ => Count {
                min: 0,
                ..self.times(turns)
            },
        }
    }

    fn unbounded(self) -> Count {
        Count { max: None, ..self }
    }
}

/// The sampling times of a run: ms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// The robot's standard one, in force until the program sets another.
    pub standard: f64,
    /// The longest one that the robot accepts.
    pub longest: f64,
}

impl Sampling {
    /// Returns the figures of a robot.
    pub fn of(robot: Robot) -> Self {
        let facts = robot.facts();
        Sampling {
            standard: facts.period,
            longest: facts.periods.max,
        }
    }
}

/// Returns the line of the first step that sets a sampling time.
pub fn sampling_set(program: &Program) -> Option<u32> {
    line_with(program, |op| {
        matches!(op, Op::SetSamplingTime | Op::SetSamplingFreq)
    })
}

/// Returns the line of the first command of a kind.
fn line_with(program: &Program, is_it: impl Fn(Op) -> bool) -> Option<u32> {
    let mut steps = program.steps().iter();
    let found = steps.find(|step| match step.action {
        Action::Command { op, .. } => is_it(op),
        _ => false,
    });
    found.map(|step| step.line)
}

/// The parts of a program that could be counted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Parts {
    /// Subroutines, then turns of loops, then stretches, each in the order of steps.
    pub counted: Vec<Part>,
    /// True if further parts were not counted because they have too many paths.
    pub has_more: bool,
}

/// Counts the parts of a program.
pub fn parts(program: &Program, sampling: Sampling) -> Parts {
    let flow = Flow::of(program);
    let Some(graph) = Graph::new(program, &flow, sampling) else {
        return Parts {
            has_more: true,
            ..Parts::default()
        };
    };
    let mut counted = subroutines(&flow, &graph);
    let (turns, are_all_turns) = loops::turns(&flow, &graph);
    let (stretches, are_all_stretches) = stretches(program, &flow, &graph);
    counted.extend(turns);
    counted.extend(stretches);
    Parts {
        counted,
        has_more: !(are_all_turns && are_all_stretches),
    }
}

fn subroutines(flow: &Flow, graph: &Graph) -> Vec<Part> {
    let returning = graph.routines().filter_map(|(entry, cycles)| {
        Some(Part {
            span: Span::Subroutine {
                entry: flow.nodes()[entry].step,
            },
            cycles: cycles?,
        })
    });
    returning.collect()
}

/// Returns the stretches, and true if none is left out.
fn stretches(program: &Program, flow: &Flow, graph: &Graph) -> (Vec<Part>, bool) {
    let work = Work::of(flow.nodes().len());
    let labels: BTreeSet<NodeId> = program
        .labels()
        .iter()
        .map(|label| flow.first(label.step))
        .collect();
    let mut begins = labels.clone();
    begins.insert(0);
    let mut parts = Vec::new();
    for from in begins {
        let Some(found) = graph.stretches(from, &labels, &work) else {
            return (parts, false);
        };
        for (place, cycles) in found {
            let to = match place {
                Place::Stop(id) => Stop::Label(flow.nodes()[id].step),
                Place::Return => Stop::Return,
                Place::End => Stop::End,
                Place::ThreadEnd => Stop::ThreadEnd,
                Place::Pass(_) => continue,
            };
            let from = flow.nodes()[from].step;
            parts.push(Part {
                span: Span::Stretch { from, to },
                cycles,
            });
        }
    }
    (parts, true)
}
