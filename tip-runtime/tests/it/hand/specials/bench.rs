//! The hand's SPECIAL commands on ideal fingers, one call or none in each cycle.

use crate::hand::rig::Hand;
use tip_runtime::command::{Command, Flag, MAX, Poll, Port, Target, Teach};
use tip_runtime::fault::Fault;
use tip_runtime::program::Robot;
use tip_runtime::special::hand::HandSpecials;
use tip_runtime::special::{Call, Special};
use tip_runtime::vibration::Vibration;

pub(crate) struct Ideal {
    pub(crate) hand: Hand,
    pub(crate) flags: [bool; 10],
    /// Switched graphs, on or off.
    pub(crate) graphs: Vec<(u8, bool)>,
}

impl Robot for Ideal {
    fn command(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        self.hand.controller.command(command)
    }
    fn teach(&self, what: Teach, target: Target) -> Result<[f64; MAX], Fault> {
        self.hand.controller.teach(what, target)
    }
    fn analog(&self, _: Port) -> Result<f64, Fault> {
        Err(Fault::Domain)
    }
    fn flag(&self, _: Flag) -> bool {
        false
    }
    fn set_special_flag(&mut self, n: u8, on: bool) {
        self.flags[usize::from(n)] = on;
    }
    fn vibrate(&mut self, joint: Target, vibration: Option<Vibration>) -> Result<(), Fault> {
        self.hand.controller.vibrate(joint, vibration)
    }
    fn pull(&mut self, point: Target, to: [f64; 3], stiffness: [f64; 3]) -> Result<(), Fault> {
        self.hand.controller.pull(point, to, stiffness)
    }
    fn torques(&self, leg: u8) -> Result<[f64; MAX], Fault> {
        self.hand.controller.torques(leg)
    }
    fn inverse(&self, leg: u8, from: &[f64; MAX], position: [f64; 3]) -> Result<[f64; MAX], Fault> {
        self.hand.controller.inverse(leg, from, position)
    }
    fn show_graph(&mut self, graph: u8, on: bool) -> Result<(), Fault> {
        self.graphs.push((graph, on));
        Ok(())
    }
    fn period(&self) -> f64 {
        self.hand.controller.period()
    }
}

pub(crate) struct Bench<U = ()> {
    pub(crate) robot: Ideal,
    special: HandSpecials<U>,
}

impl Bench {
    pub(crate) fn new() -> Self {
        Self::with_user(())
    }
}

impl<U: Special> Bench<U> {
    pub(crate) fn with_user(user: U) -> Self {
        Bench {
            robot: Ideal {
                hand: Hand::new(),
                flags: [false; 10],
                graphs: Vec::new(),
            },
            special: HandSpecials::with_user(user),
        }
    }

    /// Runs a cycle whose step is `SPECIAL number arguments`.
    pub(crate) fn call(&mut self, number: u8, arguments: &[f64]) -> Result<Poll, Fault> {
        let hand = &mut self.robot.hand;
        hand.controller.sense(&hand.sensors)?;
        let call = Call {
            number,
            arguments: [0, 1].map(|place| arguments.get(place).copied()),
            first: true,
        };
        let poll = self.special.poll(call, &mut self.robot)?;
        self.special.cycle(&mut self.robot)?;
        self.robot.hand.advance();
        Ok(poll)
    }

    /// Like `call`, for a command that takes one cycle.
    pub(crate) fn done(&mut self, number: u8, arguments: &[f64]) {
        assert_eq!(self.call(number, arguments), Ok(Poll::Done));
    }

    /// Asserts that each of these arguments is a Domain error of `number`.
    pub(crate) fn refuse(&mut self, number: u8, wrong: &[&[f64]]) {
        for arguments in wrong {
            let commanded = self.call(number, arguments);
            assert_eq!(
                commanded,
                Err(Fault::Domain),
                "SPECIAL {number} {arguments:?}"
            );
        }
    }

    /// Runs cycles with other steps.
    pub(crate) fn idle(&mut self, cycles: usize) {
        for _ in 0..cycles {
            self.special.cycle(&mut self.robot).expect("nothing fails");
            self.robot.hand.idle(1);
        }
    }
}
