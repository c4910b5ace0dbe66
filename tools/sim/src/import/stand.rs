//! Initial postures of a robot that stands at a given height.

use super::ImportError;
use crate::message::Importing;
use crate::urdf::frame::length;
use crate::{Limb, Limit, Plant, Robot, Run, load};
use tip_runtime::kinematics::{Chain, inverse_from};
use tip_runtime::model::{Inverse, Leg, Model, Point, Range};
use tipc::description::{Description, WithModel};

/// Number of steps in which feet move towards their first joints, until all are within reach.
const NEARER: u8 = 8;
/// Number of other heights that are tried if the requested one is out of reach.
const OTHERS: u16 = 40;
/// Greatest difference of knee positions that rounding explains, mm.
const ROUNDING: f64 = 1e-6;

/// The posture of each leg: deg.
pub(super) type Postures = Vec<Vec<f64>>;

/// Returns the postures that put all feet `height` (mm) below the robot frame; a height out of
/// reach is refused with one that can be reached.
pub(super) fn postures(robot: &Description, height: f64) -> Result<Postures, ImportError> {
    let stands = robot.with_model(Stand { height });
    stands.map_err(|near| {
        ImportError::new(match near {
            Some(near) => Importing::CannotStand { height, near },
            None => Importing::StandsNowhere,
        })
    })
}

/// Heights that are tried if the initial posture is left open, as shares of the length of the
/// longest leg.
const SHARES: [f64; 6] = [0.8, 0.7, 0.6, 0.5, 0.4, 0.3];
/// Time that a robot with mass has to stand, ms.
const STANDS_FOR: u64 = 500;

/// Iterates over the whole heights that are tried for a robot whose initial posture is left open,
/// mm.
pub(super) fn heights(robot: &Description) -> impl Iterator<Item = f64> {
    let legs = Robot::described(robot).description().legs;
    let size = |leg: &Limb| {
        leg.joints
            .iter()
            .map(|joint| length(joint.link))
            .sum::<f64>()
    };
    let longest = legs.iter().map(size).fold(0.0, f64::max);
    SHARES
        .into_iter()
        .map(move |share| (share * longest).round())
}

/// Returns true if the robot stays on its feet in its initial posture, simulated with mass.
pub(super) fn stays_up(robot: &Description) -> bool {
    let robot = Robot::described(robot).with_plant(Plant::Dynamic);
    let text = format!("3.1\nstands still\n\nSLEEP {STANDS_FOR}\nEND\n");
    let Some(program) = load("still.prg", &text, &robot).ok() else {
        return false;
    };
    let Ok(mut run) = Run::new(program, robot) else {
        return false;
    };
    run.to_end(Limit::cycles(STANDS_FOR));
    run.motion()
        .is_some_and(|motion| motion.falls == 0 && motion.least_margin >= 0.0)
}

struct Stand {
    height: f64,
}

impl WithModel for Stand {
    type Output = Result<Postures, Option<f64>>;

    fn with<const L: usize, const J: usize>(self, model: &Model<L, J>) -> Self::Output {
        stand(model.inverse, &model.legs, self.height)
            .ok_or_else(|| nearest(model.inverse, &model.legs, self.height))
    }
}

/// Returns the reachable height that is nearest to another one, of those that are tried.
#[inline(never)] // Else it is compiled for each number of legs.
fn nearest<const J: usize>(kind: Inverse, legs: &[Leg<J>], height: f64) -> Option<f64> {
    let size = |leg: &Leg<J>| {
        leg.joints
            .iter()
            .map(|joint| length(joint.link))
            .sum::<f64>()
    };
    let most = legs.iter().map(size).fold(0.0, f64::max);
    let step = (most / f64::from(OTHERS)).ceil();
    let heights = (1..=OTHERS).map(|number| f64::from(number) * step);
    heights
        .filter(|other| stand(kind, legs, *other).is_some())
        .min_by(|a, b| (a - height).abs().total_cmp(&(b - height).abs()))
}

/// Returns postures with each foot in its position while all joints are at 0, or moved towards its
/// first joint as far as needed.
#[inline(never)]
fn stand<const J: usize>(kind: Inverse, legs: &[Leg<J>], height: f64) -> Option<Postures> {
    (0..=NEARER).find_map(|step| {
        let nearer = f64::from(step) / f64::from(NEARER);
        let postures = legs.iter().map(|leg| {
            let straight = Chain::new(leg, &[0.0; J]).foot();
            let along = |axis: usize| straight[axis] + nearer * (leg.base[axis] - straight[axis]);
            posture(kind, leg, [along(0), along(1), -height])
        });
        postures.collect()
    })
}

/// Returns the posture of a foot with the highest last joint, or else the one farthest behind, so
/// that all legs bend alike.
fn posture<const J: usize>(kind: Inverse, leg: &Leg<J>, foot: Point) -> Option<Vec<f64>> {
    let mut best: Option<(Point, [f64; J])> = None;
    for from in starts(leg) {
        let Some(found) = inverse_from(kind, leg, &from, foot) else {
            continue;
        };
        let knee = Chain::new(leg, &found).joints().last()?;
        if best.is_none_or(|(other, _)| is_above(knee, other)) {
            best = Some((knee, found));
        }
    }
    best.map(|(_, found)| found.to_vec())
}

/// Returns the initial posture, and postures with the last joint a quarter of its limits off either
/// end.
fn starts<const J: usize>(leg: &Leg<J>) -> [[f64; J]; 3] {
    let mut starts = [leg.initial; 3];
    let [_, low, high] = &mut starts;
    for (start, share) in [(low, 0.25), (high, 0.75)] {
        if let (Some(angle), Some(joint)) = (start.last_mut(), leg.joints.last()) {
            let Range { min, max } = joint.limits;
            *angle = min + share * (max - min);
        }
    }
    starts
}

fn is_above([_, y, z]: Point, [_, other_y, other_z]: Point) -> bool {
    match (z - other_z).abs() > ROUNDING {
        true => z > other_z,
        false => y < other_y - ROUNDING,
    }
}
