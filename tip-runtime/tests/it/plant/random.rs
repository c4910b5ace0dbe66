//! Short random programs that move joints: the body only moves as feet and gravity make it.

use crate::list::{List, Step};
use tip_runtime::command::{Op, Target};
use tip_runtime::kinematics::Chain;
use tip_runtime::machine::Machine;
use tip_runtime::model::{Body, Joint, Leg, Model, Range, generic, titan8};
use tip_runtime::plant::{Pose, SimulatedPlant};
use tip_runtime::random::Random;

/// The acceleration of free fall, mm/s².
const GRAVITY: f64 = 9806.65;

/// Greatest step of a body within 20 ms, mm. Feet move it some 5 mm. A corner that has fallen 50 mm
/// moves at 1 m/s, 20 mm.
const FARTHEST: f64 = 25.0;

/// Greatest turn of a body about the vertical within 20 ms, deg.
const WIDEST: f64 = 5.0;

/// Returns a leg on the left (−1) or right (+1) of a robot with six.
const fn leg(side: f64, y: f64) -> Leg<3> {
    let joints = [
        Joint::revolute([0.0, 0.0, -side], [40.0 * side, 0.0, 0.0])
            .mass(0.2)
            .limits(-60.0, 60.0),
        Joint::revolute([0.0, -side, 0.0], [100.0 * side, 0.0, 0.0])
            .mass(0.3)
            .limits(-60.0, 75.0),
        Joint::revolute([0.0, side, 0.0], [100.0 * side, 0.0, 0.0])
            .mass(0.1)
            .limits(-5.0, 150.0),
    ];
    Leg::at([80.0 * side, y, 0.0], joints).initial([0.0, 10.0, 100.0])
}

const HEXAPOD: Model<6, 3> = Model {
    body: Some(Body {
        x: Range::new(-80.0, 80.0),
        y: Range::new(-180.0, 180.0),
        z: Range::new(-60.0, 30.0),
        mass: 4.0,
        inertial: None,
    }),
    ..Model::generic(
        "hexapod",
        [
            leg(-1.0, 150.0),
            leg(1.0, 150.0),
            leg(-1.0, 0.0),
            leg(1.0, 0.0),
            leg(-1.0, -150.0),
            leg(1.0, -150.0),
        ],
    )
};

type Steps = Vec<Step<Vec<f64>>>;

/// Returns a program that stands on feet below the initial ones and moves three legs, joint by
/// joint.
fn program<const L: usize>(model: &Model<L, 3>, numbers: &mut Random) -> Steps {
    let mut steps = Vec::new();
    for (leg, foot) in (1..).zip(model.legs.map(|leg| Chain::new(&leg, &leg.initial).foot())) {
        let [x, y, z] = foot;
        steps.push((Op::Ptp, Target::Foot(leg), vec![x, y, z - 40.0]));
    }
    steps.push((Op::Sleep, Target::None, vec![500.0]));
    for _ in 0..3 {
        let leg = numbers.within(1.0, L as f64 + 1.0) as u8;
        let angles = model.legs[usize::from(leg) - 1].initial;
        let angles = angles.map(|angle| numbers.within(angle - 25.0, angle + 25.0));
        steps.push((Op::PtpAngle, Target::Foot(leg), angles.to_vec()));
        let pause = (numbers.within(10.0, 35.0) as u32) * 20;
        steps.push((Op::Sleep, Target::None, vec![f64::from(pause)]));
    }
    steps
}

/// Returns the poses before the first cycle and after each one, of `period` ms.
fn poses<const L: usize>(model: &Model<L, 3>, steps: &Steps, period: f64) -> Vec<Pose> {
    let mut all = vec![(Op::SetSamplingTime, Target::None, vec![period])];
    all.extend(steps.iter().cloned());
    let program = List::new(all, model.signature());
    let plant = SimulatedPlant::new(model);
    let mut machine = Machine::new(program, model, plant).expect("made for this robot");
    let mut poses = vec![machine.hardware().body()];
    while machine.cycle().is_running() {
        poses.push(machine.hardware().body());
    }
    assert_eq!(machine.emergency(), None);
    poses
}

/// Fails if the body leaps between poses that are `apart` cycles apart.
fn stays_together(name: &str, poses: &[Pose], apart: usize) {
    for (cycle, (from, to)) in poses.iter().zip(&poses[apart..]).enumerate() {
        let way = [0, 1, 2].map(|axis| to.position[axis] - from.position[axis]);
        let way = way.iter().map(|way| way * way).sum::<f64>().sqrt();
        let turn = (to.yaw - from.yaw).abs();
        assert!(
            way <= FARTHEST && turn <= WIDEST,
            "{name}, cycle {cycle}: {way} mm, {turn} deg"
        );
    }
}

/// Returns the greatest descent of the middle and the lower corners of the body, mm.
fn sunk<const L: usize>(model: &Model<L, 3>, from: &Pose, to: &Pose) -> f64 {
    let body = model.body.expect("it walks");
    let height = |pose: &Pose, [x, y, z]: [f64; 3]| {
        let (roll, pitch) = (pose.roll.to_radians(), pose.pitch.to_radians());
        // By roll about y, then by pitch about x.
        let up = z * libm::cos(roll) - x * libm::sin(roll);
        pose.position[2] + y * libm::sin(pitch) + up * libm::cos(pitch)
    };
    let corners = [
        [body.x.min, body.y.min, body.z.min],
        [body.x.max, body.y.min, body.z.min],
        [body.x.min, body.y.max, body.z.min],
        [body.x.max, body.y.max, body.z.min],
        [0.0; 3],
    ];
    let sunk = corners.map(|corner| height(from, corner) - height(to, corner));
    sunk.into_iter().fold(f64::NEG_INFINITY, f64::max)
}

/// Fails if the fastest descent of the body accelerates more than a fall does.
fn falls_freely<const L: usize>(model: &Model<L, 3>, poses: &[Pose]) {
    let (dt, mut before) = (0.02, 0.0_f64);
    for (cycle, pair) in poses.windows(2).enumerate() {
        let now = sunk(model, &pair[0], &pair[1]) / dt;
        let gained = now - before.max(0.0);
        assert!(
            gained <= GRAVITY * dt + 1e-6,
            "{}, cycle {cycle}: {gained} mm/s",
            model.name
        );
        before = now;
    }
}

fn try_out<const L: usize>(model: &Model<L, 3>, numbers: &mut Random, round: u32) {
    let program = program(model, numbers);
    let by_20 = poses(model, &program, 20.0);
    stays_together(model.name, &by_20, 1);
    falls_freely(model, &by_20);
    if round.is_multiple_of(10) {
        stays_together(model.name, &poses(model, &program, 1.0), 20);
    }
}

#[test]
fn no_body_leaps_and_none_falls_faster_than_freely() {
    let mut numbers = Random::new(8);
    for round in 0..1000 {
        match round % 3 {
            0 => try_out(&titan8::MODEL, &mut numbers, round),
            1 => try_out(&generic::MODEL, &mut numbers, round),
            _ => try_out(&HEXAPOD, &mut numbers, round),
        }
    }
}

/// Two legs move, so that for a moment one foot carries all.
#[test]
fn a_lone_foot_does_not_turn_the_body() {
    let none = Target::None;
    let steps: Steps = vec![
        (Op::StandUp, none, vec![67.0]),
        (Op::WaitInpos, Target::All, Vec::new()),
        (Op::PtpAngle, Target::Foot(1), vec![-15.0, -16.0, 53.0]),
        (Op::Sleep, none, vec![700.0]),
        (Op::PtpAngle, Target::Foot(3), vec![30.0, -10.0, 90.0]),
        (Op::Sleep, none, vec![700.0]),
    ];
    let poses = poses(&titan8::MODEL, &steps, 20.0);
    stays_together("titan8", &poses, 1);
    let [x, y, _] = poses.last().expect("it ran").position;
    // With mass it ends 1.6 mm backward and 3.8 mm to the left.
    assert!(x.hypot(y) < 20.0, "{x} {y}");
}
