//! TORQUE, FORCE, COMPLIANCE_ and NO_COMPLIANCE (T.I.P. 3.1 §7-3); they take one cycle. The laws
//! that they set to work are in [`law`](super::drive).

use super::drive::Drive;
use super::operands::{Base, resolve, resolve_from};
use super::trajectory::{Goal, Track};
use super::{Controller, targets};
use crate::command::{Command, Target, Value};
use crate::fault::Fault;
use crate::kinematics::{Chain, Point};

impl<const L: usize, const J: usize> Controller<'_, L, J> {
    /// TORQUE: relative operands count from the torque commanded, else from that sensed.
    pub(super) fn torque(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let (n, first, count) = self.joints_of(command)?;
        let leg = targets::leg(&self.model.legs, n)?;
        let measured = targets::leg(&self.measured.angles, n)?;
        let sensed = targets::leg(&self.measured.torques, n)?;
        let drive = targets::leg_mut(&mut self.drives, n)?;
        let mut tracks = drive.joints(leg, measured, self.model.inverse);
        let states = measured.iter().zip(sensed);
        let chosen = tracks.iter_mut().zip(states).skip(first).take(count);
        for ((track, (measured, sensed)), value) in chosen.zip(command.values) {
            let current = match track.goal() {
                Goal::Effort(torque) => torque,
                _ => [*sensed],
            };
            let torque = resolve(&[*value], current)?;
            *track = Track::resting([*measured]).towards(Goal::Effort(torque));
        }
        drive.drive = Drive::Joints(tracks);
        Ok(())
    }

    /// FORCE: relative operands count from the force commanded, else from that sensed, else from 0.
    pub(super) fn force(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let (n, point) = self.point_of(command.target)?;
        let values: &[Value; 3] = command.values.try_into().map_err(|_| Fault::Domain)?;
        let own = targets::leg(&self.drives, n)?.own_point(point);
        let current = match own.map(Track::goal) {
            Some(Goal::Effort(force)) => force,
            _ => self.sensed_force(n, point)?.unwrap_or([0.0; 3]),
        };
        let force = self.model.inverse.flat(resolve(values, current)?);
        self.push_point(n, point, force)
    }

    /// Puts a point under force control.
    pub(super) fn push_point(&mut self, n: u8, point: Point, force: [f64; 3]) -> Result<(), Fault> {
        let place = self.measured_point(n, point)?;
        self.take_point(n, point, Track::resting(place).towards(Goal::Effort(force)))
    }

    /// COMPLIANCE_ANGLE and REL_COMPLIANCE_ANGLE.
    pub(super) fn soften_joints(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        if command.target != Target::All {
            return self.soften_joints_of_leg(command, base);
        }
        let before = self.drives;
        for n in 1..=targets::number(L.wrapping_sub(1)) {
            let target = Target::Foot(n);
            let softened = self.soften_joints_of_leg(&Command { target, ..*command }, base);
            if softened.is_err() {
                self.drives = before;
                return softened;
            }
        }
        Ok(())
    }

    fn soften_joints_of_leg(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        let (n, first, count) = self.joints_of(command)?;
        let leg = targets::leg(&self.model.legs, n)?;
        let measured = targets::leg(&self.measured.angles, n)?;
        let drive = targets::leg_mut(&mut self.drives, n)?;
        let mut tracks = drive.joints(leg, measured, self.model.inverse);
        let states = tracks.iter_mut().zip(measured).enumerate();
        let chosen = states.skip(first).take(count).zip(command.values);
        for ((m, (track, measured)), value) in chosen {
            let from = match (base, drive.point_of_joint(m), track.goal().target()) {
                (Base::Target, None, Some(target)) => target,
                _ => [*measured],
            };
            let target = resolve_from(&[*value], from, base)?;
            let hs = command.hs;
            *track = track.towards(Goal::Spring { target, hs });
        }
        drive.drive = Drive::Joints(tracks);
        Ok(())
    }

    /// COMPLIANCE_POSITION and REL_COMPLIANCE_POSITION.
    pub(super) fn soften_point(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        if command.target != Target::All {
            return self.soften_point_of_leg(command, base);
        }
        let before = self.drives;
        for n in 1..=targets::number(L.wrapping_sub(1)) {
            let target = Target::Foot(n);
            let softened = self.soften_point_of_leg(&Command { target, ..*command }, base);
            if softened.is_err() {
                self.drives = before;
                return softened;
            }
        }
        Ok(())
    }

    fn soften_point_of_leg(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        let (n, point) = self.point_of(command.target)?;
        let values: &[Value; 3] = command.values.try_into().map_err(|_| Fault::Domain)?;
        let from = match base {
            Base::Operand => self.measured_point(n, point)?,
            Base::Target => self.point_target(n, point)?,
        };
        let inverse = self.model.inverse;
        let target = inverse.flat(resolve_from(values, from, base)?);
        let leg = targets::leg(&self.model.legs, n)?;
        let track = targets::leg(&self.drives, n)?.strained_point(point, leg, inverse);
        let hs = command.hs;
        self.take_point(n, point, track.towards(Goal::Spring { target, hs }))
    }

    /// NO_COMPLIANCE: what a torque, force or spring decides about is held where it is measured.
    pub(super) fn stiffen(&mut self, target: Target) -> Result<(), Fault> {
        let (n, first, count) = match target {
            Target::Foot(n) => (n, 0, J),
            Target::Joint(n, m) if targets::index(m) < J => (n, targets::index(m), 1),
            Target::None | Target::All | Target::Floor | Target::Joint(..) => {
                return Err(Fault::Domain);
            }
        };
        let leg = targets::leg(&self.model.legs, n)?;
        let measured = targets::leg(&self.measured.angles, n)?;
        let drive = targets::leg_mut(&mut self.drives, n)?;
        let mut tracks = match &drive.drive {
            Drive::Foot(track) if !track.goal().is_soft() => return Ok(()),
            _ => drive.joints(leg, measured, self.model.inverse),
        };
        let chosen = tracks.iter_mut().zip(measured).skip(first).take(count);
        for (track, measured) in chosen {
            if track.goal().is_soft() {
                let target = [*measured];
                *track = Track::resting(target).towards(Goal::Point { target, hs: false });
            }
        }
        drive.drive = match drive.drive {
            Drive::Third(third, _) if !third.goal().is_soft() => Drive::Third(third, tracks),
            _ => Drive::Joints(tracks),
        };
        Ok(())
    }

    /// The force with which a point pushes, as the joint torques reveal it: N; `None` in a singular
    /// posture.
    pub(super) fn sensed_force(&self, n: u8, point: Point) -> Result<Option<[f64; 3]>, Fault> {
        let forces = self.model.forces.as_ref().ok_or(Fault::Domain)?;
        let leg = targets::leg(&self.model.legs, n)?;
        let chain = Chain::new(leg, targets::leg(&self.measured.angles, n)?);
        let sensed = targets::leg(&self.measured.torques, n)?;
        let torques = sensed.map(|torque| torque / forces.unit.per_newton_metre());
        let axes = self.model.inverse.axes();
        Ok(chain.force_of_torques(point, &torques, axes))
    }
}
