//! Odometry: the travel of the body.

use super::pose::FloorPose;
use crate::model::Point;
use crate::scene::Floor;
use core::f64::consts::{PI, TAU};

/// The travel of a body from its start.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Travel {
    /// To the right of its initial attitude, mm.
    pub x: f64,
    /// Forward: mm.
    pub y: f64,
    /// Up: mm.
    pub z: f64,
    /// Turn to the left, about the floor's normal, deg. Whole turns count.
    pub turn: f64,
}

impl Travel {
    /// Returns a travel along x, y and z (mm) with a turn to the left (deg).
    pub const fn new([x, y, z]: Point, turn: f64) -> Self {
        Travel { x, y, z, turn }
    }
}

/// The start of the body, and the number of its revolutions since.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Odometer {
    position: Point,
    /// rad.
    heading: f64,
    revolutions: f64,
}

impl Odometer {
    /// Starts at the current pose.
    pub(super) fn at(floor: &Floor, body: &FloorPose) -> Self {
        Odometer {
            position: floor.position(body),
            heading: body.heading,
            revolutions: 0.0,
        }
    }

    /// Records a change of the heading, which is kept within half a turn.
    pub(super) fn turned(&mut self, from: f64, to: f64) {
        if to - from > PI {
            self.revolutions -= 1.0;
        } else if to - from < -PI {
            self.revolutions += 1.0;
        }
    }

    /// Returns the travel from the start to the current pose.
    pub(super) fn travel(&self, floor: &Floor, body: &FloorPose) -> Travel {
        let ([x, y, z], [x0, y0, z0]) = (floor.position(body), self.position);
        let turn = body.heading - self.heading + self.revolutions * TAU;
        Travel {
            x: x - x0,
            y: y - y0,
            z: z - z0,
            turn: turn.to_degrees(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_turns_count_in_both_senses() {
        for sense in [1.0, -1.0] {
            let mut body = FloorPose::standing(None);
            let mut start = Odometer::at(&Floor::LEVEL, &body);
            // Two turns and a quarter, in steps of 30 degrees.
            for step in 1..=27 {
                let angle = sense * f64::from(step) * PI / 6.0;
                let heading = libm::atan2(libm::sin(angle), libm::cos(angle));
                start.turned(body.heading, heading);
                body.heading = heading;
            }
            let turn = start.travel(&Floor::LEVEL, &body).turn;
            assert!((turn - sense * 810.0).abs() < 1e-9, "{turn}");
        }
    }
}
