//! Tracking of commands by joints and feet, for robots without mass and with it.

use super::Vector;
use super::links::LegLinks;
use crate::hardware::JointCommand;
use crate::model::Leg;

/// Factor of a servo's speed from which a joint is commanded to turn too fast, rounding aside.
const FASTER: f64 = 1.0 + 1e-9;

/// Greatest distance of a foot from its path that is not counted, mm.
const STRAY: f64 = 10.0;

/// Greatest distance of equal places, mm.
const SAME: f64 = 1e-6;

/// Commands that joints and feet could not follow, counted in control cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct TrackingErrors {
    /// Number of cycles in which a joint was commanded to turn faster than its servo can.
    pub hurries: u32,
    /// Number of cycles in which a foot was more than 10 mm off its commanded path.
    pub strays: u32,
    /// The greatest distance of a foot from its path so far, mm.
    pub farthest_stray: f64,
}

impl TrackingErrors {
    pub(in crate::plant) const NONE: Self = TrackingErrors {
        hurries: 0,
        strays: 0,
        farthest_stray: 0.0,
    };

    /// Returns true if every command could be followed.
    pub const fn is_empty(&self) -> bool {
        self.hurries == 0 && self.strays == 0
    }

    /// Counts a cycle in which a foot was at most `stray` mm off its path.
    pub(in crate::plant) fn count(&mut self, hurries: bool, stray: f64) {
        self.hurries += u32::from(hurries);
        self.strays += u32::from(stray > STRAY);
        self.farthest_stray = self.farthest_stray.max(stray);
    }
}

/// Returns true if a joint is commanded to turn faster than `speed` (deg/s).
pub(in crate::plant) fn hurries(commands: &[JointCommand], speed: f64) -> bool {
    commands.iter().any(|command| match command {
        JointCommand::Angle { rate, .. } => libm::fabs(*rate) > speed * FASTER,
        JointCommand::Torque(_) => false,
    })
}

/// The commanded path of a foot.
#[derive(Clone, Copy, Debug)]
pub(in crate::plant) struct Path {
    /// The end of the path, mm; not a number before the first command.
    place: Vector,
    /// The direction of the path; zero if there is none.
    along: Vector,
}

impl Path {
    /// The path before the first command.
    pub(in crate::plant) const NONE: Self = Path {
        place: Vector::new(f64::NAN, f64::NAN, f64::NAN),
        along: Vector::new(0.0, 0.0, 0.0),
    };

    /// Returns the distance of `foot` (mm) from the line of its last path, mm. A foot that only
    /// lags is on it. Torques define no path.
    pub(super) fn stray<const J: usize>(
        &mut self,
        leg: &Leg<J>,
        commands: &[JointCommand; J],
        foot: Vector,
    ) -> f64 {
        let Some(angles) = angles(commands) else {
            *self = Path::NONE;
            return 0.0;
        };
        let place = reached(leg, angles);
        let step = (place - self.place).norm();
        if step > SAME {
            self.along = (place - self.place) / step;
        }
        self.place = place;
        if self.along == Vector::zeros() {
            return 0.0;
        }
        let off = foot - place;
        (off - self.along * self.along.dot(&off)).norm()
    }

    /// Returns [`stray`](Self::stray) for a foot at joint angles (deg).
    pub(in crate::plant) fn stray_at<const J: usize>(
        &mut self,
        leg: &Leg<J>,
        commands: &[JointCommand; J],
        angles: [f64; J],
    ) -> f64 {
        self.stray(leg, commands, reached(leg, angles))
    }
}

/// Returns the position of the foot at joint angles (deg), mm.
fn reached<const J: usize>(leg: &Leg<J>, angles: [f64; J]) -> Vector {
    let mut links = LegLinks::NOWHERE;
    links.place(leg, angles);
    links.foot
}

/// Returns the angles of commands, if all are angles.
fn angles<const J: usize>(commands: &[JointCommand; J]) -> Option<[f64; J]> {
    let mut angles = [0.0; J];
    for (angle, command) in angles.iter_mut().zip(commands) {
        let JointCommand::Angle { angle: to, .. } = command else {
            return None;
        };
        *angle = *to;
    }
    Some(angles)
}
