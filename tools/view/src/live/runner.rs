//! A run with its past: it goes on, and it is taken back.

use super::request::{Refusal, is_stop, refuse, refuse_since};
use crate::RecordError;
use crate::recorder::{self, Recorder};
use crate::recording::{Frame, Outcome, Recording, Script};
use std::collections::VecDeque;
use tip_sim::{Event, Events, Interpreter, Robot, Run, Summary, Timeline};
use tipc::Loaded;

/// The most events that wait for one cycle, and that happen to one run.
const MOST_WAITING: usize = 64;
const MOST_EVENTS: usize = 100_000;
/// Number of cuts that are remembered; a viewer that missed more begins anew.
const CUTS: usize = 64;

/// A program that runs, and what it did.
pub(super) struct Runner {
    timeline: Timeline<recorder::Checkpoint>,
    recorder: Recorder,
    /// Events that happen before the next step.
    waiting: Vec<Event>,
    /// The last cycles to which the run was taken back.
    cuts: VecDeque<u64>,
    /// Number of times that it was taken back.
    pub(super) cut_count: u64,
}

impl Runner {
    /// Creates a program before its second cycle: after the first there is something to see.
    pub(super) fn begin(
        loaded: &Loaded,
        robot: &Robot,
        scripted: &Events,
    ) -> Result<Self, RecordError> {
        let program = loaded.program.as_ref().ok_or(RecordError::NoProgram)?;
        let run = Run::new(Interpreter::new(program.clone()), robot.clone())
            .map_err(RecordError::Mismatch)?
            .with_events(scripted)
            .map_err(RecordError::Refused)?
            .followed();
        let mut recorder = Recorder::new(robot, Script::of(&loaded.source, program));
        recorder.recording.events = scripted.all().to_vec();
        let mut runner = Runner {
            timeline: Timeline::new(run, recorder.checkpoint()),
            recorder,
            waiting: Vec::new(),
            cuts: VecDeque::new(),
            cut_count: 0,
        };
        runner.cycle();
        Ok(runner)
    }

    /// Runs one cycle, unless the run is over.
    pub(super) fn cycle(&mut self) {
        if self.is_over() {
            return;
        }
        self.happen();
        let cycle = self.timeline.cycle();
        let (run, recorder) = (self.timeline.run(), &mut self.recorder);
        recorder.take(cycle, run, None);
        if let Some(ending) = run.ending() {
            recorder.recording.outcome = Outcome::from(ending);
            return;
        }
        if self.timeline.note(|| recorder.checkpoint()) {
            self.forget();
        }
    }

    /// Lets what waits happen in the next cycle. What happened later, before the run was taken back, will not happen again.
    fn happen(&mut self) {
        if self.waiting.is_empty() {
            return;
        }
        self.timeline.branch();
        for event in std::mem::take(&mut self.waiting) {
            // It was accepted when it came.
            let _ = self.timeline.add(event);
        }
        let now = self.taken();
        let events = &mut self.recorder.recording.events;
        events.retain(|event| event.cycle < now);
        events.extend_from_slice(self.timeline.to_come());
    }

    /// Lets something happen before the next step.
    pub(super) fn give(&mut self, event: Event) -> Result<(), Refusal> {
        if self.is_over() {
            return refuse("over");
        }
        let is_full = self.waiting.len() >= MOST_WAITING
            || self.recorder.recording.events.len() >= MOST_EVENTS;
        // A robot can always be stopped; once it is, the run is over.
        if is_full && !is_stop(&event) {
            return refuse("many");
        }
        self.run()
            .accepts(&event)
            .or_else(|reason| refuse_since("impossible", reason))?;
        // Of two values of one input before one step, the later one is read.
        let is_same = |other: &Event| match (other, &event) {
            (Event::Sensor(one, _), Event::Sensor(other, _)) => one == other,
            (Event::Set(one, _), Event::Set(other, _)) => one == other,
            _ => false,
        };
        self.waiting.retain(|other| !is_same(other));
        self.waiting.push(event);
        Ok(())
    }

    /// Takes the run back, or on, until so many cycles are recorded; less far if its past does not reach, or it is over
    /// before.
    pub(super) fn go_to(&mut self, taken: u64) {
        let taken = taken.max(self.first() + 1);
        if taken < self.taken() {
            let Some(checkpoint) = self.timeline.rewind(taken - 1) else {
                return;
            };
            self.recorder.take_back(checkpoint);
            self.waiting.clear();
            self.recorder.recording.outcome = Outcome::Limit;
            self.cuts.push_back(taken);
            self.cut_count += 1;
            if self.cuts.len() > CUTS {
                self.cuts.pop_front();
            }
        }
        while self.taken() < taken && !self.is_over() {
            self.cycle();
        }
    }

    /// Returns the first cycle that all later cuts left, for someone who knows of so many cuts;
    /// none if that is too long ago.
    pub(super) fn cut_since(&self, known: u64) -> Option<u64> {
        let missed = usize::try_from(self.cut_count.saturating_sub(known)).ok()?;
        let from = self.cuts.len().checked_sub(missed)?;
        Some(self.cuts.range(from..).copied().min().unwrap_or(u64::MAX))
    }

    /// Forgets what lies too far back.
    fn forget(&mut self) {
        let Some(cycle) = self.recording().long_ago(self.run().time()) else {
            return;
        };
        self.timeline.forget_before(cycle);
        let first = self.first();
        self.recorder.recording.forget(first);
    }

    /// Returns the first cycle that is still known.
    pub(super) fn first(&self) -> u64 {
        self.timeline.first()
    }

    /// Returns the number of recorded cycles.
    pub(super) fn taken(&self) -> u64 {
        self.timeline.now()
    }

    pub(super) fn is_over(&self) -> bool {
        self.run().ending().is_some()
    }

    pub(super) fn run(&self) -> &Run {
        self.timeline.run()
    }

    pub(super) fn recording(&self) -> &Recording {
        &self.recorder.recording
    }

    /// Returns the figures so far.
    pub(super) fn summary(&self) -> &Summary {
        self.recorder.summary.summary()
    }

    /// Returns the robot's last state, if it is not among the frames.
    pub(super) fn pending(&self) -> Option<&Frame> {
        self.recorder.pending.as_ref()
    }
}
