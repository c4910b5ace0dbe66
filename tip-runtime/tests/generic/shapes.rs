//! Robots of every kind of shape.

use tip_runtime::model::{Inverse, Joint, Leg, Model, Range, generic};

pub(crate) const X: [f64; 3] = [1.0, 0.0, 0.0];
pub(crate) const Y: [f64; 3] = [0.0, 1.0, 0.0];
pub(crate) const Z: [f64; 3] = [0.0, 0.0, 1.0];

pub(crate) const fn joint(axis: [f64; 3], link: [f64; 3], min: f64, max: f64) -> Joint {
    let limits = Range::new(min, max);
    Joint {
        axis,
        link,
        limits,
        outer: limits.widened(5.0),
        mass: 0.2,
        torque: 40.0,
    }
}

/// A robot that is bolted down.
pub(crate) const fn robot<const L: usize, const J: usize>(
    name: &'static str,
    legs: [Leg<J>; L],
) -> Model<L, J> {
    Model {
        name,
        family: generic::MODEL.family,
        legs,
        inverse: Inverse::LeastSquares,
        body: None,
        standards: generic::MODEL.standards,
        periods: generic::MODEL.periods,
        contact: generic::MODEL.contact,
        lamps: generic::MODEL.lamps,
        forces: generic::MODEL.forces,
        slider: None,
        vibration: None,
    }
}

/// A pendulum.
pub(crate) const PENDULUM: Model<1, 1> = robot(
    "pendulum",
    [Leg {
        base: [0.0, 0.0, 500.0],
        joints: [joint(X, [0.0, 0.0, -250.0], -80.0, 80.0)],
        initial: [10.0],
    }],
);

/// An arm like a PUMA 560 with its tool beyond the wrist.
pub(crate) const ARM: Model<1, 6> = robot(
    "arm",
    [Leg {
        base: [0.0, 0.0, 672.0],
        joints: [
            joint(Z, [0.0, 149.0, 0.0], -160.0, 160.0),
            joint(Y, [432.0, 0.0, 0.0], -110.0, 110.0),
            joint(Y, [-20.0, 0.0, -433.0], -135.0, 135.0),
            joint(Z, [0.0, 0.0, 0.0], -135.0, 135.0),
            joint(Y, [0.0, 0.0, -56.0], -100.0, 100.0),
            joint(Z, [30.0, 0.0, -100.0], -170.0, 170.0),
        ],
        initial: [0.0, -30.0, 20.0, 0.0, 40.0, 0.0],
    }],
);
