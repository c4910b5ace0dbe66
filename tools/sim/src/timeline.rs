//! A run with its past: checkpoints, rewinding, and branches.
//!
//! A position is the number of the cycle that comes next. A run returns to a position by restoring the last checkpoint
//! at or before it and running on from there, which gives the same bits. The owner of a timeline keeps records of
//! cycles, such as their steps or the motion of the robot.
//!
//! ```
//! use tip_sim::{Robot, Run, Timeline, load};
//!
//! let robot = Robot::named("titan8")?;
//! let text = "3.1\nCount\nDEF_VAR N\nN = 0\nL:\nN += 1\nGOTO L:\nEND\n";
//! let run = Run::new(load("count.prg", text, &robot)?, robot)?;
//! let mut timeline = Timeline::new(run, ());
//! for _ in 0..1000 {
//!     timeline.advance(None);
//!     timeline.note(|| ());
//! }
//! timeline.rewind(499);
//! assert_eq!(timeline.now(), 400);
//! timeline.branch();
//! timeline.add("set N=0".parse()?)?;
//! timeline.advance(None);
//! assert_eq!(timeline.changes().to_string(), "400:set N=0");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::cycle::Cycle;
use crate::event::Refused;
use crate::event::{Event, Events, Timed};
use crate::run::Run;
use crate::run::Snapshot;
use tip_runtime::machine::Status;
use tip_runtime::record::Sink;

/// Least number of cycles between two checkpoints.
const SPACING: u64 = 200;

/// Maximum number of checkpoints: enough for more than ten minutes of 2 ms cycles.
const MAX_CHECKPOINTS: usize = 2048;

/// Maximum number of values of variables in all checkpoints together.
const VALUES: usize = 1 << 24;

/// A run that can be set back, with a value of its owner for each checkpoint.
pub struct Timeline<T = ()> {
    run: Run,
    now: u64,
    checkpoints: Vec<Checkpoint<T>>,
    spacing: u64,
    most: usize,
    /// Events that happen in every branch.
    scripted: Events,
    /// Events that were added in this branch, in order of their cycles.
    changes: Events,
}

/// A position to which a run can be set back.
struct Checkpoint<T> {
    at: u64,
    snapshot: Snapshot,
    kept: T,
}

impl<T> Timeline<T> {
    /// Creates the timeline of a run before its first cycle. The events of the run happen in every branch. The more
    /// variables its program has, the fewer checkpoints are kept.
    pub fn new(run: Run, kept: T) -> Self {
        let program = run.program();
        let values = (0..).take_while(|at| program.scalar(*at).is_some());
        let first = Checkpoint {
            at: 0,
            snapshot: run.snapshot(),
            kept,
        };
        Timeline {
            now: 0,
            checkpoints: vec![first],
            spacing: SPACING,
            most: (VALUES / values.count().max(1)).clamp(2, MAX_CHECKPOINTS),
            scripted: run.events.clone(),
            changes: Events::NONE,
            run,
        }
    }

    /// Adds events that happen in every branch. It must be called before the first cycle.
    ///
    /// # Errors
    /// The robot or the program lacks what they change.
    pub fn script(&mut self, events: &Events) -> Result<(), Refused> {
        for event in events.all() {
            self.run.add(event.clone())?;
            self.scripted.insert(0, event.clone());
        }
        Ok(())
    }

    /// Returns the run at this position.
    pub fn run(&self) -> &Run {
        &self.run
    }

    /// Returns the position: the cycle that comes next.
    pub fn now(&self) -> u64 {
        self.now
    }

    /// Runs one cycle, and reports it to a sink.
    pub fn advance(&mut self, sink: Option<&mut dyn Sink>) -> Status {
        let status = self.run.advance(sink);
        self.now += 1;
        status
    }

    /// Runs one cycle, and returns what happened in it.
    pub fn cycle(&mut self) -> Cycle {
        let cycle = self.run.cycle();
        self.now += 1;
        cycle
    }

    /// Applies the events that are due before the next cycle. Otherwise that cycle applies them.
    pub fn happen(&mut self) {
        self.run.happen();
    }

    /// Makes a checkpoint here if this position is far enough from the last one, and returns true if it did. If there
    /// are too many, every second one is removed, and later ones have the new distance, so that memory is bounded for a
    /// run of any length.
    pub fn note(&mut self, kept: impl FnOnce() -> T) -> bool {
        let last = self.checkpoints.last().map_or(0, |last| last.at);
        if self.now < last + self.spacing {
            return false;
        }
        if self.checkpoints.len() >= self.most {
            let mut is_odd = false;
            self.checkpoints.retain(|_| {
                is_odd = !is_odd;
                is_odd
            });
            self.spacing *= 2;
        }
        self.checkpoints.push(Checkpoint {
            at: self.now,
            snapshot: self.run.snapshot(),
            kept: kept(),
        });
        true
    }

    /// Returns the last checkpoint at or before a position: its own position, and its snapshot.
    pub fn before(&self, at: u64) -> Option<(u64, &Snapshot)> {
        let found = self.checkpoints.get(self.index_before(at)?)?;
        Some((found.at, &found.snapshot))
    }

    fn index_before(&self, at: u64) -> Option<usize> {
        let later = self.checkpoints.partition_point(|other| other.at <= at);
        later.checked_sub(1)
    }

    /// Sets the run back to the last checkpoint at or before a position, and returns the owner's value there. The owner
    /// runs the cycles from there up to the position.
    pub fn rewind(&mut self, to: u64) -> Option<&T> {
        let found = self.checkpoints.get(self.index_before(to)?)?;
        self.run.restore(&found.snapshot);
        self.now = found.at;
        Some(&found.kept)
    }

    /// Returns the first position to which the run can be set back.
    pub fn first(&self) -> u64 {
        self.checkpoints.first().map_or(0, |first| first.at)
    }

    /// Removes the checkpoints that no position from this one on needs.
    pub fn forget_before(&mut self, at: u64) {
        let kept = self.index_before(at).unwrap_or_default();
        self.checkpoints.drain(..kept);
    }

    /// Begins a new branch: removes the checkpoints after this position, and the changes that have not happened yet.
    pub fn branch(&mut self) {
        let now = self.now;
        self.checkpoints.retain(|other| other.at <= now);
        // The events of this position happen together, and may have happened already.
        let earlier = self.scripted.before(now) + self.changes.before(now);
        let next = now + u64::from(self.run.happened > earlier);
        self.changes.truncate(self.changes.before(next));
        self.run.forget_events();
        for event in &self.scripted.all()[self.scripted.before(next)..] {
            self.run.events.insert(self.run.happened, event.clone());
        }
    }

    /// Adds a change before the next cycle.
    ///
    /// # Errors
    /// The robot or the program lacks what it changes.
    pub fn add(&mut self, event: Event) -> Result<(), Refused> {
        let event = event.at(self.now);
        self.run.add(event.clone())?;
        self.changes.insert(0, event);
        Ok(())
    }

    /// Returns the changes of this branch.
    pub fn changes(&self) -> &Events {
        &self.changes
    }

    /// Returns the events that have not happened yet.
    pub fn to_come(&self) -> &[Timed] {
        self.run
            .events
            .all()
            .get(self.run.happened..)
            .unwrap_or_default()
    }
}
