//! Robots of other shapes on the floor.

use crate::generic::program::{Step, bench, run};
use crate::generic::shapes::{ARM, BIPED, HEXAPOD, NINE, PENDULUM, SLED, SPIDER, TRIPOD};
use tip_runtime::command::{Op, Target};
use tip_runtime::kinematics::{Chain, LegPoint};
use tip_runtime::model::{Inverse, Model, generic};
use tip_runtime::plant::SimulatedPlant;

const ALL: Target = Target::All;
const NONE: Target = Target::None;

/// Returns the weight of body and links, N.
fn weight<const L: usize, const J: usize>(model: &Model<L, J>) -> f64 {
    let links = model.legs.iter().flat_map(|leg| &leg.joints);
    let body = model.body.expect("it walks").mass;
    links.fold(body, |mass, joint| mass + joint.mass) * 9.80665
}

/// Returns a place for each foot, reached by all of them.
fn feet<const L: usize, const J: usize>(
    model: &Model<L, J>,
    place: impl Fn(usize, [f64; 3]) -> [f64; 3],
) -> Vec<Step> {
    let mut steps: Vec<Step> = Vec::new();
    for (n, leg) in model.legs.iter().enumerate() {
        let foot = place(n, Chain::new(leg, &leg.initial).foot());
        steps.push((Op::Ptp, Target::Foot(n as u8 + 1), foot.to_vec()));
    }
    steps.push((Op::WaitInpos, ALL, Vec::new()));
    steps
}

#[test]
fn all_legs_carry_a_robot_that_stands() {
    fn stands<const L: usize, const J: usize>(model: &Model<L, J>) {
        let raised = |_, [x, y, _]: [f64; 3]| [x, y, -130.0];
        let mut steps = feet(model, raised);
        steps.push((Op::Sleep, NONE, vec![1000.0]));
        let (bench, fault) = run(model, steps);
        assert_eq!(fault, None, "{}", model.name);
        let plant = bench.hardware();
        let carried: f64 = plant.feet().iter().map(|foot| foot.load).sum();
        assert!((carried - weight(model)).abs() < 1e-6, "{carried}");
        assert_eq!(plant.contacts(), [true; L]);
        assert_eq!((plant.belly_load(), plant.falls()), (0.0, 0));
        let [_, _, up] = plant.body().position;
        assert!((up - 130.0).abs() < 2.5, "{:?}", plant.body());
        assert!(plant.margin() > 50.0);
    }
    stands(&TRIPOD);
    stands(&HEXAPOD);
    stands(&SPIDER);
}

#[test]
fn what_is_bolted_down_stays_and_cannot_fall() {
    fn stays<const L: usize, const J: usize>(model: &Model<L, J>) {
        let before = SimulatedPlant::new(model).body();
        let bent = model.legs.map(|leg| leg.initial.map(|angle| angle + 5.0));
        let steps = (1..).zip(bent);
        let steps = steps.map(|(n, to)| (Op::PtpAngle, Target::Foot(n), to.to_vec()));
        let mut steps: Vec<Step> = steps.collect();
        steps.push((Op::WaitInpos, ALL, Vec::new()));
        let (bench, fault) = run(model, steps);
        assert_eq!(fault, None, "{}", model.name);
        let plant = bench.hardware();
        assert_eq!(plant.body(), before);
        assert_eq!(before.position, [0.0; 3]);
        assert_eq!((plant.falls(), plant.belly_load()), (0, 0.0));
        assert!(plant.feet().iter().all(|foot| !foot.touches()));
    }
    stays(&PENDULUM);
    stays(&ARM);
    stays(&NINE);
}

#[test]
fn two_arms_raise_the_front_of_their_sled() {
    let down = [-30.0, -60.0].to_vec();
    let steps = vec![
        (Op::PtpAngle, Target::Foot(1), down.clone()),
        (Op::PtpAngle, Target::Foot(2), down),
        (Op::WaitInpos, ALL, Vec::new()),
    ];
    let (bench, fault) = run(&SLED, steps);
    assert_eq!(fault, None);
    let plant = bench.hardware();
    // From the rear edge of the belly to the feet: 120 cos 30 and the upright second link, ahead of
    // a base at y = 100; as much lower than the belly as 120 sin 30 + 100 is more than 80.
    let (ahead, below) = (200.0 + 100.0 + 120.0 * 30_f64.to_radians().cos(), 80.0);
    let pitch = f64::atan2(below, ahead).to_degrees();
    assert!(
        (plant.body().pitch - pitch).abs() < 0.5,
        "{:?}",
        plant.body()
    );
    assert_eq!(plant.falls(), 0);
    let carried: f64 = plant.feet().iter().map(|foot| foot.load).sum();
    assert!((carried + plant.belly_load() - weight(&SLED)).abs() < 1e-6);
}

#[test]
fn a_robot_on_two_feet_falls_as_soon_as_its_centre_of_mass_leaves_their_line() {
    let stands = SimulatedPlant::new(&BIPED);
    assert_eq!((stands.falls(), stands.contacts()), (0, [true; 2]));
    let one_ahead = feet(&BIPED, |n, [x, y, z]| [x, y + 40.0 * n as f64, z]);
    let (bench, fault) = run(&BIPED, one_ahead);
    assert_eq!(fault, None);
    let plant = bench.hardware();
    assert_eq!(plant.falls(), 1);
    assert!(plant.belly_load() > 0.0);
}

/// Returns the steps of a tripod gait, each 40 mm long.
fn gait(model: &Model<6, 3>, count: usize) -> Vec<Step> {
    const STRIDE: f64 = 40.0;
    let stand = |_, [x, y, _]: [f64; 3]| [x, y, -130.0];
    let mut steps = feet(model, stand);
    for step in 0..2 * count {
        let swings = |n: usize| (n.is_multiple_of(4) || n == 3) == step.is_multiple_of(2);
        let (from, to) = (-STRIDE / 4.0, STRIDE / 4.0);
        let lifted = |n: usize, place: [f64; 3]| {
            let [x, y, z] = stand(n, place);
            if swings(n) {
                [x, y + from, z + 25.0]
            } else {
                [x, y + to, z]
            }
        };
        let carried = |n: usize, place: [f64; 3]| {
            let [x, y, z] = stand(n, place);
            if swings(n) {
                [x, y + to, z + 25.0]
            } else {
                [x, y + from, z]
            }
        };
        let set_down = |n: usize, place: [f64; 3]| {
            let [x, y, z] = stand(n, place);
            [x, y + if swings(n) { to } else { from }, z]
        };
        steps.extend(feet(model, lifted));
        steps.extend(feet(model, carried));
        steps.extend(feet(model, set_down));
    }
    steps.extend([(Op::Sleep, NONE, vec![500.0])]);
    steps
}

#[test]
fn a_hexapod_walks_with_either_inverse_kinematics() {
    let closed = Model {
        inverse: Inverse::YawPitchPitch,
        ..HEXAPOD
    };
    let mut ends = Vec::new();
    for model in [HEXAPOD, closed] {
        assert_eq!(model.check(), Ok(()));
        let (bench, fault) = run(&model, gait(&model, 3));
        assert_eq!(fault, None);
        let plant = bench.hardware();
        assert_eq!(plant.falls(), 0);
        // Half a stride each time that a tripod carries the body.
        let [right, forward, _] = plant.body().position;
        assert!((forward - 120.0).abs() < 12.0, "{:?}", plant.body());
        assert!(right.abs() < 1.0 && plant.body().yaw.abs() < 0.5);
        ends.push(plant.body());
    }
    let gap = ends[0].position[1] - ends[1].position[1];
    assert!(gap.abs() < 1e-3, "{ends:?}");
}

// clauses: 7.12
#[test]
fn a_foot_on_a_spring_comes_to_rest_on_the_floor() {
    let model = &generic::MODEL;
    let target = [-391.0, 201.0, -230.0];
    let mut steps = feet(model, |_, [x, y, _]| [x, y, -220.0]);
    steps.push((Op::CompliancePosition, Target::Foot(1), target.to_vec()));
    steps.push((Op::Sleep, NONE, vec![1e9]));
    let mut bench = bench(model, steps);
    for _ in 0..300 {
        bench.cycle();
    }
    let before = bench.hardware().angles()[0];
    bench.cycle();
    let plant = bench.hardware();
    let angles = plant.angles()[0];
    for (angle, before) in angles.iter().zip(before) {
        assert!((angle - before).abs() < 1e-4, "{angle} {before}");
    }
    // The thigh's joint balances spring (1 N/mm), floor, and thigh and shank with their weight in the
    // middle.
    let chain = Chain::new(&model.legs[0], &angles);
    let of_foot = chain.foot_jacobian()[1];
    let knee = chain.point_jacobian(LegPoint::Joint(2)).expect("a knee");
    let to_knee = knee[1][2];
    let pull: f64 = (0..3)
        .map(|axis| of_foot[axis] * (target[axis] - chain.foot()[axis]))
        .sum();
    let push = of_foot[2] * plant.feet()[0].load;
    let links = 0.8 * to_knee / 2.0 + 0.4 * (to_knee + of_foot[2]) / 2.0;
    let rest = pull + push - 9.80665 * links;
    assert!(rest.abs() < 0.01 * push.abs(), "{rest} {pull} {push}");
}
