//! Every sensor, measured and set.

use crate::plant::rig::{Rig, WEIGHT, close};
use tip_runtime::command::Port;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, Outputs};
use tip_runtime::model::hand;
use tip_runtime::plant::{Plant, SimulatedHand};

/// Returns the readings of the soles of the four legs, V.
fn soles(rig: &mut Rig) -> [f64; 4] {
    let inputs = rig.sensors().inputs;
    [1, 2, 3, 4].map(|leg| inputs.get(Port::Paw(leg)).expect("a sole"))
}

// clauses: 7.32
#[test]
fn soles_measure_five_volts_for_two_hundred_newtons() {
    let mut rig = Rig::standing();
    for volts in soles(&mut rig) {
        assert!(close(volts, WEIGHT / 4.0 / 40.0, 1e-6), "{volts}");
    }
    rig.change(|feet| feet.iter_mut().for_each(|foot| foot[2] = -150.0));
    assert_eq!(soles(&mut rig), [0.0; 4]);
}

// clauses: 7.32
#[test]
fn what_nothing_drives_reads_zero() {
    let inputs = Rig::standing().sensors().inputs;
    assert_eq!(inputs.of(Port::Knob(1)), [0.0; 3]);
    assert_eq!(inputs.get(Port::Antenna), Some(0.0));
}

// clauses: 7.32
#[test]
fn a_set_input_reads_what_it_was_set_to() {
    let mut rig = Rig::standing();
    let plant = &mut rig.plant;
    assert!(plant.set_sensor(Port::Knob(1), 8.0));
    assert!(plant.set_sensor(Port::Channel(15), -1.5));
    assert!(plant.set_sensor(Port::Paw(4), 4.5));
    assert!(plant.set_sensor(Port::Antenna, 2.0));
    // J13 ranges over 0…155 degrees: 2.5 V are three quarters of it.
    assert!(plant.set_sensor(Port::Joint(1, 3), 2.5));
    let angles = plant.angles();
    let sensors = rig.sensors();
    assert_eq!(sensors.inputs.of(Port::Knob(1)), [8.0, 0.0, -1.5]);
    assert_eq!(sensors.inputs.get(Port::Paw(4)), Some(4.5));
    assert_eq!(sensors.inputs.get(Port::Antenna), Some(2.0));
    assert_eq!(sensors.angles[0][2], 116.25);
    assert_eq!(rig.plant.angles(), angles);
    assert_eq!(sensors.angles[0][1], angles[0][1]);
}

#[test]
fn inputs_that_the_robot_lacks_cannot_be_set() {
    let plant = &mut Rig::new().plant;
    for port in [
        Port::Knob(0),
        Port::Knob(4),
        Port::Paw(5),
        Port::Joint(1, 4),
        Port::Joint(0, 1),
        Port::Channel(12),
        Port::Channel(16),
    ] {
        assert!(!plant.set_sensor(port, 1.0), "{port:?}");
    }
    assert!(!SimulatedHand::new(&hand::MODEL).set_sensor(Port::Paw(1), 1.0));
}

// clauses: 7.36
#[test]
fn lamps_are_what_was_written() {
    let mut rig = Rig::new();
    let mut lamps = [0; 8];
    lamps[1] = 0b10;
    let joints = crate::plant::rig::angles(&rig.feet)
        .map(|leg| leg.map(tip_runtime::hardware::JointCommand::at));
    let outputs = Outputs {
        joints,
        lamps,
        slider: [0.0; 3],
        period: 20.0,
    };
    rig.plant.write(&outputs).expect("a plant never fails");
    assert!(rig.plant.lamp(33) && !rig.plant.lamp(32) && !rig.plant.lamp(1));
}

#[test]
fn a_stopped_robot_stays_where_it_is() {
    let mut rig = Rig::standing();
    let (body, angles) = (rig.plant.body(), rig.plant.angles());
    for _ in 0..50 {
        assert_eq!(rig.plant.stop(&Fault::EmergencyKey), Ok(()));
    }
    assert_eq!((rig.plant.body(), rig.plant.angles()), (body, angles));
}
