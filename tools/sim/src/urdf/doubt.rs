//! What a file says for want of knowing it: placeholders, and nothing where there must be something.

use super::chain::{Chain, Turning};
use super::pose::Pose;
use super::robot::{Joint, Kind, Link};
use super::values::printed;
use super::weight;
use crate::message::Importing;
use std::f64::consts::PI;
use tipc::message::list::List;

/// What is more than this stands for a motor without limit: N·m.
const STRONGEST: f64 = 1e5;
/// No leg's motor is as strong as that: N·m.
const STRONG: f64 = 1e3;
/// No joint turns as fast as that: rad/s.
const FAST: f64 = 1e3;
/// Half a turn as files write it, as 3.14: rad.
const HALF_TURN: f64 = PI - 2e-3;

/// The limits of a joint that has some: rad.
pub(super) fn ends(joint: &Joint) -> Option<[f64; 2]> {
    let ends = [joint.limit.lower, joint.limit.upper];
    let has_ends = ends.iter().all(|end| end.is_finite()) && ends[0] < ends[1];
    (joint.kind == Kind::Revolute && has_ends).then_some(ends)
}

/// The torque of a joint that has one: N·m.
pub(super) fn effort(joint: &Joint) -> Option<f64> {
    let effort = joint.limit.effort;
    (effort > 0.0 && effort <= STRONGEST).then_some(effort)
}

/// Whether a velocity says nothing: one of 0, or one that no joint reaches.
pub(super) fn is_no_velocity(velocity: f64) -> bool {
    !(velocity > 0.0 && velocity < FAST)
}

/// What has to be assumed or looked at, a line for each kind. No link is larger than `reach`: mm.
pub(super) fn of(legs: &[Chain<'_>], base: &[(&Link, Pose)], reach: f64) -> Vec<Importing> {
    let joints = |is: fn(&Turning<'_>) -> bool| {
        let all = legs.iter().flat_map(|leg| &leg.joints);
        some(all.filter(|turning| is(turning)).map(|it| &it.joint.name))
    };
    let links = |is: &dyn Fn(&Link) -> bool| {
        let all = legs.iter().flat_map(|leg| &leg.joints);
        let all = base.iter().chain(all.flat_map(|turning| &turning.links));
        some(all.filter(|(link, _)| is(link)).map(|(link, _)| &link.name))
    };
    [
        joints(|it| ends(it.joint).is_none()).map(|joints| Importing::TurnsAllRound { joints }),
        joints(|it| effort(it.joint).is_none()).map(|joints| Importing::Motor { joints }),
        joints(|it| ends(it.joint).is_some_and(is_turn))
            .map(|joints| Importing::DoubtfulLimits { joints }),
        joints(|it| effort(it.joint).is_some_and(|effort| effort >= STRONG))
            .map(|joints| Importing::DoubtfulEffort { joints }),
        joints(|it| is_no_velocity(it.joint.limit.velocity))
            .map(|joints| Importing::DoubtfulVelocity { joints }),
        joints(|it| weight::mass(&it.links) <= 0.0).map(|joints| Importing::NoMass { joints }),
        links(&weight::is_flat).map(|links| Importing::NoInertia { links }),
        links(&|link| weight::is_doubtful(link, reach))
            .map(|links| Importing::DoubtfulInertia { links }),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn is_turn([lower, upper]: [f64; 2]) -> bool {
    lower <= -HALF_TURN && upper >= HALF_TURN
}

/// The names, if there are any.
fn some<'a>(names: impl Iterator<Item = &'a String>) -> Option<List> {
    let names: Vec<String> = names.map(|name| printed(name)).collect();
    (!names.is_empty()).then_some(List(names))
}
