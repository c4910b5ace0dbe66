//! Limits of the motors under any commands.

use crate::plant::rig::{Rig, close, stance};
use tip_runtime::hardware::JointCommand;
use tip_runtime::model::titan8;
use tip_runtime::plant::{ServoDynamics, SimulatedPlant};

/// Returns a number from −1 to 1 (Park and Miller's generator, CACM 31, 1988).
fn noise(seed: &mut u64) -> f64 {
    *seed = *seed * 48_271 % 2_147_483_647;
    *seed as f64 / 1_073_741_823.5 - 1.0
}

#[test]
fn speed_and_torque_limits_are_never_exceeded() {
    let mut rig = Rig::standing();
    let mut seed = 1;
    let mut fastest: f64 = 0.0;
    let mut strongest: f64 = 0.0;
    for round in 0..300 {
        let joints = [[(); 3]; 4].map(|leg| {
            leg.map(|()| match noise(&mut seed) {
                n if n > 0.7 => JointCommand::Torque(500.0 * noise(&mut seed)),
                _ => JointCommand::at(200.0 * noise(&mut seed)),
            })
        });
        let period = if round % 7 == 0 { 100.0 } else { 20.0 };
        let before = rig.plant.angles();
        rig.command(joints, period);
        let after = rig.plant.angles();
        for (before, after) in before.iter().flatten().zip(after.iter().flatten()) {
            fastest = fastest.max((after - before).abs() / period * 1000.0);
        }
        for torque in rig.plant.torques().iter().flatten() {
            strongest = strongest.max(torque.abs());
        }
    }
    assert!(fastest > 100.0 && fastest <= 360.0 + 1e-6, "{fastest}");
    assert!(strongest > 10.0 && strongest <= 40.0, "{strongest}");
}

#[test]
fn legs_too_weak_for_the_body_give_way_until_it_lies() {
    let mut model = titan8::MODEL;
    for joint in model.legs.iter_mut().flat_map(|leg| &mut leg.joints) {
        joint.torque = 2.0;
    }
    let mut rig = Rig::on(SimulatedPlant::new(&model));
    rig.move_to(stance(-250.0));
    for _ in 0..200 {
        rig.tell(&stance(-250.0));
    }
    // The legs push it up again and again by as much as they turn in a cycle: a few mm.
    let mut lay = 0;
    for _ in 0..20 {
        rig.tell(&stance(-250.0));
        let pose = rig.plant.body();
        assert!(pose.position[2] < 215.0, "{pose:?}");
        lay += u32::from(rig.plant.belly_load() > 0.0);
    }
    assert!(lay >= 4, "{lay}");
}

// clauses: 7.15
#[test]
fn standing_servos_have_no_error_that_a_wait_could_trip_over() {
    let mut rig = Rig::standing();
    let feet = rig.feet;
    let commanded = crate::plant::rig::angles(&feet);
    let measured = rig.sensors().angles;
    for (commanded, measured) in commanded.iter().flatten().zip(measured.iter().flatten()) {
        assert!(close(*commanded, *measured, 1e-6));
    }
}

#[test]
fn other_servos_lag_otherwise() {
    let slow = ServoDynamics {
        lag: 200.0,
        speed: 360.0,
    };
    let mut quick = Rig::new();
    let mut lazy = Rig::on(SimulatedPlant::new(&titan8::MODEL).with_servos(slow));
    for rig in [&mut quick, &mut lazy] {
        rig.tell(&stance(-230.0));
    }
    assert!(lazy.plant.angles()[0][1] > quick.plant.angles()[0][1] + 1.0);
}
