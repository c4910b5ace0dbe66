//! The search for inputs that lead where no run was yet: runs that came by something new are varied, most often
//! just before cycles in which a condition went one way only so far.

use super::super::error::Error;
use super::engines::Engines;
use super::events::{self, Event, What};
use super::levers::levers;
use super::random::Random;
use super::tally::{Came, Diverging, Tally};
use tipc::program::Program;

/// Every search of a program is the same.
pub(super) const SEED: u64 = 1;
/// The first variations of the run without events fall into so many parts of it.
const PARTS: u64 = 4;
/// The most cycles that an event comes ahead of a chance.
const AHEAD: u64 = 4;
/// The most times that an event repeats itself.
const REPEATS: u64 = 12;

/// A run that came by something new.
#[derive(Clone, Debug)]
struct Seed {
    events: Vec<Event>,
    cycles: u64,
    chances: Vec<u64>,
}

/// A search.
pub(super) struct Search<'a> {
    engines: &'a mut Engines,
    tally: &'a mut Tally,
    /// The most cycles of each run.
    cycles: Option<u64>,
    seeds: Vec<Seed>,
    random: Random,
}

impl<'a> Search<'a> {
    /// A search that adds its runs to a tally.
    pub(super) fn new(engines: &'a mut Engines, tally: &'a mut Tally, cycles: Option<u64>) -> Self {
        Search {
            engines,
            tally,
            cycles,
            seeds: Vec::new(),
            random: Random::new(SEED),
        }
    }

    /// Makes `runs` runs, or one only if nothing from outside matters to the program; ends at once where the engines differ.
    pub(super) fn run(mut self, program: &Program, runs: u64) -> Result<Option<Diverging>, Error> {
        let levers = levers(program);
        if let Some(diverging) = self.attempt(Vec::new())? {
            return Ok(Some(diverging));
        }
        let length = self.seeds.first().map_or(0, |seed| seed.cycles);
        let mut planned = first(&levers, length).into_iter();
        while !levers.is_empty() && self.tally.runs() < runs {
            let events = planned.next().unwrap_or_else(|| self.varied(&levers));
            if let Some(diverging) = self.attempt(events)? {
                return Ok(Some(diverging));
            }
        }
        Ok(None)
    }

    fn attempt(&mut self, events: Vec<Event>) -> Result<Option<Diverging>, Error> {
        let inputs = events::inputs(&events, self.cycles);
        match self.tally.run(self.engines, &inputs)? {
            Came::Diverged(diverging) => Ok(Some(diverging)),
            Came::Agreed {
                cycles,
                is_new,
                chances,
            } => {
                if is_new {
                    self.seeds.push(Seed {
                        events,
                        cycles,
                        chances,
                    });
                }
                Ok(None)
            }
        }
    }

    /// A run that came by something new, more likely a late one, with one to three changes.
    fn varied(&mut self, levers: &[What]) -> Vec<Event> {
        let count = self.seeds.len() as u64;
        let which = self.random.below(count).max(self.random.below(count));
        let Some(seed) = self.seeds.get(which as usize).cloned() else {
            return Vec::new();
        };
        let mut events = seed.events.clone();
        for _ in 0..=self.random.below(3) {
            match self.random.below(6) {
                0 => {
                    let drop = self.random.below(events.len() as u64) as usize;
                    events = [&events[..drop], events.get(drop + 1..).unwrap_or_default()].concat();
                }
                1 => {
                    let which = self.random.below(events.len() as u64) as usize;
                    let cycle = self.moment(&seed);
                    events
                        .get_mut(which)
                        .into_iter()
                        .for_each(|event| event.cycle = cycle);
                }
                2 => self.repeat(levers, &seed, &mut events),
                _ => {
                    let cycle = self.moment(&seed);
                    let what = self.random.pick(levers);
                    events.extend(what.map(|what| Event { cycle, what: *what }));
                }
            }
        }
        events
    }

    /// Adds the same event again and again, as counters ask for it.
    fn repeat(&mut self, levers: &[What], seed: &Seed, events: &mut Vec<Event>) {
        let Some(what) = self.random.pick(levers).copied() else {
            return;
        };
        let (from, times) = (self.moment(seed), 2 + self.random.below(REPEATS));
        let apart = 1 + self.random.below(1 + seed.cycles / times);
        events.extend((0..times).map(|n| Event {
            cycle: from + n * apart,
            what,
        }));
    }

    /// Most often shortly before a chance, else any time.
    fn moment(&mut self, seed: &Seed) -> u64 {
        let by_chance = self.random.below(4) > 0;
        match self.random.pick(&seed.chances).copied() {
            Some(chance) if by_chance => chance.saturating_sub(self.random.below(AHEAD)),
            _ => self.random.below(1 + seed.cycles),
        }
    }
}

/// Each lever alone, at the start of each part of a run of this length.
fn first(levers: &[What], length: u64) -> Vec<Vec<Event>> {
    let starts = (0..PARTS).map(|part| part * length / PARTS);
    let at = |cycle| {
        levers
            .iter()
            .map(move |what| vec![Event { cycle, what: *what }])
    };
    starts.flat_map(at).collect()
}
