//! A run with its past: it goes on, and it is taken back.

use super::request::{Refusal, is_stop, refuse, refuse_since};
use crate::NotRecorded;
use crate::recorder::{self, Recorder};
use crate::recording::{Outcome, Recording, Script};
use std::collections::VecDeque;
use tip_sim::{Event, Events, Interpreter, Robot, Run, Snapshot};
use tipc::Loaded;

/// How many cycles lie between two marks.
const APART: u64 = 500;
/// How much of the past is kept, and how much more before it is cut: ms.
const PAST: f64 = 300_000.0;
const SLACK: f64 = 60_000.0;
/// The most events that wait for one cycle, and that happen to one run.
const MOST_WAITING: usize = 64;
const MOST_EVENTS: usize = 100_000;
/// As many cuts are remembered; who missed more begins anew.
const CUTS: usize = 64;

/// A place to which the run can be taken back.
struct Mark {
    cycle: u64,
    snapshot: Snapshot,
    recorder: recorder::Mark,
}

/// A program that runs, and what it did.
pub(super) struct Runner {
    run: Run,
    recorder: Recorder,
    /// Those of the command line, which happen whatever else does.
    scripted: Events,
    marks: VecDeque<Mark>,
    /// What happens before the next step.
    waiting: Vec<Event>,
    /// How many cycles are recorded.
    taken: u64,
    /// Where the run was taken back to, the last ones.
    cuts: VecDeque<u64>,
    /// How often it was.
    pub(super) cut_count: u64,
}

impl Runner {
    /// A program before its second cycle: after the first there is something to see.
    pub(super) fn begin(
        loaded: &Loaded,
        robot: &Robot,
        scripted: &Events,
    ) -> Result<Self, NotRecorded> {
        let program = loaded.program.as_ref().ok_or(NotRecorded::NoProgram)?;
        let run = Run::new(Interpreter::new(program.clone()), robot.clone())
            .map_err(NotRecorded::Mismatch)?
            .with_events(scripted)
            .map_err(NotRecorded::Refused)?;
        let mut recorder = Recorder::new(robot, Script::of(&loaded.source, program));
        recorder.recording.events = scripted.all().to_vec();
        let mut runner = Runner {
            run,
            recorder,
            scripted: scripted.clone(),
            marks: VecDeque::new(),
            waiting: Vec::new(),
            taken: 0,
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
        let now = self.run.cycles();
        if now.is_multiple_of(APART) && self.marks.back().is_none_or(|mark| mark.cycle < now) {
            self.marks.push_back(Mark {
                cycle: now,
                snapshot: self.run.snapshot(),
                recorder: self.recorder.mark(),
            });
            self.forget();
        }
        let cycle = self.run.cycle();
        self.taken = cycle.number + 1;
        self.recorder.take(cycle, &self.run);
        if let Some(ending) = self.run.ending() {
            self.recorder.recording.outcome = Outcome::from(ending);
        }
    }

    /// Lets what waits happen in the next cycle.
    fn happen(&mut self) {
        if self.waiting.is_empty() {
            return;
        }
        self.branch();
        let now = self.run.cycles();
        for event in std::mem::take(&mut self.waiting) {
            let timed = event.at(now);
            // It was tried when it came.
            if self.run.add(timed.clone()).is_ok() {
                let events = &mut self.recorder.recording.events;
                events.insert(events.partition_point(|other| other.cycle <= now), timed);
            }
        }
    }

    /// What happened later, before the run was taken back, will not happen again.
    fn branch(&mut self) {
        let now = self.run.cycles();
        self.run.forget_events();
        let events = &mut self.recorder.recording.events;
        events.retain(|event| event.cycle < now);
        for event in self.scripted.all() {
            if event.cycle >= now && self.run.add(event.clone()).is_ok() {
                events.push(event.clone());
            }
        }
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
        (self.run.accepts(&event)).or_else(|reason| refuse_since("impossible", reason))?;
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
        if taken < self.taken {
            let Some(last) = self
                .marks
                .partition_point(|mark| mark.cycle < taken)
                .checked_sub(1)
            else {
                return;
            };
            self.marks.truncate(last + 1);
            let mark = &self.marks[last];
            self.waiting.clear();
            self.run.restore(&mark.snapshot);
            self.recorder.take_back(mark.cycle, &mark.recorder);
            self.taken = mark.cycle;
            self.recorder.recording.outcome = Outcome::Limit;
            self.cuts.push_back(taken);
            self.cut_count += 1;
            if self.cuts.len() > CUTS {
                self.cuts.pop_front();
            }
        }
        while self.taken < taken && !self.is_over() {
            self.cycle();
        }
    }

    /// The first cycle that all later cuts left, for someone who knows of so many cuts; none if that is too long ago.
    pub(super) fn cut_since(&self, known: u64) -> Option<u64> {
        let missed = usize::try_from(self.cut_count.saturating_sub(known)).ok()?;
        let from = self.cuts.len().checked_sub(missed)?;
        Some(self.cuts.range(from..).copied().min().unwrap_or(u64::MAX))
    }

    /// Forgets what lies too far back.
    fn forget(&mut self) {
        let begins = self.recording().frames.first().map(|frame| frame.time);
        let now = self.run.time();
        if begins.is_none_or(|begins| now - begins < PAST + SLACK) {
            return;
        }
        let frames = &self.recording().frames;
        let kept = frames.partition_point(|frame| frame.time < now - PAST);
        let cycle = frames.get(kept).map_or(0, |frame| frame.cycle);
        let later = self.marks.partition_point(|mark| mark.cycle <= cycle);
        self.marks.drain(..later.saturating_sub(1));
        let first = self.first();
        self.recorder.recording.forget(first);
    }

    /// The first cycle that is still known.
    pub(super) fn first(&self) -> u64 {
        self.marks.front().map_or(0, |mark| mark.cycle)
    }

    /// How many cycles are recorded.
    pub(super) fn taken(&self) -> u64 {
        self.taken
    }

    pub(super) fn is_over(&self) -> bool {
        self.run.ending().is_some()
    }

    pub(super) fn run(&self) -> &Run {
        &self.run
    }

    pub(super) fn recording(&self) -> &Recording {
        &self.recorder.recording
    }

    /// What the robot did last, if it is not among the frames.
    pub(super) fn pending(&self) -> Option<&crate::recording::Frame> {
        self.recorder.pending.as_ref()
    }
}
