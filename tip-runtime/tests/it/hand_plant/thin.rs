//! Thin or fast objects do not pass through a finger.

use crate::hand_plant::rig::{Plant, close, cycles, held, object, outputs, plant, write};
use tip_runtime::hardware::{JointCommand, Outputs};
use tip_runtime::plant::{Object, Scene, Shape};

const G: f64 = 9.80665;

/// Returns F1 straight and level, to the left of the palm, over a floor with an object above its
/// first link: its top is at 0 mm.
fn over_a_level_finger(thing: Object) -> Plant {
    let mut plant = plant();
    let [_, right, behind] = held();
    let level = [-90.0, 0.0, 0.0].map(JointCommand::at);
    write(&mut plant, &outputs([level, right, behind]), cycles(1.0));
    let scene = Scene::EMPTY.with_object(thing).expect("a good object");
    plant.with_scene(&scene)
}

/// Returns outputs that keep this posture.
fn level() -> Outputs<3, 3> {
    let mut joints = held();
    joints[0] = [-90.0, 0.0, 0.0].map(JointCommand::at);
    outputs(joints)
}

const THING: Object = Object {
    shape: Shape::Disc { radius: 5.0 },
    mass: 0.5,
    friction: 0.5,
    x: -95.0,
    y: Some(35.0),
    angle: 0.0,
};

#[test]
fn a_disc_that_falls_deeper_than_its_middle_comes_back() {
    let mut plant = over_a_level_finger(THING);
    let mut deepest = 0.0_f64;
    for _ in 0..cycles(1.5) {
        write(&mut plant, &level(), 1);
        deepest = deepest.min(object(&plant).position[1]);
    }
    // 0.147 J of its fall, in a contact of 5 N/mm: deeper than its radius.
    assert!(deepest < 0.0, "{deepest}");
    // 4.9 N on that contact.
    close(object(&plant).position[1], 5.0 - 0.5 * G / 5.0, 0.01);
}

#[test]
fn a_wire_that_is_faster_than_thick_a_step_comes_back() {
    // 4 mm thick, and at 9 m/s: 4.5 mm a step. It hits the link so near the joint that the motor holds it.
    for above in [4131.0, 4132.0, 4133.0, 4134.0] {
        let wire = Object {
            shape: Shape::Disc { radius: 2.0 },
            mass: 0.1,
            x: -66.0,
            y: Some(above),
            ..THING
        };
        let mut plant = over_a_level_finger(wire);
        let falls = (2.0 * (above - 2.0) / 1000.0 / G).sqrt();
        // Its mass swings on 5 N/mm with a period of 28 ms, half of which throws it back.
        write(&mut plant, &level(), cycles(falls + 0.014 + 0.01));
        let state = object(&plant);
        assert!(
            state.position[1] > 10.0 && state.velocity[1] > 1000.0,
            "{state:?}"
        );
    }
}

#[test]
fn a_plate_that_falls_flat_on_a_link_stays_on_it() {
    let plate = Object {
        shape: Shape::Box {
            width: 40.0,
            height: 2.0,
        },
        ..THING
    };
    let mut plant = over_a_level_finger(plate);
    let mut deepest = 0.0_f64;
    for _ in 0..cycles(1.5) {
        write(&mut plant, &level(), 1);
        deepest = deepest.min(object(&plant).position[1]);
    }
    // Two contacts take 0.17 J: 5.8 mm.
    assert!(deepest < -1.0, "{deepest}");
    close(object(&plant).position[1], 1.0 - 0.5 * G / 10.0, 0.01);
    close(object(&plant).angle, 0.0, 0.1);
}

#[test]
fn fingertips_that_press_deeper_than_half_of_a_plate_stay_on_their_side() {
    let plate = Object {
        shape: Shape::Box {
            width: 200.0,
            height: 2.0,
        },
        mass: 1.0,
        x: 0.0,
        y: None,
        ..THING
    };
    // Two fingers straight down to −160 mm, the third out of their way.
    let straight = [0.0; 3].map(JointCommand::at);
    let aside = [90.0, 0.0, 0.0].map(JointCommand::at);
    let floor = |y: f64| Outputs {
        slider: [0.0, y, 0.0],
        ..outputs([straight, straight, aside])
    };
    let mut plant = plant();
    write(&mut plant, &floor(-170.0), cycles(1.0));
    let scene = Scene::EMPTY.with_object(plate).expect("a good object");
    let mut plant = plant.with_scene(&scene);
    for step in 0..=400 {
        write(&mut plant, &floor(-164.1 + 0.01 * f64::from(step)), 1);
    }
    write(&mut plant, &floor(-160.1), cycles(1.0));
    // Floor and fingertips leave the plate 0.1 mm. Of the 1.9 mm that it lacks, two fingertips of 5 N/mm take a part, and two
    // corners of 25 N/mm on the floor, which carry its weight too, the rest.
    let deep = (1.9 - G / 50.0) / 1.2;
    assert!(deep > 1.0);
    for tip in &plant.fingertips()[..2] {
        close(tip.on_objects[1], -5.0 * deep, 0.02);
    }
    close(object(&plant).position[1], -161.0 + deep, 0.01);
}
