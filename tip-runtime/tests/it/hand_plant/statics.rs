//! Known forces, and their measurements by the robot.

use crate::hand_plant::rig::{F1, Rig, close, over, plant};
use tip_runtime::command::{Op, Target, Teach};
use tip_runtime::model::{Model, hand};
use tip_runtime::plant::{Object, Scene, Shape, SimulatedHand};

const G: f64 = 9.80665;
const F2: Target = Target::Foot(2);
const F3: Target = Target::Foot(3);

/// The hand with its fingertips turned up: each is the highest point of its last link.
static TIPS_UP: Model<3, 3> = {
    let mut model = hand::MODEL;
    let mut n = 0;
    while n < 3 {
        model.legs[n].initial = [0.0, 0.0, 100.0];
        n += 1;
    }
    model
};

// clauses: 7.12 7.27
#[test]
fn a_fingertip_on_a_spring_gives_way_as_far_as_the_spring_says() {
    for (stiffness, pull) in [(0.1, [0.3, -0.2]), (0.2, [-0.5, 0.4]), (0.05, [0.1, 0.05])] {
        let mut rig = Rig::new();
        let [x, y, _] = rig.teach(Teach::Position, F1);
        rig.run(Op::SetPositionStiffness, F1, &[stiffness; 3]);
        rig.run(Op::CompliancePosition, F1, &[x, y, 0.0]);
        rig.plant.pull(1, pull);
        rig.idle(5.0);
        let [now_x, now_y, _] = rig.teach(Teach::Position, F1);
        for (moved, force) in [now_x - x, now_y - y].iter().zip(pull) {
            close(moved / (force / stiffness), 1.0, 0.01);
        }
    }
}

// clauses: 7.11 7.26
#[test]
fn a_joint_on_a_spring_gives_way_as_far_as_the_spring_says() {
    let mut rig = Rig::new();
    rig.run(Op::SetAngleStiffness, Target::Joint(1, 3), &[10.0]);
    rig.run(Op::ComplianceAngle, Target::Joint(1, 3), &[80.0]);
    // Link 3 points 40 deg inwards: a pull up turns it by 40 mm × sin 40°.
    rig.plant.pull(1, [0.0, 0.5]);
    rig.idle(3.0);
    let turned = rig.plant.angles()[0][2] - 80.0;
    let lever = 40.0 * (40.0 + turned).to_radians().sin();
    close(turned / (0.5 * lever / 10.0), 1.0, 0.01);
}

// clauses: 7.19
#[test]
fn teach_force_reads_the_force_that_is_applied() {
    let mut rig = Rig::new();
    for pull in [[0.4, -0.7], [-1.5, 0.2], [0.0, 3.0]] {
        rig.plant.pull(1, pull);
        rig.idle(0.2);
        let [x, y, _] = rig.teach(Teach::Force, F1);
        close(
            (x + pull[0]).hypot(y + pull[1]) / pull[0].hypot(pull[1]),
            0.0,
            0.02,
        );
    }
}

// clauses: 7.19
#[test]
fn teach_force_weighs_a_box_that_rests_on_the_fingertips() {
    // Fingertips 20.6 mm beside the middle: F1 carries one half, F2 and F3 the other.
    let tip = -120.0 - 40.0 * 100.0_f64.to_radians().cos();
    let scene = Scene::EMPTY.with_object(Object {
        shape: Shape::Box {
            width: 60.0,
            height: 30.0,
        },
        mass: 0.2,
        friction: 0.5,
        x: 0.0,
        y: Some(tip + 15.0),
        angle: 0.0,
    });
    let scene = scene.expect("a good object");
    let mut rig = Rig::with(&TIPS_UP, SimulatedHand::new(&TIPS_UP).with_scene(&scene));
    rig.idle(1.0);
    let weight = 0.2 * G;
    for (finger, share) in [(F1, 0.5), (F2, 0.25), (F3, 0.25)] {
        let [x, y, _] = rig.teach(Teach::Force, finger);
        close(y / (weight * share), 1.0, 0.02);
        close(x, 0.0, 0.02 * weight);
    }
    for (tip, share) in rig.plant.fingertips().iter().zip([0.5, 0.25, 0.25]) {
        close(tip.on_objects[1] / (weight * share), 1.0, 0.01);
        assert_eq!(tip.on_floor, [0.0; 3]);
    }
}

// clauses: 7.19
#[test]
fn teach_force_reads_how_hard_the_floor_presses() {
    let mut rig = Rig::new();
    // The fingertips are 122.6 mm below the palm.
    let tip = rig.plant.fingertips()[0].position[1];
    rig.run(Op::Ptp, Target::Floor, &[0.0, tip + 0.1, 0.0]);
    rig.run(Op::WaitInpos, Target::Floor, &[]);
    rig.idle(2.0);
    let [x, y, _] = rig.teach(Teach::Force, F1);
    // The contact is a spring of 5 N/mm: 0.1 mm is 0.5 N, and the finger pushes down.
    close(y / -0.5, 1.0, 0.02);
    close(x, 0.0, 0.02);
    let on_floor = rig.plant.fingertips()[0].on_floor;
    close(on_floor[1] / -0.5, 1.0, 0.01);
}

// clauses: 7.10
#[test]
fn a_finger_pushes_the_floor_with_the_force_it_is_told() {
    let mut rig = Rig::new();
    let tip = rig.plant.fingertips()[0].position[1];
    rig.run(Op::Ptp, Target::Floor, &[0.0, tip, 0.0]);
    rig.idle(2.0);
    rig.run(Op::Force, F1, &[0.1, -0.6, 0.0]);
    rig.idle(2.0);
    let [x, y, _] = rig.plant.fingertips()[0].on_floor;
    close(x, 0.1, 0.002);
    close(y, -0.6, 0.006);
}

#[test]
fn friction_never_pulls_harder_than_its_cone() {
    let mut rig = Rig::on(over(&Scene::EMPTY));
    let [x, y, _] = plant().fingertips()[0].position;
    rig.run(Op::Ptp, Target::Floor, &[0.0, y + 0.2, 0.0]);
    rig.idle(2.0);
    rig.run(Op::Ptp, F1, &[x + 40.0, y, 0.0]);
    let mut slid = 0;
    for _ in 0..1000 {
        rig.idle(0.002);
        let tip = rig.plant.fingertips()[0];
        let [along, push, _] = tip.on_floor;
        assert!(push <= 0.0);
        assert!(along.abs() <= 0.5 * -push + 1e-12);
        slid += usize::from((along + 0.5 * push).abs() < 1e-9 && push < -0.5);
        // 0.2 mm are pressed in; the finger is stiff.
        assert!(tip.position[1] > y - 0.05);
    }
    assert!(slid > 100, "it slid in {slid} cycles");
}
