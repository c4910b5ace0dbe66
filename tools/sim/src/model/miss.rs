//! Distance by which a robot misses a target.

use tip_runtime::command::{Op, Target};
use tip_runtime::kinematics::{Chain, LegPoint, first_beyond_limits, inverse, nearest, search};
use tip_runtime::model::{Family, Inverse, Leg, Model, Point, Range, Slider};

/// A target that is missed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Miss {
    /// A joint would have to turn beyond its limits.
    Turns {
        joint: Target,
        /// deg; negative below the lower limit.
        by: f64,
        limits: Range,
        /// Number of the command that turns it, if each turns one joint.
        number: Option<usize>,
    },
    /// Gap between the end of the foot's path and the target, mm.
    Ends { by: f64 },
    /// The slider does not go so far.
    Slides { axis: &'static str, travel: Range },
}

/// Gap that a search may leave although the target is within reach, mm.
const LEFT_OVER: f64 = 1.0;
/// Difference of angles up to which it comes from rounding, deg.
const ROUNDING: f64 = 1e-6;

/// The points and joints that commands move, of a model with any number of legs.
pub(super) struct MovableParts<'a, const J: usize> {
    legs: &'a [Leg<J>],
    family: Family,
    inverse: Inverse,
    slider: Option<&'a Slider>,
}

impl<'a, const L: usize, const J: usize> From<&'a Model<L, J>> for MovableParts<'a, J> {
    fn from(model: &'a Model<L, J>) -> Self {
        MovableParts {
            legs: &model.legs,
            family: model.family,
            inverse: model.inverse,
            slider: model.slider.as_ref(),
        }
    }
}

impl<const J: usize> MovableParts<'_, J> {
    /// Returns what PTP or PTP_ANGLE misses, if it misses.
    #[inline(never)] // Else it is compiled for each number of legs.
    pub(super) fn miss(&self, op: Op, target: Target, values: &[f64]) -> Option<Miss> {
        let leg = |n: u8| self.legs.get(usize::from(n).checked_sub(1)?);
        match (op, target) {
            (Op::PtpAngle, Target::Foot(n)) => angles(leg(n)?, n, 0, values),
            (Op::PtpAngle, Target::Joint(n, m)) => {
                angles(leg(n)?, n, usize::from(m).checked_sub(1)?, values)
            }
            (Op::Ptp, Target::Floor) => slider(self.slider?, values.try_into().ok()?),
            (Op::Ptp, Target::Foot(n)) => place(
                leg(n)?,
                n,
                (self.inverse, LegPoint::Tip),
                values.try_into().ok()?,
            ),
            (Op::Ptp, Target::Joint(n, m)) if self.family == Family::Hand => {
                let point = LegPoint::Joint(usize::from(m).checked_sub(1)?);
                place(leg(n)?, n, (self.inverse, point), values.try_into().ok()?)
            }
            _ => None,
        }
    }
}

/// Returns the first joint, from `first` on, that cannot turn so far.
fn angles<const J: usize>(leg: &Leg<J>, n: u8, first: usize, values: &[f64]) -> Option<Miss> {
    let joints = leg.joints.iter().enumerate().skip(first);
    joints
        .zip(values)
        .enumerate()
        .find_map(|(number, ((m, joint), angle))| {
            beyond(joint.limits, *angle).map(|by| Miss::Turns {
                joint: name(n, m),
                by,
                limits: joint.limits,
                number: Some(number),
            })
        })
}

/// Returns the excess of an angle over its limits; negative below them.
fn beyond(limits: Range, angle: f64) -> Option<f64> {
    let by = if angle > limits.max {
        angle - limits.max
    } else {
        angle - limits.min
    };
    (!limits.widened(ROUNDING).contains(angle)).then_some(by)
}

fn place<const J: usize>(
    leg: &Leg<J>,
    n: u8,
    (kind, point): (Inverse, LegPoint),
    target: Point,
) -> Option<Miss> {
    if kind.is_closed() {
        let Some(found) = inverse(kind, leg, target) else {
            return ends(leg, (kind, point), target, 0.0);
        };
        let m = first_beyond_limits(leg, &found)?;
        let limits = leg.joints[m].limits;
        return Some(Miss::Turns {
            joint: name(n, m),
            by: beyond(limits, found[m])?,
            limits,
            number: None,
        });
    }
    let target = kind.flat(target);
    match search(leg, point, target, kind.axes()) {
        Some(_) => None,
        None => ends(leg, (kind, point), target, LEFT_OVER),
    }
}

/// Returns the end of the point's motion, if that is not near its target.
fn ends<const J: usize>(
    leg: &Leg<J>,
    (kind, point): (Inverse, LegPoint),
    target: Point,
    near: f64,
) -> Option<Miss> {
    let angles = nearest(leg, &leg.initial, point, target, kind.axes())?;
    let there = Chain::new(leg, &angles).point(point)?;
    let there = kind.flat(there);
    let gap = there.iter().zip(target).map(|(a, b)| (a - b) * (a - b));
    let by = gap.sum::<f64>().sqrt();
    (by >= near).then_some(Miss::Ends { by })
}

fn slider(slider: &Slider, target: Point) -> Option<Miss> {
    let axes = ["x", "y", "z"].into_iter().zip(slider.travel).zip(target);
    let mut missed = axes.filter(|((_, travel), at)| !travel.contains(*at));
    missed
        .next()
        .map(|((axis, travel), _)| Miss::Slides { axis, travel })
}

fn name(n: u8, m: usize) -> Target {
    Target::Joint(n, u8::try_from(m + 1).unwrap_or(u8::MAX))
}
