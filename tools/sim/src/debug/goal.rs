//! Where a debugger is to go.

use super::Debugger;
use super::history::History;
use super::stop::Reason;

/// A movement through a run. Every one but those to a cycle, those of a cycle and [`SetBack`](Move::SetBack) stops at breakpoints,
/// watches and falls on its path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Move {
    /// One control cycle.
    Cycle,
    /// To the next step, into routines.
    Step,
    /// To the next step, over what GOSUB and CALL do.
    Over,
    /// Out of a routine, to the step after its call.
    Out,
    /// On until something stops it.
    Continue,
    /// On to a step of a line.
    Line(u32),
    /// To a cycle, known or not.
    To(u64),
    /// Back one control cycle.
    CycleBack,
    /// Back to the beginning of this step or, from there, of the one before; into routines.
    StepBack,
    /// The same over what GOSUB and CALL did.
    OverBack,
    /// Back to the call of a routine.
    OutBack,
    /// Back until something stops it.
    ReverseContinue,
    /// Back to a step of a line.
    LineBack(u32),
    /// Back to who last set what the watch of this number is on, past everything else.
    SetBack(u32),
}

impl Move {
    /// Whether it goes back.
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

/// What a movement ends at.
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
    /// Nothing of its own.
    Nowhere,
}

/// Where a movement began.
#[derive(Clone, Copy, Debug)]
pub(super) struct Origin {
    pub(super) at: u64,
    pub(super) step: u32,
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

    /// What a debugger that comes there says.
    pub(super) fn reason(self) -> Reason {
        match self {
            Goal::Step | Goal::Over | Goal::Out => Reason::Step,
            Goal::At(_) | Goal::Line(_) | Goal::Set(_) | Goal::Nowhere => Reason::There,
        }
    }

    /// Whether breakpoints and the like count on the path to it.
    pub(super) fn stops_early(self) -> bool {
        !matches!(self, Goal::At(_) | Goal::Set(_))
    }

    /// Whether a run that has come forward from an origin is there.
    pub(super) fn is_reached(self, from: &Origin, debugger: &Debugger) -> bool {
        let (step, depth) = (debugger.run.program().at(), Debugger::depth(&debugger.run));
        match self {
            Goal::At(at) => debugger.now == at,
            Goal::Step => step != from.step || depth != from.depth,
            Goal::Over => depth < from.depth || (depth == from.depth && step != from.step),
            Goal::Out => depth < from.depth,
            Goal::Line(line) => {
                debugger.history.step(debugger.now - 1) != step
                    && debugger.run.program().line(step) == line
            }
            Goal::Set(_) | Goal::Nowhere => false,
        }
    }

    /// Whether a position before an origin is there.
    pub(super) fn is_met(
        self,
        from: &Origin,
        at: u64,
        history: &History,
        debugger: &Debugger,
    ) -> bool {
        match self {
            Goal::At(goal) => at == goal,
            Goal::Step => history.enters(at),
            Goal::Over => history.enters(at) && history.depth(at) <= from.depth,
            Goal::Out => history.depth(at) < from.depth,
            Goal::Line(line) => {
                history.enters(at) && debugger.run.program().line(history.step(at)) == line
            }
            Goal::Set(_) | Goal::Nowhere => false,
        }
    }
}
