//! Reproducibility to the bit, and robustness against invalid input.

use crate::hand_plant::rig::{
    Plant, close, cycles, held, limp, object, outputs, over, plant, write,
};
use tip_runtime::command::Port;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, JointCommand, Outputs, Sensors};
use tip_runtime::plant::{Object, Plant as _, Scene, Shape};

/// Returns outputs with which the first joints close by torque and the others hold their angles,
/// over a floor out of their reach.
fn closing(torque: f64) -> Outputs<3, 3> {
    let mut joints = held();
    for [first, ..] in &mut joints {
        *first = JointCommand::Torque(torque);
    }
    Outputs {
        slider: [0.0, -140.0, 0.0],
        ..outputs(joints)
    }
}

/// Returns the whole visible state of a run, to the bit.
fn bits(plant: &Plant) -> Vec<u64> {
    let mut all: Vec<f64> = plant.angles().as_flattened().to_vec();
    all.extend(plant.torques().as_flattened());
    for tip in plant.fingertips() {
        all.extend(tip.on_floor.iter().chain(&tip.on_objects));
    }
    for state in plant.objects().iter().flatten() {
        all.extend(state.position.iter().chain(&state.velocity));
        all.extend([state.angle, state.spin, state.clearance]);
    }
    all.into_iter().map(f64::to_bits).collect()
}

#[test]
fn the_same_run_gives_the_same_bits_and_so_does_a_clone() {
    let run = || {
        let mut plant = over(&Scene::CYLINDER);
        write(&mut plant, &closing(60.0), cycles(0.4));
        plant
    };
    let (mut first, mut second) = (run(), run());
    let mut third = first.clone();
    for plant in [&mut first, &mut second, &mut third] {
        write(plant, &closing(60.0), cycles(0.3));
    }
    assert_eq!(bits(&first), bits(&second));
    assert_eq!(bits(&first), bits(&third));
    assert!(
        first.fingertips()[0].on_objects != [0.0; 3],
        "they touch it"
    );
}

#[test]
fn nonsense_commands_do_not_make_nonsense() {
    let mad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300];
    let mut plant = over(&Scene::CYLINDER);
    for (n, value) in mad.iter().cycle().take(60).enumerate() {
        let mut commands = held();
        let joint = commands.as_flattened_mut().get_mut(n % 9);
        *joint.expect("nine joints") = match n % 2 {
            0 => JointCommand::Torque(*value),
            _ => JointCommand::at(*value),
        };
        let period = if n % 7 == 3 { *value } else { 2.0 };
        let outputs = Outputs {
            slider: [*value; 3],
            period: period.min(100.0),
            ..outputs(commands)
        };
        write(&mut plant, &outputs, 3);
        for (angles, torques) in plant.angles().iter().zip(plant.torques()) {
            assert!(angles.iter().all(|angle| angle.abs() < 400.0), "{angles:?}");
            assert!(torques.iter().all(|torque| torque.abs() <= 1500.0));
        }
        let at = object(&plant).position;
        assert!(at.iter().all(|at| at.abs() < 1e5), "{at:?}");
    }
    let mut sensors = Sensors::ZERO;
    plant.read(&mut sensors).expect("good sensors");
    assert!((-200.0..=-60.0).contains(&sensors.slider[1]));
}

#[test]
fn a_squeezed_object_is_not_passed_through() {
    let mut plant = over(&Scene::CYLINDER);
    let mut hardest = 0.0_f64;
    // Before the two fingers of one side have pushed it away from under the third.
    for _ in 0..cycles(0.06) {
        write(&mut plant, &closing(1000.0), 1);
        hardest = hardest.max(plant.fingertips()[0].on_objects[0]);
        let at = object(&plant).position;
        for tip in plant.fingertips() {
            // 1 N·m over the 0.1 rad up to the object is 0.1 J: two such fingers press the third into
            // it by no more than all of that in its contact, k d²/2.
            assert!((tip.position[0] - at[0]).abs() > 100.0 - 11.0);
        }
    }
    assert!(hardest > 5.0, "{hardest} N");
}

// clauses: 7.32
#[test]
fn the_palm_feels_what_reaches_it() {
    let tall = Object {
        shape: Shape::Box {
            width: 30.0,
            height: 70.0,
        },
        mass: 0.1,
        friction: 0.5,
        x: 0.0,
        y: None,
        angle: 0.0,
    };
    let mut plant = over(&Scene::EMPTY.with_object(tall).expect("a good object"));
    let mut sensors = Sensors::ZERO;
    let mut antenna = |plant: &mut Plant| {
        plant.read(&mut sensors).expect("good sensors");
        sensors.inputs.get(Port::Antenna).expect("a palm")
    };
    assert_eq!(antenna(&mut plant), 0.0);
    let lift = |y: f64| Outputs {
        slider: [0.0, y, 0.0],
        ..outputs(held())
    };
    write(&mut plant, &lift(-71.0), cycles(0.5));
    assert_eq!(antenna(&mut plant), 0.0);
    write(&mut plant, &lift(-69.8), cycles(0.5));
    assert_eq!(antenna(&mut plant), 1.0);
    assert!(object(&plant).at_palm);
    // 0.2 mm between two springs of two corners each: it is squeezed, and its weight moves it.
    close(object(&plant).position[1], -34.9, 0.06);
    assert!(plant.set_sensor(Port::Antenna, 0.0));
    assert_eq!(antenna(&mut plant), 0.0);
}

#[test]
fn things_go_on_falling_in_an_emergency() {
    let falling = Object {
        y: Some(-80.0),
        ..Scene::CYLINDER.objects[0].expect("a cylinder")
    };
    let mut plant = over(&Scene::EMPTY.with_object(falling).expect("a good object"));
    write(&mut plant, &outputs(limp()), 1);
    for _ in 0..cycles(1.0) {
        assert_eq!(plant.stop(&Fault::EmergencyKey), Ok(()));
    }
    // 5.9 N on two contacts of 15 N/mm.
    close(object(&plant).position[1], -100.196, 0.001);
}

#[test]
fn inputs_read_what_somebody_set() {
    let mut plant = plant();
    assert!(plant.set_sensor(Port::Knob(1), 2.5));
    assert!(plant.set_sensor(Port::Joint(1, 1), 0.0));
    assert!(!plant.set_sensor(Port::Joint(4, 1), 0.0));
    let mut sensors = Sensors::ZERO;
    plant.read(&mut sensors).expect("good sensors");
    assert_eq!(sensors.inputs.get(Port::Knob(1)), Some(2.5));
    assert_eq!(sensors.angles[0][0], 0.0);
    assert_eq!(sensors.slider, [0.0, -130.0, 0.0]);
}
