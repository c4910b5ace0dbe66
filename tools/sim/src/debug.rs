//! The engine of a debugger: a run that moves forwards and backwards.
//!
//! A position is the number of the cycle that comes next. The debugger moves along a [`Timeline`], and keeps the steps
//! of every cycle. While it stands still, the robot does as well: program and robot share one time.
//!
//! ```
//! use tip_sim::debug::{Debugger, Discard, Move, Reason, When};
//! use tip_sim::{Event, Robot, load};
//!
//! let robot = Robot::named("titan8")?;
//! let text = "3.1\nCount\nDEF_VAR N\nN = 0\nL:\nN += 1\nIF N < 500 GOTO L:\nEND\n";
//! let program = load("count.prg", text, &robot)?;
//! let mut debugger = Debugger::new(program.program().clone(), &robot)?;
//!
//! // Forwards to a condition, then back to who set N last.
//! let there = debugger.break_at_line(7, &When { condition: Some("N >= 300"), hits: None })?;
//! let stop = debugger.go(Move::Continue);
//! assert_eq!(stop.reason, Reason::Breakpoint(there.id));
//! assert_eq!(debugger.value("N")?, Some(300.0));
//! debugger.watch("N")?;
//! debugger.go(Move::ReverseContinue);
//! assert_eq!((debugger.line(), debugger.value("N")?), (6, Some(299.0)));
//!
//! // A change in the past is an event; what was run after it is discarded.
//! let change: Event = "set N=499".parse()?;
//! assert!(debugger.happens(change.clone(), Discard::Nothing).is_err());
//! debugger.happens(change, Discard::Later)?;
//! debugger.unwatch_all();
//! debugger.go(Move::Over);
//! assert_eq!(debugger.value("N")?, Some(500.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod breakpoints;
mod expressions;
mod moves;
mod stop;

pub use breakpoints::{Placed, When};
pub use expressions::{BreakCondition, Frame, Value, Variable, control};
pub use moves::Work;
pub use stop::{By, DebugError, Hits, HitsError, Move, Progress, Reason, Stop};

use crate::event;
use crate::event::{Event, Events};
use crate::interp::Interpreter;
use crate::motion::Fall;
use crate::robot::Robot;
use crate::run::Run;
use crate::timeline::Timeline;
use breakpoints::{Breakpoints, Watches};
use moves::PendingCommand;
use std::sync::Arc;
use tip_lint::query::QueryContext;
use tip_runtime::machine::{Emergency, Mismatch};
use tip_runtime::program::End;
use tipc::program::Program;

/// The cycles that a change may discard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Discard {
    /// No cycles: a change in the past is refused.
    Nothing,
    /// All known cycles after the change.
    Later,
}

/// A program on a simulated robot, to be run in both directions.
pub struct Debugger {
    program: Arc<Program>,
    asker: QueryContext,
    /// The run and its checkpoints.
    timeline: Timeline,
    history: History,
    breakpoints: Breakpoints,
    watches: Watches,
    stops_at_fall: bool,
    /// The first known fall.
    fall: Option<Fall>,
    said: Vec<(u64, String)>,
    /// Number of messages that have been taken.
    taken: usize,
    /// Output of log points that has not been taken.
    logged: Vec<(u64, String)>,
    pending: Option<PendingCommand>,
    stop: Stop,
    /// The thread that is looked at and stepped; 0 is the main program.
    selected: u8,
    next_id: u32,
}

impl Debugger {
    /// Creates a debugger of a program on a robot, before its first cycle.
    ///
    /// # Errors
    /// The program was checked for another robot.
    pub fn new(program: impl Into<Arc<Program>>, robot: &Robot) -> Result<Self, Mismatch> {
        let program = program.into();
        let run = Run::new(Interpreter::new(program.clone()), robot.clone())?;
        Ok(Self::of(run, program, robot))
    }

    fn of(run: Run, program: Arc<Program>, robot: &Robot) -> Self {
        let mut debugger = Debugger {
            asker: QueryContext::new(&program, robot.options(), expressions::OWN_NAMES),
            timeline: Timeline::new(run, ()),
            history: History::default(),
            breakpoints: Breakpoints::new(program.steps().len()),
            watches: Watches::default(),
            stops_at_fall: false,
            fall: None,
            said: Vec::new(),
            taken: 0,
            logged: Vec::new(),
            pending: None,
            stop: Stop {
                reason: Reason::Start,
                at: 0,
                thread: 0,
            },
            selected: 0,
            next_id: 1,
            program,
        };
        debugger.history.next = debugger.next_steps();
        debugger
    }

    /// Sets if the debugger stops where the robot falls.
    pub fn stop_at_fall(&mut self, on: bool) {
        self.stops_at_fall = on;
    }

    /// Returns the position: the cycle that comes next.
    pub fn now(&self) -> u64 {
        self.timeline.now()
    }

    /// Returns the number of cycles that have been run.
    pub fn known(&self) -> u64 {
        self.history.len()
    }

    /// Returns the reason and the position of the last stop.
    pub fn stop(&self) -> &Stop {
        &self.stop
    }

    /// Returns the program.
    pub fn program(&self) -> &Arc<Program> {
        &self.program
    }

    /// Returns the run where the debugger stands.
    pub fn run(&self) -> &Run {
        self.timeline.run()
    }

    /// Returns the interpreter; every run of a debugger has one.
    fn interpreter(run: &Run) -> Option<&Interpreter> {
        run.engine()
    }

    /// Returns the number of open calls of the main program (0) or a thread.
    fn depth(run: &Run, thread: u8) -> u8 {
        let calls = Self::interpreter(run).map_or(0, |engine| engine.calls(thread.into()).len());
        u8::try_from(calls).unwrap_or(u8::MAX)
    }

    /// Returns the step that the main program and each running thread takes next, in the order of their turns.
    fn next_steps(&self) -> Vec<Taken> {
        let run = self.run();
        let threads = (1..).zip(self.program.threads()).map(|(thread, _)| thread);
        let running = threads.filter(|thread| run.thread_runs(*thread));
        let turns = std::iter::once(0).chain(running);
        let taken = turns.map(|thread| Taken {
            step: run.step_of(thread),
            thread,
            depth: Self::depth(run, thread),
        });
        taken.collect()
    }

    /// Returns the thread that is looked at: the selected one if it runs, else the main program (0).
    pub fn thread(&self) -> u8 {
        match self.run().thread_runs(self.selected) {
            true => self.selected,
            false => 0,
        }
    }

    /// Selects the thread that is looked at, and that steps are of; 0 is the main program.
    pub fn select(&mut self, thread: u8) {
        self.selected = thread;
    }

    /// Returns the numbers of the main program (0) and of the threads that run, in the order of their turns.
    pub fn threads(&self) -> Vec<u8> {
        let next = self.next_steps().into_iter();
        next.map(|taken| taken.thread).collect()
    }

    /// Returns the name of a thread; none for the main program.
    pub fn thread_name(&self, thread: u8) -> Option<&str> {
        let index = usize::from(thread).checked_sub(1)?;
        self.program
            .threads()
            .get(index)
            .map(|thread| &*thread.name)
    }

    fn new_id(&mut self) -> u32 {
        let id = self.next_id;
        self.next_id += 1;
        id
    }
}

impl Debugger {
    /// Adds events that happen in every branch. It must be called before the first cycle.
    ///
    /// # Errors
    /// The robot or the program lacks what they change.
    pub fn with_events(mut self, events: &Events) -> Result<Self, event::Refused> {
        self.timeline.script(events)?;
        self.timeline.happen();
        Ok(self)
    }

    /// Adds an event at this position, such as a key, the voltage of an input or another value of a variable. Its
    /// effect is visible immediately, and it happens again whenever the run is replayed. Later changes by the user are
    /// discarded with the cycles after this one.
    ///
    /// # Errors
    /// The program is over, the robot or the program lacks what it changes, or cycles would be discarded.
    pub fn happens(&mut self, event: Event, discard: Discard) -> Result<(), DebugError> {
        let now = self.now();
        if self.end_at(now).is_some() {
            return Err(DebugError::Ended);
        }
        let later = self.history.len() - now;
        if later > 0 && discard == Discard::Nothing {
            return Err(DebugError::WouldDiscard(later));
        }
        self.run().accepts(&event).map_err(DebugError::Event)?;
        self.pending = None;
        self.forget_later();
        self.timeline.add(event).map_err(DebugError::Event)?;
        self.timeline.happen();
        self.stop = Stop {
            reason: Reason::Change,
            at: now,
            thread: self.thread(),
        };
        Ok(())
    }

    /// Returns the user's changes, in the order in which they happen.
    pub fn changes(&self) -> Events {
        self.timeline.changes().clone()
    }

    /// Discards the records of the cycles from this position on.
    fn forget_later(&mut self) {
        let now = self.now();
        self.timeline.branch();
        let next = self.next_steps();
        self.history.truncate(now, next);
        self.breakpoints.truncate(now);
        self.said.retain(|(at, _)| *at < now);
        self.taken = self.taken.min(self.said.len());
        self.fall = self.fall.filter(|fall| fall.cycle < now);
    }
}

/// Maximum number of messages that are kept.
const MESSAGES: usize = 10_000;

/// State of the run after the last known cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Frontier {
    /// The run goes on.
    #[default]
    Open,
    /// The program ended.
    Ended(End),
    /// The last step failed, and changed nothing.
    Failed(Emergency),
}

/// A step of the main program or of a thread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Taken {
    step: u32,
    /// 0 for the main program.
    thread: u8,
    /// Number of calls that were open before it.
    depth: u8,
}

/// The steps of every cycle, in order: those of the main program, then those of each thread.
#[derive(Debug, Default)]
struct History {
    taken: Vec<Taken>,
    /// The place in `taken` of the first step of each cycle.
    cycles: Vec<usize>,
    /// The steps that begin the turns after the last known cycle.
    next: Vec<Taken>,
    frontier: Frontier,
}

impl History {
    fn len(&self) -> u64 {
        self.cycles.len() as u64
    }

    /// Adds the steps of a cycle that was run for the first time, and the state after it.
    fn push(&mut self, taken: Vec<Taken>, next: Vec<Taken>, frontier: Frontier) {
        self.cycles.push(self.taken.len());
        self.taken.extend(taken);
        self.next = next;
        self.frontier = frontier;
    }

    /// Removes everything from a position on, at which the steps `next` come next.
    fn truncate(&mut self, at: u64, next: Vec<Taken>) {
        if let Some(first) = self.cycles.get(place(at)) {
            self.taken.truncate(*first);
        }
        self.cycles.truncate(place(at));
        self.next = next;
        self.frontier = Frontier::Open;
    }

    /// Returns the steps of a known cycle. For the cycle after the last one, returns the first step of each turn.
    fn cycle(&self, at: u64) -> &[Taken] {
        let Some(first) = self.cycles.get(place(at)) else {
            return &self.next;
        };
        let after = self.cycles.get(place(at) + 1);
        let after = after.copied().unwrap_or(self.taken.len());
        self.taken.get(*first..after).unwrap_or_default()
    }

    /// Returns the first step of the turn of the main program (0) or a thread.
    fn first(&self, at: u64, thread: u8) -> Option<Taken> {
        let mut taken = self.cycle(at).iter();
        taken.find(|taken| taken.thread == thread).copied()
    }

    /// Iterates over the steps that begin at a position. These are the steps inside the turns that have just ended,
    /// since there are no positions inside a turn, and then the first steps of the next turns, unless they continue the
    /// last step of the turn before.
    fn begins(&self, at: u64) -> impl Iterator<Item = Taken> {
        let before = at.checked_sub(1).map_or(&[][..], |at| self.cycle(at));
        let pairs = before.iter().zip(before.iter().skip(1));
        let inside = pairs.filter(|(last, taken)| last.thread == taken.thread);
        let inside = inside.filter(|(last, taken)| last.step != taken.step);
        let inside = inside.map(|(_, taken)| *taken);
        let now = self.cycle(at);
        let firsts = now.iter().enumerate().filter(|(place, taken)| {
            let last = place.checked_sub(1).and_then(|place| now.get(place));
            last.is_none_or(|last| last.thread != taken.thread)
        });
        let firsts = firsts.map(|(_, taken)| *taken).filter(|taken| {
            let last = before.iter().rfind(|last| last.thread == taken.thread);
            last.is_none_or(|last| last.step != taken.step)
        });
        inside.chain(firsts)
    }

    /// Returns true if the turn of a thread begins with a new step at a position.
    fn enters(&self, at: u64, thread: u8) -> bool {
        let first = self.first(at, thread);
        first.is_some_and(|first| self.begins(at).any(|taken| taken == first))
    }

    /// Returns true if the last step of a cycle failed, and so changed nothing.
    fn fails(&self, at: u64) -> bool {
        matches!(self.frontier, Frontier::Failed(_)) && at + 1 == self.len()
    }
}

fn place(at: u64) -> usize {
    usize::try_from(at).unwrap_or(usize::MAX)
}
