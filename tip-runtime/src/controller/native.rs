//! Queries and changes that only native code makes.

use super::drive::reach;
use super::targets::unlocked;
use super::trajectory::{Goal, Track};
use super::{ControllerView, targets};
use crate::command::{MAX, Target};
use crate::fault::Fault;
use crate::hardware::JointCommand;
use crate::kinematics::LegPoint;
use crate::model::Point;

impl<const J: usize> ControllerView<J> {
    /// Pulls a foot, or a third joint, to the place `to` (mm) by a spring of its own stiffness (N/mm
    /// along each axis), whose set point is there immediately. The rest is as COMPLIANCE_POSITION has it.
    ///
    /// # Errors
    /// `Domain` for another target, a place that is not finite, a stiffness that is not finite or
    /// negative, or a robot without torques; `InvalidMode` if a joint is locked that it would change.
    pub fn pull(&mut self, target: Target, to: Point, stiffness: [f64; 3]) -> Result<(), Fault> {
        let (n, point) = self.point_of(target)?;
        let sound = to.iter().all(|place| place.is_finite())
            && stiffness.iter().all(|k| k.is_finite() && *k >= 0.0);
        if !sound || self.robot.forces.is_none() {
            return Err(Fault::Domain);
        }
        unlocked(self.leg(n)?.locks_point(point))?;
        let target = self.robot.inverse.flat(to);
        let spring = Goal::Spring { target, hs: false };
        self.take_point(n, point, Track::resting(target).towards(spring))?;
        targets::leg_mut(&mut self.legs, n)?.drive.own_stiffness = Some(stiffness);
        Ok(())
    }

    /// Returns the torque of each joint of a leg: what it is commanded, or else what it senses.
    ///
    /// # Errors
    /// `Domain` for a leg that the robot lacks, or a robot without torques.
    pub fn torques(&self, n: u8) -> Result<[f64; MAX], Fault> {
        if self.robot.forces.is_none() {
            return Err(Fault::Domain);
        }
        let leg = self.leg(n)?;
        let mut torques = [0.0; MAX];
        let commands = leg.drive.outputs();
        for (torque, (command, sensed)) in torques.iter_mut().zip(commands.iter().zip(&leg.torques))
        {
            *torque = match command {
                JointCommand::Torque(torque) => *torque,
                JointCommand::Angle { .. } => *sensed,
            };
        }
        Ok(torques)
    }

    /// Returns the joint angles (deg), near the angles `from`, that put a foot at `position` (mm).
    ///
    /// # Errors
    /// `OutOfReach` or `JointLimit` if there are none, `Domain` for a leg that the robot lacks.
    pub fn inverse(&self, n: u8, from: &[f64; MAX], position: Point) -> Result<[f64; MAX], Fault> {
        let leg = &self.leg(n)?.model;
        let mut near = leg.initial;
        for (near, from) in near.iter_mut().zip(from) {
            *near = *from;
        }
        let found = reach(self.robot.inverse, leg, (LegPoint::Tip, n), &near, position)?;
        let mut angles = [0.0; MAX];
        for (angle, found) in angles.iter_mut().zip(found) {
            *angle = found;
        }
        Ok(angles)
    }
}
