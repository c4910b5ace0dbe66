//! What is kept of every cycle that has been run.

use tip_runtime::machine::Emergency;
use tip_runtime::program::End;

/// How many messages are kept.
pub(super) const MESSAGES: usize = 10_000;

/// How the run went on after the last cycle that is known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Frontier {
    /// This step comes next.
    #[default]
    Open,
    /// The program ended.
    Ended(End),
    /// The last step failed, and changed nothing.
    Failed(Emergency),
}

/// The step of every cycle, and how many calls were open.
#[derive(Debug, Default)]
pub(super) struct History {
    steps: Vec<u32>,
    depths: Vec<u8>,
    /// The step that would run after all of them.
    next: u32,
    pub(super) frontier: Frontier,
}

impl History {
    pub(super) fn len(&self) -> u64 {
        self.steps.len() as u64
    }

    /// A step is about to run for the first time.
    pub(super) fn push(&mut self, step: u32, depth: u8) {
        self.steps.push(step);
        self.depths.push(depth);
    }

    /// What came after it.
    pub(super) fn reached(&mut self, next: u32, frontier: Frontier) {
        self.next = next;
        self.frontier = frontier;
    }

    /// Forgets everything from a position on, where this step comes next.
    pub(super) fn truncate(&mut self, at: u64, next: u32) {
        let at = place(at);
        self.steps.truncate(at);
        self.depths.truncate(at);
        self.next = next;
        self.frontier = Frontier::Open;
    }

    /// The step at a position.
    pub(super) fn step(&self, at: u64) -> u32 {
        self.steps.get(place(at)).copied().unwrap_or(self.next)
    }

    /// How many calls are open before a cycle.
    pub(super) fn depth(&self, at: u64) -> u8 {
        self.depths.get(place(at)).copied().unwrap_or_default()
    }

    /// Whether the step at a position is not that of the cycle before: it begins there.
    pub(super) fn enters(&self, at: u64) -> bool {
        at == 0 || self.step(at) != self.step(at - 1)
    }

    /// Whether the step of a cycle failed, and so changed nothing.
    pub(super) fn fails(&self, at: u64) -> bool {
        matches!(self.frontier, Frontier::Failed(_)) && at + 1 == self.len()
    }
}

fn place(at: u64) -> usize {
    usize::try_from(at).unwrap_or(usize::MAX)
}
