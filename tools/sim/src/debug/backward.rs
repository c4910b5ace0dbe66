//! Backwards: a search through what is kept of every cycle, which runs a stretch again only where a condition asks it to.

use super::Debugger;
use super::ask::Now;
use super::breakpoints::Known;
use super::goal::{Goal, Origin};
use super::progress::Progress;
use super::stop::{Reason, Stop};
use crate::run::Run;

/// A search under way.
#[derive(Debug)]
pub(super) struct Back {
    /// Positions from here on are searched.
    below: u64,
    /// Runs stretches again; there is one as soon as one is needed.
    scout: Option<Run>,
    stretch: Option<Stretch>,
}

/// From a mark on, positions where conditions decide.
#[derive(Debug)]
struct Stretch {
    from: u64,
    /// Where the scout is.
    at: u64,
    /// In order, those that are not asked yet.
    asks: std::vec::IntoIter<u64>,
    /// The last one that stops.
    best: Option<Stop>,
}

/// What is known of a position before the origin.
enum Found {
    Nothing,
    Stops(Reason),
    Asks,
}

impl Back {
    pub(super) fn new(now: u64) -> Self {
        Back {
            below: now,
            scout: None,
            stretch: None,
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
    /// Searches on until something is found, or no cycles are left.
    pub(super) fn look_back(
        &self,
        back: &mut Back,
        goal: Goal,
        origin: &Origin,
        left: &mut u64,
    ) -> Option<Stop> {
        loop {
            if let Some(stretch) = &mut back.stretch {
                if let Some(scout) = &mut back.scout
                    && !self.ask(stretch, scout, left)
                {
                    return None;
                }
                if let Some(stop) = stretch.best.take() {
                    return Some(stop);
                }
                back.below = stretch.from;
                back.stretch = None;
            }
            let last = match back.below.checked_sub(1) {
                Some(last) => last,
                None => {
                    let reason = Reason::Start;
                    return Some(Stop { reason, at: 0 });
                }
            };
            let (from, mark) = self.marks.before(last)?;
            let stretch = self.scan(*from, last, goal, origin);
            if !stretch.asks.as_slice().is_empty() {
                let scout = back.scout.get_or_insert_with(|| self.run.clone());
                scout.restore(mark);
            }
            back.stretch = Some(stretch);
        }
    }

    /// Looks through the positions from a mark on, the last one first, up to one that stops for certain.
    fn scan(&self, from: u64, last: u64, goal: Goal, origin: &Origin) -> Stretch {
        let mut asks = Vec::new();
        let mut best = None;
        for at in (from..=last).rev() {
            match self.found(at, goal, origin) {
                Found::Nothing => {}
                Found::Asks => asks.push(at),
                Found::Stops(reason) => {
                    best = Some(Stop { reason, at });
                    break;
                }
            }
        }
        asks.reverse();
        Stretch {
            from,
            at: from,
            asks: asks.into_iter(),
            best,
        }
    }

    fn found(&self, at: u64, goal: Goal, origin: &Origin) -> Found {
        if let Goal::Set(watch) = goal {
            let found = self.set_at(at, Some(watch));
            return found.map_or(Found::Nothing, Found::Stops);
        }
        let step = self.history.step(at);
        let known = match self.history.enters(at) {
            true => self.breakpoints.known(step, at),
            false => Known::No,
        };
        if let Known::Stops(id) = known {
            return Found::Stops(Reason::Breakpoint(id));
        }
        if let Some(watch) = self.set_at(at, None) {
            return Found::Stops(watch);
        }
        if let Some(fall) = self.fall.filter(|fall| fall.cycle == at)
            && self.stops_at_fall
        {
            return Found::Stops(Reason::Fall(fall));
        }
        match known {
            _ if goal.is_met(origin, at, &self.history, self) => Found::Stops(goal.reason()),
            Known::Asks => Found::Asks,
            _ => Found::Nothing,
        }
    }

    /// What is assigned between a position and the next one, if a watch is on it: that watch, or any.
    fn set_at(&self, at: u64, watch: Option<u32>) -> Option<Reason> {
        let assigned = (self.watches).assigned(at, watch, &self.history, &self.program);
        assigned.or_else(|| self.watches.set(at, watch, &self.run.events))
    }

    /// Runs a stretch again up to its last condition; says whether it came there.
    fn ask(&self, stretch: &mut Stretch, scout: &mut Run, left: &mut u64) -> bool {
        while let Some(to) = stretch.asks.as_slice().first().copied() {
            while stretch.at < to {
                if *left == 0 {
                    return false;
                }
                *left -= 1;
                scout.advance(None);
                stretch.at += 1;
            }
            scout.happen();
            let now = Now {
                run: scout,
                at: to,
                asker: &self.asker,
            };
            if let Some(id) = self.breakpoints.stops(self.history.step(to), &now) {
                let reason = Reason::Breakpoint(id);
                stretch.found(Stop { reason, at: to });
            }
            stretch.asks.next();
        }
        true
    }
}

impl Stretch {
    /// The later one of two stops counts; one that is certain is before all that are asked for.
    fn found(&mut self, stop: Stop) {
        if self.best.as_ref().is_none_or(|best| best.at < stop.at) {
            self.best = Some(stop);
        }
    }
}
