//! The SPECIAL commands of the Hiroshima Hand (T.I.P. 3.1 §8-2). Each takes one cycle.
//!
//! Custom commands take the remaining numbers. `Written` is a hand-written program that consists of
//! `SPECIAL 30`, and ends by END if `SPECIAL_FLAG9` is set:
//!
//! ```
//! use tip_runtime::command::{Flag, Poll};
//! use tip_runtime::machine::{Machine, Status};
//! use tip_runtime::model::hand;
//! use tip_runtime::plant::SimulatedHand;
//! use tip_runtime::program::Robot;
//! use tip_runtime::special::{Call, hand::HandSpecials};
//! # use tip_runtime::command::{Command, Op, Target, Value};
//! # use tip_runtime::fault::Fault;
//! # use tip_runtime::program::{Context, End, Flow, Program, Signature};
//! #
//! # struct Written { at: u32 }
//! #
//! # impl Program for Written {
//! #     fn signature(&self) -> Signature { hand::MODEL.signature() }
//! #     fn name(&self) -> &str { "written" }
//! #     fn title(&self) -> &str { "" }
//! #     fn at(&self) -> u32 { self.at }
//! #     fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
//! #         let special = Command { op: Op::Special, hs: false, target: Target::None, values: &[Value::Absolute(30.0)] };
//! #         match self.at {
//! #             0 => cx.ask(&special, &mut self.at, 1),
//! #             _ if cx.flag(Flag::Special(9)) => Ok(Flow::Finished(End::End)),
//! #             _ => Ok(Flow::Finished(End::Exit)),
//! #         }
//! #     }
//! #     fn scalar(&self, _: usize) -> Option<(&str, Option<f64>)> { None }
//! #     fn set_scalar(&mut self, _: usize, _: f64) {}
//! #     fn line(&self, step: u32) -> u32 { step + 3 }
//! #     fn reset(&mut self) { self.at = 0; }
//! # }
//!
//! let specials = HandSpecials::with_user(|call: Call, robot: &mut dyn Robot| match call.number {
//!     30 => {
//!         robot.set_special_flag(9, true);
//!         Ok(Poll::Done)
//!     }
//!     _ => Err(Fault::Domain),
//! });
//! let plant = SimulatedHand::new(&hand::MODEL);
//! let mut machine = Machine::new(Written { at: 0 }, &hand::MODEL, plant, (), specials)?;
//! assert_eq!(machine.cycle(), Status::Running);
//! assert_eq!(machine.cycle(), Status::Finished(End::End));
//! # Ok::<(), tip_runtime::machine::Mismatch>(())
//! ```

mod closure;
mod friction;
mod lever;

use super::{Call, Special};
use crate::command::Poll;
use crate::fault::Fault;
use crate::program::Robot;
use closure::Closure;
use friction::FrictionControl;
use lever::Lever;

/// The numbers of the hand's own commands.
pub const NUMBERS: &[u8] = &[1, 2, 5, 6, 10, 11, 12, 13, 14, 15, 16, 20];

/// Number of fingers of the hand.
const FINGERS: usize = 3;
/// Number of joints of each finger.
const JOINTS: usize = 3;

/// The SPECIAL commands of the hand, in addition to those of a user.
///
/// | number | what |
/// |---|---|
/// | 1, 2 | lever motion: begin, carry on |
/// | 5, 6 | active force closure of the second kind: begin, carry on; sets `SPECIAL_FLAG0` |
/// | 10 | active friction control off |
/// | 11–13 | active friction control of F1, F2, F3: mode, amplitude in V |
/// | 14–16 | its frequency: Hz |
/// | 20 | bar graph 0 or 1 off or on |
///
/// Wrong arguments are a `Domain` error; every other number is the user's.
#[derive(Clone, Debug, Default)]
pub struct HandSpecials<U = ()> {
    lever: Lever,
    closure: Closure,
    friction: FrictionControl,
    user: U,
}

impl HandSpecials {
    /// Returns the hand's commands alone.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }
}

impl<U> HandSpecials<U> {
    /// Returns the hand's commands, and those of `user` for every other number.
    #[must_use]
    pub fn with_user(user: U) -> Self {
        HandSpecials {
            lever: Lever::default(),
            closure: Closure::default(),
            friction: FrictionControl::default(),
            user,
        }
    }
}

impl<U: Special> Special for HandSpecials<U> {
    fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault> {
        let arguments = call.arguments;
        match call.number {
            1 => self.lever.begin(arguments, robot)?,
            2 => self.lever.carry_on(arguments, robot)?,
            5 => self.closure.begin(arguments, robot)?,
            6 => self.closure.carry_on(arguments, robot)?,
            10 => self.friction.stop(arguments, robot)?,
            11..=13 => self.friction.switch(call.number - 10, arguments, robot)?,
            14..=16 => self.friction.tune(call.number - 13, arguments, robot)?,
            20 => show_graph(arguments, robot)?,
            _ => return self.user.poll(call, robot),
        }
        Ok(Poll::Done)
    }

    fn cycle(&mut self, robot: &mut dyn Robot) -> Result<(), Fault> {
        self.closure.elapse(robot.period());
        self.user.cycle(robot)
    }
}

/// SPECIAL 20: takes a graph's number, then 1 for on or 0 for off.
fn show_graph(arguments: [Option<f64>; 2], robot: &mut dyn Robot) -> Result<(), Fault> {
    let [Some(graph), Some(on)] = arguments else {
        return Err(Fault::Domain);
    };
    robot.show_graph(u8::from(bit(graph)?), bit(on)?)
}

fn bit(value: f64) -> Result<bool, Fault> {
    match value {
        0.0 => Ok(false),
        1.0 => Ok(true),
        _ => Err(Fault::Domain),
    }
}

/// Refuses a number that is negative or infinite.
fn not_negative(value: f64) -> Result<f64, Fault> {
    if value >= 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(Fault::Domain)
    }
}
