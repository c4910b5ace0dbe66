//! Commands that start a motion (T.I.P. 3.1 §7-1, §7-2); they take one cycle.

use super::drive::{Drive, reach};
use super::trajectory::Goal;
use super::{Controller, targets};
use crate::command::{Command, Target, Value};
use crate::fault::Fault;
use crate::kinematics::{self, Chain};

/// How a REL_ command and a plain one read their operands.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Base {
    /// Each operand says for itself; relative ones count from the measured value.
    Operand,
    /// All count from the current target, else from the measured value; all zero stops.
    Target,
}

impl<const L: usize, const J: usize> Controller<'_, L, J> {
    /// PTP and REL_PTP.
    pub(super) fn move_foot(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        let n = foot_of(command.target)?;
        let values: &[Value; 3] = command.values.try_into().map_err(|_| Fault::Domain)?;
        let leg = targets::leg(&self.model.legs, n)?;
        let foot = targets::leg(&self.drives, n)?.foot(leg);
        let limits = targets::leg(&self.params.feet, n)?.limits();
        let target = if base == Base::Target && is_zero(values) {
            foot.rest_point(limits)
        } else {
            let target = match base {
                Base::Operand => resolve(values, self.measured_foot(n)?)?,
                Base::Target => sum(values, self.foot_target(n)?)?,
            };
            self.require_reach(n, target)?;
            target
        };
        // Coming to rest here keeps the braking that the motion under way allows.
        let hs = command.hs || (base == Base::Target && is_zero(values) && is_hs(foot.goal()));
        let foot = foot.towards(Goal::Point { target, hs });
        targets::leg_mut(&mut self.drives, n)?.drive = Drive::Foot(foot);
        Ok(())
    }

    /// PTP_ANGLE and REL_PTP_ANGLE.
    pub(super) fn move_joints(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        let (n, first, count) = self.joints_of(command)?;
        let leg = targets::leg(&self.model.legs, n)?;
        let measured = targets::leg(&self.measured.angles, n)?;
        let drive = targets::leg_mut(&mut self.drives, n)?;
        let params = targets::leg(&self.params.joints, n)?;
        let served = matches!(drive.drive, Drive::Foot(_));
        let stop = base == Base::Target && is_zero(command.values);
        let mut tracks = drive.joints(leg, measured);
        let states = leg.joints.iter().zip(measured).zip(params);
        let chosen = tracks.iter_mut().zip(states).enumerate().skip(first);
        let chosen = chosen.take(count).zip(command.values);
        for ((m, (track, ((joint, measured), params))), value) in chosen {
            let current = match track.goal() {
                Goal::Point {
                    target: [target], ..
                } if !served => target,
                _ => *measured,
            };
            let [target] = match base {
                _ if stop => track.rest_point(params.limits()),
                Base::Operand => resolve(&[*value], [*measured])?,
                Base::Target => sum(&[*value], [current])?,
            };
            let reachable = joint.limits.widened(kinematics::ROUNDING).contains(target);
            if self.params.emg && !stop && !reachable {
                return Err(Fault::OutOfReach(Target::Joint(n, targets::number(m))));
            }
            let hs = command.hs || (stop && is_hs(track.goal()));
            *track = track.towards(Goal::Point {
                target: [target],
                hs,
            });
        }
        drive.drive = Drive::Joints(tracks);
        Ok(())
    }

    /// VEL_CONTROL.
    pub(super) fn drive_foot(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let n = foot_of(command.target)?;
        let values: &[Value; 3] = command.values.try_into().map_err(|_| Fault::Domain)?;
        let leg = targets::leg(&self.model.legs, n)?;
        let foot = targets::leg(&self.drives, n)?.foot(leg);
        let current = match foot.goal() {
            Goal::Speed(velocity) => velocity,
            Goal::Rest | Goal::Point { .. } => {
                let rates = targets::leg(&self.rates, n)?;
                Chain::new(leg, targets::leg(&self.measured.angles, n)?).foot_velocity(rates)
            }
        };
        let goal = Goal::Speed(resolve(values, current)?);
        targets::leg_mut(&mut self.drives, n)?.drive = Drive::Foot(foot.towards(goal));
        Ok(())
    }

    /// OMEGA_CONTROL.
    pub(super) fn drive_joints(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let (n, first, count) = self.joints_of(command)?;
        let leg = targets::leg(&self.model.legs, n)?;
        let measured = targets::leg(&self.measured.angles, n)?;
        let rates = targets::leg(&self.rates, n)?;
        let drive = targets::leg_mut(&mut self.drives, n)?;
        let mut tracks = drive.joints(leg, measured);
        let chosen = tracks.iter_mut().zip(rates).skip(first).take(count);
        for ((track, rate), value) in chosen.zip(command.values) {
            let current = match track.goal() {
                Goal::Speed(velocity) => velocity,
                Goal::Rest | Goal::Point { .. } => [*rate],
            };
            *track = track.towards(Goal::Speed(resolve(&[*value], current)?));
        }
        drive.drive = Drive::Joints(tracks);
        Ok(())
    }

    /// Puts a foot under position control at `target`, wherever its leg is now.
    pub(super) fn send_foot(&mut self, n: u8, target: [f64; 3], hs: bool) -> Result<(), Fault> {
        let leg = targets::leg(&self.model.legs, n)?;
        let drive = targets::leg_mut(&mut self.drives, n)?;
        let foot = drive.foot(leg).towards(Goal::Point { target, hs });
        drive.drive = Drive::Foot(foot);
        Ok(())
    }

    /// Where a foot comes to rest when it brakes now.
    pub(super) fn foot_rest_point(&self, n: u8) -> Result<[f64; 3], Fault> {
        let foot = targets::leg(&self.drives, n)?.foot(targets::leg(&self.model.legs, n)?);
        Ok(foot.rest_point(targets::leg(&self.params.feet, n)?.limits()))
    }

    /// A foot's target, or where the foot is if it has none.
    pub(super) fn foot_target(&self, n: u8) -> Result<[f64; 3], Fault> {
        let foot = targets::leg(&self.drives, n)?.foot(targets::leg(&self.model.legs, n)?);
        match foot.goal() {
            Goal::Point { target, .. } => Ok(target),
            Goal::Rest | Goal::Speed(_) => self.measured_foot(n),
        }
    }

    /// Where a foot is.
    pub(super) fn measured_foot(&self, n: u8) -> Result<[f64; 3], Fault> {
        let leg = targets::leg(&self.model.legs, n)?;
        Ok(Chain::new(leg, targets::leg(&self.measured.angles, n)?).foot())
    }

    /// Refuses a target that the leg cannot reach; under EMG_OFF the leg goes as far as it can.
    pub(super) fn require_reach(&self, n: u8, target: [f64; 3]) -> Result<(), Fault> {
        let leg = targets::leg(&self.model.legs, n)?;
        if self.params.emg && reach(self.model.inverse, leg, target, n).is_err() {
            return Err(Fault::OutOfReach(Target::Foot(n)));
        }
        Ok(())
    }

    /// Leg, first joint (from 0) and number of joints that a command of angles acts on.
    fn joints_of(&self, command: &Command<'_>) -> Result<(u8, usize, usize), Fault> {
        let (n, first, count) = match command.target {
            Target::Foot(n) => (n, 0, J),
            Target::Joint(n, m) => (n, targets::index(m), 1),
            Target::None | Target::All | Target::Floor => return Err(Fault::Domain),
        };
        let exists = usize::from(n) >= 1 && usize::from(n) <= L && first < J;
        if exists && command.values.len() == count {
            Ok((n, first, count))
        } else {
            Err(Fault::Domain)
        }
    }
}

fn foot_of(target: Target) -> Result<u8, Fault> {
    match target {
        Target::Foot(n) => Ok(n),
        Target::None | Target::All | Target::Floor | Target::Joint(..) => Err(Fault::Domain),
    }
}

fn is_zero(values: &[Value]) -> bool {
    values.iter().all(|value| value.v == 0.0)
}

fn is_hs<const N: usize>(goal: Goal<N>) -> bool {
    matches!(goal, Goal::Point { hs: true, .. })
}

/// The operands, relative ones counted from `base`.
fn resolve<const N: usize>(values: &[Value; N], base: [f64; N]) -> Result<[f64; N], Fault> {
    let mut resolved = base;
    for (resolved, value) in resolved.iter_mut().zip(values) {
        *resolved = crate::ops::finite(if value.relative {
            *resolved + value.v
        } else {
            value.v
        })?;
    }
    Ok(resolved)
}

/// The operands, all counted from `base`.
fn sum<const N: usize>(values: &[Value; N], base: [f64; N]) -> Result<[f64; N], Fault> {
    resolve(&values.map(|value| Value::relative(value.v)), base)
}
