//! The search for inputs that lead where no run has been: runs that reached something new are varied, most often
//! just before cycles in which a condition has had only one outcome so far. Where the engines differ the inputs are shrunk.
//!
//! ```
//! use tip_sim::event::{Event, Inputs};
//! use tip_sim::lockstep::{Lockstep, Session};
//! use tip_sim::{Interpreter, Robot, load, search};
//!
//! let robot = Robot::named("titan8")?;
//! let text = "3.1\nGreet\nKEY_IN\nIF VAR_KEY == CHAR_H THEN\nMESSAGE hello\nENDIF\nEND";
//! let program = load("greet.prg", text, &robot)?.program().clone();
//!
//! // What matters to it: the key that it asks for, and one that it does not.
//! assert_eq!(search::levers(&program), [Event::Key(b'H'), Event::Key(b'Z')]);
//!
//! // Two interpreters agree; the search finds the key that leads to MESSAGE.
//! let lockstep = Lockstep::new(program.clone(), Interpreter::new(program.clone()), &robot)?;
//! let mut engines = Session::new(lockstep);
//! let inputs = Inputs { cycles: Some(100), ..Inputs::default() };
//! let (tally, diverging) = search::verify(&mut engines, &program, &inputs, 20)?;
//! assert!(diverging.is_none());
//! assert!((0..tally.reach.spots().all().len()).all(|spot| tally.reach.has(spot)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod levers;
mod random;
mod shrink;
mod tally;

pub use levers::levers;
pub use random::Random;
pub use shrink::shrink;
pub use tally::{Came, Diverging, Tally};

use crate::event::{Event, Inputs, Timed};
use crate::lockstep::{Answer, Session};
use std::convert::Infallible;
use std::fmt;
use tipc::program::Program;

/// Two engines that run the same program, wherever they are.
pub trait Engines {
    /// What keeps them from running.
    type Error;

    /// One run.
    ///
    /// # Errors
    /// There is no answer.
    fn ask(&mut self, inputs: &Inputs) -> Result<Answer, Self::Error>;
}

impl Engines for Session {
    type Error = Infallible;

    fn ask(&mut self, inputs: &Inputs) -> Result<Answer, Infallible> {
        Ok(self.answer(inputs))
    }
}

/// Why a search came to nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failed<E> {
    /// The robot lacks something that was asked for.
    Refused(String),
    /// The engines fail.
    Engines(E),
}

impl<E: fmt::Display> fmt::Display for Failed<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failed::Refused(reason) => reason.fmt(f),
            Failed::Engines(error) => error.fmt(f),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> std::error::Error for Failed<E> {}

/// Compares the engines of a program: in one run if something is to happen, else in `runs` runs with searched inputs.
/// Gives what the runs came to, and the shortest inputs on which the engines differ.
///
/// # Errors
/// The robot lacks an input, or the engines fail.
pub fn verify<E: Engines>(
    engines: &mut E,
    program: &Program,
    inputs: &Inputs,
    runs: u64,
) -> Result<(Tally, Option<Diverging>), Failed<E::Error>> {
    let mut tally = Tally::new(program);
    let diverging = if inputs.events.is_empty() {
        Search::new(engines, &mut tally, inputs.cycles).run(program, runs)?
    } else {
        match tally.run(engines, inputs)? {
            Came::Diverged(diverging) => Some(diverging),
            Came::Agreed { .. } => None,
        }
    };
    let shortest = diverging.map(|diverging| shrink(engines, diverging));
    let shortest = shortest.transpose().map_err(Failed::Engines)?;
    Ok((tally, shortest))
}

/// Every search of a program is the same.
const SEED: u64 = 1;
/// The first variations of the run without events fall into so many parts of it.
const PARTS: u64 = 4;
/// The most cycles that an event comes ahead of a chance.
const AHEAD: u64 = 4;
/// The most times that an event repeats itself.
const REPEATS: u64 = 12;

/// A run that reached something new.
#[derive(Clone, Debug)]
struct Seed {
    events: Vec<Timed>,
    cycles: u64,
    chances: Vec<u64>,
}

/// A search.
struct Search<'a, E> {
    engines: &'a mut E,
    tally: &'a mut Tally,
    /// The most cycles of each run.
    cycles: Option<u64>,
    seeds: Vec<Seed>,
    random: Random,
}

impl<'a, E: Engines> Search<'a, E> {
    /// A search that adds its runs to a tally.
    fn new(engines: &'a mut E, tally: &'a mut Tally, cycles: Option<u64>) -> Self {
        Search {
            engines,
            tally,
            cycles,
            seeds: Vec::new(),
            random: Random::new(SEED),
        }
    }

    /// Makes `runs` runs, or one only if nothing from outside matters to the program; ends at once where the engines differ.
    fn run(mut self, program: &Program, runs: u64) -> Result<Option<Diverging>, Failed<E::Error>> {
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

    fn attempt(&mut self, events: Vec<Timed>) -> Result<Option<Diverging>, Failed<E::Error>> {
        let inputs = inputs(&events, self.cycles);
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

    /// A run that reached something new, more likely a late one, with one to three changes.
    fn varied(&mut self, levers: &[Event]) -> Vec<Timed> {
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
                    events.extend(what.map(|what| what.clone().at(cycle)));
                }
            }
        }
        events
    }

    /// Adds the same event again and again, as counters ask for it.
    fn repeat(&mut self, levers: &[Event], seed: &Seed, events: &mut Vec<Timed>) {
        let Some(what) = self.random.pick(levers).cloned() else {
            return;
        };
        let (from, times) = (self.moment(seed), 2 + self.random.below(REPEATS));
        let apart = 1 + self.random.below(1 + seed.cycles / times);
        events.extend((0..times).map(|n| what.clone().at(from + n * apart)));
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

/// The inputs that some events make. Of several halt requests the first one counts.
fn inputs(events: &[Timed], cycles: Option<u64>) -> Inputs {
    let mut events = events.to_vec();
    events.sort_by_key(|timed| timed.cycle);
    let mut halted = false;
    events.retain(|timed| timed.event != Event::Halt || !std::mem::replace(&mut halted, true));
    Inputs {
        events: events.into(),
        cycles,
    }
}

/// Each lever alone, at the start of each part of a run of this length.
fn first(levers: &[Event], length: u64) -> Vec<Vec<Timed>> {
    let starts = (0..PARTS).map(|part| part * length / PARTS);
    let at = |cycle| levers.iter().map(move |what| vec![what.clone().at(cycle)]);
    starts.flat_map(at).collect()
}
