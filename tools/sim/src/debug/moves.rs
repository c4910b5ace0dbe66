//! The execution of a movement, in portions. Forwards, it runs cycle by cycle, through known cycles and beyond.
//! Backwards, it searches the records of the cycles, and replays a segment only if a condition has to be evaluated.

use super::breakpoints::HitPrediction;
use super::expressions::Now;
use super::stop::{Goal, Move, Origin, Progress, Reason, Stop};
use super::{Debugger, Frontier, MESSAGES, Taken};
use crate::run::Run;
use std::fmt::Display;
use tip_runtime::machine::Status;
use tip_runtime::program::THREADS;
use tip_runtime::record::{Cycle, Sink};
use tipc::program::{Action, Program, Thread};

/// Result of a portion of work.
#[derive(Clone, Debug, PartialEq)]
pub enum Work {
    /// There is more to do.
    Going(Progress),
    /// The movement has ended.
    Stopped(Stop),
}

/// A movement under way.
#[derive(Debug)]
pub(super) struct PendingCommand {
    pub(super) goal: Goal,
    pub(super) origin: Origin,
    is_back: bool,
    phase: Phase,
}

#[derive(Debug)]
enum Phase {
    /// Hits have to be counted first.
    CountingHits(HitCounting),
    Forward,
    BackwardSearch(BackwardSearch),
}

impl Debugger {
    /// Begins a movement and drops one that is under way. [`work`](Self::work) executes it.
    pub fn start(&mut self, movement: Move) {
        self.pending = None;
        let origin = Origin {
            at: self.now(),
            thread: self.thread(),
            depth: Self::depth(self.run(), self.thread()),
        };
        let goal = Goal::of(movement, self.now());
        let is_back = movement.is_back();
        if let Some(stop) = self.immediate_stop(goal, is_back) {
            self.arrive(stop);
            return;
        }
        let unknown = self
            .breakpoints
            .count_known(&self.history, self.now() + u64::from(!is_back));
        let unknown = unknown.filter(|_| goal.stops_early());
        if !is_back && self.now() == 0 {
            self.log_here();
        }
        let phase = match unknown.and_then(|from| HitCounting::new(from, self)) {
            Some(counting) => Phase::CountingHits(counting),
            None => Phase::after_counting(is_back, self.now()),
        };
        self.pending = Some(PendingCommand {
            goal,
            origin,
            is_back,
            phase,
        });
    }

    /// Returns the stop of a movement that needs no work.
    fn immediate_stop(&self, goal: Goal, is_back: bool) -> Option<Stop> {
        let at = self.now();
        match goal {
            Goal::At(to) if is_back || to <= self.history.len() => {
                let reason = match (to, is_back) {
                    (0, true) => Reason::Start,
                    (_, true) => Reason::Step,
                    _ if to == at + 1 => self.end_at(to).unwrap_or(Reason::Step),
                    _ => Reason::There,
                };
                Some(self.stop_for(reason, to))
            }
            _ if is_back => (at == 0).then(|| self.stop_for(Reason::Start, at)),
            _ => self.end_at(at).map(|reason| self.stop_for(reason, at)),
        }
    }

    /// Returns a stop for the selected thread, or for the thread that failed.
    fn stop_for(&self, reason: Reason, at: u64) -> Stop {
        let thread = match &reason {
            Reason::Fault(_) => self.history.cycle(at.saturating_sub(1)).last(),
            _ => None,
        };
        let thread = thread.map_or(self.selected, |taken| taken.thread);
        Stop { reason, at, thread }
    }

    /// Returns true if a step of a line begins at a position.
    pub(super) fn begins_at(&self, at: u64, line: u32) -> bool {
        let program = self.run().program();
        self.history
            .begins(at)
            .any(|it| program.line(it.step) == line)
    }

    /// Continues the movement for at most `cycles` cycles. During a backward search the position does not change.
    pub fn work(&mut self, cycles: u64) -> Work {
        let Some(mut pending) = self.pending.take() else {
            return Work::Stopped(self.stop.clone());
        };
        let mut left = cycles.max(1);
        let found = loop {
            match &mut pending.phase {
                Phase::CountingHits(counting) => match self.count_hits(counting, &mut left) {
                    true => pending.phase = Phase::after_counting(pending.is_back, self.now()),
                    false => break None,
                },
                Phase::Forward => break self.run_on(pending.goal, &pending.origin, &mut left),
                Phase::BackwardSearch(back) => {
                    break self.look_back(back, pending.goal, &pending.origin, &mut left);
                }
            }
        };
        match found {
            Some(stop) => {
                self.arrive(stop);
                Work::Stopped(self.stop.clone())
            }
            None => {
                let progress = pending.progress(self.now());
                self.pending = Some(pending);
                Work::Going(progress)
            }
        }
    }

    /// Runs a whole movement.
    pub fn go(&mut self, movement: Move) -> Stop {
        self.start(movement);
        loop {
            if let Work::Stopped(stop) = self.work(u64::MAX) {
                return stop;
            }
        }
    }

    /// Returns true if a movement is under way.
    pub fn is_going(&self) -> bool {
        self.pending.is_some()
    }

    /// Cancels a movement. The debugger stays at the position that a forward movement has reached, or at the start of a
    /// backward one.
    pub fn cancel(&mut self) -> &Stop {
        if self.pending.take().is_some() {
            self.stop = Stop {
                reason: Reason::Interrupted,
                at: self.now(),
                thread: self.thread(),
            };
        }
        &self.stop
    }

    fn arrive(&mut self, stop: Stop) {
        self.seek(stop.at);
        self.selected = stop.thread;
        self.stop = stop;
    }
}

impl Phase {
    fn after_counting(is_back: bool, now: u64) -> Self {
        match is_back {
            true => Phase::BackwardSearch(BackwardSearch::new(now)),
            false => Phase::Forward,
        }
    }
}

impl PendingCommand {
    fn progress(&self, now: u64) -> Progress {
        match &self.phase {
            Phase::CountingHits(counting) => counting.progress(),
            Phase::Forward => Progress {
                done: now - self.origin.at,
                of: match self.goal {
                    Goal::At(to) => Some(to - self.origin.at),
                    _ => None,
                },
            },
            Phase::BackwardSearch(back) => back.progress(self.origin.at),
        }
    }
}

impl Debugger {
    /// Runs until something stops it, or no cycles are left.
    pub(super) fn run_on(&mut self, goal: Goal, origin: &Origin, left: &mut u64) -> Option<Stop> {
        while *left > 0 {
            *left -= 1;
            self.advance();
            self.log_here();
            let stop = self.stop_here(goal, origin);
            if stop.is_some() {
                return stop;
            }
        }
        None
    }

    /// Returns the reason to stop at this position, if there is one, after a forward movement.
    fn stop_here(&self, goal: Goal, origin: &Origin) -> Option<Stop> {
        let at = self.now();
        if let Some(end) = self.end_at(at) {
            return Some(self.stop_for(end, at));
        }
        if let Goal::At(to) = goal {
            let reason = match to == origin.at + 1 {
                true => Reason::Step,
                false => Reason::There,
            };
            return (at == to).then(|| self.stop_for(reason, at));
        }
        let stopped = self.breakpoint_at(&self.here());
        let assigned = || (self.watches).assigned(at - 1, None, &self.history, &self.program);
        let set = || {
            Some((
                self.watches.set(at, None, &self.run().events)?,
                self.selected,
            ))
        };
        if let Some((reason, thread)) = stopped.or_else(assigned).or_else(set) {
            return Some(Stop { reason, at, thread });
        }
        if let Some(fall) = self.fall.filter(|fall| fall.cycle == at - 1)
            && self.stops_at_fall
        {
            return Some(self.stop_for(Reason::Fall(fall), at));
        }
        goal.is_reached(origin, self)
            .then(|| self.stop_for(goal.reason(), at))
    }

    /// Returns the breakpoint that stops a run at a position, and the thread of its step.
    fn breakpoint_at(&self, now: &Now<'_>) -> Option<(Reason, u8)> {
        self.history.begins(now.at).find_map(|it| {
            let id = self.breakpoints.stops(it.step, now)?;
            Some((Reason::Breakpoint(id), it.thread))
        })
    }

    /// Returns the end of the run, if it ended before this position.
    pub(super) fn end_at(&self, at: u64) -> Option<Reason> {
        match self.history.frontier {
            _ if at < self.history.len() => None,
            Frontier::Open => None,
            Frontier::Ended(end) => Some(Reason::Ended(end)),
            Frontier::Failed(emergency) => Some(Reason::Fault(emergency)),
        }
    }

    /// Runs one cycle, and the events before the next one.
    fn advance(&mut self) {
        if self.now() < self.history.len() {
            self.timeline.advance(None);
        } else {
            self.explore();
        }
        self.timeline.happen();
        let now = Now {
            run: self.timeline.run(),
            at: self.timeline.now(),
            asker: &self.asker,
        };
        self.breakpoints.count(&self.history, &now);
    }

    /// Runs a cycle for the first time.
    fn explore(&mut self) {
        let mut listener = RunListener {
            at: self.now(),
            said: &mut self.said,
            taken: &mut self.taken,
            program: &self.program,
            depths: (0..=THREADS as u8)
                .map(|thread| Self::depth(self.timeline.run(), thread))
                .collect(),
            steps: Vec::new(),
        };
        let status = self.timeline.advance(Some(&mut listener));
        let mut steps = std::mem::take(&mut listener.steps);
        let depths = std::mem::take(&mut listener.depths);
        let frontier = match (status, self.run().emergency()) {
            (Status::Finished(end), _) => Frontier::Ended(end),
            (Status::Emergency, Some(emergency)) => Frontier::Failed(emergency),
            _ => Frontier::Open,
        };
        if let Frontier::Failed(emergency) = &frontier {
            let name = emergency.thread.as_ref().map(|name| name.as_str());
            let thread = thread_of(&self.program, name);
            steps.push(Taken {
                step: emergency.step,
                thread,
                depth: depths.get(usize::from(thread)).copied().unwrap_or(0),
            });
        }
        let next = self.next_steps();
        self.history.push(steps, next, frontier);
        if self.fall.is_none() {
            self.fall = self.run().first_fall();
        }
        if frontier == Frontier::Open {
            self.timeline.note(|| ());
        }
    }

    /// Goes to a known position.
    pub(super) fn seek(&mut self, to: u64) {
        let now = self.now();
        if let Some((at, _)) = self.timeline.before(to)
            && (now > to || now < at)
        {
            self.timeline.rewind(to);
            self.timeline.happen();
        }
        while self.now() < to.min(self.history.len()) {
            self.advance();
        }
    }
}

/// Keeps the messages of the program, and the steps of a cycle.
struct RunListener<'a> {
    at: u64,
    said: &'a mut Vec<(u64, String)>,
    taken: &'a mut usize,
    program: &'a Program,
    /// Number of open calls of the main program and of each thread.
    depths: Vec<u8>,
    steps: Vec<Taken>,
}

/// Returns the number of the thread of a name; 0 without one.
fn thread_of(program: &Program, name: Option<&str>) -> u8 {
    let named = |thread: &Thread| name == Some(&*thread.name);
    let index = program.threads().iter().position(named);
    index.map_or(0, |index| u8::try_from(index + 1).unwrap_or(0))
}

impl Sink for RunListener<'_> {
    fn cycle(&mut self, record: &Cycle<'_>) {
        let thread = thread_of(self.program, record.thread);
        let depth = self.depths.get_mut(usize::from(thread));
        let step = record.step;
        self.steps.push(Taken {
            step,
            thread,
            depth: depth.as_ref().map_or(0, |depth| **depth),
        });
        let action = self.program.steps().get(step as usize);
        if let (Some(depth), Some(step)) = (depth, action) {
            match step.action {
                Action::Gosub { .. } => *depth += 1,
                Action::IfGosub { to, .. } if record.next == Some(to) => *depth += 1,
                Action::Return => *depth = depth.saturating_sub(1),
                _ => {}
            }
        }
    }

    fn say(&mut self, text: &dyn Display) {
        if self.said.len() >= 2 * MESSAGES {
            self.said.drain(..MESSAGES);
            *self.taken = self.taken.saturating_sub(MESSAGES);
        }
        self.said.push((self.at, text.to_string()));
    }
}

/// A backward search under way.
#[derive(Debug)]
pub(super) struct BackwardSearch {
    /// Positions from here on are searched.
    below: u64,
    /// A copy of the run that replays segments. It is made when it is first needed.
    scout: Option<Run>,
    segment: Option<ReplaySegment>,
}

/// The positions after a checkpoint at which conditions decide.
#[derive(Debug)]
struct ReplaySegment {
    from: u64,
    /// Position of the replay.
    at: u64,
    /// Positions that are still to be checked, in order.
    asks: std::vec::IntoIter<u64>,
    /// The stop at the last position that stops, so far.
    best: Option<Stop>,
}

/// Prediction for a position before the origin.
enum Found {
    Nothing,
    /// The reason, and the thread that it is about.
    Stops(Reason, u8),
    Asks,
}

impl BackwardSearch {
    pub(super) fn new(now: u64) -> Self {
        BackwardSearch {
            below: now,
            scout: None,
            segment: None,
        }
    }

    pub(super) fn progress(&self, origin: u64) -> Progress {
        Progress {
            done: origin - self.below,
            of: Some(origin),
        }
    }
}

impl Debugger {
    /// Continues the search until a stop is found, or no cycles are left.
    pub(super) fn look_back(
        &self,
        back: &mut BackwardSearch,
        goal: Goal,
        origin: &Origin,
        left: &mut u64,
    ) -> Option<Stop> {
        loop {
            if let Some(segment) = &mut back.segment {
                if let Some(scout) = &mut back.scout
                    && !self.run_segment(segment, scout, left)
                {
                    return None;
                }
                if let Some(stop) = segment.best.take() {
                    return Some(stop);
                }
                back.below = segment.from;
                back.segment = None;
            }
            let last = match back.below.checked_sub(1) {
                Some(last) => last,
                None => {
                    return Some(self.stop_for(Reason::Start, 0));
                }
            };
            let (from, mark) = self.timeline.before(last)?;
            let segment = self.scan(from, last, goal, origin);
            if !segment.asks.as_slice().is_empty() {
                let scout = back.scout.get_or_insert_with(|| self.run().clone());
                scout.restore(mark);
            }
            back.segment = Some(segment);
        }
    }

    /// Searches the positions after a checkpoint, the last one first, up to one that stops for certain.
    fn scan(&self, from: u64, last: u64, goal: Goal, origin: &Origin) -> ReplaySegment {
        let mut asks = Vec::new();
        let mut best = None;
        for at in (from..=last).rev() {
            match self.found(at, goal, origin) {
                Found::Nothing => {}
                Found::Asks => asks.push(at),
                Found::Stops(reason, thread) => {
                    best = Some(Stop { reason, at, thread });
                    break;
                }
            }
        }
        asks.reverse();
        ReplaySegment {
            from,
            at: from,
            asks: asks.into_iter(),
            best,
        }
    }

    fn found(&self, at: u64, goal: Goal, origin: &Origin) -> Found {
        if let Goal::Set(watch) = goal {
            let found = self.set_at(at, Some(watch));
            return found.map_or(Found::Nothing, |(reason, thread)| {
                Found::Stops(reason, thread)
            });
        }
        let mut asks = false;
        for it in self.history.begins(at) {
            match self.breakpoints.predict(it.step, at) {
                HitPrediction::Stops(id) => {
                    return Found::Stops(Reason::Breakpoint(id), it.thread);
                }
                HitPrediction::Asks => asks = true,
                HitPrediction::No => {}
            }
        }
        if let Some((watch, thread)) = self.set_at(at, None) {
            return Found::Stops(watch, thread);
        }
        if let Some(fall) = self.fall.filter(|fall| fall.cycle == at)
            && self.stops_at_fall
        {
            return Found::Stops(Reason::Fall(fall), origin.thread);
        }
        match asks {
            _ if goal.is_met(origin, at, &self.history, self) => {
                Found::Stops(goal.reason(), origin.thread)
            }
            true => Found::Asks,
            false => Found::Nothing,
        }
    }

    /// Returns the variable that is assigned between a position and the next one, if a watch is on
    /// it: that watch, or any.
    fn set_at(&self, at: u64, watch: Option<u32>) -> Option<(Reason, u8)> {
        let assigned = (self.watches).assigned(at, watch, &self.history, &self.program);
        let set = || {
            Some((
                self.watches.set(at, watch, &self.run().events)?,
                self.selected,
            ))
        };
        assigned.or_else(set)
    }

    /// Replays a segment up to its last condition. Returns true if it came there.
    fn run_segment(&self, segment: &mut ReplaySegment, scout: &mut Run, left: &mut u64) -> bool {
        while let Some(to) = segment.asks.as_slice().first().copied() {
            while segment.at < to {
                if *left == 0 {
                    return false;
                }
                *left -= 1;
                scout.advance(None);
                segment.at += 1;
            }
            scout.happen();
            let now = Now {
                run: scout,
                at: to,
                asker: &self.asker,
            };
            if let Some((reason, thread)) = self.breakpoint_at(&now) {
                segment.found(Stop {
                    reason,
                    at: to,
                    thread,
                });
            }
            segment.asks.next();
        }
        true
    }
}

impl ReplaySegment {
    /// Keeps the later one of two stops. A certain stop is before all positions with conditions.
    fn found(&mut self, stop: Stop) {
        if self.best.as_ref().is_none_or(|best| best.at < stop.at) {
            self.best = Some(stop);
        }
    }
}

/// A run that replays cycles whose passes have not been counted.
#[derive(Debug)]
pub(super) struct HitCounting {
    scout: Run,
    from: u64,
    at: u64,
    until: u64,
}

impl HitCounting {
    /// Starts counting from a position up to where the debugger stands.
    pub(super) fn new(from: u64, debugger: &Debugger) -> Option<Self> {
        let (at, mark) = debugger.timeline.before(from)?;
        let mut scout = debugger.run().clone();
        scout.restore(mark);
        scout.happen();
        Some(HitCounting {
            scout,
            from: at,
            at,
            until: debugger.now(),
        })
    }

    pub(super) fn progress(&self) -> Progress {
        Progress {
            done: self.at - self.from,
            of: Some(self.until - self.from),
        }
    }
}

impl Debugger {
    /// Continues to count. Returns true when it has finished.
    pub(super) fn count_hits(&mut self, counting: &mut HitCounting, left: &mut u64) -> bool {
        loop {
            let now = Now {
                run: &counting.scout,
                at: counting.at,
                asker: &self.asker,
            };
            self.breakpoints.count(&self.history, &now);
            if counting.at >= counting.until {
                return true;
            }
            if *left == 0 {
                return false;
            }
            *left -= 1;
            counting.scout.advance(None);
            counting.scout.happen();
            counting.at += 1;
        }
    }
}
