//! Commands that start a motion (T.I.P. 3.1 §7-1, §7-2); they take one cycle.

use super::drive::{Drive, Redundancy, THIRD, name, nearest_place, reach};
use super::targets::{Base, is_zero, joint_of, resolve, resolve_from, sum, unlocked};
use super::trajectory::{Goal, SetPoint};
use super::{ControllerView, targets};
use crate::command::{Command, Target, Value};
use crate::fault::Fault;
use crate::kinematics::{self, Chain, LegPoint};
use crate::model::{Family, Point};

impl<const J: usize> ControllerView<J> {
    /// Runs PTP and REL_PTP.
    pub(super) fn move_point(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        if command.target == Target::Floor {
            return self.move_slider(command, base);
        }
        let (n, point) = self.point_of(command.target)?;
        if point != LegPoint::Tip && self.robot.family != Family::Hand {
            return Err(Fault::Domain);
        }
        let values: &[Value; 3] = command.values.try_into().map_err(|_| Fault::Domain)?;
        let inverse = self.robot.inverse;
        let leg = self.leg(n)?;
        let moving = leg.drive.point(point, &leg.model, inverse);
        let limits = leg.params.foot.limits();
        let stop = base == Base::Target && is_zero(values);
        let direct = leg.is_direct(command.target);
        // A stop brakes as hard as the present motion may.
        let hs = command.hs || (stop && moving.goal().is_hs());
        let mut target = if stop {
            let rest = if direct {
                moving.position()
            } else {
                moving.rest_point(limits)
            };
            nearest_place(inverse, &leg.model, point, &leg.drive.angles, rest)
        } else {
            let from = match base {
                Base::Operand => leg.place(point, inverse)?,
                Base::Target => leg.target(point, inverse)?,
            };
            inverse.flat(resolve_from(values, from, base)?)
        };
        unlocked(leg.locks_point(point))?;
        let track = moving.towards(Goal::Point { target, hs });
        let how = (inverse, limits);
        let redundancy = match leg.drive.brakes_first(point, &track, &leg.model, how) {
            Some(_) if direct => Redundancy::None,
            Some(rates) => {
                if stop {
                    let angles = leg.drive.rest_angles(&rates, &leg.model, &leg.params);
                    let rest = Chain::new(&leg.model, &angles).point(point);
                    target = rest.map_or(target, |rest| inverse.flat(rest));
                }
                Redundancy::Brakes(rates)
            }
            None if stop || direct => Redundancy::None,
            None => {
                let line = (track.position(), target);
                Redundancy::seek(inverse, &leg.model, point, &leg.drive.angles, line, None)
            }
        };
        if !stop {
            self.require_reach(n, point, target)?;
        }
        let track = moving.towards(Goal::Point { target, hs });
        self.take_commanded_point(n, point, track, direct)?;
        targets::leg_mut(&mut self.legs, n)?.drive.redundancy = redundancy;
        Ok(())
    }

    /// Puts a point of leg `n` under control for a command. If that is `direct`, its set points are at their targets
    /// immediately.
    pub(super) fn take_commanded_point(
        &mut self,
        n: u8,
        point: LegPoint,
        track: SetPoint<3>,
        direct: bool,
    ) -> Result<(), Fault> {
        let from_foot = matches!(self.leg(n)?.drive.drive, Drive::Foot(_));
        self.take_point(n, point, track)?;
        if direct {
            let leg = targets::leg_mut(&mut self.legs, n)?;
            leg.drive.jump_to_point(from_foot);
        }
        Ok(())
    }

    /// Runs PTP and REL_PTP of the slider.
    fn move_slider(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        let slider = self.robot.slider.ok_or(Fault::Domain)?;
        let values: &[Value; 3] = command.values.try_into().map_err(|_| Fault::Domain)?;
        let stop = base == Base::Target && is_zero(values);
        let mut target = match base {
            _ if stop => self.slider.rest_point(self.params.slider.limits()),
            Base::Operand => resolve(values, self.slider_at)?,
            Base::Target => {
                let target = self.slider.goal().target();
                sum(values, target.unwrap_or(self.slider_at))?
            }
        };
        if !stop && !slider.reaches(target) {
            if self.params.emg {
                return Err(Fault::OutOfReach(Target::Floor));
            }
            for (at, travel) in target.iter_mut().zip(slider.travel) {
                *at = travel.nearest(*at);
            }
        }
        let hs = command.hs || (stop && self.slider.goal().is_hs());
        self.slider = self.slider.towards(Goal::Point { target, hs });
        Ok(())
    }

    /// Runs PTP_ANGLE and REL_PTP_ANGLE.
    pub(super) fn move_joints(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        let (n, first, count) = self.joints_of(command)?;
        let inverse = self.robot.inverse;
        let emg = self.params.emg;
        let leg = targets::leg_mut(&mut self.legs, n)?;
        let stop = base == Base::Target && is_zero(command.values);
        let direct = leg.is_direct(command.target);
        let mut tracks = leg.joints(inverse);
        let stays = leg.stays();
        let states = leg.model.joints.iter().zip(leg.angles.iter().zip(&stays));
        let states = states.zip(&leg.params.joints);
        let chosen = tracks.iter_mut().zip(states).enumerate().skip(first);
        let chosen = chosen.take(count).zip(command.values);
        let mut reach = Ok(());
        for ((m, (track, ((joint, (measured, stays)), params))), value) in chosen {
            let current = match (leg.drive.point_of_joint(m), track.goal().target()) {
                (None, Some([target])) => target,
                _ => *measured,
            };
            if track.goal().is_soft() {
                *track = SetPoint::resting([*stays]);
            }
            let [target] = match base {
                _ if stop && direct => track.position(),
                _ if stop => track.rest_point(params.limits()),
                Base::Operand => resolve(&[*value], [*measured])?,
                Base::Target => sum(&[*value], [current])?,
            };
            let reachable = joint.limits.widened(kinematics::ROUNDING).contains(target);
            if emg && !stop && !reachable {
                let fault = Fault::OutOfReach(Target::Joint(n, targets::number(m)));
                reach = reach.and(Err(fault));
            }
            let hs = command.hs || (stop && track.goal().is_hs());
            *track = track.towards(Goal::Point {
                target: [target],
                hs,
            });
        }
        unlocked(leg.locks_angle(joint_of(command.target)))?;
        reach?;
        leg.drive.take_joints(tracks, (first, count), direct);
        Ok(())
    }

    /// Runs VEL_CONTROL.
    pub(super) fn drive_foot(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let Target::Foot(n) = command.target else {
            return Err(Fault::Domain);
        };
        let inverse = self.robot.inverse;
        let values: &[Value; 3] = command.values.try_into().map_err(|_| Fault::Domain)?;
        let leg = self.leg(n)?;
        let foot = leg.drive.point(LegPoint::Tip, &leg.model, inverse);
        let current = match foot.goal() {
            Goal::Speed(velocity) => velocity,
            _ => leg
                .chain()
                .point_velocity(LegPoint::Tip, &leg.rates)
                .ok_or(Fault::Domain)?,
        };
        let velocity = inverse.flat(resolve(values, current)?);
        unlocked(leg.locks_point(LegPoint::Tip))?;
        self.take_point(n, LegPoint::Tip, foot.towards(Goal::Speed(velocity)))
    }

    /// Runs OMEGA_CONTROL.
    pub(super) fn drive_joints(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let (n, first, count) = self.joints_of(command)?;
        let inverse = self.robot.inverse;
        let leg = targets::leg_mut(&mut self.legs, n)?;
        let mut tracks = leg.joints(inverse);
        let states = leg.stays().into_iter().zip(&leg.rates);
        let chosen = tracks.iter_mut().zip(states).skip(first).take(count);
        for ((track, (stays, rate)), value) in chosen.zip(command.values) {
            let current = match track.goal() {
                Goal::Speed(velocity) => velocity,
                _ => [*rate],
            };
            if track.goal().is_soft() {
                *track = SetPoint::resting([stays]);
            }
            *track = track.towards(Goal::Speed(resolve(&[*value], current)?));
        }
        unlocked(leg.locks_angle(joint_of(command.target)))?;
        leg.drive.drive = Drive::Joints(tracks);
        Ok(())
    }

    /// Puts a point of leg `n` under control.
    pub(super) fn take_point(
        &mut self,
        n: u8,
        point: LegPoint,
        track: SetPoint<3>,
    ) -> Result<(), Fault> {
        let inverse = self.robot.inverse;
        let leg = targets::leg_mut(&mut self.legs, n)?;
        let stays = leg.stays();
        leg.drive
            .take_point(point, track, &leg.model, &stays, inverse);
        Ok(())
    }

    /// Puts a foot under position control at `target`, mm, from any state of its leg.
    pub(super) fn send_foot(&mut self, n: u8, target: Point, hs: bool) -> Result<(), Fault> {
        let foot = self.foot_track(n)?.towards(Goal::Point { target, hs });
        self.take_point(n, LegPoint::Tip, foot)
    }

    /// Returns a foot's set point, with the velocity that its leg is commanded now.
    pub(super) fn foot_track(&self, n: u8) -> Result<SetPoint<3>, Fault> {
        let leg = self.leg(n)?;
        let inverse = self.robot.inverse;
        Ok(leg.drive.point(LegPoint::Tip, &leg.model, inverse))
    }

    /// Returns the place at which a foot comes to rest if it brakes now, mm.
    pub(super) fn foot_rest_point(&self, n: u8) -> Result<Point, Fault> {
        let limits = self.leg(n)?.params.foot.limits();
        Ok(self.foot_track(n)?.rest_point(limits))
    }

    /// Returns a point's target, or its measured place if it has none, mm.
    pub(super) fn point_target(&self, n: u8, point: LegPoint) -> Result<Point, Fault> {
        self.leg(n)?.target(point, self.robot.inverse)
    }

    /// Returns the measured place of a point of leg `n`, mm.
    pub(super) fn measured_point(&self, n: u8, point: LegPoint) -> Result<Point, Fault> {
        self.leg(n)?.place(point, self.robot.inverse)
    }

    /// Refuses a target that the leg cannot reach; under EMG_OFF the leg goes as far as it can.
    pub(super) fn require_reach(&self, n: u8, point: LegPoint, target: Point) -> Result<(), Fault> {
        if !self.params.emg {
            return Ok(());
        }
        let leg = self.leg(n)?;
        let inverse = self.robot.inverse;
        let reached = reach(inverse, &leg.model, (point, n), &leg.drive.angles, target).is_ok();
        let elsewhere = || kinematics::search(&leg.model, point, target, inverse.axes()).is_some();
        if reached || (!inverse.is_closed() && elsewhere()) {
            Ok(())
        } else {
            Err(Fault::OutOfReach(name(point, n)))
        }
    }

    /// Returns the leg and the point that a command of positions or forces acts on.
    pub(super) fn point_of(&self, target: Target) -> Result<(u8, LegPoint), Fault> {
        match target {
            Target::Foot(n) => Ok((n, LegPoint::Tip)),
            Target::Joint(n, m) if targets::index(m) == THIRD && THIRD < J => {
                Ok((n, LegPoint::Joint(THIRD)))
            }
            Target::None | Target::All | Target::Floor | Target::Joint(..) => Err(Fault::Domain),
        }
    }

    /// Returns the leg, the first joint (from 0) and the number of joints that a command of angles
    /// acts on.
    pub(super) fn joints_of(&self, command: &Command<'_>) -> Result<(u8, usize, usize), Fault> {
        let (n, first, count) = match command.target {
            Target::Foot(n) => (n, 0, J),
            Target::Joint(n, m) => (n, targets::index(m), 1),
            Target::None | Target::All | Target::Floor => return Err(Fault::Domain),
        };
        let exists = self.leg(n).is_ok() && first < J;
        if exists && command.values.len() == count {
            Ok((n, first, count))
        } else {
            Err(Fault::Domain)
        }
    }
}
