//! Damped least squares on any chain.

use crate::generic::shapes::{ARM, PENDULUM, TRIPOD, Z, every_shape, number, posture};
use nalgebra::{Matrix3, SMatrix, SVector};
use tip_runtime::kinematics::{Chain, LegPoint, inverse, nearest, resolve, within_limits};
use tip_runtime::model::{Inverse, Joint, Leg, Model, Range};
use tip_runtime::random::Random;

const SPACE: [bool; 3] = [true; 3];

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

fn foot<const J: usize>(leg: &Leg<J>, angles: &[f64; J]) -> [f64; 3] {
    Chain::new(leg, angles).foot()
}

/// Returns the number of `count` random reachable places that are found. Every one that is found is
/// reached, within the limits.
fn found<const J: usize>(leg: &Leg<J>, random: &mut Random, count: usize) -> usize {
    let places = (0..count).filter(|_| {
        let target = foot(leg, &posture(random, leg));
        let Some(angles) = inverse(Inverse::LeastSquares, leg, target) else {
            return false;
        };
        assert!(distance(foot(leg, &angles), target) <= 1e-6);
        assert!(within_limits(leg, &angles));
        true
    });
    places.count()
}

#[test]
fn every_shape_reaches_what_it_can_reach() {
    fn reaches<const L: usize, const J: usize>(model: &Model<L, J>) {
        let mut random = Random::new(1);
        let found: usize = (model.legs.iter())
            .map(|leg| found(leg, &mut random, 1000 / L))
            .sum();
        assert_eq!(found, 1000 / L * L, "{}", model.name);
    }
    every_shape!(reaches);
}

/// Returns a chain of random axes, links and limits.
fn random_leg<const J: usize>(random: &mut Random) -> Leg<J> {
    const UNIT: Range = Range::new(-1.0, 1.0);
    let mut vector = |size: f64| [size; 3].map(|size| size * number(random, UNIT));
    let chain = [(); J].map(|()| {
        let axis = vector(1.0);
        let length = distance(axis, [0.0; 3]);
        Joint::revolute(axis.map(|part| part / length), vector(100.0))
    });
    let joints = chain.map(|joint| {
        let min = number(random, Range::new(-170.0, 0.0));
        joint.limits(min, number(random, Range::new(0.0, 170.0)))
    });
    Leg::at([10.0, -20.0, 30.0], joints)
}

#[test]
fn of_a_thousand_reachable_places_of_random_chains_one_is_missed_at_most() {
    fn of_joints<const J: usize>() -> usize {
        let mut random = Random::new(J as u64);
        let legs = (0..50).map(|_| {
            let leg = random_leg::<J>(&mut random);
            found(&leg, &mut random, 20)
        });
        legs.sum()
    }
    let few = of_joints::<1>() + of_joints::<2>() + of_joints::<3>();
    let more = of_joints::<4>() + of_joints::<5>() + of_joints::<6>();
    let most = of_joints::<7>() + of_joints::<8>() + of_joints::<9>();
    assert!(few + more + most >= 9000 - 9, "{few} {more} {most}");
}

#[test]
fn what_is_farther_than_all_links_is_refused() {
    fn refuses<const L: usize, const J: usize>(model: &Model<L, J>) {
        for leg in &model.legs {
            let lengths = leg.joints.map(|joint| distance(joint.link, [0.0; 3]));
            let reach: f64 = lengths.iter().sum();
            for axis in 0..3 {
                let mut target = leg.base;
                target[axis] += reach + 1e-3;
                assert_eq!(inverse(Inverse::LeastSquares, leg, target), None);
            }
        }
    }
    every_shape!(refuses);
}

#[test]
fn a_single_joint_reaches_its_arc_and_nothing_else() {
    let leg = &PENDULUM.legs[0];
    let on_arc = foot(leg, &[-35.0]);
    let [found] = inverse(Inverse::LeastSquares, leg, on_arc).expect("on the arc");
    assert!((found + 35.0).abs() < 1e-6, "{found}");
    let [x, y, z] = on_arc;
    for beside in [[x + 1.0, y, z], [x, y, z + 1.0], [x, y - 1.0, z]] {
        assert_eq!(inverse(Inverse::LeastSquares, leg, beside), None);
    }
    let beyond_its_limit = foot(leg, &[80.1]);
    assert_eq!(inverse(Inverse::LeastSquares, leg, beyond_its_limit), None);
}

#[test]
fn a_leg_that_is_stretched_out_is_reached_to_the_end() {
    let leg = &TRIPOD.legs[0];
    let straight = [0.0, 60.0, 0.0, 0.0];
    let end = foot(leg, &straight);
    let found = inverse(Inverse::LeastSquares, leg, end).expect("reachable");
    assert!(distance(foot(leg, &found), end) <= 1e-6);
}

#[test]
fn a_joint_at_its_limit_leaves_the_rest_of_the_way_to_the_others() {
    // The upper arm may not turn towards the target; the nearest place is where the lower arm
    // points at it from the elbow.
    for (side, min, max) in [(1.0, -90.0, 0.0), (-1.0, 0.0, 90.0)] {
        let upper = Joint::revolute(Z, [100.0, 0.0, 0.0]).limits(min, max);
        let lower = Joint::revolute(Z, [80.0, 0.0, 0.0]).limits(-150.0, 150.0);
        let leg = Leg::at([0.0; 3], [upper, lower]);
        let target = [60.0, side * 200.0, 0.0];
        let start = [0.0, side * 30.0];
        let found = nearest(&leg, &start, LegPoint::Tip, target, SPACE);
        let [upper, lower] = found.expect("a tip");
        let towards = f64::atan2(200.0, 60.0 - 100.0).to_degrees();
        assert_eq!(upper, 0.0);
        assert!((lower - side * towards).abs() < 1e-6, "{lower}");
    }
}

#[test]
fn jacobians_are_what_small_turns_do() {
    fn compare<const L: usize, const J: usize>(model: &Model<L, J>) {
        const TURN: f64 = 1e-3;
        let mut random = Random::new(3);
        for leg in &model.legs {
            let posture = posture(&mut random, leg);
            let chain = Chain::new(leg, &posture);
            let points = (0..J).map(LegPoint::Joint).chain([LegPoint::Tip]);
            for point in points {
                let jacobian = chain.point_jacobian(point).expect("it is there");
                for (m, column) in jacobian.iter().enumerate() {
                    let at = |turn: f64| {
                        let mut posture = posture;
                        posture[m] += turn;
                        Chain::new(leg, &posture).point(point).expect("it is there")
                    };
                    let (ahead, behind) = (at(TURN), at(-TURN));
                    for (axis, slope) in column.iter().enumerate() {
                        let way = ahead[axis] - behind[axis];
                        assert!((way / (2.0 * TURN.to_radians()) - slope).abs() < 1e-5);
                    }
                }
            }
        }
    }
    every_shape!(compare);
}

/// Returns `a − J# J a`: the share of a turn that moves nothing.
fn idle<const J: usize>(jacobian: &SMatrix<f64, 3, J>, turn: SVector<f64, J>) -> SVector<f64, J> {
    let gram: Matrix3<f64> = jacobian * jacobian.transpose();
    let inverse = gram.try_inverse().expect("not singular");
    turn - jacobian.transpose() * (inverse * (jacobian * turn))
}

#[test]
fn redundant_legs_turn_by_the_least_amount() {
    fn least<const L: usize, const J: usize>(model: &Model<L, J>) {
        for leg in &model.legs {
            let [x, y, z] = foot(leg, &leg.initial);
            let target = [x + 1e-3, y - 2e-3, z + 1.5e-3];
            let to = resolve(leg, &leg.initial, LegPoint::Tip, target, SPACE).expect("near");
            let turn = SVector::<f64, J>::from(to) - SVector::from(leg.initial);
            let jacobian = SMatrix::from(Chain::new(leg, &leg.initial).foot_jacobian());
            let spent = idle(&jacobian, turn).norm();
            assert!(turn.norm() > 0.0 && spent < 1e-4 * turn.norm(), "{spent}");
        }
    }
    least(&ARM);
    least(&TRIPOD);
    least(&crate::generic::shapes::NINE);
}

#[test]
fn rates_are_the_least_ones_that_give_a_velocity_and_none_where_there_are_none() {
    fn least<const L: usize, const J: usize>(model: &Model<L, J>) {
        let mut random = Random::new(5);
        let unit = Range::new(-1.0, 1.0);
        for leg in &model.legs {
            let chain = Chain::new(leg, &leg.initial);
            let rates = [(); J].map(|()| number(&mut random, unit));
            let velocity = chain.point_velocity(LegPoint::Tip, &rates).expect("a foot");
            let least = chain
                .point_rates(LegPoint::Tip, velocity, [true; 3])
                .expect("it moves so");
            assert!(
                distance(
                    chain.point_velocity(LegPoint::Tip, &least).expect("a foot"),
                    velocity
                ) < 1e-8
            );
            let norm = |rates: &[f64; J]| SVector::<f64, J>::from(*rates).norm();
            assert!(norm(&least) <= norm(&rates) * (1.0 + 1e-9));
        }
    }
    every_shape!(least);
    let pendulum = Chain::new(&PENDULUM.legs[0], &[0.0]);
    assert_eq!(
        pendulum.point_rates(LegPoint::Tip, [0.0, 10.0, 1.0], [true; 3]),
        None
    );
    assert_eq!(
        pendulum.point_rates(LegPoint::Tip, [1.0, 10.0, 0.0], [true; 3]),
        None
    );
}
