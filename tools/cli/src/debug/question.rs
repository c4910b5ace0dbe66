//! What its user is asked.

use tip_sim::Event;
use tipc::message::Debugging;

/// A question in the last line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Question {
    Event,
    Expression,
    Watch,
    Cycle,
    Condition,
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
            Question::Cycle => Debugging::AskCycle,
            Question::Condition => Debugging::AskCondition { line },
            Question::Discard(_, cycles) => Debugging::AskDiscard {
                count: usize::try_from(*cycles).unwrap_or(usize::MAX),
            },
        }
    }
}
