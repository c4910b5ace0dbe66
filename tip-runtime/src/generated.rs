//! Support for generated code, which is not part of the public API: [`version`](crate::version) ties generated code to
//! this crate.
//!
//! Every row of a table of states starts with a function, also one that is data: [`step`] loads it and jumps
//! there, without a branch on the kind of row and without keeping anything of its own.

use crate::command::{Command, Op, Target};
use crate::fault::Fault;
use crate::program::{CallStack, Context, Flow};

/// The function of a row, which gets the row itself.
pub type Run<P> = fn(&mut P, &mut dyn Context, Row<P>) -> Result<Flow, Fault>;

/// A row in its table.
pub type Row<P> = &'static Step<P>;

/// A row of a program's table of states.
#[derive(Clone, Copy, Debug)]
pub struct Step<P: 'static> {
    run: Run<P>,
    /// The command of a row of a command.
    command: &'static Command<'static>,
    /// The next row, for a row without code.
    next: u32,
}

/// A compiled program, as the rows of its table see it.
pub trait State: 'static {
    /// Returns the step that runs next.
    fn at_mut(&mut self) -> &mut u32;

    /// Goes on to a step, "taken". It never fails.
    fn go(&mut self, step: u32) -> Result<Flow, Fault>;
}

/// Placeholder in rows without a command.
const NOTHING: &Command<'static> = &Command {
    op: Op::Sleep,
    hs: false,
    target: Target::None,
    values: &[],
};

impl<P: State> Step<P> {
    /// Creates a row that executes a command with constant arguments until it is done, and then continues at `next`.
    pub const fn ask(command: &'static Command<'static>, next: u32) -> Self {
        Step {
            run: ask,
            command,
            next,
        }
    }

    /// Creates a row that only goes on.
    pub const fn go(next: u32) -> Self {
        Step {
            run: go,
            command: NOTHING,
            next,
        }
    }

    /// Creates a row with code.
    pub const fn run(run: Run<P>) -> Self {
        Step {
            run,
            command: NOTHING,
            next: 0,
        }
    }

    /// The row for a step that does not exist.
    const WRONG: Row<P> = &Step::run(wrong);
}

fn ask<P: State>(program: &mut P, cx: &mut dyn Context, row: Row<P>) -> Result<Flow, Fault> {
    cx.ask(row.command, program.at_mut(), row.next)
}

fn go<P: State>(program: &mut P, _: &mut dyn Context, row: Row<P>) -> Result<Flow, Fault> {
    program.go(row.next)
}

fn wrong<P>(_: &mut P, _: &mut dyn Context, _: Row<P>) -> Result<Flow, Fault> {
    Err(Fault::WrongStep)
}

/// Runs the program's present step.
///
/// # Errors
/// The fault that the step found.
#[inline]
pub fn step<P: State>(
    steps: &'static [Step<P>],
    program: &mut P,
    cx: &mut dyn Context,
) -> Result<Flow, Fault> {
    let row = match steps.get(*program.at_mut() as usize) {
        Some(row) => row,
        None => Step::WRONG,
    };
    (row.run)(program, cx, row)
}

/// The position of the main program or of a thread.
#[derive(Clone, Copy, Debug)]
pub struct Position {
    /// The step that runs next.
    pub at: u32,
    /// True if the step is reached from an IF or ELSEIF that was false.
    pub not_taken: bool,
    /// The open calls.
    pub calls: CallStack,
}

impl Position {
    /// Creates a place without open calls.
    pub const fn at(step: u32) -> Self {
        Position {
            at: step,
            not_taken: false,
            calls: CallStack::new(),
        }
    }
}

/// The positions of a program with threads: the main program's first, then those of threads. The position of the
/// selected one is in the program itself.
#[derive(Clone, Copy, Debug)]
pub struct Threads<const N: usize> {
    selected: u8,
    places: [Position; N],
}

impl<const N: usize> Threads<N> {
    /// Creates the places of a new program; the main program is selected.
    pub const fn new() -> Self {
        Threads {
            selected: 0,
            places: [Position::at(0); N],
        }
    }

    /// Selects the main program (0) or a thread: stores the present position and returns the other one.
    pub fn select(&mut self, thread: u8, present: Position) -> Position {
        if let Some(place) = self.places.get_mut(usize::from(self.selected)) {
            *place = present;
        }
        self.selected = thread;
        let place = self.places.get(usize::from(thread));
        place.copied().unwrap_or(present)
    }

    /// Returns the step of a thread. `present` is the step of the selected one.
    pub fn at(&self, thread: u8, present: u32) -> u32 {
        let place = self.places.get(usize::from(thread));
        match place {
            Some(place) if thread != self.selected => place.at,
            _ => present,
        }
    }

    /// Puts a thread that is not selected at its first step.
    pub fn begin(&mut self, thread: u8, step: u32) {
        if let Some(place) = self.places.get_mut(usize::from(thread)) {
            *place = Position::at(step);
        }
    }

    /// Ends the selected thread.
    ///
    /// # Errors
    /// The main program cannot end so: `InvalidReturn`.
    pub fn end(&self) -> Result<Flow, Fault> {
        match self.selected {
            0 => Err(Fault::InvalidReturn),
            _ => Ok(Flow::ThreadEnd),
        }
    }
}

impl<const N: usize> Default for Threads<N> {
    fn default() -> Self {
        Self::new()
    }
}

/// The version check between generated code and this crate.
pub mod version {
    /// The format version of generated code that this runtime accepts.
    pub const FORMAT: u32 = 5;

    /// Fails the build if code was generated for another runtime; generated code calls it in a
    /// constant.
    pub const fn require(format: u32) {
        assert!(
            format == FORMAT,
            "this program was generated by a tip of another version than tip-runtime: use the same version of tip, tip-macros and tip-runtime, and build again"
        );
    }
}
