//! Forwards, cycle by cycle, over what is known and on.

use super::Debugger;
use super::goal::{Goal, Origin};
use super::history::Frontier;
use super::stop::{Reason, Stop};
use std::fmt::Display;
use tip_runtime::machine::Status;
use tip_runtime::record::Sink;

/// How many messages are kept.
pub(super) const MESSAGES: usize = 10_000;

impl Debugger {
    /// Runs on until something stops it, or no cycles are left.
    pub(super) fn run_on(&mut self, goal: Goal, origin: &Origin, left: &mut u64) -> Option<Stop> {
        while *left > 0 {
            *left -= 1;
            self.advance();
            self.log_here();
            if let Some(reason) = self.reason_here(goal, origin) {
                let at = self.now;
                return Some(Stop { reason, at });
            }
        }
        None
    }

    /// Why a run that has just come to this position stops here.
    fn reason_here(&self, goal: Goal, origin: &Origin) -> Option<Reason> {
        if let Some(end) = self.end_at(self.now) {
            return Some(end);
        }
        if let Goal::At(to) = goal {
            let reason = match to == origin.at + 1 {
                true => Reason::Step,
                false => Reason::There,
            };
            return (self.now == to).then_some(reason);
        }
        let last = self.now - 1;
        let step = self.run.program().at();
        if self.history.step(last) != step
            && let Some(id) = self.breakpoints.stops(step, &self.here())
        {
            return Some(Reason::Breakpoint(id));
        }
        let assigned = (self.watches).assigned(last, None, &self.history, &self.program);
        let set = || self.watches.set(self.now, None, &self.run.events);
        if let Some(watch) = assigned.or_else(set) {
            return Some(watch);
        }
        if let Some(fall) = self.fall.filter(|fall| fall.cycle == last)
            && self.stops_at_fall
        {
            return Some(Reason::Fall(fall));
        }
        goal.is_reached(origin, self).then(|| goal.reason())
    }

    /// How the run ended, if it did before this position.
    pub(super) fn end_at(&self, at: u64) -> Option<Reason> {
        match self.history.frontier {
            _ if at < self.history.len() => None,
            Frontier::Open => None,
            Frontier::Ended(end) => Some(Reason::Ended(end)),
            Frontier::Failed(emergency) => Some(Reason::Fault(emergency)),
        }
    }

    /// One cycle. What happens before the next one has happened then.
    fn advance(&mut self) {
        if self.now < self.history.len() {
            self.run.advance(None);
            self.now += 1;
        } else {
            self.explore();
        }
        self.run.happen();
        let step = self.run.program().at();
        let begins = self.history.step(self.now - 1) != step;
        let now = super::ask::Now {
            run: &self.run,
            at: self.now,
            asker: &self.asker,
        };
        self.breakpoints.count(begins.then_some(step), &now);
    }

    /// A cycle that nobody has seen.
    fn explore(&mut self) {
        let before = self.run.program().at();
        self.history.push(before, Self::depth(&self.run));
        let mut listener = Listener {
            at: self.now,
            said: &mut self.said,
            taken: &mut self.taken,
        };
        let status = self.run.advance(Some(&mut listener));
        self.now += 1;
        let frontier = match (status, self.run.emergency()) {
            (Status::Finished(end), _) => Frontier::Ended(end),
            (Status::Emergency, Some(emergency)) => Frontier::Failed(emergency),
            _ => Frontier::Open,
        };
        self.history.reached(self.run.program().at(), frontier);
        if self.fall.is_none() {
            self.fall = self.run.first_fall();
        }
        if frontier == Frontier::Open {
            self.marks.note(self.now, &self.run);
        }
    }

    /// Goes to a position that is known.
    pub(super) fn seek(&mut self, to: u64) {
        if let Some((at, mark)) = self.marks.before(to)
            && (self.now > to || self.now < *at)
        {
            self.run.restore(mark);
            self.now = *at;
            self.run.happen();
        }
        while self.now < to.min(self.history.len()) {
            self.advance();
        }
    }
}

/// Keeps what the program says.
struct Listener<'a> {
    at: u64,
    said: &'a mut Vec<(u64, String)>,
    taken: &'a mut usize,
}

impl Sink for Listener<'_> {
    fn say(&mut self, text: &dyn Display) {
        if self.said.len() >= 2 * MESSAGES {
            self.said.drain(..MESSAGES);
            *self.taken = self.taken.saturating_sub(MESSAGES);
        }
        self.said.push((self.at, text.to_string()));
    }
}
