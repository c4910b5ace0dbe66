//! The mass matrix, compared with the energy of rods whose ends are followed by finite differences.

use crate::dynamic::rig::{SMOOTH, all, some};
use nalgebra::{Rotation3, Vector3};
use tip_runtime::hardware::{Hardware, JointCommand};
use tip_runtime::kinematics::frames;
use tip_runtime::model::{Body, Joint, Leg, Model, Range, titan8};
use tip_runtime::plant::dynamic::Twist;
use tip_runtime::plant::{DynamicPlant, Pose};
use tip_runtime::random::Random;

pub(crate) type Vector = Vector3<f64>;

/// Time of a finite difference, s.
pub(crate) const DIFFERENCE: f64 = 1e-5;

pub(crate) fn rotation(pose: &Pose) -> Rotation3<f64> {
    let turn = |axis, angle: f64| Rotation3::from_axis_angle(&axis, angle.to_radians());
    turn(Vector::z_axis(), pose.yaw)
        * turn(Vector::x_axis(), pose.pitch)
        * turn(Vector::y_axis(), pose.roll)
}

/// Returns both ends of each link in the world, m, after a motion of `time` s at constant velocity.
fn ends<const L: usize, const J: usize>(
    model: &Model<L, J>,
    plant: &DynamicPlant<L, J>,
    time: f64,
) -> Vec<[Vector; 2]> {
    let (pose, twist) = (plant.body(), plant.twist());
    let turn = Vector::from(twist.rate.map(f64::to_radians)) * time;
    let turned = Rotation3::from_scaled_axis(turn) * rotation(&pose);
    let at = (Vector::from(pose.position) + Vector::from(twist.velocity) * time) / 1000.0;
    let legs = model
        .legs
        .iter()
        .zip(plant.angles().into_iter().zip(plant.rates()));
    let mut ends = Vec::new();
    for (leg, (angles, rates)) in legs {
        let mut moved = angles;
        for (angle, rate) in moved.iter_mut().zip(rates) {
            *angle += rate * time;
        }
        for (frame, joint) in frames(leg.base, &leg.joints, &moved).zip(&leg.joints) {
            let place = |point: [f64; 3]| at + turned * Vector::from(point) / 1000.0;
            ends.push([place(frame.at), place(frame.point(joint.link))]);
        }
    }
    ends
}

/// Returns the kinetic energy, J. A rod whose ends have the velocities a and b has m (a² + a·b +
/// b²) / 6.
fn kinetic<const L: usize, const J: usize>(model: &Model<L, J>, plant: &DynamicPlant<L, J>) -> f64 {
    let (before, after) = (
        ends(model, plant, -DIFFERENCE),
        ends(model, plant, DIFFERENCE),
    );
    let masses = model
        .legs
        .iter()
        .flat_map(|leg| leg.joints.map(|joint| joint.mass));
    let rods = before
        .iter()
        .zip(&after)
        .zip(masses)
        .map(|((before, after), mass)| {
            let [a, b] = [0, 1].map(|end| (after[end] - before[end]) / (2.0 * DIFFERENCE));
            mass * (a.dot(&a) + a.dot(&b) + b.dot(&b)) / 6.0
        });
    rods.sum::<f64>() + rotors(model, plant) + body(model.body.as_ref(), plant)
}

/// Returns the kinetic energy of the rotors, J.
pub(crate) fn rotors<const L: usize, const J: usize>(
    model: &Model<L, J>,
    plant: &DynamicPlant<L, J>,
) -> f64 {
    let torques = model
        .legs
        .iter()
        .flat_map(|leg| leg.joints.map(|joint| joint.torque));
    let rates = plant.rates().into_iter().flatten().map(f64::to_radians);
    torques
        .zip(rates)
        .map(|(torque, rate)| 7.5e-4 * torque * rate * rate / 2.0)
        .sum()
}

fn body<const L: usize, const J: usize>(model: Option<&Body>, plant: &DynamicPlant<L, J>) -> f64 {
    let Some(body) = model else { return 0.0 };
    let length = |range: Range| (range.max - range.min) / 1000.0;
    let [x, y, z] = [body.x, body.y, body.z].map(|range| length(range) * length(range));
    let twist = plant.twist();
    let velocity = Vector::from(twist.velocity) / 1000.0;
    let rate = rotation(&plant.body()).inverse() * Vector::from(twist.rate.map(f64::to_radians));
    let turning = Vector::new(y + z, x + z, x + y)
        .component_mul(&rate)
        .dot(&rate)
        / 12.0;
    body.mass * (velocity.norm_squared() + turning) / 2.0
}

/// Throws a robot into the air in many ways, in many postures.
fn compare<const L: usize, const J: usize>(model: &Model<L, J>) {
    let mut random = Random::new(7);
    for _ in 0..20 {
        let mut plant = DynamicPlant::new(model).with_drives(SMOOTH).lifted(5000.0);
        // Some attitude and posture, by motion.
        for _ in 0..2 {
            plant = plant
                .with_twist(Twist {
                    velocity: some(&mut random, 800.0),
                    rate: some(&mut random, 300.0),
                })
                .with_rates([(); L].map(|()| some(&mut random, 300.0)));
            let still = all([[JointCommand::Torque(0.0); J]; L], 100.0);
            plant.write(&still).expect("it is simulated");
        }
        let (matrix, rods) = (plant.energy().kinetic, kinetic(model, &plant));
        assert!(
            rods > 0.0 && (matrix / rods - 1.0).abs() < 1e-6,
            "{matrix} J, {rods} J"
        );
    }
}

#[test]
fn titan_has_the_energy_of_its_rods() {
    compare(&titan8::MODEL);
}

#[test]
fn so_have_other_robots() {
    let slanted = |x: f64, y: f64| {
        Leg::at(
            [x, y, 10.0],
            [
                Joint::revolute([0.0, 0.0, 1.0], [40.0, 5.0, -3.0]).mass(0.3),
                Joint::revolute([0.6, 0.8, 0.0], [10.0, 70.0, -20.0]).mass(0.2),
                Joint::revolute([0.0, 0.6, 0.8], [0.0, 15.0, -90.0]).mass(0.15),
                Joint::revolute([1.0, 0.0, 0.0], [3.0, 0.0, -60.0]).mass(0.1),
            ],
        )
    };
    let legs = [
        slanted(80.0, 10.0),
        slanted(-80.0, 20.0),
        slanted(5.0, -90.0),
    ];
    compare(&Model::generic("tripod", legs));
    let bolted = Model {
        body: None,
        ..Model::generic("bolted", legs)
    };
    compare(&bolted);
}
