//! The interface of a compiled or interpreted program, and the robot that its steps can reach.
//!
//! Macros and build scripts make programs from text. This one is written by hand:
//!
//! ```
//! use tip_runtime::fault::Fault;
//! use tip_runtime::model::titan8;
//! use tip_runtime::program::{Context, End, Flow, Program, Signature, VariableError};
//!
//! /// `COUNT = COUNT + 1` in each cycle until it is 3.
//! struct Counting {
//!     at: u32,
//!     count: Option<f64>,
//! }
//!
//! impl Program for Counting {
//!     fn signature(&self) -> Signature {
//!         titan8::MODEL.signature()
//!     }
//!     fn name(&self) -> &str {
//!         "counting"
//!     }
//!     fn title(&self) -> &str {
//!         "Count to three"
//!     }
//!     fn at(&self) -> u32 {
//!         self.at
//!     }
//!     fn step(&mut self, _cx: &mut dyn Context) -> Result<Flow, Fault> {
//!         let count = self.count.ok_or(Fault::Unassigned(0))?;
//!         if count >= 3.0 {
//!             return Ok(Flow::Finished(End::End));
//!         }
//!         self.count = Some(count + 1.0);
//!         Ok(Flow::Next)
//!     }
//!     fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
//!         (i == 0).then_some(("COUNT", self.count))
//!     }
//!     fn set_scalar(&mut self, i: usize, value: f64) {
//!         if i == 0 {
//!             self.count = Some(value);
//!         }
//!     }
//!     fn line(&self, step: u32) -> u32 {
//!         if step == 0 { 3 } else { 0 }
//!     }
//!     fn reset(&mut self) {
//!         (self.at, self.count) = (0, None);
//!     }
//! }
//!
//! let mut program = Counting { at: 0, count: None };
//! assert_eq!(program.get("COUNT"), Ok(None));
//! assert_eq!(program.set("COUNT", 2.0), Ok(()));
//! assert_eq!(program.set("HEIGHT", 2.0), Err(VariableError::Unknown));
//! # #[cfg(feature = "control")] {
//! use tip_runtime::machine::{Machine, Status};
//!
//! let mut machine = Machine::simulated_on(&mut program, &titan8::MODEL).expect("it is for TITAN VIII");
//! assert_eq!(machine.cycle(), Status::Running);
//! assert_eq!(machine.cycle(), Status::Finished(End::End));
//! assert_eq!(program.get("COUNT"), Ok(Some(3.0)));
//! # }
//! ```

use crate::command::{CONSTANT, Command, Flag, MAX, Poll, Port, Reading, Target, Teach};
use crate::fault::Fault;
use crate::model::{Family, Model, Point};
use crate::vibration::Vibration;
use core::fmt;
use core::fmt::Display;

/// Maximum number of THREADs of a program (T.I.P. 3.2).
pub const THREADS: usize = 7;

/// The command that ended the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// `END`.
    End,
    /// `EXIT`.
    Exit,
}

/// Result of one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flow {
    /// The step ran to its end; [`Program::at`] names the step of the next cycle.
    Next,
    /// The step waits: the next cycle runs it again.
    Wait,
    /// The thread that ran the step is over.
    ThreadEnd,
    /// The program is over.
    Finished(End),
}

/// The robot a program was checked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signature {
    /// The robot's name.
    pub robot: &'static str,
    /// The set of commands that the program may use.
    pub family: Family,
    /// Number of legs.
    pub legs: u8,
    /// Number of joints on each leg.
    pub joints: u8,
}

impl<const L: usize, const J: usize> Model<L, J> {
    /// Returns the signature that a program must have been checked for to run on this robot.
    pub const fn signature(&self) -> Signature {
        Signature {
            robot: self.name,
            family: self.family,
            legs: L as u8,
            joints: J as u8,
        }
    }
}

/// A motion program: generated code or the reference interpreter.
pub trait Program {
    /// Returns the signature of the robot that the program was checked for.
    fn signature(&self) -> Signature;
    /// Returns the program's name: its file, or the type that holds it.
    fn name(&self) -> &str;
    /// Returns line 2 of the source.
    fn title(&self) -> &str;
    /// Returns the step that the next call of [`step`](Self::step) runs.
    fn at(&self) -> u32;
    /// Runs one step. A fault leaves variables, position and call stack as they were.
    ///
    /// # Errors
    /// The fault that the step found; the machine answers it with an emergency stop.
    fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault>;
    /// Returns name and value of scalar `i` in declaration order (`VAR_KEY` first, members one by
    /// one); `None` past the last, an inner `None` while unassigned.
    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)>;
    /// Assigns a finite value to scalar `i`; does nothing past the last. [`set`](Self::set) does it by name.
    fn set_scalar(&mut self, i: usize, value: f64);
    /// Returns the source line (from 1) of a step; 0 if there is no such step.
    fn line(&self, step: u32) -> u32;
    /// Resets to the state of a new program.
    fn reset(&mut self);

    /// Returns the name of thread `n` and the step that it runs next. Threads (T.I.P. 3.2) count from 1 in the order of
    /// the text; `None` past the last.
    fn thread(&self, n: u8) -> Option<(&str, u32)> {
        let _ = n;
        None
    }

    /// Selects the thread, or the main program (0), to which [`at`](Self::at) and [`step`](Self::step) apply.
    fn select(&mut self, thread: u8) {
        let _ = thread;
    }

    /// Puts a thread at its first step, without open calls.
    fn begin(&mut self, thread: u8) {
        let _ = thread;
    }

    /// Returns the number of scalars after `VAR_KEY` that belong to special variables, which native code of SPECIAL
    /// shares ([`SpecialVariable`]).
    fn specials(&self) -> usize {
        0
    }

    /// Returns the value of a variable, or of a struct's member such as `P.X`; `None` while
    /// unassigned.
    ///
    /// # Errors
    /// `Unknown` for a name that the program does not declare, `Constant` for constants such as `CHAR_A`.
    fn get(&self, name: &str) -> Result<Option<f64>, VariableError> {
        find(self, name).map(|(_, value)| value)
    }

    /// Assigns a variable, or a struct's member such as `P.X`, between two control cycles. The steps that follow
    /// read it, until one of them assigns another value. A program may not read what was never assigned
    /// (T.I.P. 3.1 §5-1), and the compiler warns where it does: let it assign a default first, and set the variable
    /// after that step.
    ///
    /// # Errors
    /// The errors of [`get`](Self::get); `NotFinite` for an infinite value, or one that is not a
    /// number.
    fn set(&mut self, name: &str, value: f64) -> Result<(), VariableError> {
        let index = settable(self, name, value)?;
        self.set_scalar(index, value);
        Ok(())
    }

    /// Checks that [`set`](Self::set) would assign the variable, and changes nothing.
    ///
    /// # Errors
    /// The errors of [`set`](Self::set).
    fn accepts(&self, name: &str, value: f64) -> Result<(), VariableError> {
        settable(self, name, value).map(drop)
    }
}

impl<P: Program + ?Sized> Program for &mut P {
    fn signature(&self) -> Signature {
        (**self).signature()
    }
    fn name(&self) -> &str {
        (**self).name()
    }
    fn title(&self) -> &str {
        (**self).title()
    }
    fn at(&self) -> u32 {
        (**self).at()
    }
    fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
        (**self).step(cx)
    }
    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
        (**self).scalar(i)
    }
    fn set_scalar(&mut self, i: usize, value: f64) {
        (**self).set_scalar(i, value);
    }
    fn line(&self, step: u32) -> u32 {
        (**self).line(step)
    }
    fn reset(&mut self) {
        (**self).reset();
    }
    fn thread(&self, n: u8) -> Option<(&str, u32)> {
        (**self).thread(n)
    }
    fn select(&mut self, thread: u8) {
        (**self).select(thread);
    }
    fn begin(&mut self, thread: u8) {
        (**self).begin(thread);
    }
    fn specials(&self) -> usize {
        (**self).specials()
    }
}

/// A variable that a program and native code of SPECIAL share: `VAR_SPECIAL_n`, a member of
/// `POS_SPECIAL_n` or `JNT_SPECIAL_n` (T.I.P. 3.2). `n` is 0…9; members count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpecialVariable {
    /// `VAR_SPECIAL_n`.
    Var(u8),
    /// X, Y or Z of `POS_SPECIAL_n`.
    Position(u8, u8),
    /// A joint of `JNT_SPECIAL_n`.
    Joint(u8, u8),
}

/// The interface of steps and of native code of SPECIAL to the robot.
pub trait Robot {
    /// Starts or continues a command. While it answers `Pending` the same command is asked again each cycle.
    ///
    /// # Errors
    /// The fault of the command; nothing of it took effect.
    fn command(&mut self, command: &Command<'_>) -> Result<Poll, Fault>;
    /// Measures: three members for a position or force, one for each joint of a leg for angles and
    /// torques, the first one alone for a single joint.
    ///
    /// # Errors
    /// `Domain` for a target that the robot lacks.
    fn teach(&self, what: Teach, target: Target) -> Result<[f64; MAX], Fault>;
    /// Reads an input in volts.
    ///
    /// # Errors
    /// `Sensor` if the input reads nonsense, `Domain` for one that the robot lacks.
    fn analog(&self, port: Port) -> Result<f64, Fault>;
    /// Returns the state of an event flag.
    fn flag(&self, flag: Flag) -> bool;
    /// Sets one of `SPECIAL_FLAG0…9`; other numbers are ignored.
    fn set_special_flag(&mut self, n: u8, on: bool);
    /// Starts or ends the vibration of a joint about its command. A joint that vibrates already keeps the phase of its
    /// wave. Vibration ends with the program, and rests under ALL_STOP.
    ///
    /// # Errors
    /// `Domain` for a target that is not a joint, a robot that does not vibrate
    /// ([`Model::vibration`](crate::model::Model::vibration)), an amplitude that is not finite, or a
    /// frequency that is not finite or negative.
    fn vibrate(&mut self, joint: Target, vibration: Option<Vibration>) -> Result<(), Fault>;
    /// Pulls a foot, or a third joint (`Jn3`), to the place `to` (mm) by a spring with its own stiffness (N/mm along
    /// each axis), whose set point is there immediately. All else is as in COMPLIANCE_POSITION. The stiffness that the
    /// program has set does not change.
    ///
    /// # Errors
    /// `Domain` for another target, a robot without torques, a number that is not finite, or a negative
    /// stiffness.
    fn pull(&mut self, point: Target, to: Point, stiffness: [f64; 3]) -> Result<(), Fault>;
    /// Returns the commanded torque of each joint of a leg without vibration, or the sensed one if none is commanded,
    /// in the robot's torque unit.
    ///
    /// # Errors
    /// `Domain` for a leg that the robot lacks, or a robot without torques.
    fn torques(&self, leg: u8) -> Result<[f64; MAX], Fault>;
    /// Returns the joint angles (deg), near the angles `from`, that put a foot at `position` (mm).
    ///
    /// # Errors
    /// `OutOfReach` or `JointLimit` if there are none, `Domain` for a leg that the robot lacks.
    fn inverse(&self, leg: u8, from: &[f64; MAX], position: Point) -> Result<[f64; MAX], Fault>;
    /// Shows or removes a bar graph on the console: 0 is that of the joint torques, 1 that of the forces at the feet.
    ///
    /// # Errors
    /// `Domain` for another graph, or a robot without torques.
    fn show_graph(&mut self, graph: u8, on: bool) -> Result<(), Fault>;
    /// Returns the sampling time in ms.
    fn period(&self) -> f64;
    /// Returns the value of a variable that the program and native code share; 0 at the start, and for one that does
    /// not exist.
    fn special_variable(&self, variable: SpecialVariable) -> f64 {
        let _ = variable;
        0.0
    }
    /// Assigns a variable that the program and native code share. Steps after this call read it: those of the next
    /// cycle if it comes from [`Special::cycle`](crate::special::Special::cycle).
    ///
    /// # Errors
    /// `Domain` for a value that is not finite or a variable that does not exist, `InvalidMode` before the first
    /// SPECIAL of the program. Nothing changes then.
    fn set_special_variable(&mut self, variable: SpecialVariable, value: f64) -> Result<(), Fault> {
        let _ = (variable, value);
        Err(Fault::Domain)
    }
}

/// The interface of steps to the robot and the console.
pub trait Context: Robot {
    /// Asks for the command of a step, and sets `at` to `next` when the command is done. A compiled step that is a
    /// command ends in this call.
    ///
    /// # Errors
    /// The errors of [`command`](Robot::command); `at` stays what it is.
    fn ask(&mut self, command: &Command<'_>, at: &mut u32, next: u32) -> Result<Flow, Fault> {
        match self.command(command)? {
            Poll::Done => {
                *at = next;
                Ok(Flow::Next)
            }
            Poll::Pending => Ok(Flow::Wait),
        }
    }
    /// Takes the oldest key, upper-cased, and empties the keyboard buffer; `None` if it is empty.
    fn key(&mut self) -> Option<u8>;
    /// Shows one line of text; an empty one clears it.
    fn message(&mut self, text: &dyn Display);
    /// Appends text to FOUT.LOG (F_MESSAGE).
    fn append(&mut self, text: &dyn Display) {
        let _ = text;
    }
    /// Returns the members of a special variable, a number as the first one: what a TEACH_ command would give in this
    /// cycle, or the time of a timer.
    ///
    /// # Errors
    /// `Domain` for a part that the robot lacks, or a value that is not finite.
    fn reading(&self, reading: Reading) -> Result<[f64; MAX], Fault> {
        match reading {
            Reading::Timer(n) => {
                let mut members = [0.0; MAX];
                members[0] = self.timer(n);
                Ok(members)
            }
            Reading::Measured(what, target) => {
                let members = self.teach(what, target)?;
                match members.iter().all(|member| member.is_finite()) {
                    true => Ok(members),
                    false => Err(Fault::Domain),
                }
            }
        }
    }
    /// Returns the time of timer `n`, ms.
    fn timer(&self, n: u8) -> f64 {
        let _ = n;
        0.0
    }
    /// Starts a thread (from 1) in the next cycle.
    ///
    /// # Errors
    /// `InvalidMode` for a thread that runs.
    fn start_thread(&mut self, thread: u8) -> Result<(), Fault> {
        let _ = thread;
        Err(Fault::InvalidMode)
    }
    /// Ends a thread with this cycle.
    fn stop_thread(&mut self, thread: u8) {
        let _ = thread;
    }
    /// Returns `Done` if a thread does not run.
    ///
    /// # Errors
    /// `InvalidMode` for the thread that asks.
    fn wait_thread(&mut self, thread: u8) -> Result<Poll, Fault> {
        let _ = thread;
        Err(Fault::InvalidMode)
    }
}

#[doc(hidden)]
/// Return steps of GOSUB and CALL, ten deep (T.I.P. 3.1 §10-3-6).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CallStack {
    steps: [u32; Self::DEPTH],
    len: u8,
}

impl CallStack {
    /// Maximum depth of nested calls.
    pub const DEPTH: usize = 10;

    /// Creates a stack without an open call.
    pub const fn new() -> Self {
        CallStack {
            steps: [0; Self::DEPTH],
            len: 0,
        }
    }

    /// Stores a return address.
    ///
    /// # Errors
    /// `TooDeep` when ten calls are open.
    pub fn push(&mut self, step: u32) -> Result<(), Fault> {
        let slot = self
            .steps
            .get_mut(usize::from(self.len))
            .ok_or(Fault::TooDeep)?;
        *slot = step;
        self.len += 1;
        Ok(())
    }

    /// Returns the return addresses of the open calls, the outermost first.
    pub fn open(&self) -> &[u32] {
        self.steps.get(..usize::from(self.len)).unwrap_or(&[])
    }

    /// Removes the innermost return address and returns it.
    ///
    /// # Errors
    /// `InvalidReturn` when no call is open.
    pub fn pop(&mut self) -> Result<u32, Fault> {
        let len = self.len.checked_sub(1).ok_or(Fault::InvalidReturn)?;
        let step = self
            .steps
            .get(usize::from(len))
            .ok_or(Fault::InvalidReturn)?;
        self.len = len;
        Ok(*step)
    }
}

impl Default for CallStack {
    fn default() -> Self {
        Self::new()
    }
}

/// The reason why a variable cannot be read or set by that name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum VariableError {
    /// The program has no variable of that name; a struct has only members, such as `P.X`.
    Unknown,
    /// The name is a constant of the language.
    Constant,
    /// The value is infinite or is not a number.
    NotFinite,
}

impl fmt::Display for VariableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            VariableError::Unknown => "the program has no variable of that name",
            VariableError::Constant => "that name is a constant",
            VariableError::NotFinite => "a variable holds finite numbers only",
        })
    }
}

impl core::error::Error for VariableError {}

/// Returns the index of a variable that can have a value.
fn settable<P: Program + ?Sized>(
    program: &P,
    name: &str,
    value: f64,
) -> Result<usize, VariableError> {
    let (index, _) = find(program, name)?;
    match value.is_finite() {
        true => Ok(index),
        false => Err(VariableError::NotFinite),
    }
}

/// Returns index and value of the scalar of that name.
fn find<P: Program + ?Sized>(
    program: &P,
    name: &str,
) -> Result<(usize, Option<f64>), VariableError> {
    let mut index = 0;
    while let Some((scalar, value)) = program.scalar(index) {
        if scalar.eq_ignore_ascii_case(name) {
            return Ok((index, value));
        }
        index += 1;
    }
    let start = name.get(..CONSTANT.len());
    match start.is_some_and(|start| start.eq_ignore_ascii_case(CONSTANT)) {
        true => Err(VariableError::Constant),
        false => Err(VariableError::Unknown),
    }
}

#[cfg(test)]
mod tests {
    use super::VariableError;
    use crate::fault::Fault;
    use crate::model::Family;
    use crate::program::{Context, Flow, Program, Signature};

    /// `DEF_VAR STRIDE` and `DEF_POS P`, after the variable that every program has.
    struct Walk([Option<f64>; 5]);

    const NAMES: [&str; 5] = ["VAR_KEY", "STRIDE", "P.X", "P.Y", "P.Z"];

    impl Program for Walk {
        fn signature(&self) -> Signature {
            Signature {
                robot: "none",
                family: Family::Generic,
                legs: 1,
                joints: 1,
            }
        }
        fn name(&self) -> &str {
            "walk"
        }
        fn title(&self) -> &str {
            "walk"
        }
        fn at(&self) -> u32 {
            0
        }
        fn step(&mut self, _: &mut dyn Context) -> Result<Flow, Fault> {
            Ok(Flow::Wait)
        }
        fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
            Some((*NAMES.get(i)?, *self.0.get(i)?))
        }
        fn set_scalar(&mut self, i: usize, value: f64) {
            self.0[i] = Some(value);
        }
        fn line(&self, _: u32) -> u32 {
            0
        }
        fn reset(&mut self) {}
    }

    #[test]
    fn a_variable_is_read_and_set_by_its_name() {
        let mut walk = Walk([None; 5]);
        assert_eq!(walk.get("STRIDE"), Ok(None));
        assert_eq!(walk.set("STRIDE", 80.0), Ok(()));
        assert_eq!(walk.set("P.Y", -0.5), Ok(()));
        assert_eq!(walk.get("STRIDE"), Ok(Some(80.0)));
        assert_eq!(walk.0, [None, Some(80.0), None, Some(-0.5), None]);
    }

    // clauses: 1.7
    #[test]
    fn the_case_of_a_name_does_not_matter() {
        let mut walk = Walk([None; 5]);
        assert_eq!(walk.set("Stride", 1.0), Ok(()));
        assert_eq!(walk.get("stride"), Ok(Some(1.0)));
    }

    #[test]
    fn what_is_no_variable_is_refused() {
        let mut walk = Walk([Some(1.0); 5]);
        for (name, error) in [
            ("STRIDES", VariableError::Unknown),
            ("STRID", VariableError::Unknown),
            ("P", VariableError::Unknown),
            ("", VariableError::Unknown),
            ("歩幅", VariableError::Unknown),
            ("CHAR_A", VariableError::Constant),
            ("char_space", VariableError::Constant),
        ] {
            assert_eq!(walk.get(name), Err(error), "{name}");
            assert_eq!(walk.set(name, 1.0), Err(error), "{name}");
        }
    }

    #[test]
    fn a_value_that_is_not_finite_is_refused_and_changes_nothing() {
        let mut walk = Walk([Some(1.0); 5]);
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(walk.set("STRIDE", value), Err(VariableError::NotFinite));
        }
        assert_eq!(walk.get("STRIDE"), Ok(Some(1.0)));
    }

    #[test]
    fn a_program_that_is_borrowed_has_the_same_variables() {
        let mut walk = Walk([None; 5]);
        let mut borrowed = &mut walk;
        assert_eq!(Program::set(&mut borrowed, "STRIDE", 3.0), Ok(()));
        let dynamic: &dyn Program = &walk;
        assert_eq!(dynamic.get("STRIDE"), Ok(Some(3.0)));
    }
}
