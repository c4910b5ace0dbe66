//! Commands that start a motion (T.I.P. 3.1 §7-1, §7-2); they take one cycle.

use super::drive::{Drive, THIRD, name, nearest_place, reach};
use super::operands::{Base, is_zero, resolve, resolve_from, sum};
use super::trajectory::{Goal, Track};
use super::{Controller, targets};
use crate::command::{Command, Target, Value};
use crate::fault::Fault;
use crate::kinematics::{self, Chain, Point};
use crate::model::{Family, Inverse};

impl<const L: usize, const J: usize> Controller<'_, L, J> {
    /// PTP and REL_PTP.
    pub(super) fn move_point(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        if command.target == Target::Floor {
            return self.move_slider(command, base);
        }
        let (n, point) = self.point_of(command.target)?;
        if point != Point::Tip && self.model.family != Family::Hand {
            return Err(Fault::Domain);
        }
        let values: &[Value; 3] = command.values.try_into().map_err(|_| Fault::Domain)?;
        let leg = targets::leg(&self.model.legs, n)?;
        let track = targets::leg(&self.drives, n)?.point(point, leg, self.model.inverse);
        let limits = targets::leg(&self.params.feet, n)?.limits();
        let stop = base == Base::Target && is_zero(values);
        let target = if stop {
            let angles = &targets::leg(&self.drives, n)?.angles;
            let rest = track.rest_point(limits);
            nearest_place(self.model.inverse, leg, point, angles, rest)
        } else {
            let from = match base {
                Base::Operand => self.measured_point(n, point)?,
                Base::Target => self.point_target(n, point)?,
            };
            let target = self.model.inverse.flat(resolve_from(values, from, base)?);
            self.require_reach(n, point, target)?;
            target
        };
        // Coming to rest here keeps the braking that the motion under way allows.
        let hs = command.hs || (stop && track.goal().is_hs());
        self.take_point(n, point, track.towards(Goal::Point { target, hs }))
    }

    /// PTP and REL_PTP of the slider.
    fn move_slider(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        let slider = self.model.slider.as_ref().ok_or(Fault::Domain)?;
        let values: &[Value; 3] = command.values.try_into().map_err(|_| Fault::Domain)?;
        let stop = base == Base::Target && is_zero(values);
        let mut target = match base {
            _ if stop => self.slider.rest_point(self.params.slider.limits()),
            Base::Operand => resolve(values, self.measured.slider)?,
            Base::Target => {
                let target = self.slider.goal().target();
                sum(values, target.unwrap_or(self.measured.slider))?
            }
        };
        if !stop && !slider.reaches(target) {
            if self.params.emg {
                return Err(Fault::OutOfReach(Target::Floor));
            }
            for (at, travel) in target.iter_mut().zip(slider.travel) {
                *at = at.max(travel.min).min(travel.max);
            }
        }
        let hs = command.hs || (stop && self.slider.goal().is_hs());
        self.slider = self.slider.towards(Goal::Point { target, hs });
        Ok(())
    }

    /// PTP_ANGLE and REL_PTP_ANGLE.
    pub(super) fn move_joints(&mut self, command: &Command<'_>, base: Base) -> Result<(), Fault> {
        let (n, first, count) = self.joints_of(command)?;
        let leg = targets::leg(&self.model.legs, n)?;
        let measured = targets::leg(&self.measured.angles, n)?;
        let drive = targets::leg_mut(&mut self.drives, n)?;
        let params = targets::leg(&self.params.joints, n)?;
        let stop = base == Base::Target && is_zero(command.values);
        let mut tracks = drive.joints(leg, measured, self.model.inverse);
        let states = leg.joints.iter().zip(measured).zip(params);
        let chosen = tracks.iter_mut().zip(states).enumerate().skip(first);
        let chosen = chosen.take(count).zip(command.values);
        for ((m, (track, ((joint, measured), params))), value) in chosen {
            let current = match (drive.point_of_joint(m), track.goal().target()) {
                (None, Some([target])) => target,
                _ => *measured,
            };
            if track.goal().is_soft() {
                *track = Track::resting([*measured]);
            }
            let [target] = match base {
                _ if stop => track.rest_point(params.limits()),
                Base::Operand => resolve(&[*value], [*measured])?,
                Base::Target => sum(&[*value], [current])?,
            };
            let reachable = joint.limits.widened(kinematics::ROUNDING).contains(target);
            if self.params.emg && !stop && !reachable {
                return Err(Fault::OutOfReach(Target::Joint(n, targets::number(m))));
            }
            let hs = command.hs || (stop && track.goal().is_hs());
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
        let Target::Foot(n) = command.target else {
            return Err(Fault::Domain);
        };
        let inverse = self.model.inverse;
        let values: &[Value; 3] = command.values.try_into().map_err(|_| Fault::Domain)?;
        let leg = targets::leg(&self.model.legs, n)?;
        let foot = targets::leg(&self.drives, n)?.point(Point::Tip, leg, inverse);
        let current = match foot.goal() {
            Goal::Speed(velocity) => velocity,
            _ => {
                let rates = targets::leg(&self.rates, n)?;
                Chain::new(leg, targets::leg(&self.measured.angles, n)?).foot_velocity(rates)
            }
        };
        let velocity = inverse.flat(resolve(values, current)?);
        self.take_point(n, Point::Tip, foot.towards(Goal::Speed(velocity)))
    }

    /// OMEGA_CONTROL.
    pub(super) fn drive_joints(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let (n, first, count) = self.joints_of(command)?;
        let leg = targets::leg(&self.model.legs, n)?;
        let measured = targets::leg(&self.measured.angles, n)?;
        let rates = targets::leg(&self.rates, n)?;
        let drive = targets::leg_mut(&mut self.drives, n)?;
        let mut tracks = drive.joints(leg, measured, self.model.inverse);
        let states = measured.iter().zip(rates);
        let chosen = tracks.iter_mut().zip(states).skip(first).take(count);
        for ((track, (measured, rate)), value) in chosen.zip(command.values) {
            let current = match track.goal() {
                Goal::Speed(velocity) => velocity,
                _ => [*rate],
            };
            if track.goal().is_soft() {
                *track = Track::resting([*measured]);
            }
            *track = track.towards(Goal::Speed(resolve(&[*value], current)?));
        }
        drive.drive = Drive::Joints(tracks);
        Ok(())
    }

    /// Puts a point of leg `n` under control.
    pub(super) fn take_point(&mut self, n: u8, point: Point, track: Track<3>) -> Result<(), Fault> {
        let leg = targets::leg(&self.model.legs, n)?;
        let measured = targets::leg(&self.measured.angles, n)?;
        let drive = targets::leg_mut(&mut self.drives, n)?;
        drive.take_point(point, track, leg, measured, self.model.inverse);
        Ok(())
    }

    /// Puts a foot under position control at `target`, wherever its leg is now.
    pub(super) fn send_foot(&mut self, n: u8, target: [f64; 3], hs: bool) -> Result<(), Fault> {
        let foot = self.foot_track(n)?.towards(Goal::Point { target, hs });
        self.take_point(n, Point::Tip, foot)
    }

    /// A foot's set point, in the motion that its leg is commanded now.
    pub(super) fn foot_track(&self, n: u8) -> Result<Track<3>, Fault> {
        let leg = targets::leg(&self.model.legs, n)?;
        Ok(targets::leg(&self.drives, n)?.point(Point::Tip, leg, self.model.inverse))
    }

    /// Where a foot comes to rest when it brakes now.
    pub(super) fn foot_rest_point(&self, n: u8) -> Result<[f64; 3], Fault> {
        let limits = targets::leg(&self.params.feet, n)?.limits();
        Ok(self.foot_track(n)?.rest_point(limits))
    }

    /// A point's target, or where the point is if it has none.
    pub(super) fn point_target(&self, n: u8, point: Point) -> Result<[f64; 3], Fault> {
        let own = targets::leg(&self.drives, n)?.own_point(point);
        match own.and_then(|track| track.goal().target()) {
            Some(target) => Ok(target),
            None => self.measured_point(n, point),
        }
    }

    /// Where a point of leg `n` is.
    pub(super) fn measured_point(&self, n: u8, point: Point) -> Result<[f64; 3], Fault> {
        let leg = targets::leg(&self.model.legs, n)?;
        let chain = Chain::new(leg, targets::leg(&self.measured.angles, n)?);
        let place = chain.point(point).ok_or(Fault::Domain)?;
        Ok(self.model.inverse.flat(place))
    }

    /// Refuses a target that the leg cannot reach; under EMG_OFF the leg goes as far as it can.
    pub(super) fn require_reach(&self, n: u8, point: Point, target: [f64; 3]) -> Result<(), Fault> {
        if !self.params.emg {
            return Ok(());
        }
        let leg = targets::leg(&self.model.legs, n)?;
        let inverse = self.model.inverse;
        let commanded = &targets::leg(&self.drives, n)?.angles;
        let reached = reach(inverse, leg, (point, n), commanded, target).is_ok();
        let elsewhere = || kinematics::search(leg, point, target, inverse.axes()).is_some();
        if reached || (inverse != Inverse::YawPitchPitch && elsewhere()) {
            Ok(())
        } else {
            Err(Fault::OutOfReach(name(point, n)))
        }
    }

    /// Leg and point that a command of positions or forces acts on.
    pub(super) fn point_of(&self, target: Target) -> Result<(u8, Point), Fault> {
        match target {
            Target::Foot(n) => Ok((n, Point::Tip)),
            Target::Joint(n, m) if targets::index(m) == THIRD && THIRD < J => {
                Ok((n, Point::Joint(THIRD)))
            }
            Target::None | Target::All | Target::Floor | Target::Joint(..) => Err(Fault::Domain),
        }
    }

    /// Leg, first joint (from 0) and number of joints that a command of angles acts on.
    pub(super) fn joints_of(&self, command: &Command<'_>) -> Result<(u8, usize, usize), Fault> {
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
