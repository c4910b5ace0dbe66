//! The links of a leg: positions, masses, and the torques of loads on their joints.

use super::Vector;
use crate::model::{Joint, Leg};
use crate::plant::GRAVITY;
use nalgebra::{Rotation3, Unit};

/// A leg in the robot frame: mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct LegLinks<const J: usize> {
    /// Joint angles of this posture, deg.
    angles: [f64; J],
    joints: [Vector; J],
    axes: [Vector; J],
    /// Centres of mass of the links.
    pub(super) centres: [Vector; J],
    pub(super) foot: Vector,
}

/// The mass of the robot.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mass {
    /// Centre in the robot frame, mm.
    pub(super) centre: Vector,
    /// Weight, N.
    pub(super) weight: f64,
}

impl Mass {
    /// An empty mass.
    pub(super) const NONE: Self = Mass {
        centre: Vector::new(0.0, 0.0, 0.0),
        weight: 0.0,
    };
}

impl<const J: usize> LegLinks<J> {
    /// Links that are not placed yet.
    pub(super) const NOWHERE: Self = LegLinks {
        angles: [f64::NAN; J],
        joints: [Vector::new(0.0, 0.0, 0.0); J],
        axes: [Vector::new(0.0, 0.0, 0.0); J],
        centres: [Vector::new(0.0, 0.0, 0.0); J],
        foot: Vector::new(0.0, 0.0, 0.0),
    };

    /// Places the links, if the joints have turned.
    pub(super) fn place(&mut self, leg: &Leg<J>, angles: [f64; J]) {
        if self.angles.map(f64::to_bits) != angles.map(f64::to_bits) {
            self.turn(leg, angles);
        }
    }

    /// Calculates the positions from base to foot.
    fn turn(&mut self, leg: &Leg<J>, angles: [f64; J]) {
        self.angles = angles;
        let mut turned = Rotation3::identity();
        let mut at = Vector::from(leg.base);
        let places = self.joints.iter_mut().zip(&mut self.axes);
        let places = places.zip(&mut self.centres);
        for (((place, axis), centre), (joint, angle)) in places.zip(leg.joints.iter().zip(angles)) {
            let own_axis = Vector::from(joint.axis);
            *place = at;
            *axis = turned * own_axis;
            let own_axis = Unit::new_unchecked(own_axis);
            turned *= Rotation3::from_axis_angle(&own_axis, angle.to_radians());
            let link = turned * Vector::from(joint.link);
            *centre = match joint.inertial {
                None => at + link / 2.0,
                Some(inertial) => at + turned * Vector::from(inertial.centre),
            };
            at += link;
        }
        self.foot = at;
    }

    /// Iterates over the positions of the joints, from base to foot.
    pub(super) fn places(&self) -> impl Iterator<Item = Vector> + Clone + '_ {
        self.joints.iter().copied()
    }

    /// Iterates over the links, by both ends.
    pub(super) fn lines(&self) -> impl Iterator<Item = [Vector; 2]> + Clone + '_ {
        let ends = self.places().skip(1).chain([self.foot]);
        self.places().zip(ends).map(|(from, to)| [from, to])
    }

    /// Returns the stiffness of each joint against a foot whose contact gives way by `stiffness`
    /// (N/mm) along `normal`, N·m/rad. All joints turn together, so that a joint includes the terms
    /// that it shares with the others: row sums, which are no less than the stiffness of any motion
    /// of the leg.
    pub(super) fn stiffness(&self, normal: Vector, stiffness: f64) -> [f64; J] {
        let levers = self.levers(normal);
        let sum: f64 = levers.iter().sum();
        levers.map(|lever| stiffness * lever * sum / 1000.0)
    }

    /// Returns the motion of the foot along `normal` for each joint's turn, mm/rad.
    pub(super) fn levers(&self, normal: Vector) -> [f64; J] {
        let mut levers = [0.0; J];
        for (lever, (joint, axis)) in levers.iter_mut().zip(self.joints.iter().zip(&self.axes)) {
            *lever = libm::fabs(axis.cross(&(self.foot - joint)).dot(&normal));
        }
        levers
    }

    /// Returns the torque about each joint axis of the floor's `push` at the foot (N) and the
    /// links' weight: Jᵀ F (e.g. Siciliano et al., Robotics, 2009, §3.8), N·m. `down` is the
    /// direction of gravity. All vectors are in the robot frame.
    pub(super) fn load_torques(&self, leg: &Leg<J>, push: Vector, down: Vector) -> [f64; J] {
        let weight_of = |link: &Joint| down * link.mass * GRAVITY;
        let weights = leg.joints.each_ref().map(weight_of);
        let mut torques = [0.0; J];
        for (place, torque) in torques.iter_mut().enumerate() {
            let (Some(joint), Some(axis)) = (self.joints.get(place), self.axes.get(place)) else {
                continue;
            };
            let mut moment = (self.foot - joint).cross(&push);
            let links = weights.iter().zip(&self.centres).skip(place);
            for (weight, centre) in links {
                moment += (centre - joint).cross(weight);
            }
            *torque = axis.dot(&moment) / 1000.0;
        }
        torques
    }
}
