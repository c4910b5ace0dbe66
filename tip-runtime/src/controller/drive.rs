//! Motion of the joints of one leg, by their own set points or by that of a point of the leg.

mod advance;
mod reach;
mod redundancy;

pub(super) use advance::bounded;
pub(super) use advance::{CycleParams, MovingLeg};
pub(super) use reach::{name, nearest_place, reach};
pub(super) use redundancy::Redundancy;

use super::trajectory::{Goal, SetPoint};
use crate::hardware::JointCommand;
use crate::kinematics::{Chain, LegPoint};
use crate::model::{Inverse, Leg, Point};

/// The joint whose position can be controlled (`Jn3`), counted from 0. It is moved by the joints
/// before it.
pub(super) const THIRD: usize = 2;

/// The set points that a leg's joints follow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Drive<const J: usize> {
    /// One for each joint: free (it stays where it is), at an angle, at an angular velocity, or by torque.
    Joints([SetPoint<1>; J]),
    /// The foot's, which moves all joints: at a position, at a velocity, or by force.
    Foot(SetPoint<3>),
    /// The third joint's position, which moves the joints before it. The third joint and those after it have their own
    /// set points.
    Third(SetPoint<3>, [SetPoint<1>; J]),
}

/// A leg's joint commands, and the set points from which they follow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LegDrive<const J: usize> {
    /// The commanded angles, or those to which torques have led, deg.
    pub(super) angles: [f64; J],
    /// Rates at which the angles changed in the last sampling time, deg/s.
    turns: [f64; J],
    /// The torques commanded in place of angles.
    torques: [Option<f64>; J],
    pub(super) drive: Drive<J>,
    /// The stiffness of the spring at a point, N/mm; `None` if it is that of the parameter.
    pub(super) own_stiffness: Option<[f64; 3]>,
    /// Motion of redundant joints on the path of a point.
    pub(super) redundancy: Redundancy<J>,
    /// The last solution of the closed form of the inverse kinematics.
    solved: Option<Solved<J>>,
}

/// The demanded place of a foot, mm, and the angles, deg, that put it there.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Solved<const J: usize> {
    foot: Point,
    angles: [f64; J],
}

impl<const J: usize> LegDrive<J> {
    /// Creates a drive that controls nothing: the servos hold `angles`.
    pub(super) fn free(angles: [f64; J]) -> Self {
        LegDrive {
            angles,
            turns: [0.0; J],
            torques: [None; J],
            drive: Drive::Joints(angles.map(|angle| SetPoint::resting([angle]))),
            own_stiffness: None,
            redundancy: Redundancy::None,
            solved: None,
        }
    }

    /// Returns the command of each joint.
    pub(super) fn outputs(&self) -> [JointCommand; J] {
        let mut outputs = self.angles.map(JointCommand::at);
        let joints = self.angles.iter().zip(&self.turns).zip(&self.torques);
        for (output, ((angle, rate), torque)) in outputs.iter_mut().zip(joints) {
            *output = match *torque {
                Some(torque) => JointCommand::Torque(torque),
                None => JointCommand::Angle {
                    angle: *angle,
                    rate: *rate,
                },
            };
        }
        outputs
    }

    /// Returns true if a joint was commanded a torque.
    pub(super) fn pushes(&self) -> bool {
        self.torques.iter().any(Option::is_some)
    }

    /// Sets the commanded angles of joints under torque to `stays`: the measured angles, limited to the working limits.
    pub(super) fn follow(&mut self, stays: &[f64; J]) {
        let states = self.torques.iter().zip(stays);
        for (angle, (torque, stays)) in self.angles.iter_mut().zip(states) {
            if torque.is_some() {
                *angle = *stays;
            }
        }
    }

    /// Moves the set point of the controlled point to its target immediately. So do the third joint and those after it, if
    /// the third joint is the point and the foot was controlled before (`from_foot`).
    pub(super) fn jump_to_point(&mut self, from_foot: bool) {
        match &mut self.drive {
            Drive::Joints(_) => {}
            Drive::Foot(track) => *track = track.jumping(true),
            Drive::Third(track, joints) => {
                *track = track.jumping(true);
                for joint in joints.iter_mut().skip(THIRD) {
                    *joint = joint.jumping(joint.jumps() || from_foot);
                }
            }
        }
    }

    /// Puts each joint under its own control. If the command of the `count` joints from `first` is `direct`, the set
    /// points of these joints, and of those that moved a controlled point, are at their targets immediately.
    pub(super) fn take_joints(
        &mut self,
        mut tracks: [SetPoint<1>; J],
        (first, count): (usize, usize),
        direct: bool,
    ) {
        if direct {
            let served = self.served();
            for (m, track) in tracks.iter_mut().enumerate() {
                let is_set = m < served || (m >= first && m - first < count);
                *track = track.jumping(track.jumps() || is_set);
            }
        }
        self.drive = Drive::Joints(tracks);
    }

    /// Returns the number of joints, from the first, that move the controlled point.
    pub(super) fn served(&self) -> usize {
        match self.drive {
            Drive::Joints(_) => 0,
            Drive::Foot(_) => J,
            Drive::Third(..) => THIRD,
        }
    }

    pub(super) fn is_at_rest(&self) -> bool {
        match &self.drive {
            Drive::Joints(joints) => joints.iter().all(SetPoint::is_at_rest),
            Drive::Foot(foot) => foot.is_at_rest() && self.redundancy.is_at_rest(),
            Drive::Third(third, joints) => {
                let joints = joints.iter().skip(THIRD);
                third.is_at_rest() && self.redundancy.is_at_rest() && { joints }
                    .all(SetPoint::is_at_rest)
            }
        }
    }

    /// Returns true if a torque, force or spring drives any joint.
    pub(super) fn is_soft(&self) -> bool {
        match &self.drive {
            Drive::Joints(joints) => joints.iter().any(|joint| joint.goal().is_soft()),
            Drive::Foot(foot) => foot.goal().is_soft(),
            Drive::Third(third, joints) => {
                third.goal().is_soft()
                    || joints
                        .iter()
                        .skip(THIRD)
                        .any(|joint| joint.goal().is_soft())
            }
        }
    }

    /// Returns the set point of the controlled point, if it moves joint `m`, counted from 0.
    pub(super) fn point_of_joint(&self, m: usize) -> Option<(LegPoint, &SetPoint<3>)> {
        match &self.drive {
            Drive::Joints(_) => None,
            Drive::Foot(foot) => Some((LegPoint::Tip, foot)),
            Drive::Third(third, _) if m <= THIRD => Some((LegPoint::Joint(THIRD), third)),
            Drive::Third(..) => None,
        }
    }

    /// Returns the set point of a point of the leg, if that is controlled.
    pub(super) fn own_point(&self, point: LegPoint) -> Option<&SetPoint<3>> {
        match (&self.drive, point) {
            (Drive::Foot(foot), LegPoint::Tip) => Some(foot),
            (Drive::Third(third, _), LegPoint::Joint(THIRD)) => Some(third),
            _ => None,
        }
    }

    /// Returns the set points of the joints under their own control, and the number of the first one, from 0.
    pub(super) fn own_joints(&self) -> (usize, &[SetPoint<1>]) {
        match &self.drive {
            Drive::Joints(joints) => (0, joints),
            Drive::Foot(_) => (J, &[]),
            Drive::Third(_, joints) => (THIRD, joints.get(THIRD..).unwrap_or(&[])),
        }
    }

    /// Returns a point's set point, with the position and velocity that the leg is commanded now. Under torque control
    /// it starts from the measured place.
    pub(super) fn point(&self, point: LegPoint, leg: &Leg<J>, inverse: Inverse) -> SetPoint<3> {
        if let Some(own) = self.own_point(point)
            && !own.goal().is_soft()
        {
            return *own;
        }
        let chain = Chain::new(leg, &self.angles);
        let place = chain.point(point).unwrap_or([0.0; 3]);
        let velocity = chain.point_velocity(point, &self.rates(leg, inverse));
        SetPoint::moving(
            inverse.flat(place),
            inverse.flat(velocity.unwrap_or([0.0; 3])),
        )
    }

    /// Returns the same as [`point`](Self::point), but keeps the tension of a spring that already pulls at the point,
    /// unless its stiffness changes.
    pub(super) fn strained_point(
        &self,
        point: LegPoint,
        leg: &Leg<J>,
        inverse: Inverse,
    ) -> SetPoint<3> {
        match self.own_point(point) {
            Some(own)
                if matches!(own.goal(), Goal::Spring { .. }) && self.own_stiffness.is_none() =>
            {
                *own
            }
            _ => self.point(point, leg, inverse),
        }
    }

    /// Puts a point under control. Joints after it keep their modes; those that moved another point hold the angles
    /// `stays`.
    pub(super) fn take_point(
        &mut self,
        point: LegPoint,
        track: SetPoint<3>,
        leg: &Leg<J>,
        stays: &[f64; J],
        inverse: Inverse,
    ) {
        self.own_stiffness = None;
        self.redundancy = Redundancy::None;
        self.drive = match point {
            LegPoint::Tip => Drive::Foot(track),
            LegPoint::Joint(_) => Drive::Third(track, self.joints(leg, stays, inverse)),
        };
    }

    /// Returns the joints' set points, with the velocities that the leg is commanded now. Joints that moved a
    /// controlled point stay at the angles `stays`.
    pub(super) fn joints(
        &self,
        leg: &Leg<J>,
        stays: &[f64; J],
        inverse: Inverse,
    ) -> [SetPoint<1>; J] {
        let (served, own) = match &self.drive {
            Drive::Joints(joints) => return *joints,
            Drive::Foot(_) => (J, None),
            Drive::Third(_, joints) => (THIRD, Some(joints)),
        };
        let mut joints = self.angles.map(|angle| SetPoint::resting([angle]));
        let states = self.angles.iter().zip(self.rates(leg, inverse)).zip(stays);
        for (joint, ((angle, rate), stays)) in joints.iter_mut().zip(states).take(served) {
            *joint = SetPoint::moving([*angle], [rate]).towards(Goal::Point {
                target: [*stays],
                hs: false,
            });
        }
        let behind = joints.iter_mut().skip(served);
        for (joint, own) in behind.zip(own.into_iter().flatten().skip(served)) {
            *joint = *own;
        }
        joints
    }

    /// Returns the commanded rates of the joints, deg/s; 0 under torque control.
    fn rates(&self, leg: &Leg<J>, inverse: Inverse) -> [f64; J] {
        let mut rates = match &self.drive {
            Drive::Joints(_) => [0.0; J],
            Drive::Foot(foot) => self.rates_of_point(LegPoint::Tip, foot, leg, inverse),
            Drive::Third(third, _) => {
                self.rates_of_point(LegPoint::Joint(THIRD), third, leg, inverse)
            }
        };
        let (first, own) = self.own_joints();
        for (rate, joint) in rates.iter_mut().skip(first).zip(own) {
            *rate = if joint.goal().is_soft() {
                0.0
            } else {
                joint.velocity().iter().sum()
            };
        }
        rates
    }

    fn rates_of_point(
        &self,
        point: LegPoint,
        track: &SetPoint<3>,
        leg: &Leg<J>,
        inverse: Inverse,
    ) -> [f64; J] {
        if track.goal().is_soft() {
            return [0.0; J];
        }
        if !self.redundancy.is_none() {
            return self.turns;
        }
        let chain = Chain::new(leg, &self.angles);
        chain
            .point_rates(point, track.velocity(), inverse.axes())
            .unwrap_or([0.0; J])
    }
}

/// Returns the distance of two points, mm.
pub(super) fn distance(a: Point, b: Point) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    libm::sqrt(squares.sum())
}
