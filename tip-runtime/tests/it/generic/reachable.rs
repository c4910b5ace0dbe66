//! From a posture nearby, every foot of a posture within the limits is found.

use crate::generic::shapes::{ARM, HEXAPOD, X, Y, Z, number, posture};
use tip_runtime::kinematics::{Chain, inverse, inverse_from, within_limits};
use tip_runtime::model::{Inverse, Joint, Leg, Model, Range, hand, titan8};
use tip_runtime::random::Random;

/// Number of postures of each robot with a closed form.
const POSTURES: usize = 10_000;

/// Number of postures of each other robot, for which a search takes a hundred times as long.
const SEARCHED: usize = 1500;

/// Greatest distance of a joint from its target, deg.
const NEARBY: f64 = 3.0;

/// Rolls about y, which is forward here, then pitches: the figures of the Unitree A1.
const A1: Model<2, 3> = closed("a1", [quadruped(-1.0), quadruped(1.0)]);

const fn quadruped(side: f64) -> Leg<3> {
    let joints = [
        Joint::revolute(Y, [side * 83.8, 0.0, 0.0]).limits(-46.0, 46.0),
        Joint::revolute(X, [0.0, 0.0, -200.0]).limits(-60.0, 240.0),
        Joint::revolute(X, [0.0, 0.0, -200.0]).limits(-154.5, -52.5),
    ];
    Leg::at([side * 47.0, 180.5, 0.0], joints).initial([0.0, 45.0, -90.0])
}

/// Offsets in every link, and joints that turn round more than once: the figures of Solo12.
const SOLO: Model<1, 3> = closed(
    "solo",
    [Leg::at(
        [87.5, 214.1, 0.0],
        [
            Joint::revolute(Y, [14.0, 19.5, 0.0]).limits(-573.0, 573.0),
            Joint::revolute(X, [37.45, 0.0, -160.0]).limits(-573.0, 573.0),
            Joint::revolute(X, [9.0, 0.0, -160.0]).limits(-573.0, 573.0),
        ],
    )],
);

/// Both bends of the knee lie within the limits, and the foot may come onto the axis of the roll.
const PRINTED: Model<1, 3> = closed(
    "printed",
    [Leg::at(
        [0.0; 3],
        [
            Joint::revolute(Y, [0.0; 3]).limits(-82.5, 82.5),
            Joint::revolute(X, [0.0, 0.0, -107.5]).limits(-170.0, 170.0),
            Joint::revolute([-1.0, 0.0, 0.0], [0.0, 20.0, -130.0]).limits(-120.0, 120.0),
        ],
    )],
);

/// A yaw, and pitches with links that are bent at 0: the figures of PhantomX.
const BENT: Model<1, 3> = closed(
    "bent",
    [Leg::at(
        [60.0, 120.0, 0.0],
        [
            Joint::revolute(Z, [52.0, 0.0, 0.0]).limits(-150.0, 150.0),
            Joint::revolute([0.0, -1.0, 0.0], [63.3, 0.0, 16.0]).limits(-100.0, 100.0),
            Joint::revolute(Y, [88.8, 0.0, -99.0]).limits(-100.0, 100.0),
        ],
    )],
);

/// A yaw and pitches in line, all of which turn far.
const WIDE: Model<1, 3> = Model {
    inverse: Inverse::YawPitchPitch,
    ..closed(
        "wide",
        [Leg::at(
            [0.0; 3],
            [
                Joint::revolute(Z, [0.0, 50.0, 0.0]).limits(-200.0, 200.0),
                Joint::revolute(X, [0.0, 120.0, 0.0]).limits(-180.0, 180.0),
                Joint::revolute([-1.0, 0.0, 0.0], [0.0, 120.0, 0.0]).limits(-130.0, 150.0),
            ],
        )],
    )
};

const fn closed<const L: usize, const J: usize>(
    name: &'static str,
    legs: [Leg<J>; L],
) -> Model<L, J> {
    Model {
        inverse: Inverse::RollPitchPitch,
        ..Model::generic(name, legs)
    }
}

fn length<const J: usize>(leg: &Leg<J>) -> f64 {
    let links = leg.joints.iter().map(|joint| joint.link);
    links
        .map(|link| link.iter().map(|part| part * part).sum::<f64>().sqrt())
        .sum()
}

fn largest_turn<const J: usize>(a: &[f64; J], b: &[f64; J]) -> f64 {
    let turns = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    turns.fold(0.0, f64::max)
}

/// Returns a posture within the limits, and within [`NEARBY`] of another one.
fn near<const J: usize>(random: &mut Random, leg: &Leg<J>, angles: &[f64; J]) -> [f64; J] {
    let mut near = *angles;
    for (angle, joint) in near.iter_mut().zip(&leg.joints) {
        let limits = joint.limits;
        *angle += number(random, Range::new(-NEARBY, NEARBY));
        *angle = angle.clamp(limits.min, limits.max);
    }
    near
}

/// Returns the number of feet that are refused. A solution that is found is within the limits, puts
/// the foot where it was, and is no farther than the posture that was taken.
fn refused<const L: usize, const J: usize>(model: &Model<L, J>, postures: usize) -> usize {
    assert_eq!(model.check(), Ok(()), "{}", model.name);
    let mut random = Random::new(16);
    let mut refused = 0;
    for leg in &model.legs {
        for _ in 0..postures / L + 1 {
            let angles = posture(&mut random, leg);
            let from = near(&mut random, leg, &angles);
            let foot = Chain::new(leg, &angles).foot();
            let Some(found) = inverse_from(model.inverse, leg, &from, foot) else {
                refused += 1;
                continue;
            };
            assert!(within_limits(leg, &found), "{}: {found:?}", model.name);
            let there = Chain::new(leg, &found).foot();
            let gap = (0..3).map(|i| (there[i] - foot[i]).abs()).sum::<f64>();
            assert!(
                gap <= 1e-9 * length(leg),
                "{}: {gap} {angles:?}",
                model.name
            );
            if model.inverse.is_closed() {
                let (turn, known) = (largest_turn(&from, &found), largest_turn(&from, &angles));
                assert!(turn <= known + 1e-4, "{}: {angles:?} {found:?}", model.name);
                let anywhere = inverse(model.inverse, leg, foot).expect("it is there");
                assert!(within_limits(leg, &anywhere), "{}", model.name);
            }
        }
    }
    refused
}

#[test]
fn no_foot_within_the_limits_is_refused() {
    assert_eq!(refused(&titan8::MODEL, POSTURES), 0);
    let hexapod = Model {
        inverse: Inverse::YawPitchPitch,
        ..HEXAPOD
    };
    assert_eq!(refused(&hexapod, POSTURES), 0);
    assert_eq!(refused(&WIDE, POSTURES), 0);
    assert_eq!(refused(&A1, POSTURES), 0);
    assert_eq!(refused(&SOLO, POSTURES), 0);
    assert_eq!(refused(&PRINTED, POSTURES), 0);
    assert_eq!(refused(&BENT, POSTURES), 0);
}

#[test]
fn searches_refuse_no_foot_either() {
    assert_eq!(refused(&hand::MODEL, SEARCHED), 0);
    assert_eq!(refused(&ARM, SEARCHED), 0);
    assert_eq!(refused(&HEXAPOD, SEARCHED), 0);
}

/// A roll φ turns the offset and the height h of the leg in its plane: x = 47 + 83.8 cos φ + h sin φ,
/// z = −83.8 sin φ + h cos φ; y = 180.5 + 200 (sin θ + sin(θ + κ)), h = −200 (cos θ + cos(θ + κ)).
#[test]
fn a_roll_and_two_pitches_have_the_written_out_form() {
    let leg = &A1.legs[1];
    let mut random = Random::new(3);
    for _ in 0..100 {
        let angles = posture(&mut random, leg);
        let [roll, thigh, knee] = angles.map(f64::to_radians);
        let height = -200.0 * (libm::cos(thigh) + libm::cos(thigh + knee));
        let foot = [
            47.0 + 83.8 * libm::cos(roll) + height * libm::sin(roll),
            180.5 + 200.0 * (libm::sin(thigh) + libm::sin(thigh + knee)),
            -83.8 * libm::sin(roll) + height * libm::cos(roll),
        ];
        let found = inverse_from(A1.inverse, leg, &angles, foot).expect("it is there");
        assert!(largest_turn(&angles, &found) < 1e-6, "{angles:?} {found:?}");
    }
}

#[test]
fn of_two_postures_the_nearer_one_is_taken() {
    let leg = &PRINTED.legs[0];
    let foot = Chain::new(leg, &[10.0, 30.0, 60.0]).foot();
    let bent = |knee: f64| {
        let from = [10.0, 0.0, knee];
        let [_, _, knee] = inverse_from(PRINTED.inverse, leg, &from, foot).expect("either way");
        knee
    };
    assert!((bent(50.0) - 60.0).abs() < 1e-9);
    assert!(bent(-50.0) < -40.0);
}

#[test]
fn a_joint_that_turns_round_goes_on_in_its_turn() {
    let leg = &SOLO.legs[0];
    let turned = [370.0, -400.0, 60.0];
    let foot = Chain::new(leg, &turned).foot();
    let from = turned.map(|angle| angle + 1.0);
    let found = inverse_from(SOLO.inverse, leg, &from, foot).expect("it is there");
    assert!(largest_turn(&turned, &found) < 1e-6, "{found:?}");
}
