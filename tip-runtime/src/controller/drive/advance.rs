//! The advance of a leg by one sampling time: set points move, and joint commands follow from them.
//!
//! A joint's spring: `τ = k (θ_d − θ)`. A point's spring: `F = K (x_d − x)`, axis by axis. Either is
//! bounded by the compliance limit, if one is set. A force acts through the joints as `τ = Jᵀ F`, and
//! no joint is commanded more than `TORQUE_MAX`, or than its motor gives. This is stiffness control
//! without an inner force loop (Salisbury, *Active Stiffness Control of a Manipulator in Cartesian
//! Coordinates*, 1980), without damping of its own: that of the joints brings the robot to rest. Units:
//! deg, mm, N, and torques in the robot's torque unit.
//!
//! A point takes its velocity over from the joints that moved it. A stretched leg that turns moves its foot along the
//! border of its reach: neither on its way to the target nor by braking straight ahead would the foot stay
//! within it. So joints may brake first, each for itself.

use super::reach::{follow, has_few_joints, leap, name, reach};
use super::redundancy::{PointOfLeg, Redundancy, has_choice};
use super::{Drive, LegDrive, Solved, THIRD};
use crate::controller::params::{JointParams, LegParams};
use crate::controller::targets::number;
use crate::controller::trajectory::{Goal, Limits, SetPoint};
use crate::fault::Fault;
use crate::kinematics::{Chain, LegPoint, ROUNDING};
use crate::model::{Inverse, Joint, Leg};

/// Values that all legs share in an advance.
#[derive(Clone, Copy)]
pub(in crate::controller) struct CycleParams {
    /// Inverse kinematics of the robot.
    pub(in crate::controller) inverse: Inverse,
    /// Number of the robot's torque units in 1 N·m.
    pub(in crate::controller) torque_unit: f64,
    /// The sampling time, s.
    pub(in crate::controller) dt: f64,
    /// Reciprocal of the sampling time, 1/s; 0 if the sampling time is 0.
    pub(in crate::controller) per_second: f64,
    /// True if a hold brakes every motion and makes it wait.
    pub(in crate::controller) held: bool,
}

/// The leg that is advanced.
#[derive(Clone, Copy)]
pub(in crate::controller) struct MovingLeg<'a, const J: usize> {
    /// Number of the leg, from 1.
    pub(in crate::controller) number: u8,
    pub(in crate::controller) model: &'a Leg<J>,
    pub(in crate::controller) params: &'a LegParams<J>,
    /// The angles measured, deg.
    pub(in crate::controller) measured: &'a [f64; J],
}

impl<const J: usize> LegDrive<J> {
    /// Advances the leg by one sampling time. It stops where it can go no farther.
    ///
    /// # Errors
    /// The fault that stopped it: the path to a target is out of reach, or a joint is at its limit.
    pub(in crate::controller) fn advance(
        &mut self,
        leg: &MovingLeg<'_, J>,
        cycle: &CycleParams,
    ) -> Result<(), Fault> {
        let before = self.angles;
        let result = self.follow_tracks(leg, cycle);
        let turns = self.turns.iter_mut().zip(self.angles.iter().zip(before));
        for (turn, (angle, before)) in turns {
            *turn = (angle - before) * cycle.per_second;
        }
        result
    }

    fn follow_tracks(&mut self, leg: &MovingLeg<'_, J>, cycle: &CycleParams) -> Result<(), Fault> {
        self.torques = [None; J];
        match self.drive {
            Drive::Joints(mut tracks) => {
                let result = self.advance_joints(&mut tracks, 0, leg, cycle);
                self.drive = Drive::Joints(tracks);
                result
            }
            Drive::Foot(mut foot) => {
                let result = self.advance_point(LegPoint::Tip, &mut foot, leg, cycle);
                self.drive = Drive::Foot(foot);
                result
            }
            Drive::Third(mut third, mut tracks) => {
                let point = self.advance_point(LegPoint::Joint(THIRD), &mut third, leg, cycle);
                let joints = self.advance_joints(&mut tracks, THIRD, leg, cycle);
                self.drive = Drive::Third(third, tracks);
                point.and(joints)
            }
        }
    }

    fn advance_joints(
        &mut self,
        tracks: &mut [SetPoint<1>; J],
        first: usize,
        leg: &MovingLeg<'_, J>,
        cycle: &CycleParams,
    ) -> Result<(), Fault> {
        let mut result = Ok(());
        let data = leg.model.joints.iter().zip(&leg.params.joints);
        let data = data.zip(leg.measured);
        let each = tracks.iter_mut().zip(data).enumerate().skip(first);
        for (m, (track, ((joint, params), measured))) in each {
            let moved = if track.goal().is_soft() {
                self.advance_soft_joint(m, track, *measured, (joint, params), cycle);
                Ok(())
            } else {
                self.advance_stiff_joint((leg.number, m), track, (joint, params), cycle)
            };
            result = result.and(moved);
        }
        result
    }

    fn advance_stiff_joint(
        &mut self,
        (n, m): (u8, usize),
        track: &mut SetPoint<1>,
        (joint, params): (&Joint, &JointParams),
        cycle: &CycleParams,
    ) -> Result<(), Fault> {
        let Some(angle) = self.angles.get_mut(m) else {
            return Ok(());
        };
        let from = *angle;
        track.advance(params.limits(), cycle.dt, cycle.held);
        *angle = track.position().iter().sum();
        let free = joint.limits.including(from);
        let wanted = *angle;
        *angle = free.nearest(wanted);
        if !free.widened(ROUNDING).contains(wanted) {
            *track = track.stopped_at([*angle]);
            return Err(Fault::JointLimit(n, number(m)));
        }
        Ok(())
    }

    fn advance_soft_joint(
        &mut self,
        m: usize,
        track: &mut SetPoint<1>,
        measured: f64,
        (joint, params): (&Joint, &JointParams),
        cycle: &CycleParams,
    ) {
        track.advance(params.limits(), cycle.dt, cycle.held);
        let goal = track.goal();
        let [torque] = match goal {
            Goal::Effort(torque) => torque,
            _ => spring(
                [params.stiffness],
                track.position(),
                [measured],
                params.limit.map(|limit| [limit]),
            ),
        };
        if matches!(goal, Goal::Effort(_)) {
            *track = track.stopped_at([measured]);
        }
        self.push(m, torque, measured, (joint, params), cycle);
    }

    fn advance_point(
        &mut self,
        point: LegPoint,
        track: &mut SetPoint<3>,
        leg: &MovingLeg<'_, J>,
        cycle: &CycleParams,
    ) -> Result<(), Fault> {
        if track.goal().is_soft() {
            self.advance_soft_point(point, track, leg, cycle);
            return Ok(());
        }
        if let Redundancy::Brakes(rates) = self.redundancy {
            return self.brake(point, track, rates, (leg, cycle));
        }
        let before = *track;
        let limits = leg.params.foot.limits();
        let looking = PointOfLeg {
            leg: leg.model,
            point,
            axes: cycle.inverse.axes(),
        };
        self.redundancy.look(&looking, &self.angles, track, limits);
        let held = cycle.held || self.redundancy.waits();
        let jumps = track.jumps() && !held;
        track.advance(limits, cycle.dt, held);
        if let Some(target) = track.goal().target() {
            let line = (track.position(), target);
            self.redundancy.advance(line, cycle.dt, cycle.held);
        }
        match self.solve(point, (track, jumps), leg, cycle) {
            Ok(angles) => {
                let moving = self.angles.iter_mut().zip(angles);
                for (angle, new) in moving.take(point.moved_by(J)) {
                    *angle = new;
                }
                Ok(())
            }
            Err(fault) => {
                *track = before.stopped_at(before.position());
                Err(match track.goal().target() {
                    Some(_) => Fault::OutOfReach(name(point, leg.number)),
                    None => fault,
                })
            }
        }
    }

    /// Returns the angles that put a point at its set point, to which it may have jumped. A closed form is solved only
    /// once for a foot that stays in place.
    fn solve(
        &mut self,
        point: LegPoint,
        (track, jumps): (&SetPoint<3>, bool),
        leg: &MovingLeg<'_, J>,
        cycle: &CycleParams,
    ) -> Result<[f64; J], Fault> {
        let foot = track.position();
        let is_closed = cycle.inverse.is_closed() && point == LegPoint::Tip;
        let stays = |solved: &Solved<J>| {
            is_same(&solved.foot, &foot) && is_same(&solved.angles, &self.angles)
        };
        let solved = self.solved.filter(stays);
        if let Some(solved) = solved.filter(|_| is_closed) {
            return Ok(solved.angles);
        }
        let name = (point, leg.number);
        let target = track.goal().target();
        let posture =
            target.and_then(|target| self.redundancy.posture(&self.angles, (foot, target)));
        let angles = if jumps {
            leap(cycle.inverse, leg.model, name, &self.angles, foot)?
        } else {
            let path = (track, posture);
            follow(cycle.inverse, leg.model, name, &self.angles, path)?
        };
        if is_closed {
            self.solved = Some(Solved { foot, angles });
        }
        Ok(angles)
    }

    fn advance_soft_point(
        &mut self,
        point: LegPoint,
        track: &mut SetPoint<3>,
        leg: &MovingLeg<'_, J>,
        cycle: &CycleParams,
    ) {
        track.advance(leg.params.foot.limits(), cycle.dt, cycle.held);
        let chain = Chain::new(leg.model, leg.measured);
        let at = cycle.inverse.flat(chain.point(point).unwrap_or([0.0; 3]));
        let force = match track.goal() {
            Goal::Effort(force) => {
                *track = track.stopped_at(at);
                force
            }
            _ => {
                let params = &leg.params.foot;
                let stiffness = self.own_stiffness.unwrap_or(params.stiffness);
                spring(stiffness, track.position(), at, params.limit(point))
            }
        };
        let Some(torques) = chain.torques_of_force(point, force) else {
            return;
        };
        let data = leg.model.joints.iter().zip(&leg.params.joints);
        let data = data.zip(leg.measured);
        for (m, (torque, ((joint, params), measured))) in
            torques.iter().zip(data).enumerate().take(point.moved_by(J))
        {
            let torque = torque * cycle.torque_unit;
            self.push(m, torque, *measured, (joint, params), cycle);
        }
    }

    /// Commands joint `m` (from 0) a torque. A joint at its limit is not pushed farther, but held there.
    fn push(
        &mut self,
        m: usize,
        torque: f64,
        measured: f64,
        (joint, params): (&Joint, &JointParams),
        cycle: &CycleParams,
    ) {
        let (Some(slot), Some(angle)) = (self.torques.get_mut(m), self.angles.get_mut(m)) else {
            return;
        };
        if cycle.held {
            return;
        }
        let torque = bounded(torque, params.most_torque(joint, cycle.torque_unit));
        let outward = (torque > 0.0 && measured >= joint.limits.max)
            || (torque < 0.0 && measured <= joint.limits.min);
        if outward {
            *angle = joint.limits.nearest(measured);
        } else {
            *slot = Some(torque);
        }
    }
}

/// Returns true if the numbers are equal to the bit.
fn is_same<const N: usize>(a: &[f64; N], b: &[f64; N]) -> bool {
    a.map(f64::to_bits) == b.map(f64::to_bits)
}

/// Number of places on the way of a foot to its line at which its reach is checked.
const PLACES: u8 = 8;

/// Distance from its target within which a point has arrived, mm.
const THERE: f64 = 1e-6;

impl<const J: usize> LegDrive<J> {
    /// Returns the commanded rates of the joints (deg/s), if they have to come to rest before `point` can follow `track`.
    pub(in crate::controller) fn brakes_first(
        &self,
        point: LegPoint,
        track: &SetPoint<3>,
        leg: &Leg<J>,
        (inverse, limits): (Inverse, Limits),
    ) -> Option<[f64; J]> {
        if let Some(own) = self.own_point(point)
            && !own.goal().is_soft()
        {
            return match self.redundancy {
                Redundancy::Brakes(rates) => Some(rates),
                _ => None,
            };
        }
        if track.is_at_rest() || has_few_joints::<J>(inverse, point) {
            return None;
        }
        let reaches = |at| reach(inverse, leg, (point, 0), &self.angles, at).is_ok();
        let goes = if has_choice::<J>(inverse, point) {
            // The point may have to wait until postures are found.
            reaches(track.rest_point(limits))
        } else {
            let shares = (1..=PLACES).map(|place| f64::from(place) / f64::from(PLACES));
            shares
                .into_iter()
                .all(|share| reaches(track.ahead(limits, share)))
        };
        (!goes).then(|| self.rates(leg, inverse))
    }

    /// Returns the angles at which joints come to rest that brake from these rates.
    pub(in crate::controller) fn rest_angles(
        &self,
        rates: &[f64; J],
        leg: &Leg<J>,
        params: &LegParams<J>,
    ) -> [f64; J] {
        let mut angles = self.angles;
        let joints = leg.joints.iter().zip(&params.joints);
        for ((angle, rate), (joint, params)) in angles.iter_mut().zip(rates).zip(joints) {
            let [rest] = SetPoint::moving([*angle], [*rate]).rest_point(params.limits());
            *angle = joint.limits.nearest(rest);
        }
        angles
    }

    /// Brakes the joints that move `point` for one sampling time. The point goes where they lead it, and sets off when
    /// they are at rest.
    pub(super) fn brake(
        &mut self,
        point: LegPoint,
        track: &mut SetPoint<3>,
        mut rates: [f64; J],
        (leg, cycle): (&MovingLeg<'_, J>, &CycleParams),
    ) -> Result<(), Fault> {
        let mut result = Ok(());
        let joints = leg.model.joints.iter().zip(&leg.params.joints);
        let joints = joints.enumerate().take(point.moved_by(J));
        for ((m, joint), (rate, angle)) in joints.zip(rates.iter_mut().zip(self.angles)) {
            let mut braking = SetPoint::moving([angle], [*rate]);
            let moved = self.advance_stiff_joint((leg.number, m), &mut braking, joint, cycle);
            *rate = braking.velocity().iter().sum();
            result = result.and(moved);
        }
        let place = Chain::new(leg.model, &self.angles).point(point);
        *track = track.stopped_at(place.map_or(track.position(), |at| cycle.inverse.flat(at)));
        let is_at_rest = rates
            .iter()
            .take(point.moved_by(J))
            .all(|rate| *rate == 0.0);
        self.redundancy = match track.goal().target() {
            _ if !is_at_rest => Redundancy::Brakes(rates),
            Some(target) if !is_near(track.position(), target) => {
                let line = (track.position(), target);
                Redundancy::seek(cycle.inverse, leg.model, point, &self.angles, line, None)
            }
            _ => Redundancy::None,
        };
        result
    }
}

fn is_near(at: [f64; 3], target: [f64; 3]) -> bool {
    at.iter()
        .zip(target)
        .all(|(at, target)| libm::fabs(at - target) <= THERE)
}

/// Returns the pull of a spring, bounded by `limit` where there is one.
pub(super) fn spring<const N: usize>(
    stiffness: [f64; N],
    target: [f64; N],
    at: [f64; N],
    limit: Option<[f64; N]>,
) -> [f64; N] {
    let mut pull = stiffness;
    for (pull, (target, at)) in pull.iter_mut().zip(target.iter().zip(at)) {
        *pull *= target - at;
    }
    for (pull, limit) in pull.iter_mut().zip(limit.into_iter().flatten()) {
        *pull = bounded(*pull, limit);
    }
    pull
}

/// Returns `value` within ±`most`.
pub(in crate::controller) fn bounded(value: f64, most: f64) -> f64 {
    value.min(most).max(-most)
}
