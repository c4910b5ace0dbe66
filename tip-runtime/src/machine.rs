//! The control loop: sample sensors, run one step, advance the trajectories, write to the robot.
//!
//! `Written` is a hand-written program of `LAMP_ON 3` and `END`; macros and build scripts compile one from its text.
//!
//! ```
//! use tip_runtime::machine::{Machine, Status};
//! use tip_runtime::model::titan8;
//! use tip_runtime::plant::SimulatedPlant;
//! # use tip_runtime::command::{Command, Op, Target, Value};
//! # use tip_runtime::fault::Fault;
//! # use tip_runtime::program::{Context, End, Flow, Program, Signature};
//! #
//! # struct Written { at: u32 }
//! #
//! # impl Program for Written {
//! #     fn signature(&self) -> Signature { titan8::MODEL.signature() }
//! #     fn name(&self) -> &str { "written" }
//! #     fn title(&self) -> &str { "" }
//! #     fn at(&self) -> u32 { self.at }
//! #     fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
//! #         let lamp = Command { op: Op::LampOn, hs: false, target: Target::None, values: &[Value::Absolute(3.0)] };
//! #         match self.at {
//! #             0 => cx.ask(&lamp, &mut self.at, 1),
//! #             _ => Ok(Flow::Finished(End::End)),
//! #         }
//! #     }
//! #     fn scalar(&self, _: usize) -> Option<(&str, Option<f64>)> { None }
//! #     fn set_scalar(&mut self, _: usize, _: f64) {}
//! #     fn line(&self, step: u32) -> u32 { step + 3 }
//! #     fn reset(&mut self) { self.at = 0; }
//! # }
//!
//! let program = Written { at: 0 };
//! let plant = SimulatedPlant::new(&titan8::MODEL);
//! let mut machine = Machine::new(program, &titan8::MODEL, plant)?;
//!
//! assert_eq!(machine.cycle(), Status::Running);
//! assert!(machine.hardware().lamp(3));
//! assert_eq!(machine.cycle(), Status::Finished(End::End));
//!
//! // The loop goes on: a robot has to be held after END as well.
//! assert_eq!(machine.cycle(), Status::Finished(End::End));
//! # Ok::<(), tip_runtime::machine::Mismatch>(())
//! ```

mod cycle;
mod devices;
mod state;
#[cfg(all(test, feature = "std"))]
mod tests;
mod threads;
mod variables;

pub use crate::emergency::{Emergency, Report, ThreadName};
pub use state::Status;

use crate::command::Flag;
use crate::console::Console;
use crate::controller::Controller;
use crate::hardware::{Hardware, JointCommand, Outputs, Sensors};
use crate::model::{self, Model};
use crate::plant::{SimulatedHand, SimulatedPlant};
use crate::program::{Program, Signature};
use crate::record::Sink;
use crate::robot::{For, Generic, Hand, Titan8};
use crate::special::Special;
use crate::special::hand::HandSpecials;
use core::fmt;
use cycle::{ControlCycle, SizedIo};
use state::State;

/// A program `P` on the hardware `H` of a robot with `L` legs of `J` joints, with a console `C` and
/// native commands `S`.
///
/// Each call of [`cycle`](Self::cycle) is one control cycle (T.I.P. 3.1 §3-2) and runs one step. It
/// neither allocates nor blocks; pacing it is the caller's affair. It may be called after the
/// program's end, and should be: the robot has to come to rest and to be held, or to be stopped
/// again and again.
#[derive(Clone, Debug)]
pub struct Machine<P, H, const L: usize, const J: usize, C = (), S = ()> {
    program: P,
    console: C,
    special: S,
    state: State,
    hardware: H,
    controller: Controller<L, J>,
    sensors: Sensors<L, J>,
    /// Outputs of the last cycle.
    outputs: Outputs<L, J>,
}

impl<P: Program, H: Hardware<L, J>, const L: usize, const J: usize> Machine<P, H, L, J> {
    /// Puts a program on a robot, without a console and native commands.
    ///
    /// # Errors
    /// The program was checked for another robot.
    pub fn new(program: P, model: &Model<L, J>, hardware: H) -> Result<Self, Mismatch> {
        Mismatch::check(&program, model.signature())?;
        Ok(Self::resting(program, model, hardware, ()))
    }
}

impl<P, H, const L: usize, const J: usize, C, S> Machine<P, H, L, J, C, S>
where
    P: Program,
    H: Hardware<L, J>,
    C: Console,
    S: Special,
{
    /// Returns the machine with a console, in place of the one that it had.
    pub fn with_console<D: Console>(self, console: D) -> Machine<P, H, L, J, D, S> {
        Machine {
            program: self.program,
            console,
            special: self.special,
            state: self.state,
            hardware: self.hardware,
            controller: self.controller,
            sensors: self.sensors,
            outputs: self.outputs,
        }
    }

    /// Returns the machine with native commands, in place of those that it had.
    pub fn with_special<T: Special>(self, special: T) -> Machine<P, H, L, J, C, T> {
        Machine {
            program: self.program,
            console: self.console,
            special,
            state: self.state,
            hardware: self.hardware,
            controller: self.controller,
            sensors: self.sensors,
            outputs: self.outputs,
        }
    }

    /// Restarts the program on the robot in its present state: after its end, after an emergency, or in the middle.
    /// Everything that steps have set is reset; nothing is controlled, and every joint stays where it was measured, as
    /// in an emergency stop. Cycles and time count from 0. Native code of SPECIAL keeps its state.
    pub fn restart(&mut self) {
        self.program.reset();
        self.controller.restart();
        self.state = State::new();
    }

    /// Runs one control cycle.
    pub fn cycle(&mut self) -> Status {
        self.control(None)
    }

    /// Runs one control cycle and reports it to `sink`.
    pub fn cycle_traced(&mut self, sink: &mut dyn Sink) -> Status {
        self.control(Some(sink))
    }

    fn control(&mut self, sink: Option<&mut dyn Sink>) -> Status {
        let mut robot = SizedIo {
            hardware: &mut self.hardware,
            sensors: &mut self.sensors,
            outputs: &mut self.outputs,
        };
        let mut cycle = ControlCycle {
            program: &mut self.program,
            robot: &mut robot,
            console: &mut self.console,
            special: &mut self.special,
            controller: &mut self.controller,
            state: &mut self.state,
        };
        cycle.run(sink)
    }
}

impl<P, H, const L: usize, const J: usize, S> Machine<P, H, L, J, (), S> {
    /// Creates a machine before its first cycle.
    fn resting(program: P, model: &Model<L, J>, hardware: H, special: S) -> Self {
        Machine {
            program,
            console: (),
            special,
            state: State::new(),
            hardware,
            controller: Controller::new(model),
            sensors: Sensors::UNREAD,
            outputs: Outputs {
                joints: [[JointCommand::at(0.0); J]; L],
                slider: [0.0; 3],
                lamps: [0; 8],
                period: model.standards.period,
            },
        }
    }
}

impl<P, H, const L: usize, const J: usize, C, S> Machine<P, H, L, J, C, S> {
    /// Takes a typed byte: RETURN stops the robot in the next cycle, ESC requests a halt, any other
    /// goes to the keyboard buffer.
    pub fn key(&mut self, byte: u8) {
        self.state.key(byte);
    }

    /// Requests the program to stop at its next good moment: `HALT_REQUEST` is true from now on.
    pub fn request_halt(&mut self) {
        self.state.io.halt_requested = true;
    }

    /// Stops the robot in the next cycle, as the RETURN key does.
    pub fn emergency_stop(&mut self) {
        self.state.stop_requested = true;
    }

    /// Runs no step and holds the robot until [`resume`](Self::resume), as `ALL_STOP` does. Paused
    /// cycles do not count.
    pub fn pause(&mut self) {
        if !self.state.paused {
            self.state.paused = true;
            self.state.io.held_for_pause = self.controller.take_hold();
        }
    }

    /// Goes on after [`pause`](Self::pause).
    pub fn resume(&mut self) {
        self.state.paused = false;
        if core::mem::take(&mut self.state.io.held_for_pause) {
            self.controller.release();
        }
    }

    /// Returns the status of the program.
    pub fn status(&self) -> Status {
        self.state.status
    }

    /// Returns the cause and the place of an emergency stop.
    pub fn emergency(&self) -> Option<&Emergency> {
        self.state.emergency.as_ref()
    }

    /// Returns the program.
    pub fn program(&self) -> &P {
        &self.program
    }

    /// Returns the program.
    pub fn program_mut(&mut self) -> &mut P {
        &mut self.program
    }

    /// Returns the robot.
    pub fn hardware(&self) -> &H {
        &self.hardware
    }

    /// Returns the robot.
    pub fn hardware_mut(&mut self) -> &mut H {
        &mut self.hardware
    }

    /// Returns the console.
    pub fn console(&self) -> &C {
        &self.console
    }

    /// Returns the console.
    pub fn console_mut(&mut self) -> &mut C {
        &mut self.console
    }

    /// Returns the controller.
    pub fn controller(&self) -> &Controller<L, J> {
        &self.controller
    }

    /// Returns true if a thread (from 1, in the order of the text) runs.
    pub fn thread_runs(&self, thread: u8) -> bool {
        self.state.threads.runs(thread)
    }

    /// Returns the time of timer `n`, ms.
    pub fn timer(&self, n: u8) -> f64 {
        self.state.io.timers.time(n)
    }

    /// Returns the state of an event flag (T.I.P. 3.1 §6-2).
    pub fn flag(&self, flag: Flag) -> bool {
        let (controller, inputs) = (&self.controller, &self.sensors.inputs);
        self.state.io.flag(flag, controller, inputs)
    }

    /// Returns the readings of the last cycle.
    pub fn sensors(&self) -> &Sensors<L, J> {
        &self.sensors
    }

    /// Returns the outputs of the last cycle.
    pub fn outputs(&self) -> &Outputs<L, J> {
        &self.outputs
    }

    /// Returns the number of cycles whose step ran without a fault.
    pub fn cycles(&self) -> u64 {
        self.state.cycles
    }

    /// Returns the time on the robot since the start, up to the end of the last cycle, ms.
    pub fn time(&self) -> f64 {
        self.state.time
    }

    /// Returns the sampling time, ms.
    pub fn period(&self) -> f64 {
        self.controller.period()
    }
}

/// The error for a program that was checked for another robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mismatch {
    /// The robot the program was checked for.
    pub program: Signature,
    /// The robot of the machine.
    pub robot: Signature,
}

impl Mismatch {
    /// Checks a program against a robot. It is compiled once for robots of all sizes.
    #[inline(never)]
    fn check(program: &dyn Program, robot: Signature) -> Result<(), Self> {
        let program = program.signature();
        if program == robot {
            Ok(())
        } else {
            Err(Mismatch { program, robot })
        }
    }
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the program was compiled for ")?;
        describe(f, self.program)?;
        f.write_str(", the robot is ")?;
        describe(f, self.robot)
    }
}

fn describe(f: &mut fmt::Formatter<'_>, robot: Signature) -> fmt::Result {
    let Signature {
        robot,
        family,
        legs,
        joints,
    } = robot;
    write!(
        f,
        "{robot} (commands of {family}, {legs} legs of {joints} joints)"
    )
}

impl core::error::Error for Mismatch {}

/// A robot that can be simulated by its name alone.
pub trait Simulated<const L: usize, const J: usize> {
    /// The simulated robot.
    type Hardware: Hardware<L, J>;
    /// Its native commands.
    type Special: Special;
    /// The robot as data.
    const MODEL: &'static Model<L, J>;

    /// Returns the simulated robot before a run: a walker on a level floor, a hand without objects.
    fn hardware() -> Self::Hardware;

    /// Returns its native commands.
    fn special() -> Self::Special;
}

impl Simulated<4, 3> for Titan8 {
    type Hardware = SimulatedPlant<4, 3>;
    type Special = ();
    const MODEL: &'static Model<4, 3> = &model::titan8::MODEL;

    fn hardware() -> Self::Hardware {
        SimulatedPlant::new(Self::MODEL)
    }

    fn special() {}
}

impl Simulated<4, 3> for Generic {
    type Hardware = SimulatedPlant<4, 3>;
    type Special = ();
    const MODEL: &'static Model<4, 3> = &model::generic::MODEL;

    fn hardware() -> Self::Hardware {
        SimulatedPlant::new(Self::MODEL)
    }

    fn special() {}
}

impl Simulated<3, 3> for Hand {
    type Hardware = SimulatedHand<3, 3>;
    type Special = HandSpecials;
    const MODEL: &'static Model<3, 3> = &model::hand::MODEL;

    fn hardware() -> Self::Hardware {
        SimulatedHand::new(Self::MODEL)
    }

    fn special() -> Self::Special {
        HandSpecials::new()
    }
}

impl<P, H, const L: usize, const J: usize, S> Machine<P, H, L, J, (), S>
where
    P: Program,
    H: Hardware<L, J>,
    S: Special,
{
    /// Puts a compiled program on the simulated robot that it was compiled for, without a console.
    pub fn simulated<R>(program: P) -> Self
    where
        P: For<R>,
        R: Simulated<L, J, Hardware = H, Special = S>,
    {
        Self::resting(program, R::MODEL, R::hardware(), R::special())
    }
}

impl<P: Program, const L: usize, const J: usize> Machine<P, SimulatedPlant<L, J>, L, J> {
    /// Puts a program on a described robot, which is simulated on a level floor, without a console.
    ///
    /// # Errors
    /// The program was checked for another robot.
    pub fn simulated_on(program: P, model: &Model<L, J>) -> Result<Self, Mismatch> {
        Machine::new(program, model, SimulatedPlant::new(model))
    }
}
