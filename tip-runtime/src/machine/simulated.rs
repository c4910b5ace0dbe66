//! A program on the simulated robot that it was compiled for.

use super::{Machine, Mismatch};
use crate::hardware::Hardware;
use crate::model::{self, Model};
use crate::plant::{SimulatedHand, SimulatedPlant};
use crate::program::Program;
use crate::robot::{For, Generic, Hand, Titan8};
use crate::special::Special;
use crate::special::hand::HandSpecials;

/// A robot that can be simulated by its name alone.
pub trait Simulated<const L: usize, const J: usize> {
    /// The simulated robot.
    type Hardware: Hardware<L, J>;
    /// Its native commands.
    type Special: Special;
    /// The robot as data.
    const MODEL: &'static Model<L, J>;

    /// Returns the robot as every run begins with it: a walker above a level floor, a hand without
    /// objects.
    fn hardware() -> Self::Hardware;

    /// Its native commands.
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

impl<P, H, S, const L: usize, const J: usize> Machine<P, H, (), S, L, J>
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
        Self::resting(program, R::MODEL, R::hardware(), (), R::special())
    }
}

impl<P: Program, const L: usize, const J: usize> Machine<P, SimulatedPlant<L, J>, (), (), L, J> {
    /// Puts a program on a described robot, which is simulated on a level floor, without a console.
    ///
    /// # Errors
    /// The program was checked for another robot.
    pub fn simulated_on(program: P, model: &Model<L, J>) -> Result<Self, Mismatch> {
        Machine::new(program, model, SimulatedPlant::new(model), (), ())
    }
}
