//! What moves the joints of one leg: their own set points, or that of the foot.

use super::targets::number;
use super::trajectory::{Goal, Limits, Track};
use crate::command::Target;
use crate::fault::Fault;
use crate::kinematics::{self, Chain, ROUNDING};
use crate::model::{Inverse, Leg};

/// Who decides about a leg's joints.
#[expect(clippy::large_enum_variant, reason = "there is no heap to box it on")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Drive<const J: usize> {
    /// Each joint for itself: free (it stays where it is), at an angle, or at an angular velocity.
    Joints([Track<1>; J]),
    /// The foot, for all joints: at a position or at a velocity.
    Foot(Track<3>),
}

/// A leg's joint commands and what makes them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LegDrive<const J: usize> {
    /// The angles commanded: deg.
    pub(super) angles: [f64; J],
    pub(super) drive: Drive<J>,
}

impl<const J: usize> LegDrive<J> {
    /// Nothing controlled: the servos hold `angles`.
    pub(super) fn free(angles: [f64; J]) -> Self {
        LegDrive {
            angles,
            drive: Drive::Joints(angles.map(|angle| Track::resting([angle]))),
        }
    }

    pub(super) fn is_at_rest(&self) -> bool {
        match &self.drive {
            Drive::Joints(joints) => joints.iter().all(Track::is_at_rest),
            Drive::Foot(foot) => foot.is_at_rest(),
        }
    }

    /// The foot's set point, in the motion that the leg is commanded now.
    pub(super) fn foot(&self, leg: &Leg<J>) -> Track<3> {
        match &self.drive {
            Drive::Foot(foot) => *foot,
            Drive::Joints(joints) => {
                let mut rates = [0.0; J];
                for (rate, joint) in rates.iter_mut().zip(joints) {
                    *rate = joint.velocity().iter().sum();
                }
                let chain = Chain::new(leg, &self.angles);
                Track::moving(chain.foot(), chain.foot_velocity(&rates))
            }
        }
    }

    /// The joints' set points, in the motion that the leg is commanded now. Joints that served
    /// the foot are to stay at the angles `measured`.
    pub(super) fn joints(&self, leg: &Leg<J>, measured: &[f64; J]) -> [Track<1>; J] {
        match &self.drive {
            Drive::Joints(joints) => *joints,
            Drive::Foot(foot) => {
                let chain = Chain::new(leg, &self.angles);
                let rates = chain.joint_rates(foot.velocity()).unwrap_or([0.0; J]);
                let mut joints = self.angles.map(|angle| Track::resting([angle]));
                let states = self.angles.iter().zip(rates).zip(measured);
                for (joint, ((angle, rate), measured)) in joints.iter_mut().zip(states) {
                    *joint = Track::moving([*angle], [rate]).towards(Goal::Point {
                        target: [*measured],
                        hs: false,
                    });
                }
                joints
            }
        }
    }
}

/// What holds while a leg moves on.
pub(super) struct Going {
    /// Which inverse kinematics the robot has.
    pub(super) inverse: Inverse,
    /// The leg, from 1.
    pub(super) number: u8,
    /// The sampling time: s.
    pub(super) dt: f64,
    /// Whether every motion brakes and waits.
    pub(super) held: bool,
}

impl<const J: usize> LegDrive<J> {
    /// Moves on by one sampling time. At the border of what the leg can do it stops there.
    ///
    /// # Errors
    /// What stopped it: the way to a foot's target is out of reach, or a joint is at its limit.
    pub(super) fn advance(
        &mut self,
        leg: &Leg<J>,
        foot: Limits,
        joints: &[Limits; J],
        going: &Going,
    ) -> Result<(), Fault> {
        match &mut self.drive {
            Drive::Foot(track) => {
                let before = *track;
                track.advance(foot, going.dt, going.held);
                match reach(going.inverse, leg, track.position(), going.number) {
                    Ok(angles) => {
                        self.angles = angles;
                        Ok(())
                    }
                    Err(fault) => {
                        *track = before.stopped_at(before.position());
                        Err(match track.goal() {
                            Goal::Point { .. } => Fault::OutOfReach(Target::Foot(going.number)),
                            Goal::Rest | Goal::Speed(_) => fault,
                        })
                    }
                }
            }
            Drive::Joints(tracks) => {
                let mut result = Ok(());
                let each = tracks.iter_mut().zip(&mut self.angles);
                let limits = leg.joints.iter().zip(joints);
                for (m, ((track, angle), (joint, limits))) in each.zip(limits).enumerate() {
                    let from = *angle;
                    track.advance(*limits, going.dt, going.held);
                    *angle = track.position().iter().sum();
                    // A joint that is beyond its limits already may come back, not go on.
                    let (low, high) = (joint.limits.min.min(from), joint.limits.max.max(from));
                    if *angle < low - ROUNDING || *angle > high + ROUNDING {
                        *angle = angle.max(low).min(high);
                        *track = track.stopped_at([*angle]);
                        result = result.and(Err(Fault::JointLimit(going.number, number(m))));
                    }
                }
                result
            }
        }
    }
}

/// The joint angles for a foot's position.
///
/// # Errors
/// `OutOfReach` if the links do not reach it, `JointLimit` if a joint cannot turn so far.
pub(super) fn reach<const J: usize>(
    inverse: Inverse,
    leg: &Leg<J>,
    foot: [f64; 3],
    number_of_leg: u8,
) -> Result<[f64; J], Fault> {
    let angles = kinematics::inverse(inverse, leg, foot)
        .ok_or(Fault::OutOfReach(Target::Foot(number_of_leg)))?;
    match kinematics::first_beyond_limits(leg, &angles) {
        None => Ok(angles),
        Some(m) => Err(Fault::JointLimit(number_of_leg, number(m))),
    }
}
