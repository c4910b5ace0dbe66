//! Objects from 1 g to 10 kg: all fall, touch and rest alike.

use crate::hand_plant::rig::{Plant, close, cycles, held, object, outputs, over, write};
use tip_runtime::hardware::{JointCommand, Outputs};
use tip_runtime::plant::{Object, Scene, Shape};

const G: f64 = 9.80665;

const BOX: Object = Object {
    shape: Shape::Box {
        width: 40.0,
        height: 30.0,
    },
    mass: 1.0,
    friction: 0.5,
    x: 0.0,
    y: Some(-90.0),
    angle: 20.0,
};

const MASSES: [f64; 6] = [0.001, 0.005, 0.05, 0.3, 1.0, 10.0];

fn with(objects: &[Object]) -> Plant {
    let add = |scene: Scene, object: &Object| scene.with_object(*object).expect("a good object");
    over(&objects.iter().fold(Scene::EMPTY, add))
}

/// Returns the stiffness of one contact, N/m: 5 N/mm up to 0.2 kg, then 25 N/mm for each kg.
fn stiffness(mass: f64) -> f64 {
    5000.0_f64.max(25_000.0 * mass)
}

#[test]
fn a_box_of_any_mass_comes_to_rest_as_deep_as_its_contacts_say() {
    for mass in MASSES {
        let mut plant = with(&[Object { mass, ..BOX }]);
        write(&mut plant, &outputs(held()), cycles(2.0));
        let state = object(&plant);
        close(state.angle, 0.0, 1e-3);
        close(state.spin, 0.0, 1e-3);
        close(state.velocity[0].hypot(state.velocity[1]), 0.0, 1e-3);
        let depth = mass * G / (2.0 * stiffness(mass)) * 1000.0;
        close(-state.clearance / depth, 1.0, 1e-3);
        assert!(depth < 0.2, "10 kg sank 10 mm into contacts of 5 N/mm");
    }
}

#[test]
fn heavy_boxes_move_alike() {
    let mut plants = [0.2, 1.0, 10.0].map(|mass| with(&[Object { mass, ..BOX }]));
    for _ in 0..cycles(1.0) {
        let states = plants.each_mut().map(|plant| {
            write(plant, &outputs(held()), 1);
            object(plant)
        });
        for state in &states[1..] {
            close(state.position[0], states[0].position[0], 1e-6);
            close(state.position[1], states[0].position[1], 1e-6);
            close(state.angle, states[0].angle, 1e-6);
        }
    }
}

/// Returns the ratio of the speeds of a disc after and before a bounce off the floor.
fn bounce(mass: f64) -> f64 {
    let shape = Shape::Disc { radius: 20.0 };
    let mut plant = with(&[Object { shape, mass, ..BOX }]);
    let (mut down, mut up) = (0.0_f64, 0.0_f64);
    for _ in 0..cycles(0.2) {
        write(&mut plant, &outputs(held()), 1);
        let speed = object(&plant).velocity[1];
        down = down.min(speed);
        up = up.max(speed);
    }
    up / -down
}

#[test]
fn discs_of_all_masses_bounce_alike() {
    // A damping ratio of 15 / (2 √(5000 × 0.2)) on one contact that lets go as soon as spring and damper
    // together would pull.
    let ratio = 15.0 / (2.0 * (5000.0_f64 * 0.2).sqrt());
    let swing = (1.0 - ratio * ratio).sqrt();
    let ends = (2.0 * ratio * swing).atan2(2.0 * ratio * ratio - 1.0);
    let expected = (-ratio / swing * ends).exp();
    for mass in MASSES {
        // Its weight on the contact and the cycle in which it is read take some of it.
        close(bounce(mass), expected, 0.05);
    }
}

#[test]
fn a_blow_keeps_momentum_and_gains_no_energy() {
    for (light, heavy) in [(0.001, 1.0), (0.05, 10.0), (0.2, 0.2)] {
        let disc = |mass: f64, x: f64, y: f64| Object {
            shape: Shape::Disc { radius: 10.0 },
            mass,
            x,
            y: Some(y),
            ..BOX
        };
        // The upper one, 19 mm above the lower one, begins inside it: they fly apart as they fall.
        let mut plant = with(&[disc(heavy, 0.0, 500.0), disc(light, 4.0, 518.0)]);
        let masses = [heavy, light];
        let stored = stiffness(light) * (0.020 - 0.004_f64.hypot(0.018)).powi(2) / 2.0;
        for cycle in 1..=cycles(0.1) {
            write(&mut plant, &outputs(held()), 1);
            let states = plant.objects();
            let states = states.iter().flatten().zip(masses);
            let (mut along, mut up, mut turn, mut motion) = (0.0, 0.0, 0.0, 0.0);
            let fallen = G * 0.002 * cycle as f64;
            for (state, mass) in states {
                let [x, y] = [state.position[0] / 1000.0, state.position[1] / 1000.0];
                let [u, v] = [
                    state.velocity[0] / 1000.0,
                    state.velocity[1] / 1000.0 + fallen,
                ];
                let (inertia, spin) = (mass * 0.01 * 0.01 / 2.0, state.spin.to_radians());
                let drop = G * (0.002 * cycle as f64).powi(2) / 2.0;
                along += mass * u;
                up += mass * v;
                turn += inertia * spin + mass * (x * v - (y + drop - 0.5) * u);
                motion += mass * (u * u + v * v) / 2.0 + inertia * spin * spin / 2.0;
            }
            close(along, 0.0, 1e-12);
            close(up, 0.0, 1e-12);
            close(turn, 0.0, 1e-12);
            assert!(motion <= stored * 1.01, "{motion} of {stored} J");
        }
    }
}

#[test]
fn what_weighs_1_g_is_held_between_fingers_as_steadily_as_what_weighs_300_g() {
    for mass in [0.001, 0.01, 0.3] {
        // Fingertips of the initial posture are 106 mm from the middle.
        let wide = Object {
            shape: Shape::Box {
                width: 200.0,
                height: 60.0,
            },
            mass,
            friction: 1.5,
            angle: 0.0,
            y: None,
            ..BOX
        };
        let mut plant = with(&[wide]);
        // The floor goes down first, until fingertips are beside the box's middle: they would touch the
        // floor otherwise, and what tilts the box would leave its lower edge on the link, above the tip.
        let commands = |joints| Outputs {
            slider: [0.0, -155.0, 0.0],
            ..outputs(joints)
        };
        write(&mut plant, &commands(held()), cycles(0.5));
        let mut joints = held();
        for (finger, torque) in joints.iter_mut().zip([60.0, 30.0, 30.0]) {
            finger[0] = JointCommand::Torque(torque);
        }
        write(&mut plant, &commands(joints), cycles(1.0));
        let before = (object(&plant), plant.fingertips()[0]);
        write(&mut plant, &commands(joints), cycles(0.2));
        let after = (object(&plant), plant.fingertips()[0]);
        for axis in 0..2 {
            close(after.0.position[axis], before.0.position[axis], 1e-4);
            close(after.1.on_objects[axis], before.1.on_objects[axis], 1e-4);
        }
        // 60 mN·m of joint 1 about the one force on its finger, which is at its tip.
        assert_eq!(after.1.on_floor, [0.0; 3]);
        let ([x, y, _], [along, up, _]) = (after.1.position, after.1.on_objects);
        assert!((-150.0..-100.0).contains(&y), "beside the box: {y}");
        close(((x + 60.0) * up - y * along) / 60.0, 1.0, 1e-3);
    }
}
