//! What a file says for want of knowing it: placeholders, and nothing where there must be something.

use super::chain::{Chain, Turning};
use super::pose::Pose;
use super::robot::{Joint, Kind, Link};
use super::values::printed;
use super::weight;
use super::write::measure;
use crate::message::Importing;
use std::f64::consts::{PI, TAU};
use tipc::message::list::List;

/// What is more than this stands for a motor without limit: N·m.
const STRONGEST: f64 = 1e5;
/// No leg's motor is as strong as that: N·m.
const STRONG: f64 = 1e3;
/// No joint turns as fast as that: rad/s.
const FAST: f64 = 1e3;
/// Half a turn as files write it, as 3.14: rad.
const HALF_TURN: f64 = PI - 2e-3;

/// What a file says of how far a joint turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stated {
    Nothing,
    /// Of a continuous joint, where it has no meaning.
    Unheeded,
    Infinite,
    /// One end; the other one is infinite or not stated.
    OneEnd,
    Swapped,
    Locked,
    BothEnds,
}

/// The limits of a joint (rad), unless it turns all round, and what the file says of them.
fn limits(joint: &Joint) -> (Option<[f64; 2]>, Stated) {
    let limit = &joint.limit;
    // An end that is not stated is at 0 before 1.2, if that leaves the joint some room.
    let other = |leaves_room: bool| match leaves_room {
        true => limit.unstated,
        false => f64::INFINITY,
    };
    let [lower, upper] = match (limit.lower, limit.upper) {
        (None, None) => return (None, Stated::Nothing),
        _ if joint.kind == Kind::Continuous => return (None, Stated::Unheeded),
        (Some(lower), Some(upper)) => [lower, upper],
        (Some(lower), None) => [lower, other(lower < 0.0)],
        (None, Some(upper)) => [-other(upper > 0.0), upper],
    };
    let [from, to] = [lower.min(upper), lower.max(upper)];
    let turn = |ends, stated| {
        let stated = match lower > upper {
            true => Stated::Swapped,
            false => stated,
        };
        (Some(ends), stated)
    };
    let both_stated = limit.lower.is_some() && limit.upper.is_some();
    match [from, to].map(f64::is_finite) {
        [false, false] => (None, Stated::Infinite),
        // The other end is half a turn off 0, or a whole turn off this one.
        [true, false] if from < PI => turn([from, PI], Stated::OneEnd),
        [true, false] => turn([from, from + TAU], Stated::OneEnd),
        [false, true] if to > -PI => turn([-PI, to], Stated::OneEnd),
        [false, true] => turn([to - TAU, to], Stated::OneEnd),
        [true, true] if from == to => turn([from, to], Stated::Locked),
        [true, true] if both_stated => turn([from, to], Stated::BothEnds),
        [true, true] => turn([from, to], Stated::OneEnd),
    }
}

/// The limits of a joint that has some: rad.
pub(super) fn ends(joint: &Joint) -> Option<[f64; 2]> {
    limits(joint).0
}

/// A joint and the limits that it gets: deg.
fn limited(joint: &Joint) -> String {
    let name = printed(&joint.name);
    match ends(joint) {
        Some(ends) => {
            let [from, to] = ends.map(|end| measure(end.to_degrees()));
            format!("{name} [{from}, {to}]")
        }
        None => name,
    }
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
    let stating = |stated: Stated| {
        let all = legs.iter().flat_map(|leg| &leg.joints);
        let those = all.filter(|it| limits(it.joint).1 == stated);
        let names: Vec<String> = those.map(|it| limited(it.joint)).collect();
        (!names.is_empty()).then_some(List(names))
    };
    [
        stating(Stated::Nothing).map(|joints| Importing::TurnsAllRound { joints }),
        stating(Stated::Unheeded).map(|joints| Importing::LimitsOfContinuous { joints }),
        stating(Stated::Infinite).map(|joints| Importing::InfiniteLimits { joints }),
        stating(Stated::OneEnd).map(|joints| Importing::OpenLimits { joints }),
        stating(Stated::Swapped).map(|joints| Importing::SwappedLimits { joints }),
        stating(Stated::Locked).map(|joints| Importing::LockedJoints { joints }),
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
