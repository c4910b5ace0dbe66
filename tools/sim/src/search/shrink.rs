//! The shortest inputs on which the engines still differ: the fewest events, each as early as can be, the fewest cycles.

use super::{Diverging, Engines};
use crate::event::{Event, Inputs, Timed};
use crate::lockstep::Answer;

/// Shrinks by dropping and moving events until nothing helps any more.
///
/// # Errors
/// The engines fail.
pub fn shrink<E: Engines>(engines: &mut E, diverging: Diverging) -> Result<Diverging, E::Error> {
    let mut events = diverging.inputs.events.all().to_vec();
    // The order of the options, which are tried one after the other.
    events.sort_by_key(|timed| match timed.event {
        Event::Key(_) => 0,
        Event::Sensor(..) => 1,
        Event::Halt => 2,
        _ => 3,
    });
    let mut shrinking = Shrinking {
        events,
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
    best.inputs.events = shrinking.events.into();
    best.inputs.cycles = Some(best.divergence.cycle + 1);
    Ok(best)
}

struct Shrinking<'a, E> {
    engines: &'a mut E,
    events: Vec<Timed>,
    best: Diverging,
}

impl<E: Engines> Shrinking<'_, E> {
    /// Keeps the events if the engines still differ.
    fn attempt(&mut self, events: Vec<Timed>) -> Result<bool, E::Error> {
        let inputs = Inputs {
            events: events.clone().into(),
            cycles: self.best.inputs.cycles,
        };
        let Answer::Diverged(divergence) = self.engines.ask(&inputs)? else {
            return Ok(false);
        };
        self.best = Diverging { inputs, divergence };
        self.events = events;
        Ok(true)
    }

    /// Drops events, many at once first.
    fn drop_events(&mut self) -> Result<(), E::Error> {
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
    fn advance_events(&mut self) -> Result<(), E::Error> {
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
