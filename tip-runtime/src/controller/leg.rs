//! The state of one leg in the controller.

use super::drive::{CycleParams, Drive, LegDrive, MovingLeg, THIRD};
use super::native::JointVibration;
use super::params::LegParams;
use super::targets::joint_of;
use super::trajectory::SetPoint;
use crate::command::Target;
use crate::fault::Fault;
use crate::hardware::JointCommand;
use crate::kinematics::{Chain, LegPoint, ROUNDING};
use crate::model::{Inverse, Leg, ModelFacts, Point, Range};

/// One leg: its model, its motion and its measurements.
#[derive(Clone, Copy, Debug)]
pub struct LegState<const J: usize> {
    /// The working limits of the robot itself.
    pub(super) own: [Range; J],
    /// The leg with the working limits in force.
    pub(super) model: Leg<J>,
    pub(super) switches: LegSwitches<J>,
    pub(super) params: LegParams<J>,
    pub(super) drive: LegDrive<J>,
    pub(super) vibrations: [JointVibration; J],
    /// Measured joint angles, deg.
    pub(super) angles: [f64; J],
    /// Measured joint rates, deg/s.
    pub(super) rates: [f64; J],
    /// Time since the last cycle that measured the angle, s; 0 if the last one did.
    pub(super) unmeasured: [f64; J],
    /// Measured joint torques, in the robot's torque unit.
    pub(super) torques: [f64; J],
    /// Voltage of the sole's pressure sensor, V.
    pub(super) paw: f64,
    /// Number of cycles that the leg has been still in a search; `None` if it does not search.
    pub(super) search: Option<u16>,
}

impl<const J: usize> LegState<J> {
    /// Creates a leg in its initial posture, not controlled, with standard parameters.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn new(model: &Leg<J>, robot: &ModelFacts) -> Self {
        LegState {
            own: model.joints.map(|joint| joint.limits),
            model: *model,
            switches: LegSwitches::STANDARD,
            params: LegParams::standard(robot),
            drive: LegDrive::free(model.initial),
            vibrations: [JointVibration::STILL; J],
            angles: model.initial,
            rates: [0.0; J],
            unmeasured: [0.0; J],
            torques: [0.0; J],
            paw: 0.0,
            search: None,
        }
    }

    /// Advances leg `number` by one sampling time.
    ///
    /// # Errors
    /// The errors of its drive.
    pub(super) fn advance(&mut self, number: u8, cycle: &CycleParams) -> Result<(), Fault> {
        let room;
        let model = if self.switches.any_outside {
            room = self.room();
            &room
        } else {
            &self.model
        };
        let leg = MovingLeg {
            number,
            model,
            params: &self.params,
            measured: &self.angles,
        };
        self.drive.advance(&leg, cycle)
    }

    /// Returns the leg at its measured angles.
    pub(super) fn chain(&self) -> Chain<J> {
        Chain::new(&self.model, &self.angles)
    }

    /// Returns the measured place of one of its points, mm.
    pub(super) fn place(&self, point: LegPoint, inverse: Inverse) -> Result<Point, Fault> {
        let place = self.chain().point(point).ok_or(Fault::Domain)?;
        Ok(inverse.flat(place))
    }

    /// Returns a point's target, or its measured place if it has none, mm.
    pub(super) fn target(&self, point: LegPoint, inverse: Inverse) -> Result<Point, Fault> {
        let own = self.drive.own_point(point);
        match own.and_then(|track| track.goal().target()) {
            Some(target) => Ok(target),
            None => self.place(point, inverse),
        }
    }

    /// Returns the angles at which the joints stay: the measured ones, limited to the working limits. A joint that new
    /// limits left outside may stay there.
    pub(super) fn stays(&self) -> [f64; J] {
        let mut stays = self.model.within_limits(&self.angles);
        if self.switches.any_outside {
            let joints = self.switches.outside.iter().zip(&self.angles);
            for (stay, (outside, angle)) in stays.iter_mut().zip(joints) {
                if *outside {
                    *stay = *angle;
                }
            }
        }
        stays
    }

    /// Returns the joints' set points, with the velocities that the leg is commanded now. Joints that moved a
    /// controlled point stay where they are measured.
    pub(super) fn joints(&self, inverse: Inverse) -> [SetPoint<1>; J] {
        self.drive.joints(&self.model, &self.stays(), inverse)
    }

    /// Returns the commands of its joints, vibrations included.
    pub(super) fn outputs(&self, robot: &ModelFacts) -> [JointCommand; J] {
        let mut commands = self.drive.outputs();
        let Some(per_volt) = robot.vibration else {
            return commands;
        };
        let joints = self.model.joints.iter().zip(&self.params.joints);
        let states = self.vibrations.iter().zip(&self.angles);
        for (command, ((joint, params), (vibration, measured))) in
            commands.iter_mut().zip(joints.zip(states))
        {
            let most_torque = params.most_torque(joint, robot.torque_unit());
            *command = vibration.vibrated(*command, joint, *measured, (per_volt, most_torque));
        }
        commands
    }
}

/// The switches of one leg.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LegSwitches<const J: usize> {
    /// True if DIRECT holds for commands that name the foot.
    pub(super) direct_foot: bool,
    /// True if DIRECT holds for commands that name the joint.
    pub(super) direct: [bool; J],
    /// True if mode and target of the joint cannot be changed.
    pub(super) locked: [bool; J],
    /// True for a joint that SET_LIMIT left outside its limits and that has not been inside since.
    pub(super) outside: [bool; J],
    /// True if a joint is outside.
    pub(super) any_outside: bool,
}

impl<const J: usize> LegSwitches<J> {
    /// The switches at a program's start.
    const STANDARD: Self = LegSwitches {
        direct_foot: false,
        direct: [false; J],
        locked: [false; J],
        outside: [false; J],
        any_outside: false,
    };

    /// Returns true if a joint is locked.
    pub(super) fn has_locked(&self) -> bool {
        self.locked.contains(&true)
    }

    /// Returns true if a joint, counted from 0, is locked.
    pub(super) fn is_locked(&self, m: usize) -> bool {
        self.locked.get(m).is_some_and(|locked| *locked)
    }
}

impl<const J: usize> LegState<J> {
    /// Resets switches and working limits.
    pub(super) fn reset_switches(&mut self) {
        self.switches = LegSwitches::STANDARD;
        for (joint, own) in self.model.joints.iter_mut().zip(&self.own) {
            joint.limits = *own;
        }
    }

    /// Returns true if DIRECT holds for commands that name this target of the leg.
    pub(super) fn is_direct(&self, target: Target) -> bool {
        match joint_of(target) {
            None => self.switches.direct_foot,
            Some(m) => self.switches.direct.get(m).is_some_and(|direct| *direct),
        }
    }

    /// Returns the leg with room for joints that new limits left outside: they may hold or move
    /// inward, not farther out.
    pub(super) fn room(&self) -> Leg<J> {
        let mut room = self.model;
        let joints = self.switches.outside.iter().zip(&self.drive.angles);
        for (joint, (outside, angle)) in room.joints.iter_mut().zip(joints) {
            if *outside {
                joint.limits = joint.limits.including(*angle);
            }
        }
        room
    }

    /// Returns true if new limits left joint `m` (from 0) outside, within those of the robot.
    pub(super) fn may_be_outside(&self, m: usize, angle: f64) -> bool {
        let is_outside = self.switches.outside.get(m).is_some_and(|outside| *outside);
        let own = self.own.get(m);
        is_outside && own.is_some_and(|own| own.widened(ROUNDING).contains(angle))
    }

    /// Updates the joints that are inside their new limits now.
    pub(super) fn note_inside(&mut self) {
        let joints = self.model.joints.iter().zip(&self.angles);
        for (outside, (joint, angle)) in self.switches.outside.iter_mut().zip(joints) {
            *outside = *outside && !joint.limits.widened(ROUNDING).contains(*angle);
        }
        self.switches.any_outside = self.switches.outside.contains(&true);
    }

    /// Returns true if a command of a joint's angle, velocity or torque, counted from 0, or of all
    /// joints, would change a locked joint.
    pub(super) fn locks_angle(&self, joint: Option<usize>) -> bool {
        if !self.switches.has_locked() {
            return false;
        }
        let served = self.drive.served();
        joint.is_none_or(|m| self.switches.is_locked(m)) || self.locks_first(served)
    }

    /// Returns true if a command of a point's place or force would change a locked joint.
    pub(super) fn locks_point(&self, point: LegPoint) -> bool {
        if !self.switches.has_locked() {
            return false;
        }
        match (point, &self.drive.drive) {
            (LegPoint::Tip, _) | (_, Drive::Foot(_)) => true,
            (LegPoint::Joint(m), _) => self.locks_first(m + 1),
        }
    }

    /// Returns true if NO_COMPLIANCE of a joint, counted from 0, or of all joints, names or would
    /// change a locked joint.
    pub(super) fn locks_stiffening(&self, joint: Option<usize>) -> bool {
        let served = match &self.drive.drive {
            Drive::Foot(track) if track.goal().is_soft() => J,
            Drive::Third(track, _) if track.goal().is_soft() => THIRD,
            _ => 0,
        };
        match joint {
            None => self.switches.has_locked(),
            Some(m) => self.switches.is_locked(m) || self.locks_first(served),
        }
    }

    /// Returns true if a joint that moves a controlled point is locked, so that no joint of the leg can get its own
    /// control.
    pub(super) fn locks_served(&self) -> bool {
        self.locks_first(self.drive.served())
    }

    /// Puts the joints that are not locked under the control of `tracks`.
    pub(super) fn soften_unlocked(&mut self, tracks: &[SetPoint<1>; J], direct: bool) {
        // No locked joint moved a controlled point before.
        let mut joints = *tracks;
        let (first, own) = self.drive.own_joints();
        let own = (first..).zip(own);
        for (m, own) in own.filter(|(m, _)| self.switches.is_locked(*m)) {
            if let Some(joint) = joints.get_mut(m) {
                *joint = *own;
            }
        }
        for (m, joint) in joints.iter_mut().enumerate() {
            *joint = joint.jumping(joint.jumps() || (direct && !self.switches.is_locked(m)));
        }
        self.drive.drive = Drive::Joints(joints);
    }

    /// Returns true if one of the first `count` joints is locked.
    fn locks_first(&self, count: usize) -> bool {
        self.switches
            .locked
            .iter()
            .take(count)
            .any(|locked| *locked)
    }
}
