//! Robots of many shapes.

use tip_runtime::model::{Body, Joint, Leg, Model, Range, generic};
use tip_runtime::random::Random;

pub(crate) const X: [f64; 3] = [1.0, 0.0, 0.0];
pub(crate) const Y: [f64; 3] = [0.0, 1.0, 0.0];
pub(crate) const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// Returns a robot with torques that is bolted down.
const fn bolted<const L: usize, const J: usize>(
    name: &'static str,
    legs: [Leg<J>; L],
) -> Model<L, J> {
    Model {
        forces: generic::MODEL.forces,
        ..Model::generic(name, legs)
    }
}

/// Returns a robot with torques that walks on the belly `z` mm below its middle.
const fn walking<const L: usize, const J: usize>(
    name: &'static str,
    z: f64,
    legs: [Leg<J>; L],
) -> Model<L, J> {
    Model {
        body: Some(Body {
            x: Range::new(-100.0, 100.0),
            y: Range::new(-200.0, 200.0),
            z: Range::new(-z, 50.0),
            mass: 5.0,
            inertial: None,
        }),
        ..bolted(name, legs)
    }
}

/// A pendulum.
pub(crate) const PENDULUM: Model<1, 1> = bolted(
    "pendulum",
    [Leg::at(
        [0.0, 0.0, 500.0],
        [Joint::revolute(X, [0.0, 0.0, -250.0]).limits(-80.0, 80.0)],
    )
    .initial([10.0])],
);

/// An arm like a PUMA 560 with its tool beyond the wrist.
pub(crate) const ARM: Model<1, 6> = bolted(
    "arm",
    [Leg::at(
        [0.0, 0.0, 672.0],
        [
            Joint::revolute(Z, [0.0, 149.0, 0.0])
                .limits(-160.0, 160.0)
                .torque(100.0),
            Joint::revolute(Y, [432.0, 0.0, 0.0])
                .limits(-110.0, 110.0)
                .torque(100.0),
            Joint::revolute(Y, [-20.0, 0.0, -433.0])
                .limits(-135.0, 135.0)
                .torque(100.0),
            Joint::revolute(Z, [0.0, 0.0, 0.0]).limits(-135.0, 135.0),
            Joint::revolute(Y, [0.0, 0.0, -56.0]).limits(-100.0, 100.0),
            Joint::revolute(Z, [30.0, 0.0, -100.0]).limits(-170.0, 170.0),
        ],
    )
    .initial([0.0, -30.0, 20.0, 0.0, 40.0, 0.0])],
);

/// Two arms of two joints on a sled.
pub(crate) const SLED: Model<2, 2> = walking("sled", 80.0, [paddle(-1.0), paddle(1.0)]);

const fn paddle(side: f64) -> Leg<2> {
    let joints = [
        Joint::revolute(X, [0.0, 120.0, 0.0]).limits(-70.0, 70.0),
        Joint::revolute(X, [0.0, 100.0, 0.0]).limits(-120.0, 20.0),
    ];
    Leg::at([side * 120.0, 100.0, 0.0], joints).initial([30.0, -60.0])
}

/// Three legs of four joints.
pub(crate) const TRIPOD: Model<3, 4> = walking(
    "tripod",
    60.0,
    [
        redundant(0.0, 1.0),
        redundant(0.96, -0.28),
        redundant(-0.96, -0.28),
    ],
);

/// Returns a leg towards (x, y) of hip, thigh, shank and toe.
const fn redundant(x: f64, y: f64) -> Leg<4> {
    let across = [y, -x, 0.0];
    let joints = [
        Joint::revolute(Z, [40.0 * x, 40.0 * y, 0.0]).limits(-60.0, 60.0),
        Joint::revolute(across, [120.0 * x, 120.0 * y, 0.0]).limits(-75.0, 75.0),
        Joint::revolute(across, [0.0, 0.0, -120.0]).limits(-80.0, 80.0),
        Joint::revolute(across, [0.0, 0.0, -60.0]).limits(-80.0, 80.0),
    ];
    Leg::at([100.0 * x, 100.0 * y, 0.0], joints).initial([0.0, 20.0, -10.0, -10.0])
}

/// Two legs of three joints.
pub(crate) const BIPED: Model<2, 3> = walking("biped", 80.0, [leg(-1.0, 0.0), leg(1.0, 0.0)]);

/// Six legs of three joints.
pub(crate) const HEXAPOD: Model<6, 3> = walking(
    "hexapod",
    80.0,
    [
        leg(-1.0, 200.0),
        leg(1.0, 200.0),
        leg(-1.0, 0.0),
        leg(1.0, 0.0),
        leg(-1.0, -200.0),
        leg(1.0, -200.0),
    ],
);

/// Eight legs of three joints.
pub(crate) const SPIDER: Model<8, 3> = walking(
    "spider",
    80.0,
    [
        leg(-1.0, 225.0),
        leg(1.0, 225.0),
        leg(-1.0, 75.0),
        leg(1.0, 75.0),
        leg(-1.0, -75.0),
        leg(1.0, -75.0),
        leg(-1.0, -225.0),
        leg(1.0, -225.0),
    ],
);

/// Returns a leg on the left (−1) or right (+1).
const fn leg(side: f64, y: f64) -> Leg<3> {
    let joints = [
        Joint::revolute([0.0, 0.0, side], [side * 50.0, 0.0, 0.0]).limits(-60.0, 60.0),
        Joint::revolute([0.0, -side, 0.0], [side * 150.0, 0.0, 0.0]).limits(-60.0, 75.0),
        Joint::revolute([0.0, side, 0.0], [side * 150.0, 0.0, 0.0]).limits(5.0, 150.0),
    ];
    Leg::at([side * 100.0, y, 0.0], joints).initial([0.0, 20.0, 100.0])
}

/// Nine tentacles of nine joints.
pub(crate) const NINE: Model<9, 9> = bolted(
    "nine",
    [
        tentacle(0.0),
        tentacle(100.0),
        tentacle(200.0),
        tentacle(300.0),
        tentacle(400.0),
        tentacle(500.0),
        tentacle(600.0),
        tentacle(700.0),
        tentacle(800.0),
    ],
);

const fn tentacle(x: f64) -> Leg<9> {
    const BEND: Joint = Joint::revolute(X, [0.0, 0.0, 50.0]).limits(-40.0, 40.0);
    const SWAY: Joint = Joint::revolute(Y, [0.0, 0.0, 50.0]).limits(-40.0, 40.0);
    let joints = [BEND, SWAY, BEND, SWAY, BEND, SWAY, BEND, SWAY, BEND];
    let bent = [10.0, 5.0, 10.0, 5.0, 10.0, 5.0, 10.0, 5.0, 10.0];
    Leg::at([x, 0.0, 0.0], joints).initial(bent)
}

/// Calls a function with the model of each shape.
macro_rules! every_shape {
    ($function:ident) => {
        $function(&crate::generic::shapes::PENDULUM);
        $function(&crate::generic::shapes::ARM);
        $function(&crate::generic::shapes::SLED);
        $function(&crate::generic::shapes::TRIPOD);
        $function(&crate::generic::shapes::HEXAPOD);
        $function(&crate::generic::shapes::SPIDER);
        $function(&crate::generic::shapes::NINE);
    };
}
pub(crate) use every_shape;

#[test]
fn every_shape_is_a_robot() {
    fn check<const L: usize, const J: usize>(model: &Model<L, J>) {
        assert_eq!(model.check(), Ok(()), "{}", model.name);
    }
    every_shape!(check);
}

/// Draws a number of a range.
pub(crate) fn number(random: &mut Random, range: Range) -> f64 {
    random.within(range.min, range.max)
}

/// Draws a posture within a leg's limits.
pub(crate) fn posture<const J: usize>(random: &mut Random, leg: &Leg<J>) -> [f64; J] {
    leg.joints.map(|joint| number(random, joint.limits))
}
