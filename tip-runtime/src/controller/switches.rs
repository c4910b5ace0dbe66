//! What edition 3.2 lets a program switch at joints: DIRECT and TRAJECTORY, LOCK and UNLOCK, and
//! working limits of its own. INITIAL_POSTURE and the end of a program put all of it back.

use super::drive::{Drive, THIRD};
use super::leg::LegState;
use super::trajectory::Track;
use super::{ControllerView, targets};
use crate::command::{Command, Target, Value};
use crate::fault::Fault;
use crate::kinematics::{LegPoint, ROUNDING};
use crate::model::{Leg, Range};

/// The switches of one leg.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LegSwitches<const J: usize> {
    /// DIRECT holds for commands that name the foot.
    direct_foot: bool,
    /// DIRECT holds for commands that name the joint.
    direct: [bool; J],
    /// Mode and target of the joint cannot be changed.
    locked: [bool; J],
    /// SET_LIMIT left the joint outside its limits, and it has not been inside since.
    pub(super) outside: [bool; J],
    /// One of them is outside.
    any_outside: bool,
}

impl<const J: usize> LegSwitches<J> {
    /// The switches at a program's start.
    pub(super) const STANDARD: Self = LegSwitches {
        direct_foot: false,
        direct: [false; J],
        locked: [false; J],
        outside: [false; J],
        any_outside: false,
    };

    /// Returns true if new limits left a joint outside.
    pub(super) fn has_outside(&self) -> bool {
        self.any_outside
    }

    /// Returns true if a joint is locked.
    pub(super) fn has_locked(&self) -> bool {
        self.locked.contains(&true)
    }

    /// Returns true if a joint, counted from 0, is locked.
    pub(super) fn is_locked(&self, m: usize) -> bool {
        self.locked.get(m).is_some_and(|locked| *locked)
    }

    /// Returns true if DIRECT holds for commands that name a joint, counted from 0, or the foot.
    pub(super) fn is_direct(&self, joint: Option<usize>) -> bool {
        match joint {
            None => self.direct_foot,
            Some(m) => self.direct.get(m).is_some_and(|direct| *direct),
        }
    }
}

impl<const J: usize> LegState<'_, J> {
    /// Puts back switches and working limits.
    pub(super) fn reset_switches(&mut self) {
        self.switches = LegSwitches::STANDARD;
        self.model = *self.own;
    }

    /// Returns true if DIRECT holds for commands that name this target of the leg.
    pub(super) fn is_direct(&self, target: Target) -> bool {
        self.switches.is_direct(joint_of(target))
    }

    /// Returns the leg with room for joints that new limits left outside: they may hold or move
    /// inward, not farther out.
    pub(super) fn room(&self) -> Leg<J> {
        let mut room = self.model;
        let joints = self.switches.outside.iter().zip(&self.drive.angles);
        for (joint, (outside, angle)) in room.joints.iter_mut().zip(joints) {
            if *outside {
                let Range { min, max } = joint.limits;
                joint.limits = Range::new(min.min(*angle), max.max(*angle));
            }
        }
        room
    }

    /// Returns true if new limits left joint `m` (from 0) outside, within those of the robot.
    pub(super) fn may_be_outside(&self, m: usize, angle: f64) -> bool {
        let is_outside = self.switches.outside.get(m).is_some_and(|outside| *outside);
        let own = self.own.joints.get(m);
        is_outside && own.is_some_and(|own| own.limits.widened(ROUNDING).contains(angle))
    }

    /// Takes note of joints that are inside their new limits now.
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

    /// Returns true if a joint that serves a point is locked, so that no joint of the leg can go for
    /// itself.
    pub(super) fn locks_served(&self) -> bool {
        self.locks_first(self.drive.served())
    }

    /// Puts the joints that are not locked under the control of `tracks`.
    pub(super) fn soften_unlocked(&mut self, tracks: &[Track<1>; J], direct: bool) {
        // Before this, no locked joint served a point.
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

/// Refuses what is locked.
pub(super) fn unlocked(is_locked: bool) -> Result<(), Fault> {
    if is_locked {
        Err(Fault::InvalidMode)
    } else {
        Ok(())
    }
}

impl<const J: usize> ControllerView<'_, J> {
    /// Runs DIRECT and TRAJECTORY. With ALL, what is locked keeps its switch.
    pub(super) fn switch_direct(&mut self, target: Target, on: bool) -> Result<(), Fault> {
        self.require_joints(target)?;
        let of_joint = joint_of(target);
        for leg in targets::feet(&mut self.legs, of_legs(target))? {
            let is_locked =
                of_joint.map_or_else(|| leg.switches.has_locked(), |m| leg.switches.is_locked(m));
            unlocked(is_locked && target != Target::All)?;
            let LegSwitches {
                direct_foot,
                direct,
                locked,
                ..
            } = &mut leg.switches;
            for (m, (direct, locked)) in direct.iter_mut().zip(locked).enumerate() {
                if !*locked && of_joint.is_none_or(|joint| joint == m) {
                    *direct = on;
                }
            }
            if of_joint.is_none() && !is_locked {
                *direct_foot = on;
            }
        }
        Ok(())
    }

    /// Runs LOCK and UNLOCK.
    pub(super) fn switch_lock(&mut self, target: Target, on: bool) -> Result<(), Fault> {
        self.require_joints(target)?;
        for leg in targets::feet(&mut self.legs, of_legs(target))? {
            for (m, locked) in leg.switches.locked.iter_mut().enumerate() {
                if names(target, m) {
                    *locked = on;
                }
            }
        }
        Ok(())
    }

    /// Runs SET_LIMIT: the low ends, then the high ones.
    pub(super) fn set_limits(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let target = command.target;
        let (n, count) = match target {
            Target::Joint(n, _) => (n, 1),
            Target::Foot(n) => (n, J),
            Target::None | Target::All | Target::Floor => return Err(Fault::Domain),
        };
        self.require_joints(target)?;
        if command.values.len() != 2 * count {
            return Err(Fault::Domain);
        }
        let (lows, highs) = command.values.split_at(count);
        let leg = targets::leg_mut(&mut self.legs, n)?;
        let mut limited = leg.model;
        let joints = limited.joints.iter_mut().zip(&leg.own.joints).enumerate();
        let joints = joints.filter(|(m, _)| names(target, *m));
        for ((_, (joint, own)), (low, high)) in joints.zip(lows.iter().zip(highs)) {
            joint.limits = within(own.limits, low, high).ok_or(Fault::Domain)?;
        }
        leg.model = limited;
        for (m, outside) in leg.switches.outside.iter_mut().enumerate() {
            *outside |= names(target, m);
        }
        leg.note_inside();
        Ok(())
    }

    /// Runs RESET_LIMIT: the robot's own limits hold again.
    pub(super) fn reset_limits(&mut self, target: Target) -> Result<(), Fault> {
        self.require_joints(target)?;
        for leg in targets::feet(&mut self.legs, of_legs(target))? {
            let joints = leg.model.joints.iter_mut().zip(&leg.own.joints);
            let joints = joints.zip(&mut leg.switches.outside).enumerate();
            for (m, ((joint, own), outside)) in joints {
                if names(target, m) {
                    joint.limits = own.limits;
                    *outside = false;
                }
            }
            leg.switches.any_outside = leg.switches.outside.contains(&true);
        }
        Ok(())
    }

    /// Refuses a target without joints.
    fn require_joints(&self, target: Target) -> Result<(), Fault> {
        match target {
            Target::All => Ok(()),
            Target::Foot(n) => self.leg(n).map(drop),
            Target::Joint(n, m) if targets::index(m) < J => self.leg(n).map(drop),
            Target::None | Target::Floor | Target::Joint(..) => Err(Fault::Domain),
        }
    }
}

/// Returns the target of all joints of the legs that a target names.
fn of_legs(target: Target) -> Target {
    match target {
        Target::Joint(n, _) => Target::Foot(n),
        target => target,
    }
}

/// Returns the joint (from 0) that a target names, if it names one alone.
pub(super) fn joint_of(target: Target) -> Option<usize> {
    match target {
        Target::Joint(_, m) => Some(targets::index(m)),
        Target::None | Target::All | Target::Floor | Target::Foot(_) => None,
    }
}

/// Returns true if a target of joints names joint `m` (from 0) of its legs.
fn names(target: Target, m: usize) -> bool {
    joint_of(target).is_none_or(|joint| joint == m)
}

/// Returns limits inside those of the robot.
fn within(own: Range, low: &Value, high: &Value) -> Option<Range> {
    let (low, high) = (low.number(), high.number());
    let is_inside = own.contains(low) && own.contains(high) && low < high;
    is_inside.then_some(Range::new(low, high))
}
