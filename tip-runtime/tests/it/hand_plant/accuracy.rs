//! The accuracy of the simulated hand in its own time steps: compared with closed forms, equations
//! that are derived and integrated here, and itself in steps of 0.01 ms. `cargo test -p tip-runtime
//! --test it hand_plant::accuracy -- --nocapture` prints the table of docs/robots.md.

use crate::hand_plant::rig::{F1, Plant, Rig, cycles, held, object, outputs, over, plant, write};
use std::io::{self, Write};
use tip_runtime::command::{Op, Target};
use tip_runtime::hardware::{JointCommand, Outputs};
use tip_runtime::model::hand;
use tip_runtime::plant::{Object, Scene, Shape};

const G: f64 = 9.80665;

/// Lengths (m) and masses (kg) of the links, the motors' inertia (kg·m²), friction of joints (N·m·s/rad).
const LENGTHS: [f64; 3] = [0.070, 0.050, 0.040];
const MASSES: [f64; 3] = [0.060, 0.040, 0.025];
const ROTOR: f64 = 1e-4;
const FRICTION: f64 = 0.01;

/// A box 100 mm wide, 60 mm high, 0.2 kg, on the floor under the palm.
const BOX: Object = Object {
    shape: Shape::Box {
        width: 100.0,
        height: 60.0,
    },
    mass: 0.2,
    friction: 0.8,
    x: 0.0,
    y: None,
    angle: 0.0,
};

fn scene(object: Object) -> Scene {
    Scene::EMPTY.with_object(object).expect("a good object")
}

/// Runs the same commands for `seconds`, in cycles of `period` ms.
fn go(plant: &mut Plant, joints: [[JointCommand; 3]; 3], seconds: f64, period: f64) {
    let commands = Outputs {
        period,
        ..outputs(joints)
    };
    write(
        plant,
        &commands,
        (seconds * 1000.0 / period).round() as usize,
    );
}

/// Returns the greatest distance of two runs of `seconds`, one in cycles of 2 ms, the other in
/// steps of 0.01 ms, in the values that are `seen` every 2 ms; and the greatest motion.
fn refined<const N: usize>(
    ready: &Plant,
    joints: [[JointCommand; 3]; 3],
    seconds: f64,
    seen: impl Fn(&Plant) -> [f64; N],
) -> (f64, f64) {
    let (mut plain, mut fine) = (ready.clone(), ready.clone());
    let start = seen(ready);
    let (mut error, mut path) = (0.0_f64, 0.0_f64);
    for _ in 0..cycles(seconds) {
        go(&mut plain, joints, 0.002, 2.0);
        go(&mut fine, joints, 0.002, 0.01);
        let (a, b) = (seen(&plain), seen(&fine));
        for ((a, b), start) in a.into_iter().zip(b).zip(start) {
            error = error.max((a - b).abs());
            path = path.max((b - start).abs());
        }
    }
    (error, path)
}

/// Returns the accelerations of three rods in a chain, from Lagrange's equations in the rods' own
/// angles: with a = (angle of each rod), `T = Σ Aᵢⱼ cos(aᵢ − aⱼ) ȧᵢ ȧⱼ / 2`, and motors between
/// neighbours.
fn chain(angles: [f64; 3], rates: [f64; 3], torques: [f64; 3]) -> [f64; 3] {
    let mut matrix = nalgebra::Matrix3::<f64>::zeros();
    let mut forces = nalgebra::Vector3::<f64>::zeros();
    for i in 0..3 {
        for j in 0..3 {
            let (low, high) = (i.min(j), i.max(j));
            let beyond: f64 = MASSES[high + 1..].iter().sum();
            let own = if i == j {
                MASSES[i] / 3.0
            } else {
                MASSES[high] / 2.0
            };
            let inertia = LENGTHS[low] * LENGTHS[high] * (own + beyond);
            let (sin, cos) = (angles[i] - angles[j]).sin_cos();
            matrix[(i, j)] += inertia * cos;
            forces[i] -= inertia * sin * rates[j] * rates[j];
        }
        // Joint i turns rod i against the rod before it.
        let before = if i > 0 { rates[i - 1] } else { 0.0 };
        let torque = torques[i] - FRICTION * (rates[i] - before);
        matrix[(i, i)] += ROTOR;
        forces[i] += torque;
        if i > 0 {
            matrix[(i - 1, i - 1)] += ROTOR;
            matrix[(i - 1, i)] -= ROTOR;
            matrix[(i, i - 1)] -= ROTOR;
            forces[i - 1] -= torque;
        }
    }
    let solved = matrix.lu().solve(&forces).expect("a mass matrix");
    [solved[0], solved[1], solved[2]]
}

/// Returns the joints of a free finger (deg) after `time` s of constant torques (N·m), by Runge and
/// Kutta's method of fourth order in steps of 0.01 ms.
fn swung(start: [f64; 3], torques: [f64; 3], time: f64) -> [f64; 3] {
    type State = [[f64; 3]; 2];
    let sums = |[a, b, c]: [f64; 3]| [a, a + b, a + b + c];
    let slope = |[angles, rates]: State| [rates, chain(angles, rates, torques)];
    let along = |state: State, slope: State, by: f64| -> State {
        std::array::from_fn(|n| std::array::from_fn(|m| state[n][m] + by * slope[n][m]))
    };
    let mut state = [sums(start.map(f64::to_radians)), [0.0; 3]];
    let dt = 1e-5;
    for _ in 0..(time / dt).round() as usize {
        let a = slope(state);
        let b = slope(along(state, a, dt / 2.0));
        let c = slope(along(state, b, dt / 2.0));
        let d = slope(along(state, c, dt));
        for (slope, share) in [(a, 1.0), (b, 2.0), (c, 2.0), (d, 1.0)] {
            state = along(state, slope, share * dt / 6.0);
        }
    }
    let [a, b, c] = state[0];
    [a, b - a, c - b].map(f64::to_degrees)
}

/// Returns the greatest error of an angle of a finger that three torques swing for 40 ms, and its
/// path, deg.
fn free_finger() -> (f64, f64) {
    let torques = [40.0, -30.0, -12.0];
    let start = hand::MODEL.legs[0].initial;
    let mut joints = held();
    joints[0] = torques.map(JointCommand::Torque);
    let mut plant = plant();
    let (mut error, mut path) = (0.0_f64, 0.0_f64);
    for cycle in 1..=20 {
        go(&mut plant, joints, 0.002, 2.0);
        let exact = swung(
            start,
            torques.map(|torque| torque / 1000.0),
            0.002 * f64::from(cycle),
        );
        for ((angle, exact), start) in plant.angles()[0].into_iter().zip(exact).zip(start) {
            error = error.max((angle - exact).abs());
            path = path.max((exact - start).abs());
        }
    }
    (error, path)
}

/// The fingers, and the side of the box that each touches.
const FINGERS: [(Target, f64); 3] = [(F1, -1.0), (Target::Foot(2), 1.0), (Target::Foot(3), 1.0)];

/// Height of the fingers at the grasp, mm.
const HEIGHT: f64 = -115.0;

/// Returns the fingertips 6 mm from the sides of the box on a low floor.
fn beside() -> Rig {
    let mut rig = Rig::on(over(&scene(BOX)));
    rig.run(Op::Ptp, Target::Floor, &[0.0, -155.0, 0.0]);
    for (finger, _) in FINGERS {
        rig.run(Op::PtpAngle, finger, &[-50.0, 0.0, 20.0]);
    }
    rig.run(Op::WaitInpos, Target::All, &[]);
    for x in [85.0, 56.0] {
        for (finger, side) in FINGERS {
            rig.run(Op::Ptp, finger, &[side * x, HEIGHT, 0.0]);
        }
        rig.run(Op::WaitInpos, Target::All, &[]);
    }
    rig.idle(0.5);
    rig
}

/// Returns a grasp by the first joints, F1's twice as hard as the others.
fn grasped() -> Rig {
    let mut rig = beside();
    for (n, torque) in [(1, 200.0), (2, 100.0), (3, 100.0)] {
        rig.run(Op::Torque, Target::Joint(n, 1), &[torque]);
    }
    rig.idle(0.7);
    rig
}

/// Returns the moment about F1's first joint of the force with which its tip presses the box, and
/// the joint's torque, N·m.
fn grasp_force() -> (f64, f64) {
    let tip = grasped().plant.fingertips()[0];
    let ([x, y, _], [along, up, _]) = (tip.position, tip.on_objects);
    (((x + 60.0) * up - y * along) / 1000.0, 0.2)
}

/// Returns the part of the box's weight that stretched springs carry, and its weight, N.
fn lift() -> (f64, f64) {
    let mut rig = grasped();
    for (n, (finger, _)) in FINGERS.into_iter().enumerate() {
        let stiffness = if n == 0 { 0.4 } else { 0.2 };
        rig.run(Op::SetPositionStiffness, finger, &[stiffness; 3]);
    }
    for (rise, time) in [(0.0, 0.7), (42.0, 4.0)] {
        for (finger, side) in FINGERS {
            rig.run(
                Op::CompliancePosition,
                finger,
                &[side * 42.0, HEIGHT + rise, 0.0],
            );
        }
        rig.idle(time);
    }
    assert!(object(&rig.plant).clearance > 30.0);
    let [a, b, c] = rig
        .plant
        .fingertips()
        .map(|tip| HEIGHT + 42.0 - tip.position[1]);
    (0.4 * a + 0.2 * b + 0.2 * c, 0.2 * G)
}

/// Returns the greatest error of a free finger in cycles of one step of `period` ms, deg.
fn error_in_steps_of(period: f64) -> f64 {
    let torques = [40.0, -30.0, -12.0];
    let mut joints = held();
    joints[0] = torques.map(JointCommand::Torque);
    let mut plant = plant();
    go(&mut plant, joints, 0.04, period);
    let start = hand::MODEL.legs[0].initial;
    let exact = swung(start, torques.map(|torque| torque / 1000.0), 0.04);
    let angles = plant.angles()[0].into_iter().zip(exact);
    angles.fold(0.0, |error, (angle, exact)| {
        error.max((angle - exact).abs())
    })
}

#[test]
fn half_the_step_makes_a_quarter_of_the_error() {
    let errors = [0.5, 0.25, 0.125].map(error_in_steps_of);
    for pair in errors.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((3.5..4.5).contains(&ratio), "{errors:?}");
    }
}

/// Writes one line of the table.
fn row(out: &mut impl Write, what: &str, error: f64, of: f64, unit: &str) -> f64 {
    let share = error / of;
    writeln!(
        out,
        "| {what} | {of:.4} {unit} | {error:.2e} {unit} | {:.4} % |",
        100.0 * share
    )
    .expect("a table");
    share
}

#[test]
fn what_the_hand_does_is_as_exact_as_documented() {
    let mut out = io::stdout().lock();
    writeln!(
        out,
        "| what | path, or value | error | of it |\n|---|---|---|---|"
    )
    .expect("a table");
    let (error, path) = free_finger();
    let free = row(
        &mut out,
        "a free finger, swung by three torques",
        error,
        path,
        "deg",
    );
    let (force, exact) = grasp_force();
    let grasp = row(
        &mut out,
        "torque of a grasp that rests",
        (force - exact).abs(),
        exact,
        "N·m",
    );
    let (weight, exact) = lift();
    let lift = row(
        &mut out,
        "weight that springs carry",
        (weight - exact).abs(),
        exact,
        "N",
    );
    // The slider returns from −155 mm to −130 mm meanwhile.
    let ready = beside().plant;
    let mut joints = ready.angles().map(|finger| finger.map(JointCommand::at));
    for (finger, torque) in joints.iter_mut().zip([200.0, 100.0, 100.0]) {
        finger[0] = JointCommand::Torque(torque);
    }
    let (error, path) = refined(&ready, joints, 0.1, |plant| {
        let [x, ..] = plant.fingertips()[0].position;
        let body = object(plant);
        [x, body.position[0], body.position[1]]
    });
    let closing = row(
        &mut out,
        "fingers close on a box that the floor lifts",
        error,
        path,
        "mm",
    );
    let falling = Object {
        y: Some(-60.0),
        angle: 20.0,
        ..BOX
    };
    let (error, path) = refined(&over(&scene(falling)), held(), 0.4, |plant| {
        let [x, y, _] = object(plant).position;
        [x, y]
    });
    let falling = row(
        &mut out,
        "a tilted box falls and comes to rest",
        error,
        path,
        "mm",
    );
    assert!(free < 1e-4 && grasp < 1e-8 && lift < 1e-8);
    assert!(closing < 3e-3 && falling < 3e-3);
}
