//! Flight: conservation laws and closed forms.

use crate::dynamic::rig::{GRAVITY, SMOOTH, hold, limp, rod, some, titan};
use tip_runtime::model::titan8;
use tip_runtime::plant::DynamicPlant;
use tip_runtime::plant::dynamic::Twist;
use tip_runtime::random::Random;

/// Returns TITAN VIII thrown into the air, its legs limp and swinging.
fn thrown() -> DynamicPlant<4, 3> {
    let mut random = Random::new(3);
    titan()
        .with_drives(SMOOTH)
        .lifted(5000.0)
        .with_twist(Twist {
            velocity: some(&mut random, 500.0),
            rate: some(&mut random, 60.0),
        })
        .with_rates([(); 4].map(|()| some(&mut random, 60.0)))
}

/// Returns the potential energy that a method that falls g t (t + dt) / 2 loses in `time` s, J.
fn method(time: f64, step: f64) -> f64 {
    20.0 * GRAVITY * GRAVITY * time * step / 2000.0
}

/// Returns the changes of energy (J), beyond that, and of momentum about the centre of mass (N·m·s)
/// after 0.2 s in steps of `step` ms.
fn changes(step: f64) -> (f64, f64) {
    let mut plant = thrown();
    let (energy, momentum) = (plant.energy(), plant.momentum());
    limp(&mut plant, step, (200.0 / step) as u32);
    let (after, turned) = (plant.energy(), plant.momentum());
    let change = after.kinetic + after.potential - energy.kinetic - energy.potential;
    let change = change + method(0.2, step);
    let changes = turned.angular.iter().zip(&momentum.angular);
    let turn: f64 = changes.map(|(a, b)| (a - b) * (a - b)).sum();
    (change.abs(), turn.sqrt())
}

#[test]
fn energy_and_momentum_stay_the_better_the_shorter_the_step() {
    let thrown = thrown();
    let whole = thrown.energy().kinetic;
    let spin: f64 = thrown.momentum().angular.iter().map(|own| own * own).sum();
    let (coarse, fine) = (changes(0.5), changes(0.125));
    println!(
        "of {whole} J and {} N·m·s: {coarse:?}, {fine:?}",
        spin.sqrt()
    );
    assert!(coarse.0 < 1e-4 * whole, "{coarse:?} of {whole} J");
    assert!(coarse.1 < 1e-4 * spin.sqrt(), "{coarse:?} of {spin}");
    // A method of first order: a quarter of the step, a quarter of the error.
    assert!(
        fine.0 < 0.4 * coarse.0 && fine.1 < 0.4 * coarse.1,
        "{fine:?}, {coarse:?}"
    );
}

#[test]
fn gravity_alone_changes_the_momentum_of_flight() {
    let mut plant = thrown();
    let before = plant.momentum().linear;
    limp(&mut plant, 0.5, 400);
    let [x, y, z] = plant.momentum().linear;
    // Legs that turn within a step move their momentum a little: first order in the step.
    assert!(
        (x - before[0]).abs() < 0.05 && (y - before[1]).abs() < 0.05,
        "{x}, {y}"
    );
    assert!((z - before[2] + 20.0 * GRAVITY * 0.2).abs() < 0.05, "{z}");
}

#[test]
fn a_robot_falls_as_fast_as_anything() {
    let mut plant = titan().lifted(2000.0);
    let from = plant.body().position[2];
    hold(&mut plant, titan8::MODEL.legs.map(|leg| leg.initial), 20);
    // 0.4 s in steps of 0.5 ms, whose method falls g t (t + dt) / 2.
    let fallen = 1000.0 * GRAVITY * 0.4 * 0.4005 / 2.0;
    assert!((from - plant.body().position[2] - fallen).abs() < 1e-6);
    let twist = plant.twist();
    assert!((twist.velocity[2] + 1000.0 * GRAVITY * 0.4).abs() < 1e-6);
    assert!(twist.rate.iter().all(|rate| rate.abs() < 1e-6), "{twist:?}");
}

#[test]
fn a_limp_rod_swings_like_a_pendulum() {
    let model = rod([0.0, 1.0, 0.0], [0.0, 0.0, -400.0], 3.0);
    let mut plant = DynamicPlant::new(&model).with_drives(SMOOTH);
    let (mut time, mut crossings) = (0.0, [0.0; 3]);
    let mut count = 0;
    let mut before = plant.angles()[0][0];
    while count < 3 {
        limp(&mut plant, 0.5, 1);
        let angle = plant.angles()[0][0];
        if before * angle < 0.0 {
            crossings[count] = time + 5e-4 * before / (before - angle);
            count += 1;
        }
        before = angle;
        time += 5e-4;
    }
    // A rod about its end, with the motor's rotor; the amplitude makes it slower by θ²/16.
    let inertia = 1.0 * 0.4 * 0.4 / 3.0 + 7.5e-4 * 10.0;
    let small = core::f64::consts::TAU * (inertia / (1.0 * GRAVITY * 0.2)).sqrt();
    let amplitude = 3.0_f64.to_radians();
    let period = small * (1.0 + amplitude * amplitude / 16.0);
    let measured = crossings[2] - crossings[0];
    assert!(
        (measured / period - 1.0).abs() < 1e-4,
        "{measured} s, {period} s"
    );
}

#[test]
fn shorter_steps_come_to_the_same_end() {
    let end = |step: f64| {
        let mut plant = thrown();
        limp(&mut plant, step, (200.0 / step) as u32);
        plant.angles()
    };
    let [coarse, fine, finer] = [0.5, 0.25, 0.125].map(end);
    let apart = |one: &[[f64; 3]; 4], other: &[[f64; 3]; 4]| {
        let angles = one.iter().flatten().zip(other.iter().flatten());
        angles.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    let (first, second) = (apart(&coarse, &fine), apart(&fine, &finer));
    assert!(
        second < 0.6 * first && first < 0.5,
        "{first} deg, {second} deg"
    );
}
