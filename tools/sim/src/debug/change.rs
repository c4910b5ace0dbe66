//! What a debugger's user makes happen.

use super::stop::{Reason, Stop};
use super::{Debugger, Refused};
use crate::event::{Event, Events, Timed};
use crate::refused;

/// What may be given up for a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Discard {
    /// Nothing: in the past a change is refused.
    Nothing,
    /// All that was run after the change.
    Later,
}

impl Debugger {
    /// Adds events that are to happen in any case; before the first cycle.
    ///
    /// # Errors
    /// The robot or the program lacks what they change.
    pub fn with_events(mut self, events: &Events) -> Result<Self, refused::Refused> {
        self.run = self.run.with_events(events)?;
        self.run.happen();
        Ok(self)
    }

    /// Makes something happen at this position: a key, the voltage of an input, another value of a variable. It shows at once,
    /// and happens again whenever the run comes here. What the user had made happen later is discarded with the cycles after
    /// this one.
    ///
    /// # Errors
    /// The program is over, the robot or the program lacks what it changes, or cycles would be discarded.
    pub fn happens(&mut self, event: Event, discard: Discard) -> Result<(), Refused> {
        if self.end_at(self.now).is_some() {
            return Err(Refused::Ended);
        }
        let later = self.history.len() - self.now;
        if later > 0 && discard == Discard::Nothing {
            return Err(Refused::WouldDiscard(later));
        }
        let event = event.at(self.now);
        self.run.add(event.clone()).map_err(Refused::Event)?;
        self.errand = None;
        self.forget_later();
        self.changes.push(event);
        self.run.happen();
        self.stop = Stop {
            reason: Reason::Change,
            at: self.now,
        };
        Ok(())
    }

    /// What its user made happen, in the order in which it happens.
    pub fn changes(&self) -> Events {
        self.changes.iter().cloned().collect()
    }

    /// Discards what is known of the cycles from here on.
    fn forget_later(&mut self) {
        let now = self.now;
        self.history.truncate(now, self.run.program().at());
        self.marks.truncate(now);
        self.breakpoints.truncate(now);
        self.said.retain(|(at, _)| *at < now);
        self.taken = self.taken.min(self.said.len());
        self.fall = self.fall.filter(|fall| fall.cycle < now);
        let mut dropped: Vec<Timed> = self.changes.extract_if(.., |one| one.cycle > now).collect();
        self.run.events.retain(|event| {
            let place = dropped.iter().position(|one| one == event);
            place.map(|place| dropped.swap_remove(place)).is_none()
        });
    }
}
