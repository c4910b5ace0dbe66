//! What its user is asked.

use tip_sim::Event;
use tip_sim::message::Debugging;

/// A question in the last line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Question {
    Event,
    Expression,
    Watch,
    /// Whose last assignment to go back to.
    Who,
    Cycle,
    Condition,
    /// Which passes of a breakpoint with this condition.
    Passes(String),
    /// What to stop before.
    Name,
    /// Whether so many cycles may be discarded for an event.
    Discard(Event, u64),
}

impl Question {
    /// What is asked, for a cursor on this line.
    pub(crate) fn message(&self, line: u32) -> Debugging {
        match self {
            Question::Event => Debugging::AskEvent,
            Question::Expression => Debugging::AskExpression,
            Question::Watch => Debugging::AskWatch,
            Question::Who => Debugging::AskWho,
            Question::Cycle => Debugging::AskCycle,
            Question::Condition => Debugging::AskCondition { line },
            Question::Passes(_) => Debugging::AskPasses,
            Question::Name => Debugging::AskName,
            Question::Discard(_, cycles) => Debugging::AskDiscard {
                count: usize::try_from(*cycles).unwrap_or(usize::MAX),
            },
        }
    }
}
