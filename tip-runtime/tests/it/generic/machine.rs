//! Programs on robots of every shape.

use crate::generic::program::{Bench, Step, bench, run};
use crate::generic::shapes::{
    ARM, HEXAPOD, NINE, PENDULUM, SLED, SPIDER, TRIPOD, every_shape, number,
};
use allocation_counter::measure;
use tip_runtime::command::{Op, Target};
use tip_runtime::fault::Fault;
use tip_runtime::kinematics::{Chain, within_limits};
use tip_runtime::model::{Leg, Model, Range};
use tip_runtime::random::Random;

const ALL: Target = Target::All;
const F1: Target = Target::Foot(1);
const NONE: Target = Target::None;

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

fn foot<const J: usize>(leg: &Leg<J>, angles: &[f64; J]) -> [f64; 3] {
    Chain::new(leg, angles).foot()
}

/// Returns the distance of a foot from its place in a posture of its leg, from 0.
fn gap<const L: usize, const J: usize>(
    model: &Model<L, J>,
    bench: &Bench<L, J>,
    n: usize,
    posture: &[f64; J],
) -> f64 {
    let leg = &model.legs[n];
    distance(foot(leg, &bench.hardware().angles()[n]), foot(leg, posture))
}

/// Returns the initial posture of a leg, each joint a tenth of the way towards its upper limit.
fn near<const J: usize>(leg: &Leg<J>) -> [f64; J] {
    let mut angles = leg.initial;
    for (angle, joint) in angles.iter_mut().zip(&leg.joints) {
        *angle += (joint.limits.max - *angle) / 10.0;
    }
    angles
}

/// Returns a step for each leg.
fn for_legs<const L: usize, const J: usize>(
    model: &Model<L, J>,
    op: Op,
    values: fn(&Leg<J>) -> Vec<f64>,
) -> Vec<Step> {
    let legs = (1..).zip(&model.legs);
    legs.map(|(n, leg)| (op, Target::Foot(n), values(leg)))
        .collect()
}

const fn wait() -> Step {
    (Op::WaitInpos, ALL, Vec::new())
}

// clauses: 7.4 7.15
#[test]
fn every_shape_goes_to_its_angles() {
    fn goes<const L: usize, const J: usize>(model: &Model<L, J>) {
        let mut steps = for_legs(model, Op::PtpAngle, |leg| near(leg).to_vec());
        steps.push(wait());
        let (bench, fault) = run(model, steps);
        assert_eq!(fault, None, "{}", model.name);
        for (leg, angles) in model.legs.iter().zip(bench.hardware().angles()) {
            for (angle, target) in angles.iter().zip(near(leg)) {
                assert!((angle - target).abs() <= model.standards.just_angle);
            }
        }
    }
    every_shape!(goes);
}

// clauses: 7.2 7.6 7.15
#[test]
fn every_shape_goes_to_its_places_and_back() {
    fn goes<const L: usize, const J: usize>(model: &Model<L, J>) {
        let mut steps = for_legs(model, Op::Ptp, |leg| foot(leg, &near(leg)).to_vec());
        steps.push(wait());
        let (bench, fault) = run(model, steps.clone());
        assert_eq!(fault, None, "{}", model.name);
        for (n, leg) in model.legs.iter().enumerate() {
            let gap = gap(model, &bench, n, &near(leg));
            assert!(gap <= model.standards.just_position, "{} {gap}", model.name);
        }
        steps.extend([(Op::InitialPosture, NONE, Vec::new()), wait()]);
        let (bench, fault) = run(model, steps);
        assert_eq!(fault, None, "{}", model.name);
        for (n, leg) in model.legs.iter().enumerate() {
            let gap = gap(model, &bench, n, &leg.initial);
            assert!(gap <= model.standards.just_position, "{} {gap}", model.name);
        }
    }
    every_shape!(goes);
}

// clauses: 7.6
#[test]
fn legs_with_joints_to_spare_return_to_their_initial_angles() {
    fn returns<const L: usize, const J: usize>(model: &Model<L, J>) {
        // To a posture at an angle of each joint, and by position to a place in another one.
        let away = |leg: &Leg<J>| near(leg).to_vec();
        let place = |leg: &Leg<J>| foot(leg, &leg.initial).map(|at| at + 10.0).to_vec();
        for second in [
            for_legs(model, Op::PtpAngle, away),
            for_legs(model, Op::Ptp, place),
        ] {
            let mut steps = for_legs(model, Op::PtpAngle, away);
            steps.push(wait());
            steps.extend(second);
            steps.push(wait());
            steps.push((Op::InitialPosture, NONE, Vec::new()));
            steps.push(wait());
            steps.push((Op::Sleep, NONE, vec![1000.0]));
            let (bench, fault) = run(model, steps);
            assert_eq!(fault, None, "{}", model.name);
            for (leg, angles) in model.legs.iter().zip(bench.hardware().angles()) {
                for (angle, initial) in angles.iter().zip(leg.initial) {
                    assert!((angle - initial).abs() <= 1.0, "{} {angles:?}", model.name);
                }
            }
        }
    }
    returns(&TRIPOD);
    returns(&ARM);
    returns(&NINE);
}

// clauses: 2.22 7.2
#[test]
fn what_no_leg_reaches_is_an_emergency() {
    fn refuses<const L: usize, const J: usize>(model: &Model<L, J>) {
        let far = vec![9e3, 0.0, 0.0];
        let (_, fault) = run(model, vec![(Op::Ptp, F1, far.clone())]);
        assert_eq!(fault, Some(Fault::OutOfReach(F1)));
        let steps = vec![
            (Op::EmgOff, NONE, Vec::new()),
            (Op::Ptp, F1, far),
            (Op::Sleep, NONE, vec![1000.0]),
        ];
        let (bench, fault) = run(model, steps);
        assert_eq!(fault, None);
        assert!(within_limits(&model.legs[0], &bench.hardware().angles()[0]));
    }
    every_shape!(refuses);
}

// clauses: 2.24 2.25 7.3
#[test]
fn a_foot_with_few_joints_comes_to_rest_on_what_it_has() {
    let leg = &PENDULUM.legs[0];
    let steps = vec![
        (Op::Ptp, F1, foot(leg, &[70.0]).to_vec()),
        (Op::Sleep, NONE, vec![300.0]),
        (Op::RelPtp, F1, vec![0.0; 3]),
        (Op::Sleep, NONE, vec![1000.0]),
        (Op::WaitNear, F1, Vec::new()),
    ];
    let (bench, fault) = run(&PENDULUM, steps);
    assert_eq!(fault, None);
    let [angle] = bench.hardware().angles()[0];
    assert!(angle > 15.0 && angle < 60.0, "{angle}");
}

// clauses: 2.25 5.1 7.12 7.16
#[test]
fn a_joint_behind_the_third_one_knows_nothing_of_its_position() {
    let leg = &TRIPOD.legs[0];
    let third = Chain::new(leg, &near(leg)).joint(2).expect("four joints");
    let steps = vec![
        (Op::CompliancePosition, Target::Joint(1, 3), third.to_vec()),
        (Op::WaitNear, Target::Joint(1, 4), Vec::new()),
    ];
    assert_eq!(run(&TRIPOD, steps).1, Some(Fault::InvalidMode));
}

/// Returns a speed, kept for half a second.
fn at_speed<const L: usize, const J: usize>(
    model: &Model<L, J>,
    velocity: [f64; 3],
) -> Result<[f64; 3], Fault> {
    let steps = vec![
        (Op::VelControl, F1, velocity.to_vec()),
        (Op::Sleep, NONE, vec![500.0]),
    ];
    let (bench, fault) = run(model, steps);
    let from = foot(&model.legs[0], &model.legs[0].initial);
    let to = foot(&model.legs[0], &bench.hardware().angles()[0]);
    fault.map_or(Ok([0, 1, 2].map(|axis| to[axis] - from[axis])), Err)
}

// clauses: 2.22 7.7
#[test]
fn a_foot_keeps_its_velocity_where_its_joints_allow_it() {
    fn keeps<const L: usize, const J: usize>(model: &Model<L, J>) {
        for axis in 0..3 {
            let mut velocity = [0.0; 3];
            velocity[axis] = 20.0;
            let way = at_speed(model, velocity).expect("it goes on");
            // 20 mm/s for 0.5 s, except for the servos' lag of 15 ms.
            let wanted = velocity.map(|along| along * 0.485);
            assert!(distance(way, wanted) < 0.6, "{} {way:?}", model.name);
        }
    }
    keeps(&ARM);
    keeps(&TRIPOD);
    keeps(&HEXAPOD);
    keeps(&SPIDER);
    keeps(&NINE);
    let out_of_reach = Err(Fault::OutOfReach(F1));
    let in_its_plane = at_speed(&SLED, [0.0, -20.0, 20.0]).expect("it goes on");
    assert!(
        distance(in_its_plane, [0.0, -9.7, 9.7]) < 0.6,
        "{in_its_plane:?}"
    );
    assert_eq!(at_speed(&SLED, [1.0, 0.0, 0.0]), out_of_reach);
    assert_eq!(at_speed(&PENDULUM, [0.0, 20.0, 0.0]), out_of_reach);
}

/// Returns the robot without weight, so that nothing but its springs moves it.
fn weightless<const L: usize, const J: usize>(model: &Model<L, J>) -> Model<L, J> {
    let mut model = Model {
        body: None,
        ..*model
    };
    for joint in model.legs.iter_mut().flat_map(|leg| &mut leg.joints) {
        joint.mass = 0.0;
    }
    model
}

// clauses: 7.12 7.13
#[test]
fn springs_pull_every_shape_to_their_rest_and_let_go() {
    fn pull<const L: usize, const J: usize>(model: &Model<L, J>) {
        let model = &weightless(model);
        let mut steps = vec![(Op::SetPositionStiffness, ALL, vec![0.1; 3])];
        let soft = |leg: &Leg<J>| foot(leg, &near(leg)).to_vec();
        steps.extend(for_legs(model, Op::CompliancePosition, soft));
        steps.push((Op::Sleep, NONE, vec![40_000.0]));
        let (bench, fault) = run(model, steps.clone());
        assert_eq!(fault, None, "{}", model.name);
        for (n, leg) in model.legs.iter().enumerate() {
            let gap = gap(model, &bench, n, &near(leg));
            assert!(gap < 0.1, "{} {gap}", model.name);
        }
        steps.extend(for_legs(model, Op::NoCompliance, |_| Vec::new()));
        let back = |leg: &Leg<J>| foot(leg, &leg.initial).to_vec();
        steps.extend(for_legs(model, Op::Ptp, back));
        steps.push(wait());
        assert_eq!(run(model, steps).1, None, "{}", model.name);
    }
    every_shape!(pull);
}

// clauses: 7.9 7.10 7.42
#[test]
fn no_force_and_no_torque_leads_a_joint_beyond_its_limits() {
    fn stays<const L: usize, const J: usize>(model: &Model<L, J>) {
        let model = &weightless(model);
        let mut random = Random::new(9);
        let size = Range::new(-30.0, 30.0);
        for _ in 0..5 {
            let force = [(); 3].map(|()| number(&mut random, size)).to_vec();
            let torques = [(); J].map(|()| number(&mut random, size)).to_vec();
            for push in [(Op::Force, F1, force), (Op::Torque, F1, torques)] {
                let steps = vec![
                    (Op::EmgOff, NONE, Vec::new()),
                    (Op::SetTorqueMax, ALL, vec![3.0]),
                    push,
                    (Op::Sleep, NONE, vec![20_000.0]),
                ];
                let (bench, fault) = run(model, steps);
                assert_eq!(fault, None, "{}", model.name);
                let joints = model.legs[0].joints.iter();
                for (joint, angle) in joints.zip(bench.hardware().angles()[0]) {
                    let limits = joint.limits.widened(1e-3);
                    assert!(limits.contains(angle), "{} {angle} {limits:?}", model.name);
                }
            }
        }
    }
    every_shape!(stays);
}

/// Returns steps that keep every part of a controller busy.
fn busy<const L: usize, const J: usize>(model: &Model<L, J>) -> Vec<Step> {
    let mut steps = for_legs(model, Op::Ptp, |leg| foot(leg, &near(leg)).to_vec());
    steps.push(wait());
    steps.extend(for_legs(model, Op::PtpAngle, |leg| leg.initial.to_vec()));
    steps.push((Op::Sleep, NONE, vec![100.0]));
    steps.extend(for_legs(model, Op::CompliancePosition, |leg| {
        foot(leg, &leg.initial).to_vec()
    }));
    steps.push((Op::LogOneShot, NONE, Vec::new()));
    steps.push((Op::OutputVariables, NONE, Vec::new()));
    steps.push((Op::Sleep, NONE, vec![100.0]));
    steps.push((Op::InitialPosture, NONE, Vec::new()));
    steps
}

#[test]
fn no_cycle_of_any_shape_takes_from_the_heap() {
    fn takes_nothing<const L: usize, const J: usize>(model: &Model<L, J>) {
        let mut bench = bench(model, busy(model));
        let heap = measure(|| {
            for _ in 0..500 {
                bench.cycle();
            }
        });
        assert_eq!(heap.count_total, 0, "{}", model.name);
    }
    every_shape!(takes_nothing);
}

#[test]
fn every_shape_does_the_same_twice_to_the_bit() {
    fn repeats<const L: usize, const J: usize>(model: &Model<L, J>) {
        let (mut one, mut other) = (bench(model, busy(model)), bench(model, busy(model)));
        for _ in 0..500 {
            assert_eq!(one.cycle(), other.cycle());
            let bits =
                |bench: &Bench<L, J>| bench.hardware().angles().map(|leg| leg.map(f64::to_bits));
            assert_eq!(bits(&one), bits(&other));
        }
    }
    every_shape!(repeats);
}
