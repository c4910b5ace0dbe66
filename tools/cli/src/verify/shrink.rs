//! The shortest inputs on which the engines still differ: the fewest events, each as early as can be, the fewest cycles.

use super::super::error::Error;
use super::engines::Engines;
use super::events::{self, Event};
use super::tally::Diverging;
use tipc::lockstep::Answer;

/// Shrinks by dropping and moving events until nothing helps any more.
pub(super) fn shrink(engines: &mut Engines, diverging: Diverging) -> Result<Diverging, Error> {
    let mut shrinking = Shrinking {
        events: events::of(&diverging.inputs),
        best: diverging,
        engines,
    };
    loop {
        let before = shrinking.events.clone();
        shrinking.drop_events()?;
        shrinking.advance_events()?;
        if shrinking.events == before {
            break;
        }
    }
    // The last cycle is the one that differs.
    let mut best = shrinking.best;
    best.inputs = events::inputs(&shrinking.events, Some(best.divergence.cycle + 1));
    Ok(best)
}

struct Shrinking<'a> {
    engines: &'a mut Engines,
    events: Vec<Event>,
    best: Diverging,
}

impl Shrinking<'_> {
    /// Keeps the events if the engines still differ.
    fn attempt(&mut self, events: Vec<Event>) -> Result<bool, Error> {
        let inputs = events::inputs(&events, self.best.inputs.cycles);
        let Answer::Diverged(divergence) = self.engines.ask(&inputs)? else {
            return Ok(false);
        };
        self.best = Diverging { inputs, divergence };
        self.events = events;
        Ok(true)
    }

    /// Drops events, many at once first.
    fn drop_events(&mut self) -> Result<(), Error> {
        let mut size = self.events.len();
        while size > 0 {
            let mut from = 0;
            while from < self.events.len() {
                let mut fewer = self.events.clone();
                fewer.drain(from..fewer.len().min(from + size));
                if !self.attempt(fewer)? {
                    from += size;
                }
            }
            size /= 2;
        }
        Ok(())
    }

    /// Moves each event to an earlier cycle: the earliest that bisection finds.
    fn advance_events(&mut self) -> Result<(), Error> {
        for which in 0..self.events.len() {
            let mut too_early = None;
            while self.events[which].cycle > too_early.map_or(0, |cycle: u64| cycle + 1) {
                let mut events = self.events.clone();
                let last = events[which].cycle;
                let cycle = too_early.map_or(0, |early: u64| early + (last - early) / 2);
                events[which].cycle = cycle;
                if !self.attempt(events)? {
                    too_early = Some(cycle);
                }
            }
        }
        Ok(())
    }
}
