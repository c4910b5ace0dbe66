//! Movements of a debugger, and its reasons to stop or to refuse a request.

use super::Debugger;
use super::History;
use crate::event;
use crate::message::Debugging;
use crate::motion::Fall;
use std::fmt;
use std::str::FromStr;
use tip_runtime::fault::Fault;
use tip_runtime::machine::Emergency;
use tip_runtime::program::{End, VariableError};
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;

/// A position, and why the debugger stopped there.
#[derive(Clone, Debug, PartialEq)]
pub struct Stop {
    /// The reason.
    pub reason: Reason,
    /// The cycle that comes next.
    pub at: u64,
    /// The thread that the reason is about; 0 for the main program.
    pub thread: u8,
}

/// The reason why a debugger stopped.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// The beginning of the run is reached.
    Start,
    /// The requested steps are done.
    Step,
    /// The requested line or cycle is reached.
    There,
    /// The breakpoint of this number is reached.
    Breakpoint(u32),
    /// A variable is assigned. Forwards, it has just been; backwards, it is about to be.
    Watch {
        /// The watch of this number.
        id: u32,
        /// The source of the assignment.
        by: By,
    },
    /// The robot fell. Forwards, in the cycle before; backwards, in the cycle that comes next.
    Fall(Fall),
    /// Emergency stop.
    Fault(Emergency),
    /// The program is over.
    Ended(End),
    /// The movement was interrupted.
    Interrupted,
    /// The user made a change.
    Change,
}

/// The source of an assignment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// A step of the program.
    Step(u32),
    /// An event.
    Event,
}

/// Progress of a movement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Cycles that are done or searched.
    pub done: u64,
    /// Number of all cycles; `None` if it is not known.
    pub of: Option<u64>,
}

/// A movement through a run. It stops at breakpoints, watches and falls on its path, except for movements by a cycle or
/// to a cycle, and [`SetBack`](Move::SetBack).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Move {
    /// Goes forward one control cycle.
    Cycle,
    /// Steps to the next step, into routines.
    Step,
    /// Steps to the next step, over the routines of GOSUB and CALL.
    Over,
    /// Goes on to the step after the call of the present routine.
    Out,
    /// Goes on until something stops it.
    Continue,
    /// Goes on to a step of a line.
    Line(u32),
    /// Goes to a cycle, known or not.
    To(u64),
    /// Goes back one control cycle.
    CycleBack,
    /// Goes back to the beginning of this step or, from there, of the one before, into routines.
    StepBack,
    /// Goes back as [`StepBack`](Move::StepBack) does, but over the routines of GOSUB and CALL.
    OverBack,
    /// Goes back to the call of the present routine.
    OutBack,
    /// Goes back until something stops it.
    ReverseContinue,
    /// Goes back to a step of a line.
    LineBack(u32),
    /// Goes back to the last assignment to the variable of the watch of this number, past everything else.
    SetBack(u32),
}

impl Move {
    /// Returns true if it goes back.
    pub fn is_back(self) -> bool {
        match self {
            Move::Cycle
            | Move::Step
            | Move::Over
            | Move::Out
            | Move::Continue
            | Move::Line(_)
            | Move::To(_) => false,
            Move::CycleBack
            | Move::StepBack
            | Move::OverBack
            | Move::OutBack
            | Move::ReverseContinue
            | Move::LineBack(_)
            | Move::SetBack(_) => true,
        }
    }
}

/// The end of a movement.
#[derive(Clone, Copy, Debug)]
pub(super) enum Goal {
    /// This position.
    At(u64),
    /// Another step.
    Step,
    /// Another step with no more calls open.
    Over,
    /// Fewer calls open.
    Out,
    /// A step of this line.
    Line(u32),
    /// An assignment that this watch is on.
    Set(u32),
    /// None: only other reasons stop the movement.
    Nowhere,
}

/// The beginning of a movement.
#[derive(Clone, Copy, Debug)]
pub(super) struct Origin {
    pub(super) at: u64,
    pub(super) thread: u8,
    pub(super) depth: u8,
}

impl Goal {
    pub(super) fn of(movement: Move, now: u64) -> Self {
        match movement {
            Move::Cycle => Goal::At(now + 1),
            Move::CycleBack => Goal::At(now.saturating_sub(1)),
            Move::To(cycle) => Goal::At(cycle),
            Move::Step | Move::StepBack => Goal::Step,
            Move::Over | Move::OverBack => Goal::Over,
            Move::Out | Move::OutBack => Goal::Out,
            Move::Line(line) | Move::LineBack(line) => Goal::Line(line),
            Move::SetBack(watch) => Goal::Set(watch),
            Move::Continue | Move::ReverseContinue => Goal::Nowhere,
        }
    }

    /// Returns the reason of a stop at the goal.
    pub(super) fn reason(self) -> Reason {
        match self {
            Goal::Step | Goal::Over | Goal::Out => Reason::Step,
            Goal::At(_) | Goal::Line(_) | Goal::Set(_) | Goal::Nowhere => Reason::There,
        }
    }

    /// Returns true if breakpoints, watches and falls stop the movement to it.
    pub(super) fn stops_early(self) -> bool {
        !matches!(self, Goal::At(_) | Goal::Set(_))
    }

    /// Returns true if a run has reached the goal in a forward movement from an origin.
    pub(super) fn is_reached(self, from: &Origin, debugger: &Debugger) -> bool {
        let (history, now) = (&debugger.history, debugger.now());
        let Some(first) = history.first(now, from.thread) else {
            // The thread is over.
            return matches!(self, Goal::Step | Goal::Over | Goal::Out);
        };
        let (depth, enters) = (first.depth, history.enters(now, from.thread));
        match self {
            Goal::At(at) => now == at,
            Goal::Step => enters || depth != from.depth,
            Goal::Over => depth < from.depth || (depth == from.depth && enters),
            Goal::Out => depth < from.depth,
            Goal::Line(line) => debugger.begins_at(now, line),
            Goal::Set(_) | Goal::Nowhere => false,
        }
    }

    /// Returns true if a position before an origin meets the goal.
    pub(super) fn is_met(
        self,
        from: &Origin,
        at: u64,
        history: &History,
        debugger: &Debugger,
    ) -> bool {
        let depth = history.first(at, from.thread).map(|first| first.depth);
        let enters = || history.enters(at, from.thread);
        match self {
            Goal::At(goal) => at == goal,
            Goal::Step => enters(),
            Goal::Over => depth.is_some_and(|depth| depth <= from.depth) && enters(),
            Goal::Out => depth.is_some_and(|depth| depth < from.depth),
            Goal::Line(line) => debugger.begins_at(at, line),
            Goal::Set(_) | Goal::Nowhere => false,
        }
    }
}

/// The passes of a breakpoint that stop a run, counted from its start. As text: `5` or `== 5`, `>
/// 5`, `>= 5`, `% 5`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hits {
    /// This pass alone.
    Only(u64),
    /// This pass and all after it.
    From(u64),
    /// Every pass whose number is a multiple of this.
    Each(u64),
}

impl Hits {
    /// Returns true if pass `n`, counted from 1, stops a run.
    pub fn has(self, n: u64) -> bool {
        match self {
            Hits::Only(only) => n == only,
            Hits::From(first) => n >= first,
            Hits::Each(each) => n.is_multiple_of(each),
        }
    }
}

/// A text that is not a choice of passes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HitsError(pub(super) String);

impl HitsError {
    pub(super) fn message(&self) -> Debugging {
        Debugging::NoCountOfHits {
            text: self.0.clone().into(),
        }
    }
}

impl fmt::Display for HitsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().fmt(f)
    }
}

impl std::error::Error for HitsError {}

impl FromStr for Hits {
    type Err = HitsError;

    fn from_str(text: &str) -> Result<Self, HitsError> {
        let text = text.trim();
        let digits = text.find(|char: char| char.is_ascii_digit());
        let (sign, number) = text.split_at(digits.unwrap_or(text.len()));
        let hits = number.parse().ok().and_then(|n: u64| match sign.trim() {
            "" | "=" | "==" => Some(Hits::Only(n)),
            ">=" => Some(Hits::From(n)),
            ">" => Some(Hits::From(n.saturating_add(1))),
            "%" if n > 0 => Some(Hits::Each(n)),
            _ => None,
        });
        hits.ok_or_else(|| HitsError(text.to_owned()))
    }
}

/// The reason why a request is refused.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum DebugError {
    /// No step is on this line, and none after it.
    NoStep(u32),
    /// No routine, label or command has this name.
    NoName(String),
    /// The program has no such variable, or it is a constant.
    NoVariable(String, VariableError),
    /// The text is not a condition or number of the program.
    Wrong(Box<Diagnostic>),
    /// It cannot be calculated, or reads an unassigned variable.
    Fault(Fault),
    /// The text is not a choice of passes.
    Hits(HitsError),
    /// The change would discard this number of cycles after the position.
    WouldDiscard(u64),
    /// The program is over.
    Ended,
    /// It cannot happen to this robot or program.
    Event(event::Refused),
}

impl DebugError {
    /// Returns the message in a language. A fault has its classical text in each.
    pub fn text(&self, lang: Lang) -> String {
        let message = match self {
            DebugError::Wrong(diagnostic) => return diagnostic.headline(lang),
            DebugError::Fault(fault) => return fault.to_string(),
            DebugError::Event(refused) => return refused.text(lang),
            DebugError::NoStep(line) => Debugging::NoStepFrom { line: *line },
            DebugError::NoName(name) => Debugging::NoSuchName {
                name: name.clone().into(),
            },
            DebugError::NoVariable(name, error) => {
                return event::refused_variable(name, *error, lang);
            }
            DebugError::Hits(error) => error.message(),
            DebugError::WouldDiscard(cycles) => Debugging::WouldDiscard {
                cycles: usize::try_from(*cycles).unwrap_or(usize::MAX),
            },
            DebugError::Ended => Debugging::Ended,
        };
        message.in_lang(lang).to_string()
    }
}

impl fmt::Display for DebugError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(Lang::English))
    }
}

impl std::error::Error for DebugError {}

impl From<HitsError> for DebugError {
    fn from(error: HitsError) -> Self {
        DebugError::Hits(error)
    }
}

impl From<Box<Diagnostic>> for DebugError {
    fn from(error: Box<Diagnostic>) -> Self {
        DebugError::Wrong(error)
    }
}

impl From<Fault> for DebugError {
    fn from(error: Fault) -> Self {
        DebugError::Fault(error)
    }
}
