//! Lever motion (SPECIAL 1 and 2): a soft spring draws the end of each finger's second link sideways
//! to the middle of the hand, a stiff one keeps its height. The fingertip joint is left alone.

use super::{FINGERS, not_negative};
use crate::command::{Target, Teach};
use crate::fault::Fault;
use crate::program::Robot;

/// The stiffness that keeps the height: N/mm.
const HEIGHT_STIFFNESS: f64 = 0.2;

const MILLIMETRES_PER_METRE: f64 = 1000.0;

#[derive(Clone, Debug, Default)]
pub(super) struct Lever {
    /// Heights to keep, mm.
    heights: Option<[f64; FINGERS]>,
    /// Stiffness towards the middle, N/m.
    stiffness: Option<f64>,
}

impl Lever {
    /// SPECIAL 1: stores the measured heights, and the stiffness, if one is given.
    pub(super) fn begin(
        &mut self,
        arguments: [Option<f64>; 2],
        robot: &mut dyn Robot,
    ) -> Result<(), Fault> {
        let [stiffness, None] = arguments else {
            return Err(Fault::Domain);
        };
        let stiffness = stiffness.map(not_negative).transpose()?;
        let mut heights = [0.0; FINGERS];
        for (n, height) in (1..).zip(&mut heights) {
            let [_, y, ..] = robot.teach(Teach::Position, Target::Joint(n, 3))?;
            *height = y;
        }
        *self = Lever {
            heights: Some(heights),
            stiffness,
        };
        Ok(())
    }

    /// SPECIAL 2: sets the springs, with the stiffness given here, or else that of SPECIAL 1.
    pub(super) fn carry_on(
        &mut self,
        arguments: [Option<f64>; 2],
        robot: &mut dyn Robot,
    ) -> Result<(), Fault> {
        let ([stiffness, None], Some(heights)) = (arguments, self.heights) else {
            return Err(Fault::Domain);
        };
        let stiffness = not_negative(stiffness.or(self.stiffness).ok_or(Fault::Domain)?)?;
        let sideways = stiffness / MILLIMETRES_PER_METRE;
        for (n, height) in (1..).zip(heights) {
            let point = Target::Joint(n, 3);
            robot.pull(point, [0.0, height, 0.0], [sideways, HEIGHT_STIFFNESS, 0.0])?;
        }
        Ok(())
    }
}
