//! Motors: commanded torques, their limits, and servos.

use crate::dynamic::rig::{GRAVITY, SMOOTH, all, go, hold, rod, titan};
use tip_runtime::hardware::{Hardware, JointCommand, Sensors};
use tip_runtime::model::titan8;
use tip_runtime::plant::{DynamicPlant, Noise, Plant, Scene};

/// Inertia of the rod about its end, with the rotor, kg·m².
const INERTIA: f64 = 0.4 * 0.4 / 3.0 + 7.5e-3;

fn run(plant: &mut DynamicPlant<1, 1>, command: JointCommand, cycles: u32) -> Sensors<1, 1> {
    for _ in 0..cycles {
        plant
            .write(&all([[command]], 20.0))
            .expect("it is simulated");
    }
    let mut sensors = Sensors::ZERO;
    plant.read(&mut sensors).expect("it is simulated");
    sensors
}

/// Returns a rod that turns in the horizontal plane.
fn flat() -> DynamicPlant<1, 1> {
    DynamicPlant::new(&rod([0.0, 0.0, 1.0], [400.0, 0.0, 0.0], 0.0)).with_drives(SMOOTH)
}

/// Returns a rod that is held out along x and would fall.
fn held_out() -> DynamicPlant<1, 1> {
    DynamicPlant::new(&rod([0.0, 1.0, 0.0], [400.0, 0.0, 0.0], 0.0))
}

#[test]
fn a_torque_accelerates_an_inertia() {
    let mut plant = flat();
    let sensors = run(&mut plant, JointCommand::Torque(0.5), 15);
    // 0.3 s in steps of 0.5 ms.
    let angle = 0.5 / INERTIA * 0.3 * 0.3005 / 2.0;
    assert!((sensors.angles[0][0] - angle.to_degrees()).abs() < 1e-6);
    assert!((sensors.torques[0][0] - 0.5).abs() < 1e-12);
}

#[test]
fn no_motor_drives_its_joint_faster_than_it_turns() {
    let mut plant = flat();
    run(&mut plant, JointCommand::Torque(5.0), 20);
    let rate = plant.rates()[0][0];
    assert!((rate - 360.0).abs() < 1.0, "{rate} deg/s");
}

#[test]
fn no_motor_gives_more_than_its_torque() {
    let mut plant = flat();
    for cycle in 0..20 {
        let command = JointCommand::at(if cycle % 2 == 0 { 90.0 } else { -90.0 });
        run(&mut plant, command, 1);
        assert!(plant.torques()[0][0].abs() <= 10.0);
    }
    let sensors = run(&mut flat(), JointCommand::Torque(1e9), 1);
    assert!(sensors.torques[0][0] <= 10.0);
}

#[test]
fn a_push_moves_a_body_for_its_cycles() {
    // 20 kg in the air, pushed by 100 N for 5 cycles of 20 ms: 0.5 m/s.
    let mut plant = titan().lifted(1000.0);
    assert!(plant.push([100.0, 0.0, 0.0], 5));
    for (cycles, speed) in [(5, 500.0), (2, 500.0)] {
        hold(
            &mut plant,
            titan8::MODEL.legs.map(|leg| leg.initial),
            cycles,
        );
        let momentum = plant.momentum().linear[0] / 20.0 * 1000.0;
        assert!((momentum - speed).abs() < 0.5, "{momentum} mm/s");
    }
    let bolted = &mut flat();
    assert!(!bolted.push([1.0; 3], 1));
}

#[test]
fn noise_is_that_of_its_seed_and_moves_nothing() {
    let read = |seed| {
        let mut plant = titan();
        let noise = Noise {
            angle: 0.5,
            volts: 0.0,
            seed,
        };
        assert!(plant.set_noise(noise));
        let mut squares = 0.0;
        let mut sensors = Sensors::ZERO;
        for _ in 0..1000 {
            plant.read(&mut sensors).expect("it is simulated");
            let errors = sensors
                .angles
                .iter()
                .flatten()
                .zip(plant.angles().into_iter().flatten());
            squares += errors
                .map(|(read, is)| (read - is) * (read - is))
                .sum::<f64>();
        }
        assert_eq!(plant.angles(), titan().angles());
        ((squares / 12_000.0).sqrt(), sensors)
    };
    let (deviation, sensors) = read(1);
    // Of 12000 numbers: within 3 %.
    assert!((deviation / 0.5 - 1.0).abs() < 0.03, "{deviation} deg");
    assert_eq!(read(1).1, sensors);
    assert_ne!(read(2).1, sensors);
}

#[test]
fn a_servo_carries_its_load() {
    let mut plant = held_out();
    let sensors = run(&mut plant, JointCommand::at(0.0), 100);
    // 1 kg at 200 mm; positive turns lower it.
    let load = GRAVITY * 0.2;
    assert!((sensors.torques[0][0] + load).abs() < 1e-6, "{sensors:?}");
    // 2000 N·m/rad give way by so much.
    let sag = (load / 2000.0).to_degrees();
    assert!((sensors.angles[0][0] - sag).abs() < 1e-4, "{sensors:?}");
}

#[test]
fn a_servo_lags_and_turns_no_faster_than_it_can() {
    let mut plant = flat();
    // 90 deg/s: 1.8 deg each cycle. It follows by 15 ms: 1.35 deg.
    for cycle in 1..=30 {
        run(&mut plant, JointCommand::at(1.8 * f64::from(cycle)), 1);
    }
    let angle = plant.angles()[0][0];
    assert!((angle - (54.0 - 1.35)).abs() < 0.05, "{angle} deg");
    run(&mut plant, JointCommand::at(150.0), 5);
    let turned = plant.angles()[0][0] - angle;
    assert!(turned < 36.5, "0.1 s at 360 deg/s: {turned} deg");
}

#[test]
fn motors_at_their_limit_hold_still() {
    // 38 kg on legs that are stretched so far that at least one motor needs all of its torque.
    let mut model = titan8::MODEL;
    if let Some(body) = &mut model.body {
        body.mass = 30.0;
    }
    let scene = Scene {
        friction: 0.9,
        ..Scene::EMPTY
    };
    for posture in [
        [[-9, -38, 17], [6, -32, 49], [19, -36, 44], [4, -30, 45]],
        [[-1, -31, 45], [6, -30, 48], [-18, -31, 31], [-9, -42, 37]],
        [[2, -37, 40], [-13, -35, 33], [10, -40, 41], [19, -35, 17]],
        [[-8, -29, 47], [11, -27, 48], [-9, -34, 12], [6, -32, 41]],
    ] {
        let posture = posture.map(|leg| leg.map(f64::from));
        let mut plant = DynamicPlant::new(&model).with_scene(&scene);
        go(&mut plant, posture);
        hold(&mut plant, posture, 100);
        let before = plant.torques();
        let greatest = before
            .iter()
            .flatten()
            .fold(0.0, |most: f64, torque| most.max(torque.abs()));
        assert!((greatest - 40.0).abs() < 1e-9, "{greatest} N·m");
        for _ in 0..10 {
            hold(&mut plant, posture, 1);
            let torques = plant.torques().into_iter().flatten();
            for (now, before) in torques.zip(before.iter().flatten()) {
                assert!(
                    (now - before).abs() < 0.01,
                    "{posture:?}: {now}, {before} N·m"
                );
            }
        }
    }
}

#[test]
fn a_load_above_its_torque_turns_a_joint_to_its_stop() {
    // 1.96 N·m against a motor of 1 N·m, and mechanical stops at 187 deg.
    let mut model = rod([0.0, 1.0, 0.0], [400.0, 0.0, 0.0], 0.0);
    model.legs[0].joints[0] = model.legs[0].joints[0].torque(1.0).limits(-30.0, 30.0);
    let mut plant = DynamicPlant::new(&model);
    let sensors = run(&mut plant, JointCommand::at(0.0), 200);
    let angle = sensors.angles[0][0];
    assert!((angle - 37.0).abs() < 0.5, "{angle} deg");
    assert!((sensors.torques[0][0] + 1.0).abs() < 1e-9);
}
