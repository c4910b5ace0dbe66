//! Contacts between legs: those that meet push each other apart.

use super::Vector;
use super::leg::LegBody;
use super::spatial::MovingFrame;
use crate::command::MAX;
use crate::plant::ContactLaw;
use crate::plant::cuboid::Cuboid;
use crate::plant::self_collision::nearest_points;

/// The coefficient of Coulomb friction between legs.
const FRICTION: f64 = 0.5;

/// Pushes legs apart that meet.
pub(super) fn push_legs_apart<const J: usize>(
    legs: &mut [LegBody<J>],
    frame: &MovingFrame,
    law: &ContactLaw,
) {
    const NOWHERE: Cuboid = Cuboid {
        low: Vector::new(0.0, 0.0, 0.0),
        high: Vector::new(0.0, 0.0, 0.0),
    };
    let mut boxes = [NOWHERE; MAX];
    for (own, leg) in boxes.iter_mut().zip(legs.iter()) {
        *own = around(leg, frame);
    }
    for (number, own) in (0..).zip(&boxes).take(legs.len()).skip(1) {
        let Some((before, rest)) = legs.split_at_mut_checked(number) else {
            return;
        };
        let Some(leg) = rest.first_mut() else {
            return;
        };
        for (m, (other, theirs)) in before.iter_mut().zip(&boxes).enumerate() {
            if !own.may_be_within(f64::MIN_POSITIVE, theirs) {
                continue;
            }
            for j in 0..J {
                for i in 0..J {
                    if leg.capsules.meets(j, (m, i)) {
                        push_apart((&mut *leg, j), (&mut *other, i), frame, law);
                    }
                }
            }
        }
    }
}

/// Pushes two links apart, if they meet.
fn push_apart<const J: usize>(
    (leg, j): (&mut LegBody<J>, usize),
    (other, i): (&mut LegBody<J>, usize),
    frame: &MovingFrame,
    law: &ContactLaw,
) {
    let Some((one, two)) = leg.link(j, frame).zip(other.link(i, frame)) else {
        return;
    };
    let [at, from] = nearest_points(one, two);
    let gap = (at - from).norm();
    let thickness = (leg.capsules.radius(j) + other.capsules.radius(i)) / 1000.0;
    let depth = thickness - gap;
    if depth > 0.0 && gap > 0.0 {
        let normal = (at - from) / gap;
        let velocity = leg.velocity(j, at, frame) - other.velocity(i, from, frame);
        let away = velocity.dot(&normal);
        let push = law.push(depth, away);
        let rub = (velocity - normal * away) * law.damping;
        let most = FRICTION * push / rub.norm().max(FRICTION * push);
        let force = if push > 0.0 {
            normal * push - rub * most
        } else {
            Vector::zeros()
        };
        leg.push(j, at, force);
        other.push(i, from, -force);
    }
}

/// Returns the box around a leg, from the body's origin, m.
fn around<const J: usize>(leg: &LegBody<J>, frame: &MovingFrame) -> Cuboid {
    let mut low = Vector::repeat(f64::INFINITY);
    let mut high = -low;
    for (j, [start, end]) in (0..J).filter_map(|j| Some((j, leg.link(j, frame)?))) {
        let radius = Vector::repeat(leg.capsules.radius(j) / 1000.0);
        low = low.inf(&(start - radius)).inf(&(end - radius));
        high = high.sup(&(start + radius)).sup(&(end + radius));
    }
    Cuboid { low, high }
}
