//! Feet in space: joint angles of a foothold, the speed of joints on a stride, support polygons, and the centre of mass.

use tip_runtime::model::Point;
use tip_sim::{Limb, RobotDescription};

/// Distance that joints keep from their limits, deg.
const INSET: f64 = 2.0;
/// Largest error of a foot, mm.
const CLOSE: f64 = 0.05;
/// Maximum number of iterations of the inverse kinematics.
const ITERATIONS: usize = 40;

/// Returns the joint angles (deg) that put the foot of a leg at a point (mm), near other angles; `None` outside of its reach.
///
/// Damped least squares (Levenberg–Marquardt) with a numeric Jacobian: legs may have any number of joints.
pub(super) fn angles(limb: &Limb, target: Point, near: &[f64]) -> Option<Vec<f64>> {
    const TURN: f64 = 0.01;
    let mut angles = near.to_vec();
    for _ in 0..ITERATIONS {
        let foot = limb.foot(&angles);
        let error = [0, 1, 2].map(|axis| target[axis] - foot[axis]);
        if size(error) < CLOSE {
            return is_within(limb, &angles).then_some(angles);
        }
        let columns: Vec<Point> = (0..angles.len())
            .map(|joint| {
                let mut turned = angles.clone();
                turned[joint] += TURN;
                let moved = limb.foot(&turned);
                [0, 1, 2].map(|axis| (moved[axis] - foot[axis]) / TURN)
            })
            .collect();
        // (J Jᵀ + λ I) y = error; the step is Jᵀ y.
        let mut matrix = [[0.0; 3]; 3];
        for (i, row) in matrix.iter_mut().enumerate() {
            for (j, cell) in row.iter_mut().enumerate() {
                *cell = columns.iter().map(|column| column[i] * column[j]).sum();
            }
            row[i] += 1e-3;
        }
        let weights = solve(matrix, error)?;
        let steps = columns.iter().map(|column| dot(*column, weights));
        for (angle, step) in angles.iter_mut().zip(steps) {
            *angle += step.clamp(-20.0, 20.0);
        }
    }
    None
}

fn is_within(limb: &Limb, angles: &[f64]) -> bool {
    let mut joints = limb.joints.iter().zip(&limb.initial).zip(angles);
    joints.all(|((joint, initial), angle)| {
        // The initial posture may be nearer to a limit.
        let min = (joint.limits.min + INSET).min(*initial);
        let max = (joint.limits.max - INSET).max(*initial);
        (min..=max).contains(angle)
    })
}

/// Solves three linear equations by Cramer's rule; `None` if they are singular.
fn solve(m: [[f64; 3]; 3], b: Point) -> Option<Point> {
    let det = |m: [[f64; 3]; 3]| {
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
            - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    };
    let whole = det(m);
    let replaced = |column: usize| {
        let mut m = m;
        for (row, value) in m.iter_mut().zip(b) {
            row[column] = value;
        }
        det(m) / whole
    };
    (whole.abs() > 1e-12).then(|| [0, 1, 2].map(replaced))
}

/// A velocity of the body: to the right and ahead, mm/s; turn to the left, deg/s.
pub(super) type Twist = [f64; 3];

/// Returns where a foot is, seen from the body, that the body has left behind for a time (s) at a velocity.
pub(super) fn left_behind([x, y, z]: Point, twist: Twist, seconds: f64) -> Point {
    let [right, ahead, turn] = twist.map(|part| part * seconds);
    let (sin, cos) = (-turn).to_radians().sin_cos();
    [cos * x - sin * y - right, sin * x + cos * y - ahead, z]
}

/// The times of a stride.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stride {
    /// Time of a foot in the air, s.
    pub(super) swing: f64,
    /// Time of a foot on the floor, s.
    pub(super) stance: f64,
    /// Height of a step, mm.
    pub(super) lift: f64,
    /// Control cycle, s.
    pub(super) cycle: f64,
}

/// Returns the greatest speed of a joint on a stride, deg/s; `None` if a foot does not reach.
pub(super) fn fastest_joint(
    description: &RobotDescription,
    homes: &[Point],
    twist: Twist,
    stride: Stride,
) -> Option<f64> {
    let cycles = |seconds: f64| (seconds / stride.cycle).round().max(1.0) as u32;
    let (standing, swinging) = (cycles(stride.stance), cycles(stride.swing));
    let half = stride.stance / 2.0;
    let mut fastest = 0.0_f64;
    for (limb, home) in description.legs.iter().zip(homes) {
        let mut before: Option<Vec<f64>> = None;
        let mut near = limb.initial.clone();
        for n in 0..=standing + swinging {
            let point = if n <= standing {
                let part = f64::from(n) / f64::from(standing);
                left_behind(*home, twist, half * (2.0 * part - 1.0))
            } else {
                let part = f64::from(n - standing) / f64::from(swinging);
                let angle = core::f64::consts::PI * part;
                let share = (1.0 - angle.cos()) / 2.0;
                let from = left_behind(*home, twist, half + part * stride.swing);
                let to = left_behind(*home, twist, -half - (1.0 - part) * stride.swing);
                let height = stride.lift * angle.sin();
                [0, 1, 2].map(|axis| {
                    let up = if axis == 2 { height } else { 0.0 };
                    from[axis] + (to[axis] - from[axis]) * share + up
                })
            };
            let now = angles(limb, point, &near)?;
            if let Some(before) = &before {
                let turns = now.iter().zip(before).map(|(now, before)| now - before);
                let most = turns.map(f64::abs).fold(0.0, f64::max);
                fastest = fastest.max(most / stride.cycle);
            }
            near.clone_from(&now);
            before = Some(now);
        }
    }
    Some(fastest)
}

/// Returns the largest number up to `most` for which a condition holds, if it holds for all smaller ones.
pub(super) fn largest(most: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, most);
    for _ in 0..10 {
        let middle = (low + high) / 2.0;
        if holds(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Returns the distance of a point from the edge of the convex hull of others, mm; negative outside.
pub(super) fn margin(feet: &[[f64; 2]], point: [f64; 2]) -> f64 {
    let cross = |o: [f64; 2], a: [f64; 2], b: [f64; 2]| {
        (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])
    };
    // Of each directed line through two feet that has all others on its left, the distance of the point.
    let mut least = f64::INFINITY;
    for (i, a) in feet.iter().enumerate() {
        for (j, b) in feet.iter().enumerate() {
            let length = (b[0] - a[0]).hypot(b[1] - a[1]);
            if i == j || length < 1e-9 || feet.iter().any(|foot| cross(*a, *b, *foot) < -1e-9) {
                continue;
            }
            least = least.min(cross(*a, *b, point) / length);
        }
    }
    if feet.len() < 3 { -least.abs() } else { least }
}

/// Returns x and y of the centre of mass with legs at these angles, in the robot frame, mm.
pub(super) fn centre_of_mass(description: &RobotDescription, angles: &[Vec<f64>]) -> [f64; 2] {
    let mut all = Vec::new();
    if let Some(body) = &description.body {
        let centre = body.inertial.map_or([0.0; 3], |inertial| inertial.centre);
        all.push((body.mass, centre));
    }
    for (limb, angles) in description.legs.iter().zip(angles) {
        for (frame, joint) in limb.frames(angles).iter().zip(&limb.joints) {
            let centre = joint.inertial.map(|inertial| inertial.centre);
            let centre = centre.unwrap_or(joint.link.map(|part| part / 2.0));
            all.push((joint.mass, frame.point(centre)));
        }
    }
    let mass: f64 = all.iter().map(|(mass, _)| mass).sum();
    [0, 1].map(|axis| all.iter().map(|(own, at)| own * at[axis]).sum::<f64>() / mass)
}

/// Returns the middle of feet, mm.
pub(super) fn middle(feet: &[Point]) -> [f64; 2] {
    let count = feet.len() as f64;
    [0, 1].map(|axis| feet.iter().map(|foot| foot[axis]).sum::<f64>() / count)
}

/// Returns the legs in their order around the robot.
pub(super) fn around(feet: &[Point]) -> Vec<usize> {
    let [x, y] = middle(feet);
    let angle = |leg: usize| (feet[leg][1] - y).atan2(feet[leg][0] - x);
    let mut order: Vec<usize> = (0..feet.len()).collect();
    order.sort_by(|a, b| angle(*a).total_cmp(&angle(*b)));
    order
}

/// Returns the two legs beside one, around the robot.
pub(super) fn beside(feet: &[Point], leg: usize) -> [usize; 2] {
    let order = around(feet);
    let count = order.len();
    let place = order.iter().position(|other| *other == leg).unwrap_or(0);
    [count - 1, 1].map(|step| order[(place + step) % count])
}

pub(super) fn size(point: Point) -> f64 {
    dot(point, point).sqrt()
}

fn dot(a: Point, b: Point) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_margin_is_the_distance_to_the_nearest_edge() {
        let square = [[0.0, 0.0], [100.0, 0.0], [100.0, 100.0], [0.0, 100.0]];
        assert!((margin(&square, [30.0, 50.0]) - 30.0).abs() < 1e-9);
        assert!((margin(&square, [-20.0, 50.0]) + 20.0).abs() < 1e-9);
        // Two feet hold nothing: the point is on their line at best.
        assert!((margin(&square[..2], [50.0, 40.0]) + 40.0).abs() < 1e-9);
    }

    #[test]
    fn a_body_that_goes_ahead_leaves_its_feet_behind() {
        let foot = left_behind([10.0, 20.0, -5.0], [0.0, 100.0, 0.0], 0.5);
        assert_eq!(foot, [10.0, -30.0, -5.0]);
        // A turn to the left by 90 deg takes what is on the right to the rear... seen from the body.
        let [x, y, _] = left_behind([0.0, 20.0, 0.0], [0.0, 0.0, 90.0], 1.0);
        assert!((x - 20.0).abs() < 1e-9 && y.abs() < 1e-9, "{x}, {y}");
    }
}
