//! Self-collision: legs that meet push each other apart. Links are rods whose thickness is in
//! proportion to their length.

use super::Vector;
use super::leg::LegBody;
use super::spatial::MovingFrame;
use crate::command::MAX;
use crate::plant::ContactLaw;

/// Radius of a link, as a share of its length.
const RADIUS: f64 = 0.05;
/// The coefficient of Coulomb friction between legs.
const FRICTION: f64 = 0.5;

/// Returns the share of their thickness that links have, so that none touch in this posture: 1 if
/// they are far enough apart.
pub(super) fn clearance<const J: usize>(legs: &[LegBody<J>], frame: &MovingFrame) -> f64 {
    let mut clearance = 1.0_f64;
    for (number, leg) in legs.iter().enumerate() {
        for other in legs.iter().take(number) {
            for (j, i) in pairs::<J>() {
                if let Some((one, two)) = leg.link(j, frame).zip(other.link(i, frame)) {
                    let [at, from] = nearest(one, two);
                    clearance = clearance.min((at - from).norm() / thickness(one, two));
                }
            }
        }
    }
    if clearance.is_nan() { 0.0 } else { clearance }
}

/// Pushes legs apart that meet.
pub(super) fn push_legs_apart<const J: usize>(
    legs: &mut [LegBody<J>],
    frame: &MovingFrame,
    law: &ContactLaw,
    clearance: f64,
) {
    let mut boxes = [[Vector::zeros(); 2]; MAX];
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
        for (other, theirs) in before.iter_mut().zip(&boxes) {
            if are_near(own, theirs) {
                for (j, i) in pairs::<J>() {
                    collide((&mut *leg, j), (&mut *other, i), frame, law, clearance);
                }
            }
        }
    }
}

/// Iterates over all pairs of links of two legs except the first of both, which are next to each
/// other on the body.
fn pairs<const J: usize>() -> impl Iterator<Item = (usize, usize)> {
    (0..J)
        .flat_map(|j| (0..J).map(move |i| (j, i)))
        .filter(|pair| *pair != (0, 0))
}

/// Pushes two links apart, if they meet.
fn collide<const J: usize>(
    (leg, j): (&mut LegBody<J>, usize),
    (other, i): (&mut LegBody<J>, usize),
    frame: &MovingFrame,
    law: &ContactLaw,
    clearance: f64,
) {
    let Some((one, two)) = leg.link(j, frame).zip(other.link(i, frame)) else {
        return;
    };
    let [at, from] = nearest(one, two);
    let gap = (at - from).norm();
    let depth = thickness(one, two) * clearance - gap;
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

/// Returns true if the boxes around two legs meet.
#[inline]
fn are_near([low, high]: &[Vector; 2], [least, most]: &[Vector; 2]) -> bool {
    (0..3).all(|axis| {
        let at = |point: &Vector| point.get(axis).copied().unwrap_or(0.0);
        at(low) <= at(most) && at(least) <= at(high)
    })
}

/// Returns the box around a leg, m.
fn around<const J: usize>(leg: &LegBody<J>, frame: &MovingFrame) -> [Vector; 2] {
    let ends = (0..J).filter_map(|j| leg.link(j, frame));
    let mut least = Vector::repeat(f64::INFINITY);
    let mut most = -least;
    for [start, end] in ends {
        let radius = Vector::repeat(RADIUS * (end - start).norm());
        least = least.inf(&(start - radius)).inf(&(end - radius));
        most = most.sup(&(start + radius)).sup(&(end + radius));
    }
    [least, most]
}

/// Returns the distance of the axes of two links that touch, m.
#[inline]
fn thickness([a, b]: [Vector; 2], [c, d]: [Vector; 2]) -> f64 {
    RADIUS * ((b - a).norm() + (d - c).norm())
}

/// Returns the nearest points of two segments (Ericson, *Real-Time Collision Detection*, 2005,
/// §5.1.9).
#[inline]
fn nearest([a, b]: [Vector; 2], [c, d]: [Vector; 2]) -> [Vector; 2] {
    let (along, beside, apart) = (b - a, d - c, a - c);
    let (square, other) = (along.norm_squared(), beside.norm_squared());
    let (to, of) = (along.dot(&apart), beside.dot(&apart));
    let both = along.dot(&beside);
    let area = square * other - both * both;
    let share = if area > 1e-12 * square * other {
        part(both * of - to * other, area)
    } else {
        0.0
    };
    let second = part(both * share + of, other);
    let share = part(both * second - to, square);
    [a + along * share, c + beside * second]
}

/// Returns the fraction, limited to 0…1.
#[inline]
fn part(of: f64, total: f64) -> f64 {
    if total > 0.0 && of > 0.0 {
        (of / total).min(1.0)
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the least distance of points of two segments, by sampling.
    fn tried([a, b]: [Vector; 2], [c, d]: [Vector; 2]) -> f64 {
        let points = |from: Vector, to: Vector| {
            (0..=200).map(move |n| from + (to - from) * (f64::from(n) / 200.0))
        };
        let others = || points(c, d);
        let distances = points(a, b).flat_map(|one| others().map(move |two| (one - two).norm()));
        distances.fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn nothing_is_nearer_than_the_nearest() {
        let mut state = 1_u64;
        let mut number = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 40) as f64 / f64::from(1 << 23) - 1.0
        };
        let mut point = || Vector::new(number(), number(), number());
        for _ in 0..50 {
            let (one, two) = ([point(), point()], [point(), point()]);
            let [at, from] = nearest(one, two);
            let (found, tried) = ((at - from).norm(), tried(one, two));
            assert!(
                found <= tried + 1e-12 && found > tried - 0.02,
                "{found}, {tried}"
            );
        }
        let origin = Vector::zeros();
        let [at, from] = nearest([origin, origin], [Vector::x(), Vector::x()]);
        assert_eq!((at, from), (origin, Vector::x()), "points");
    }
}
