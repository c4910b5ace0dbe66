//! Closed forms of the inverse kinematics, and the selection among their solutions.

use super::chain::ChainBuilder;
use super::{NEAR_AXIS, ROUNDING, Solutions, largest_turn};
use crate::model::{Inverse, Joint, Leg, Point, Range};
use crate::ops::{DEGREES_PER_RADIAN, RADIANS_PER_DEGREE};
use nalgebra::{Vector2, Vector3};

/// Greatest turn of a joint in one cycle where a leg passes from one branch of solutions to
/// another, deg. A greater turn skips postures in between.
const LEAP: f64 = 6.0;

/// A leg of three joints with a closed-form inverse.
#[derive(Clone, Copy)]
pub(super) struct ClosedFormLeg<'a> {
    kind: Inverse,
    base: Point,
    joints: [&'a Joint; 3],
}

impl<'a> ClosedFormLeg<'a> {
    /// Returns `None` if the leg does not have three joints.
    pub(super) fn new(kind: Inverse, base: Point, joints: &'a [Joint]) -> Option<Self> {
        let [first, second, third] = joints else {
            return None;
        };
        let joints = [first, second, third];
        Some(ClosedFormLeg { kind, base, joints })
    }

    /// Returns all solutions that put the foot at `foot` (mm), whatever the limits. A joint that
    /// does not matter stays as in `from`.
    pub(super) fn solutions(&self, from: &[f64; 3], foot: Point) -> Solutions {
        let [first, _, _] = from;
        match self.kind {
            Inverse::YawPitchPitch => yaw_pitch_pitch(self.base, self.joints, foot, *first),
            Inverse::RollPitchPitch => roll_pitch_pitch(self.base, self.joints, foot, *first),
            Inverse::Planar | Inverse::LeastSquares => [None; 4],
        }
    }

    /// Returns the solution within the limits that is nearest to `from`; the first of equally near
    /// ones.
    pub(super) fn nearest(&self, from: &[f64; 3], foot: Point) -> Option<[f64; 3]> {
        self.nearest_of(from, foot, |_| true)
    }

    /// Like [`nearest`](Self::nearest), among the solutions that the leg reaches from `from`
    /// without skipping postures.
    pub(super) fn next(&self, from: &[f64; 3], foot: Point) -> Option<[f64; 3]> {
        self.nearest_of(from, foot, |to| !self.leaps(from, to))
    }

    fn nearest_of(
        &self,
        from: &[f64; 3],
        foot: Point,
        accepts: impl Fn(&[f64; 3]) -> bool,
    ) -> Option<[f64; 3]> {
        let mut nearest: Option<(f64, [f64; 3])> = None;
        for solution in self.solutions(from, foot).into_iter().flatten() {
            let Some(angles) = self.within_limits(from, solution) else {
                continue;
            };
            let turn = largest_turn(from, &angles);
            // Turns that differ only by rounding are equal.
            let is_nearer = nearest.is_none_or(|(least, _)| turn < least - ROUNDING);
            if is_nearer && accepts(&angles) {
                nearest = Some((turn, angles));
            }
        }
        nearest.map(|(_, angles)| angles)
    }

    /// Returns equivalent angles within the limits, as near to `from` as possible.
    fn within_limits(&self, from: &[f64; 3], mut angles: [f64; 3]) -> Option<[f64; 3]> {
        for ((angle, joint), from) in angles.iter_mut().zip(self.joints).zip(from) {
            *angle = within(joint.limits, *from, *angle)?;
        }
        Some(angles)
    }

    /// Returns true if postures are skipped between two: they belong to different branches of
    /// solutions, or differ by whole turns.
    fn leaps(&self, from: &[f64; 3], to: &[f64; 3]) -> bool {
        let (before, after) = (self.branch(from), self.branch(to));
        let ([first, _, _], [first_to, _, _]) = (from, to);
        let largest = largest_turn(from, to);
        let rolls_over = before.side * after.side < 0.0 && libm::fabs(first_to - first) > LEAP;
        let bends_over = before.bend * after.bend < 0.0 && largest > LEAP;
        rolls_over || bends_over || largest > 180.0
    }

    fn branch(&self, angles: &[f64; 3]) -> Branch {
        let [first, second, third] = self.joints;
        let [roll, thigh, knee] = angles;
        let mut builder = ChainBuilder::at(self.base);
        let (hip, along) = builder.append(first, *roll);
        let (upper, across) = builder.append(second, *thigh);
        let (lower, _) = builder.append(third, *knee);
        let foot = builder.end();
        let side = along.cross(&across).dot(&(foot - hip));
        let bend = across.dot(&(lower - upper).cross(&(foot - lower)));
        let size = (lower - upper).norm() + (foot - lower).norm() + (upper - hip).norm();
        Branch {
            side: unless_tiny(side / size),
            bend: unless_tiny(bend / (size * size)),
        }
    }
}

/// The branch of a solution: the side of its first axis on which the foot is, and the side to which
/// the last joint is bent; 0 between them.
struct Branch {
    side: f64,
    bend: f64,
}

fn unless_tiny(share: f64) -> f64 {
    if libm::fabs(share) < 1e-6 { 0.0 } else { share }
}

/// Returns `angle` plus whole turns, within the limits and as near to `near` as possible, deg.
fn within(limits: Range, near: f64, angle: f64) -> Option<f64> {
    let limits = limits.widened(ROUNDING);
    let and_turns = |turns: f64| {
        if turns == 0.0 {
            angle
        } else {
            angle + 360.0 * turns
        }
    };
    let nearest = and_turns(libm::round((near - angle) / 360.0));
    let found = if nearest > limits.max {
        and_turns(libm::floor((limits.max - angle) / 360.0))
    } else if nearest < limits.min {
        and_turns(libm::ceil((limits.min - angle) / 360.0))
    } else {
        nearest
    };
    limits.contains(found).then_some(found)
}

/// Tolerance for a foot that rounding puts beyond full stretch, as a cosine.
const STRETCH: f64 = 1e-12;

/// Returns the angles (deg) that put a foot at `foot` (mm): first those of a leg that points at it
/// with its knee up. On the yaw axis, where any yaw is possible, the yaw stays at `yaw_now`.
///
/// The leg turns about the vertical until it points at the foot, or away from it; the remaining
/// triangle is made of thigh, shank and the line between their ends, with the knee above or below
/// that line.
fn yaw_pitch_pitch(base: Point, joints: [&Joint; 3], foot: Point, yaw_now: f64) -> Solutions {
    let [yaw, thigh, knee] = joints;
    let reach = Vector3::from(foot) - Vector3::from(base);
    let level = Vector3::new(reach.x, reach.y, 0.0);
    let (l1, l2, l3) = (length(yaw), length(thigh), length(knee));
    let outward = Vector3::from(yaw.link) / l1;
    let yaw_axis = Vector3::from(yaw.axis);
    let turn = libm::atan2(yaw_axis.dot(&outward.cross(&level)), outward.dot(&level));
    let turn = turn * DEGREES_PER_RADIAN;
    let turns = if level.norm() <= NEAR_AXIS * (l1 + l2 + l3) {
        [yaw_now; 2]
    } else {
        [turn, turn - libm::copysign(180.0, turn)]
    };

    let lift = outward.cross(&Vector3::z());
    let thigh_sign = lift.dot(&Vector3::from(thigh.axis));
    let knee_sign = -lift.dot(&Vector3::from(knee.axis));
    let solution = |[turn, out]: [f64; 2], side: f64| {
        let [raised, flexed] = triangle([l2, l3], [out, reach.z], side)?;
        Some([turn, thigh_sign * raised, knee_sign * flexed])
    };
    let [towards, away] = turns;
    let towards = [towards, level.norm() - l1];
    let away = [away, -level.norm() - l1];
    [
        solution(towards, 1.0),
        solution(towards, -1.0),
        solution(away, 1.0),
        solution(away, -1.0),
    ]
}

/// Returns the raise of the thigh and the flexion of the knee, to the side of `side`, for a foot at
/// a distance and height, deg.
fn triangle([l2, l3]: [f64; 2], [out, up]: [f64; 2], side: f64) -> Option<[f64; 2]> {
    let bend = (out * out + up * up - l2 * l2 - l3 * l3) / (2.0 * l2 * l3);
    if !(-1.0 - STRETCH..=1.0 + STRETCH).contains(&bend) {
        return None;
    }
    let flexed = libm::copysign(libm::acos(bend.clamp(-1.0, 1.0)), side);
    let (sin, cos) = libm::sincos(flexed);
    let raised = libm::atan2(up, out) + libm::atan2(l3 * sin, l2 + l3 * cos);
    Some([
        wrapped(raised * DEGREES_PER_RADIAN),
        flexed * DEGREES_PER_RADIAN,
    ])
}

fn length(joint: &Joint) -> f64 {
    Vector3::from(joint.link).norm()
}

/// Returns the equivalent of an angle of −360…360 deg within −180…180 deg.
fn wrapped(angle: f64) -> f64 {
    if angle > 180.0 {
        angle - 360.0
    } else if angle < -180.0 {
        angle + 360.0
    } else {
        angle
    }
}

/// Tolerance for a foot that rounding puts nearer to the first axis than the offset, as a share of
/// the leg's squared length.
const INSIDE: f64 = 1e-12;

/// Returns the angles (deg) that put a foot at `foot` (mm). On the first axis, where any roll is
/// possible, the roll stays at `roll_now`.
///
/// A joint is followed by two parallel ones at right angles to it: a roll and two pitches, as at the hips of most
/// quadrupeds (an anthropomorphic arm: Siciliano et al., *Robotics*, 2009, §2.12.4). Along the parallel axes no joint
/// but the first moves the foot. So it turns the foot's distance to its axis into that offset and a height, which is on
/// either side; what is left are two links in a plane.
fn roll_pitch_pitch(base: Point, joints: [&Joint; 3], foot: Point, roll_now: f64) -> Solutions {
    let [roll, thigh, knee] = joints;
    let (along, across) = (Vector3::from(roll.axis), Vector3::from(thigh.axis));
    let frame = Frame {
        along,
        across,
        height: along.cross(&across),
    };
    let [hip, upper, lower] = [roll, thigh, knee].map(|joint| Vector3::from(joint.link));
    let size = hip.norm() + upper.norm() + lower.norm();
    let reach = Vector3::from(foot) - Vector3::from(base);
    let aside = Vector2::new(frame.across.dot(&reach), frame.height.dot(&reach));

    let offset = frame.across.dot(&(hip + upper + lower));
    let square = aside.norm_squared() - offset * offset;
    // A NaN must not count as outside, so the comparison is written this way round.
    let is_outside = square >= -INSIDE * size * size;
    if !is_outside {
        return [None; 4];
    }
    let height = libm::sqrt(square.max(0.0));
    let links = TwoLinks {
        first: frame.plane(&upper),
        second: frame.plane(&lower),
    };
    let knee_sense = libm::copysign(1.0, across.dot(&Vector3::from(knee.axis)));
    let solution = |height: f64, side: f64| {
        let turn = libm::atan2(aside.y, aside.x) - libm::atan2(height, offset);
        let turn = if aside.norm() <= NEAR_AXIS * size {
            roll_now
        } else {
            turn * DEGREES_PER_RADIAN
        };
        let reach = Vector2::new(height, along.dot(&reach)) - frame.plane(&hip);
        let [turned, bent] = links.turns(reach, side)?;
        Some([turn, turned, knee_sense * bent])
    };
    [
        solution(-height, 1.0),
        solution(-height, -1.0),
        solution(height, 1.0),
        solution(height, -1.0),
    ]
}

/// The axes of the leg while its first joint is at 0.
struct Frame {
    /// The axis of the first joint.
    along: Vector3<f64>,
    /// The axes of the other two joints.
    across: Vector3<f64>,
    /// The normal of both.
    height: Vector3<f64>,
}

impl Frame {
    /// Projects a vector onto the plane in which the last two joints turn; a positive turn about
    /// `across` is to the left.
    fn plane(&self, vector: &Vector3<f64>) -> Vector2<f64> {
        Vector2::new(self.height.dot(vector), self.along.dot(vector))
    }
}

/// Bend of a second joint below which it counts as straight and may bend to either side, deg.
const STRAIGHT: f64 = 0.01;

/// Two links at angle 0, mm: the triangle of the links and the line between their ends (Craig, *Introduction to
/// Robotics*, ch. 4.4).
#[derive(Clone, Copy)]
struct TwoLinks {
    pub(super) first: Vector2<f64>,
    pub(super) second: Vector2<f64>,
}

impl TwoLinks {
    /// Returns the bend of the second link to the left of the first one at angle 0, deg.
    fn unbent(&self) -> f64 {
        let (a, b) = (self.first, self.second);
        libm::atan2(a.perp(&b), a.dot(&b)) / RADIANS_PER_DEGREE
    }

    /// Returns the turns of the links to the left (deg) that lead to `reach` (mm), with the second
    /// one bent to the side of `side`; `None` if the links do not reach it.
    pub(super) fn turns(&self, reach: Vector2<f64>, side: f64) -> Option<[f64; 2]> {
        let (a, b) = (self.first, self.second);
        let (long, short) = (a.norm(), b.norm());
        let cosine = (reach.norm_squared() - long * long - short * short) / (2.0 * long * short);
        if !(-1.0 - STRETCH..=1.0 + STRETCH).contains(&cosine) {
            return None;
        }
        let bent = libm::copysign(libm::acos(cosine.clamp(-1.0, 1.0)), side);
        // In the frame of the first link, the second one points along it, turned by the bend.
        let (sin, cos) = libm::sincos(bent);
        let ahead = libm::atan2(short * sin, long + short * cos);
        let turned = libm::atan2(reach.y, reach.x) - libm::atan2(a.y, a.x) - ahead;
        Some([
            turned / RADIANS_PER_DEGREE,
            bent / RADIANS_PER_DEGREE - self.unbent(),
        ])
    }
}

/// Returns the joint angles (deg) that put the third joint of `leg`, which is at `from`, at `place`
/// (mm); `None` if the links do not reach it, or a joint cannot turn so far. A straight leg bends
/// to the side of `posture`. Joint 2 keeps the side to which it is bent.
pub(super) fn two_joints<const J: usize>(
    leg: &Leg<J>,
    from: &[f64; J],
    [x, y, _]: Point,
    posture: &[f64; J],
) -> Option<[f64; J]> {
    let [first, second, ..] = leg.joints.as_slice() else {
        return None;
    };
    let [base_x, base_y, _] = leg.base;
    let links = TwoLinks {
        first: flat(first),
        second: flat(second),
    };
    let unbent = links.unbent();
    let bend = |angles: &[f64; J]| {
        let angle = angles.get(1).copied().unwrap_or_default();
        half_turn(sense(second) * angle + unbent)
    };
    let side = match bend(from) {
        straight if libm::fabs(straight) < STRAIGHT => bend(posture),
        bent => bent,
    };
    let [turned, bent] = links.turns(Vector2::new(x - base_x, y - base_y), side)?;
    let solved = [
        sense(first) * half_turn(turned),
        sense(second) * half_turn(bent),
    ];
    let mut angles = *from;
    let joints = angles.iter_mut().zip(&leg.joints);
    for ((angle, joint), solved) in joints.zip(solved) {
        let free = joint.limits.including(*angle);
        if !free.widened(ROUNDING).contains(solved) {
            return None;
        }
        *angle = free.nearest(solved);
    }
    Some(angles)
}

/// Returns the link after a joint, in the plane.
fn flat(joint: &Joint) -> Vector2<f64> {
    let [x, y, _] = joint.link;
    Vector2::new(x, y)
}

/// Returns 1 if a joint turns to the left, −1 if it turns to the right.
fn sense(joint: &Joint) -> f64 {
    let [_, _, z] = joint.axis;
    libm::copysign(1.0, z)
}

/// Returns the equivalent angle within −180…180 deg.
fn half_turn(angle: f64) -> f64 {
    angle - 360.0 * libm::round(angle / 360.0)
}
