//! Where the links are, what they weigh, and which torque a load asks of their joints.

use super::Point;
use super::servo::Servo;
use crate::model::{Leg, Model};
use nalgebra::{Rotation3, Unit};

/// Standard gravity: m/s² (3rd CGPM, 1901).
pub(super) const GRAVITY: f64 = 9.80665;

/// A leg in the robot frame: mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct LegLinks<const J: usize> {
    joints: [Point; J],
    axes: [Point; J],
    /// The middle of each link, where its mass is taken to be.
    centres: [Point; J],
    pub(super) foot: Point,
}

/// All mass of the robot.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mass {
    /// In the robot frame: mm.
    pub(super) centre: Point,
    /// N.
    pub(super) weight: f64,
}

/// Places every leg.
pub(super) fn legs<const L: usize, const J: usize>(
    model: &Model<L, J>,
    servos: &[[Servo; J]; L],
) -> [LegLinks<J>; L] {
    let mut links = [LegLinks::NOWHERE; L];
    for ((links, leg), servos) in links.iter_mut().zip(&model.legs).zip(servos) {
        *links = LegLinks::of(leg, servos);
    }
    links
}

/// Adds up body and links.
pub(super) fn mass<const L: usize, const J: usize>(
    model: &Model<L, J>,
    legs: &[LegLinks<J>; L],
) -> Mass {
    let mut mass = model.body.map_or(0.0, |body| body.mass);
    let mut moment = Point::zeros();
    for (leg, links) in model.legs.iter().zip(legs) {
        for (joint, centre) in leg.joints.iter().zip(&links.centres) {
            mass += joint.mass;
            moment += centre * joint.mass;
        }
    }
    Mass {
        centre: if mass > 0.0 { moment / mass } else { moment },
        weight: mass * GRAVITY,
    }
}

impl<const J: usize> LegLinks<J> {
    const NOWHERE: Self = LegLinks {
        joints: [Point::new(0.0, 0.0, 0.0); J],
        axes: [Point::new(0.0, 0.0, 0.0); J],
        centres: [Point::new(0.0, 0.0, 0.0); J],
        foot: Point::new(0.0, 0.0, 0.0),
    };

    /// Follows the chain from base to foot.
    fn of(leg: &Leg<J>, servos: &[Servo; J]) -> Self {
        let mut links = Self::NOWHERE;
        let mut turned = Rotation3::identity();
        let mut at = Point::from(leg.base);
        let places = links.joints.iter_mut().zip(&mut links.axes);
        let places = places.zip(&mut links.centres);
        for (((place, axis), centre), (joint, servo)) in places.zip(leg.joints.iter().zip(servos)) {
            let own_axis = Point::from(joint.axis);
            *place = at;
            *axis = turned * own_axis;
            let angle = servo.angle.to_radians();
            turned *= Rotation3::from_axis_angle(&Unit::new_unchecked(own_axis), angle);
            let link = turned * Point::from(joint.link);
            *centre = at + link / 2.0;
            at += link;
        }
        links.foot = at;
        links
    }

    /// How stiffly each joint feels a foot whose contact gives way by `stiffness` (N/mm) along
    /// `normal`: N·m/rad. All joints turn at once, so that a joint is lent what it shares with the
    /// others: row sums, which are no less than the stiffness of any motion of the leg.
    pub(super) fn stiffness(&self, normal: Point, stiffness: f64) -> [f64; J] {
        let mut levers = [0.0; J];
        for (lever, (joint, axis)) in levers.iter_mut().zip(self.joints.iter().zip(&self.axes)) {
            *lever = libm::fabs(axis.cross(&(self.foot - joint)).dot(&normal));
        }
        let sum: f64 = levers.iter().sum();
        levers.map(|lever| stiffness * lever * sum / 1000.0)
    }

    /// Torque about each joint axis that the floor's `push` at the foot (N) and the links' own
    /// weight exert: Jᵀ F (e.g. Siciliano et al., Robotics, 2009, §3.8), N·m. `down` is the
    /// direction of gravity. All in the robot frame.
    pub(super) fn load_torques(&self, leg: &Leg<J>, push: Point, down: Point) -> [f64; J] {
        let mut torques = [0.0; J];
        for (place, torque) in torques.iter_mut().enumerate() {
            let (Some(joint), Some(axis)) = (self.joints.get(place), self.axes.get(place)) else {
                continue;
            };
            let mut moment = (self.foot - joint).cross(&push);
            let links = leg.joints.iter().zip(&self.centres).skip(place);
            for (link, centre) in links {
                moment += (centre - joint).cross(&(down * link.mass * GRAVITY));
            }
            *torque = axis.dot(&moment) / 1000.0;
        }
        torques
    }
}
