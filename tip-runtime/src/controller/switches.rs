//! Switches of joints in edition 3.2: DIRECT and TRAJECTORY, LOCK and UNLOCK, and
//! working limits of its own. INITIAL_POSTURE and the end of a program put all of it back.

use super::leg::LegSwitches;
use super::targets::{joint_of, unlocked};
use super::{ControllerView, targets};
use crate::command::{Command, Target, Value};
use crate::fault::Fault;
use crate::model::Range;

impl<const J: usize> ControllerView<J> {
    /// Runs DIRECT and TRAJECTORY. With ALL, locked joints keep their switch.
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
        let joints = limited.joints.iter_mut().zip(&leg.own).enumerate();
        let joints = joints.filter(|(m, _)| names(target, *m));
        for ((_, (joint, own)), (low, high)) in joints.zip(lows.iter().zip(highs)) {
            joint.limits = within(*own, low, high).ok_or(Fault::Domain)?;
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
            let joints = leg.model.joints.iter_mut().zip(&leg.own);
            let joints = joints.zip(&mut leg.switches.outside).enumerate();
            for (m, ((joint, own), outside)) in joints {
                if names(target, m) {
                    joint.limits = *own;
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
