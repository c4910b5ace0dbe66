//! What is kept of every cycle that has been run, and snapshots to go back to.

use crate::run::Run;
use crate::snapshot::Snapshot;
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

/// How many cycles are run again at most, as long as there is room.
const SPACING: u64 = 200;

/// How many snapshots there may be: more than ten minutes of 2 ms need.
const MOST: usize = 2048;

/// How many values of variables all snapshots may hold together.
const VALUES: usize = 1 << 24;

/// Snapshots, two hundred cycles apart. When there are too many, every second one goes, and later ones are as far apart as
/// those that stay; so a run of any length needs no more memory than a long one.
#[derive(Debug)]
pub(super) struct Marks {
    marks: Vec<(u64, Snapshot)>,
    spacing: u64,
    most: usize,
}

impl Marks {
    /// Returns no snapshots yet, of a program with so many values. The more it has, the fewer snapshots are kept.
    pub(super) fn new(values: usize) -> Self {
        Marks {
            marks: Vec::new(),
            spacing: SPACING,
            most: (VALUES / values.max(1)).clamp(2, MOST),
        }
    }

    /// Marks a run at a position beyond all others, if it is far enough from the last mark.
    pub(super) fn note(&mut self, at: u64, run: &Run) {
        let due = self.marks.last().map_or(0, |(last, _)| last + self.spacing);
        if at < due {
            return;
        }
        if self.marks.len() >= self.most {
            let mut place = 0;
            self.marks.retain(|_| {
                place += 1;
                place % 2 == 1
            });
            self.spacing *= 2;
        }
        self.marks.push((at, run.snapshot()));
    }

    /// The last mark that is not after a position; the first one is at 0.
    pub(super) fn before(&self, at: u64) -> Option<&(u64, Snapshot)> {
        let behind = self.marks.partition_point(|(mark, _)| *mark <= at);
        self.marks.get(behind.checked_sub(1)?)
    }

    /// Forgets all marks after a position.
    pub(super) fn truncate(&mut self, at: u64) {
        let keep = self.marks.partition_point(|(mark, _)| *mark <= at);
        self.marks.truncate(keep);
    }
}
