//! The search for inputs that reach new coverage points. Runs that reached new points are varied, most often just
//! before cycles in which a condition has had only one outcome so far. If the engines differ, the inputs are shrunk.
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
//! assert_eq!(search::inputs(&program), [Event::Key(b'H'), Event::Key(b'Z')]);
//!
//! // Two interpreters agree; the search finds the key that leads to MESSAGE.
//! let lockstep = Lockstep::new(program.clone(), Interpreter::new(program.clone()), &robot)?;
//! let mut engines = Session::new(lockstep);
//! let inputs = Inputs { cycles: Some(100), ..Inputs::default() };
//! let (coverage, diverging) = search::verify(&mut engines, &program, &inputs, 20)?;
//! assert!(diverging.is_none());
//! assert!((0..coverage.reach.points().all().len()).all(|point| coverage.reach.has(point)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::event::{Event, Inputs, Timed};
use crate::lockstep::{Answer, Divergence, ReachedPoints, RunEnd, Session};
use std::collections::BTreeSet;
use std::convert::Infallible;
use std::fmt;
use tip_runtime::command::Port;
use tip_runtime::random::Random;
use tipc::language::flags::{self, Cause};
use tipc::program::{Action, Condition, Operand, Program};

/// Two engines that run the same program, in this process or another one.
pub trait Engines {
    /// The error if they cannot run.
    type Error;

    /// Runs both engines once.
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

/// The reason why a search has no result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failed<E> {
    /// The robot lacks a requested input.
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

/// Compares the engines of a program: in one run if `inputs` has events, else in `runs` runs with searched inputs.
/// Returns the coverage, and the shortest inputs on which the engines differ.
///
/// # Errors
/// The robot lacks an input, or the engines fail.
pub fn verify<E: Engines>(
    engines: &mut E,
    program: &Program,
    inputs: &Inputs,
    runs: u64,
) -> Result<(Coverage, Option<Diverging>), Failed<E::Error>> {
    let mut coverage = Coverage::new(program);
    let diverging = if inputs.events.is_empty() {
        Search::new(engines, &mut coverage, inputs.cycles).run(program, runs)?
    } else {
        match coverage.run(engines, inputs)? {
            RunResult::Diverged(diverging) => Some(diverging),
            RunResult::Agreed { .. } => None,
        }
    };
    let shortest = diverging.map(|diverging| shrink(engines, diverging));
    let shortest = shortest.transpose().map_err(Failed::Engines)?;
    Ok((coverage, shortest))
}

/// Seed of the search, so that every search of a program is the same.
const SEED: u64 = 1;
/// Number of parts of the run without events at whose starts the first variations have their event.
const PARTS: u64 = 4;
/// Maximum number of cycles by which an event precedes a chance.
const AHEAD: u64 = 4;
/// Maximum number of repetitions of an event.
const REPEATS: u64 = 12;

/// A run that reached new points.
#[derive(Clone, Debug)]
struct Seed {
    events: Vec<Timed>,
    cycles: u64,
    chances: Vec<u64>,
}

/// A search.
struct Search<'a, E> {
    engines: &'a mut E,
    coverage: &'a mut Coverage,
    /// Maximum number of cycles of each run.
    cycles: Option<u64>,
    seeds: Vec<Seed>,
    random: Random,
}

impl<'a, E: Engines> Search<'a, E> {
    /// Creates a search that adds its runs to a coverage.
    fn new(engines: &'a mut E, coverage: &'a mut Coverage, cycles: Option<u64>) -> Self {
        Search {
            engines,
            coverage,
            cycles,
            seeds: Vec::new(),
            random: Random::new(SEED),
        }
    }

    /// Makes `runs` runs, or a single one if no event matters to the program. Ends at the first difference between the
    /// engines.
    fn run(mut self, program: &Program, runs: u64) -> Result<Option<Diverging>, Failed<E::Error>> {
        let choices = inputs(program);
        if let Some(diverging) = self.attempt(Vec::new())? {
            return Ok(Some(diverging));
        }
        let length = self.seeds.first().map_or(0, |seed| seed.cycles);
        let mut planned = first(&choices, length).into_iter();
        while !choices.is_empty() && self.coverage.runs() < runs {
            let events = planned.next().unwrap_or_else(|| self.varied(&choices));
            if let Some(diverging) = self.attempt(events)? {
                return Ok(Some(diverging));
            }
        }
        Ok(None)
    }

    fn attempt(&mut self, events: Vec<Timed>) -> Result<Option<Diverging>, Failed<E::Error>> {
        let inputs = of_events(&events, self.cycles);
        match self.coverage.run(self.engines, &inputs)? {
            RunResult::Diverged(diverging) => Ok(Some(diverging)),
            RunResult::Agreed {
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

    /// Returns the events of a run that reached new points, more likely a late one, with one to three changes.
    fn varied(&mut self, choices: &[Event]) -> Vec<Timed> {
        let count = self.seeds.len() as u64;
        let which = self.random.below(count).max(self.random.below(count));
        let Some(seed) = self.seeds.get(which as usize).cloned() else {
            return Vec::new();
        };
        let mut events = seed.events.clone();
        for _ in 0..=self.random.below(3) {
            match self.random.below(6) {
                0 => {
                    let drop = self.random.index(events.len());
                    events = [&events[..drop], events.get(drop + 1..).unwrap_or_default()].concat();
                }
                1 => {
                    let which = self.random.index(events.len());
                    let cycle = self.moment(&seed);
                    events
                        .get_mut(which)
                        .into_iter()
                        .for_each(|event| event.cycle = cycle);
                }
                2 => self.repeat(choices, &seed, &mut events),
                _ => {
                    let cycle = self.moment(&seed);
                    let what = self.random.pick(choices);
                    events.extend(what.map(|what| what.clone().at(cycle)));
                }
            }
        }
        events
    }

    /// Adds an event several times, for programs that count.
    fn repeat(&mut self, choices: &[Event], seed: &Seed, events: &mut Vec<Timed>) {
        let Some(what) = self.random.pick(choices).cloned() else {
            return;
        };
        let (from, times) = (self.moment(seed), 2 + self.random.below(REPEATS));
        let apart = 1 + self.random.below(1 + seed.cycles / times);
        events.extend((0..times).map(|n| what.clone().at(from + n * apart)));
    }

    /// Draws a cycle, most often shortly before a chance.
    fn moment(&mut self, seed: &Seed) -> u64 {
        let by_chance = self.random.below(4) > 0;
        match self.random.pick(&seed.chances).copied() {
            Some(chance) if by_chance => chance.saturating_sub(self.random.below(AHEAD)),
            _ => self.random.below(1 + seed.cycles),
        }
    }
}

/// Returns inputs with some events. Only the first of several halt requests is kept.
fn of_events(events: &[Timed], cycles: Option<u64>) -> Inputs {
    let mut events = events.to_vec();
    events.sort_by_key(|timed| timed.cycle);
    let mut halted = false;
    events.retain(|timed| timed.event != Event::Halt || !std::mem::replace(&mut halted, true));
    Inputs {
        events: events.into(),
        cycles,
    }
}

/// Returns each input alone, at the start of each part of a run of this length.
fn first(choices: &[Event], length: u64) -> Vec<Vec<Timed>> {
    let starts = (0..PARTS).map(|part| part * length / PARTS);
    let at = |cycle| choices.iter().map(move |what| vec![what.clone().at(cycle)]);
    starts.flat_map(at).collect()
}

/// Shrinks by dropping and moving events until nothing helps any more.
///
/// # Errors
/// The engines fail.
pub fn shrink<E: Engines>(engines: &mut E, diverging: Diverging) -> Result<Diverging, E::Error> {
    let mut events = diverging.inputs.events.all().to_vec();
    // The order in which the kinds of events are tried.
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
    // The run ends with the cycle that differs.
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

/// Inputs on which the engines differ.
#[derive(Clone, Debug)]
pub struct Diverging {
    /// The inputs of the run.
    pub inputs: Inputs,
    /// The first difference.
    pub divergence: Divergence,
}

/// Result of one run.
#[derive(Clone, Debug)]
pub enum RunResult {
    /// The engines agree.
    Agreed {
        /// Number of cycles that were compared.
        cycles: u64,
        /// True if it reached a point that no run before it did.
        is_new: bool,
        /// Cycles where another input may change the path.
        chances: Vec<u64>,
    },
    /// The engines differ.
    Diverged(Diverging),
}

/// Results of all runs.
#[derive(Debug)]
pub struct Coverage {
    /// The points that they reached.
    pub reach: ReachedPoints,
    /// Cycles that were compared.
    pub cycles: u64,
    /// Runs to END or EXIT.
    pub finished: u64,
    /// Runs to the last cycle allowed.
    pub limited: u64,
    /// Runs to an emergency stop.
    pub stopped: u64,
}

impl Coverage {
    /// Creates a coverage without runs.
    pub fn new(program: &Program) -> Self {
        Coverage {
            reach: ReachedPoints::new(program),
            cycles: 0,
            finished: 0,
            limited: 0,
            stopped: 0,
        }
    }

    /// Returns the number of runs.
    pub fn runs(&self) -> u64 {
        self.finished + self.limited + self.stopped
    }

    /// Runs once and adds the result.
    ///
    /// # Errors
    /// The robot lacks an input, or the engines fail.
    pub fn run<E: Engines>(
        &mut self,
        engines: &mut E,
        inputs: &Inputs,
    ) -> Result<RunResult, Failed<E::Error>> {
        match engines.ask(inputs).map_err(Failed::Engines)? {
            Answer::Refused(reason) => Err(Failed::Refused(reason)),
            Answer::Diverged(divergence) => Ok(RunResult::Diverged(Diverging {
                inputs: inputs.clone(),
                divergence,
            })),
            Answer::Agreed {
                cycles,
                end,
                new,
                chances,
            } => {
                self.cycles += cycles;
                *match end {
                    RunEnd::Finished => &mut self.finished,
                    RunEnd::Limit => &mut self.limited,
                    RunEnd::Emergency => &mut self.stopped,
                } += 1;
                for point in &new {
                    self.reach.add(*point);
                }
                Ok(RunResult::Agreed {
                    cycles,
                    is_new: !new.is_empty(),
                    chances,
                })
            }
        }
    }
}

/// Codes of the keys that a program can get.
const KEYS: std::ops::RangeInclusive<f64> = 32.0..=126.0;
/// Range of the inputs' readings, V.
const VOLTS: std::ops::RangeInclusive<f64> = -10.0..=10.0;

/// Returns every single event that can affect a program.
pub fn inputs(program: &Program) -> Vec<Event> {
    let mut takes_keys = false;
    let mut takes_halts = false;
    let mut ports = Vec::new();
    let mut numbers = Vec::new();
    for step in program.steps() {
        match step.action {
            Action::KeyIn { .. } => takes_keys = true,
            // Channels have no name for a command line.
            Action::AdIn { port, .. } if !matches!(port, Port::Channel(_)) => ports.push(port),
            _ => {}
        }
        match step.action.condition() {
            Some(Condition::Flag { flag, .. }) => match flags::row(*flag).map(|row| row.cause) {
                Some(Cause::Key) => takes_keys = true,
                Some(Cause::Halt) => takes_halts = true,
                Some(Cause::Input(port)) => ports.push(port),
                Some(Cause::Robot) | None => {}
            },
            Some(Condition::Compare { left, right, .. }) => {
                numbers.extend([left, right].into_iter().filter_map(constant));
            }
            None => {}
        }
    }
    ports.sort_by_key(|port| format!("{port:?}"));
    ports.dedup();
    let keys = if takes_keys {
        keys(&numbers)
    } else {
        BTreeSet::new()
    };
    let keys = keys.into_iter().map(Event::Key);
    let halt = takes_halts.then_some(Event::Halt);
    let volts = volts(&numbers);
    let sensors = ports
        .iter()
        .flat_map(|port| volts.iter().map(|volts| Event::Sensor(*port, *volts)));
    keys.chain(halt).chain(sensors).collect()
}

fn constant(operand: &Operand) -> Option<f64> {
    match operand {
        Operand::Constant(number) => Some(*number),
        Operand::Scalar { .. } | Operand::Reading { .. } => None,
    }
}

/// Returns the keys in conditions, and one that is in none.
fn keys(numbers: &[f64]) -> BTreeSet<u8> {
    let codes = numbers.iter().filter(|number| KEYS.contains(number));
    let mut keys: BTreeSet<u8> = codes.map(|number| *number as u8).collect();
    keys.extend((b'A'..=b'Z').rev().find(|key| !keys.contains(key)));
    keys
}

/// Returns values below, at and above each number in conditions, and both ends of the range.
fn volts(numbers: &[f64]) -> Vec<f64> {
    let around = numbers
        .iter()
        .flat_map(|number| [number - 0.5, *number, number + 0.5]);
    let mut volts: Vec<f64> = around
        .chain([0.0, 5.0, 10.0])
        .filter(|volts| VOLTS.contains(volts))
        .collect();
    volts.sort_by(f64::total_cmp);
    volts.dedup();
    volts
}
