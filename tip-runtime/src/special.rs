//! Native code for the command SPECIAL (T.I.P. 3.1 §7-10-11).
//!
//! A program contains `SPECIAL 14 TIMES`; its meaning is defined by the host that builds the
//! machine. This handler blinks a lamp: it takes an argument and several cycles, and sets a flag
//! that the program can test with `IF SPECIAL_FLAG0`.
//!
//! ```
//! use tip_runtime::command::{Command, Op, Poll, Target, Value};
//! use tip_runtime::fault::Fault;
//! use tip_runtime::machine::{Machine, Mismatch};
//! use tip_runtime::program::{Program, Robot};
//! use tip_runtime::special::{Call, Special};
//! use tip_runtime::{model::titan8, plant::SimulatedPlant};
//!
//! struct Blink {
//!     left: f64,
//! }
//!
//! impl Special for Blink {
//!     fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault> {
//!         let (14, [Some(times), None]) = (call.number, call.arguments) else {
//!             return Err(Fault::Domain);
//!         };
//!         if call.first {
//!             self.left = 2.0 * times;
//!         }
//!         if self.left < 1.0 {
//!             robot.set_special_flag(0, true);
//!             return Ok(Poll::Done);
//!         }
//!         self.left -= 1.0;
//!         let on = self.left % 2.0 >= 1.0;
//!         robot.command(&Command {
//!             op: if on { Op::LampOn } else { Op::LampOff },
//!             hs: false,
//!             target: Target::None,
//!             values: &[Value::Absolute(1.0)],
//!         })?;
//!         Ok(Poll::Pending)
//!     }
//! }
//!
//! fn simulate(program: impl Program) -> Result<(), Mismatch> {
//!     let plant = SimulatedPlant::new(&titan8::MODEL);
//!     let blink = Blink { left: 0.0 };
//!     let mut machine = Machine::new(program, &titan8::MODEL, plant)?.with_special(blink);
//!     while machine.cycle().is_running() {}
//!     Ok(())
//! }
//! ```

pub mod hand;

use crate::command::Poll;
use crate::fault::Fault;
use crate::program::Robot;

/// One evaluation of a SPECIAL command. The step is evaluated once a cycle until it is done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Call {
    /// The command's number, 0…255.
    pub number: u8,
    /// Its two arguments, `None` where omitted.
    pub arguments: [Option<f64>; 2],
    /// True in the first evaluation of the step.
    pub first: bool,
}

/// The SPECIAL commands of a robot.
///
/// Any `FnMut(Call, &mut dyn Robot) -> Result<Poll, Fault>` is one; `()` has none.
pub trait Special {
    /// Carries out `call`: returns [`Poll::Pending`] to be called again in the next cycle with
    /// `first` false, [`Poll::Done`] when the step is over.
    ///
    /// # Errors
    /// `Domain` for a number that is not known, or any other fault. A handler that fails must not
    /// have commanded the robot in the same cycle.
    fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault>;

    /// Continues motions that a command began and other steps do not wait for. Called in every
    /// cycle of a running program, after its step.
    ///
    /// # Errors
    /// The fault: an emergency stop, found at the start of the next cycle.
    fn cycle(&mut self, robot: &mut dyn Robot) -> Result<(), Fault> {
        let _ = robot;
        Ok(())
    }
}

impl Special for () {
    fn poll(&mut self, _call: Call, _robot: &mut dyn Robot) -> Result<Poll, Fault> {
        Err(Fault::Domain)
    }
}

impl<F: FnMut(Call, &mut dyn Robot) -> Result<Poll, Fault>> Special for F {
    fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault> {
        self(call, robot)
    }
}
