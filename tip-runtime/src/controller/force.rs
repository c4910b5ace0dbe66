//! TORQUE, FORCE, COMPLIANCE_ and NO_COMPLIANCE (T.I.P. 3.1 §7-3); they take one cycle. The laws
//! that they set to work are in [`drive`](super::drive).

use super::drive::Drive;
use super::targets::{Base, joint_of, resolve, resolve_from, unlocked};
use super::trajectory::{Goal, SetPoint};
use super::{ControllerView, targets};
use crate::command::{Command, Target, Value};
use crate::fault::Fault;
use crate::kinematics::LegPoint;
use core::ops::RangeInclusive;

impl<const J: usize> ControllerView<J> {
    /// Runs TORQUE: relative operands count from the torque commanded, or else from that sensed.
    pub(super) fn torque(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let (n, first, count) = self.joints_of(command)?;
        let inverse = self.robot.inverse;
        let leg = targets::leg_mut(&mut self.legs, n)?;
        let mut tracks = leg.joints(inverse);
        let states = leg.angles.iter().zip(&leg.torques);
        let chosen = tracks.iter_mut().zip(states).skip(first).take(count);
        for ((track, (measured, sensed)), value) in chosen.zip(command.values) {
            let current = match track.goal() {
                Goal::Effort(torque) => torque,
                _ => [*sensed],
            };
            let torque = resolve(&[*value], current)?;
            *track = SetPoint::resting([*measured]).towards(Goal::Effort(torque));
        }
        unlocked(leg.locks_angle(joint_of(command.target)))?;
        leg.drive.drive = Drive::Joints(tracks);
        Ok(())
    }

    /// Runs FORCE: relative operands count from the force commanded, or else from that sensed, or
    /// else from 0.
    pub(super) fn force(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let (n, point) = self.point_of(command.target)?;
        let values: &[Value; 3] = command.values.try_into().map_err(|_| Fault::Domain)?;
        let own = self.leg(n)?.drive.own_point(point);
        let current = match own.map(SetPoint::goal) {
            Some(Goal::Effort(force)) => force,
            _ => self.sensed_force(n, point)?.unwrap_or([0.0; 3]),
        };
        let force = self.robot.inverse.flat(resolve(values, current)?);
        unlocked(self.leg(n)?.locks_point(point))?;
        self.push_point(n, point, force)
    }

    /// Puts a point under force control.
    pub(super) fn push_point(
        &mut self,
        n: u8,
        point: LegPoint,
        force: [f64; 3],
    ) -> Result<(), Fault> {
        let place = self.measured_point(n, point)?;
        self.take_point(
            n,
            point,
            SetPoint::resting(place).towards(Goal::Effort(force)),
        )
    }

    /// Runs COMPLIANCE_ANGLE and REL_COMPLIANCE_ANGLE. With ALL, no leg is softened unless each can
    /// be.
    pub(super) fn soften_joints(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        let all = command.target == Target::All;
        for n in self.legs_of(command.target)? {
            self.softened(&of_leg(command, n), base)?;
            let is_locked = self.leg(n)?.locks_angle(joint_of(command.target));
            unlocked(is_locked && !all)?;
        }
        for n in self.legs_of(command.target)? {
            let command = of_leg(command, n);
            let (_, first, count) = self.joints_of(&command)?;
            let tracks = self.softened(&command, base)?;
            let leg = targets::leg_mut(&mut self.legs, n)?;
            let direct = leg.is_direct(command.target);
            if leg.locks_served() {
                continue;
            }
            if leg.switches.has_locked() {
                leg.soften_unlocked(&tracks, direct);
            } else {
                leg.drive.take_joints(tracks, (first, count), direct);
            }
        }
        Ok(())
    }

    fn softened(&self, command: &Command<'_>, base: Base) -> Result<[SetPoint<1>; J], Fault> {
        let (n, first, count) = self.joints_of(command)?;
        let leg = self.leg(n)?;
        let mut tracks = leg.joints(self.robot.inverse);
        let states = tracks.iter_mut().zip(&leg.angles).enumerate();
        let chosen = states.skip(first).take(count).zip(command.values);
        for ((m, (track, measured)), value) in chosen {
            let from = match (base, leg.drive.point_of_joint(m), track.goal().target()) {
                (Base::Target, None, Some(target)) => target,
                _ => [*measured],
            };
            let target = resolve_from(&[*value], from, base)?;
            let hs = command.hs;
            *track = track.towards(Goal::Spring { target, hs });
        }
        Ok(tracks)
    }

    /// Runs COMPLIANCE_POSITION and REL_COMPLIANCE_POSITION. With ALL, no leg is softened unless
    /// each can be.
    pub(super) fn soften_point(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        let all = command.target == Target::All;
        for n in self.legs_of(command.target)? {
            let (point, _) = self.softened_point(&of_leg(command, n), base)?;
            unlocked(!all && self.leg(n)?.locks_point(point))?;
        }
        for n in self.legs_of(command.target)? {
            let command = of_leg(command, n);
            let (point, track) = self.softened_point(&command, base)?;
            let leg = self.leg(n)?;
            if !leg.locks_point(point) {
                let direct = leg.is_direct(command.target);
                self.take_commanded_point(n, point, track, direct)?;
            }
        }
        Ok(())
    }

    fn softened_point(
        &self,
        command: &Command<'_>,
        base: Base,
    ) -> Result<(LegPoint, SetPoint<3>), Fault> {
        let (n, point) = self.point_of(command.target)?;
        let values: &[Value; 3] = command.values.try_into().map_err(|_| Fault::Domain)?;
        let from = match base {
            Base::Operand => self.measured_point(n, point)?,
            Base::Target => self.point_target(n, point)?,
        };
        let inverse = self.robot.inverse;
        let target = inverse.flat(resolve_from(values, from, base)?);
        let leg = self.leg(n)?;
        let track = leg.drive.strained_point(point, &leg.model, inverse);
        let hs = command.hs;
        Ok((point, track.towards(Goal::Spring { target, hs })))
    }

    /// Returns the legs that a target of one leg, or of all, means.
    fn legs_of(&self, target: Target) -> Result<RangeInclusive<u8>, Fault> {
        match target {
            Target::All => Ok(1..=self.count()),
            Target::Foot(n) | Target::Joint(n, _) => Ok(n..=n),
            Target::None | Target::Floor => Err(Fault::Domain),
        }
    }

    /// Runs NO_COMPLIANCE: joints and points that follow a torque, force or spring are held where
    /// they are measured.
    pub(super) fn stiffen(&mut self, target: Target) -> Result<(), Fault> {
        let (n, first, count) = match target {
            Target::Foot(n) => (n, 0, J),
            Target::Joint(n, m) if targets::index(m) < J => (n, targets::index(m), 1),
            Target::None | Target::All | Target::Floor | Target::Joint(..) => {
                return Err(Fault::Domain);
            }
        };
        let inverse = self.robot.inverse;
        let leg = targets::leg_mut(&mut self.legs, n)?;
        unlocked(leg.locks_stiffening(joint_of(target)))?;
        let mut tracks = match &leg.drive.drive {
            Drive::Foot(track) if !track.goal().is_soft() => return Ok(()),
            _ => leg.joints(inverse),
        };
        let chosen = tracks.iter_mut().zip(leg.stays());
        let chosen = chosen.skip(first).take(count);
        for (track, measured) in chosen {
            if track.goal().is_soft() {
                let target = [measured];
                *track = SetPoint::resting(target).towards(Goal::Point { target, hs: false });
            }
        }
        leg.drive.drive = match leg.drive.drive {
            Drive::Third(third, _) if !third.goal().is_soft() => Drive::Third(third, tracks),
            _ => Drive::Joints(tracks),
        };
        Ok(())
    }

    /// Returns the force with which a point pushes, as the joint torques reveal it, N; `None` in a
    /// singular posture.
    pub(super) fn sensed_force(&self, n: u8, point: LegPoint) -> Result<Option<[f64; 3]>, Fault> {
        let forces = self.robot.forces.ok_or(Fault::Domain)?;
        let leg = self.leg(n)?;
        let torques = leg
            .torques
            .map(|torque| torque / forces.unit.per_newton_metre());
        let axes = self.robot.inverse.axes();
        Ok(leg.chain().force_of_torques(point, &torques, axes))
    }
}

/// Narrows a command for all legs to leg `n`.
fn of_leg<'c>(command: &Command<'c>, n: u8) -> Command<'c> {
    let target = match command.target {
        Target::All => Target::Foot(n),
        target => target,
    };
    Command { target, ..*command }
}
