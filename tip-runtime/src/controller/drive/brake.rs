//! Joints that brake, each for itself, before their leg moves a point.
//!
//! A point takes its velocity over from the joints that moved it. A stretched leg that turns moves its foot along the
//! border of its reach: neither on its way to the target nor by braking straight ahead would the foot stay
//! within it.

use super::reach::{has_few_joints, reach};
use super::redundancy::{Redundancy, has_choice};
use super::{CycleParams, LegDrive, MovingLeg};
use crate::controller::params::LegParams;
use crate::controller::trajectory::{Limits, Track};
use crate::fault::Fault;
use crate::kinematics::{Chain, LegPoint};
use crate::model::{Inverse, Leg};

/// At how many places of its way to the line a foot is tried out.
const PLACES: u8 = 8;

/// Distance from its target at which a point has nowhere to go, mm.
const THERE: f64 = 1e-6;

impl<const J: usize> LegDrive<J> {
    /// Returns the rates (deg/s) at which the joints turn, if they have to come to rest before
    /// `point` can set off as `track` does.
    pub(in crate::controller) fn brakes_first(
        &self,
        point: LegPoint,
        track: &Track<3>,
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
            // It may have to wait for its postures.
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
            let [rest] = Track::moving([*angle], [*rate]).rest_point(params.limits());
            *angle = joint.limits.nearest(rest);
        }
        angles
    }

    /// Lets the joints that move `point` brake for one sampling time; the point goes where they lead it, and sets
    /// off once they are at rest.
    pub(super) fn brake(
        &mut self,
        point: LegPoint,
        track: &mut Track<3>,
        mut rates: [f64; J],
        (leg, cycle): (&MovingLeg<'_, J>, &CycleParams),
    ) -> Result<(), Fault> {
        let mut result = Ok(());
        let joints = leg.model.joints.iter().zip(&leg.params.joints);
        let joints = joints.enumerate().take(point.moved_by(J));
        for ((m, joint), (rate, angle)) in joints.zip(rates.iter_mut().zip(self.angles)) {
            let mut braking = Track::moving([angle], [*rate]);
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
                Redundancy::to_place(cycle.inverse, leg.model, point, &self.angles, line)
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
