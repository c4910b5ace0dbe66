//! The counts of unmodelled effects.

use crate::plant::rig::{Rig, WEIGHT, angles, high_bellied, stance};
use tip_runtime::hardware::JointCommand;
use tip_runtime::model::{Part, titan8};
use tip_runtime::plant::{
    Block, Clearance, Floor, Plant, Scene, ServoDynamics, SimulatedPlant, Unmodelled,
};

/// Standard gravity: mm/s².
const GRAVITY: f64 = 9806.65;

/// The sampling time: s.
const DT: f64 = 0.02;

fn seen(rig: &Rig) -> Unmodelled {
    rig.plant.unmodelled()
}

/// Moves the body forward by `a t² / 2` over fixed feet, and compares the margin of the zero moment
/// point with that of `c − c̈ c_z / g` in the rectangle of the feet.
fn accelerate(a: f64, cycles: u32) -> (Rig, f64) {
    let mut rig = Rig::standing();
    let mut places = vec![rig.plant.centre_of_mass(); 2];
    let mut last = 0.0;
    for cycle in 1..=cycles {
        let time = f64::from(cycle) * DT;
        let back = stance(-250.0).map(|[x, y, z]| [x, y - a * time * time / 2.0, z]);
        rig.tell(&back);
        places.push(rig.plant.centre_of_mass());
        let [.., before, mid, now] = places[..] else {
            unreachable!("there are three")
        };
        let bent = |i: usize| (now[i] - 2.0 * mid[i] + before[i]) / (DT * DT);
        last = bent(1);
        // Feet are where the floor carries them, a little below its height.
        let feet = rig.plant.feet().map(|foot| foot.position);
        let height = now[2] - feet[0][2];
        let zmp = [0, 1].map(|i| now[i] - bent(i) * height / (GRAVITY + bent(2)));
        let edges = [
            zmp[0] - feet[0][0],
            feet[1][0] - zmp[0],
            feet[0][1] - zmp[1],
            zmp[1] - feet[2][1],
        ];
        let margin = edges.into_iter().fold(f64::INFINITY, f64::min);
        let found = seen(&rig).zmp_margin;
        assert!((found - margin).abs() < 0.5, "{cycle}: {found} {margin}");
    }
    (rig, last)
}

#[test]
fn the_zero_moment_point_of_a_body_that_accelerates_is_behind_its_centre_of_mass() {
    // The servos are up to speed after some of their time constants.
    let (rig, reached) = accelerate(1000.0, 20);
    assert!((reached - 1000.0).abs() < 150.0, "{reached}");
    let behind = rig.plant.margin() - seen(&rig).zmp_margin;
    assert!(behind.abs() > 10.0, "{behind}");
    assert_eq!(seen(&rig).tips, 0);
    let (rig, _) = accelerate(15_000.0, 6);
    assert!(rig.plant.margin() > 0.0 && rig.plant.falls() == 0);
    assert!(seen(&rig).tips > 0 && seen(&rig).least_zmp_margin < 0.0);
}

#[test]
fn a_robot_that_stands_leaves_nothing_out() {
    let mut rig = Rig::standing();
    let before = seen(&rig);
    assert!(before.is_empty(), "{before:?}");
    for _ in 0..20 {
        rig.tell(&stance(-250.0));
    }
    assert!(seen(&rig).is_empty());
    let margins = rig.plant.margin() - seen(&rig).zmp_margin;
    assert!(margins.abs() < 1e-6, "{margins}");
}

/// Returns the number of ten cycles in which a robot that lies on a slope would slide.
fn slides(slope: [f64; 2], friction: f64) -> u32 {
    let scene = Scene {
        floor: Floor { height: 0.0, slope },
        friction,
        ..Scene::EMPTY
    };
    let mut rig = Rig::on(SimulatedPlant::new(&titan8::MODEL).with_scene(&scene));
    for _ in 0..10 {
        rig.tell(&stance(-200.0));
    }
    seen(&rig).slides
}

/// A block slides where the tangent of the slope is above the friction.
#[test]
fn feet_slide_on_slopes_that_are_steeper_than_their_friction() {
    for friction in [0.3, 0.5] {
        assert_eq!(slides([0.0, friction - 0.01], friction), 0);
        assert_eq!(slides([friction - 0.01, 0.0], friction), 0);
        assert_eq!(slides([0.0, friction + 0.01], friction), 10);
        assert_eq!(slides([-friction - 0.01, 0.0], friction), 10);
        // 0.8 of it along both: 1.13 of it along the slope.
        assert_eq!(slides([0.8 * friction; 2], friction), 10);
    }
    // 63 degrees.
    assert_eq!(slides([0.0, 2.0], 0.5), 10);
    assert_eq!(slides([0.0, 0.0], 0.0), 0);
}

/// Servos without lag and limit.
const INSTANT: ServoDynamics = ServoDynamics {
    lag: 1e-3,
    speed: 1e9,
};

fn carried(rig: &Rig) -> f64 {
    rig.loads().iter().sum::<f64>() + rig.plant.belly_load()
}

/// Feet drawn in at once: ½ g t² until the belly lies on the floor.
#[test]
fn a_body_without_feet_falls_freely() {
    let mut rig = Rig::on(SimulatedPlant::new(&titan8::MODEL).with_servos(INSTANT));
    rig.move_to(stance(-320.0));
    let start = rig.plant.body().position[2];
    assert!(start > 319.0);
    let mut flown = 0;
    for cycle in 1..=20 {
        rig.tell(&stance(-190.0));
        let time = f64::from(cycle) * DT;
        let sunk = start - rig.plant.body().position[2];
        let free = GRAVITY * time * time / 2.0;
        assert!(sunk <= free + 1e-6, "{cycle}: {sunk} {free}");
        if carried(&rig) == 0.0 {
            assert!((sunk - free).abs() < 1e-6, "{cycle}: {sunk} {free}");
            flown += 1;
        }
    }
    // 120 mm take 0.156 s.
    assert_eq!(flown, 7);
    assert!((rig.plant.body().position[2] - 200.0).abs() < 1.0);
    assert!((carried(&rig) - WEIGHT).abs() < 1e-3);
}

/// Returns the heights of the corners of the belly in the world, mm.
fn corners(rig: &Rig) -> [f64; 4] {
    let pose = rig.plant.body();
    let (pitch, roll) = (pose.pitch.to_radians(), pose.roll.to_radians());
    [
        [-120.0, -230.0],
        [120.0, -230.0],
        [120.0, 230.0],
        [-120.0, 230.0],
    ]
    .map(|[x, y]| {
        // By roll about y, then by pitch about x.
        let up = -x * libm::sin(roll) - 200.0 * libm::cos(roll);
        pose.position[2] + y * libm::sin(pitch) + up * libm::cos(pitch)
    })
}

/// Two feet drawn in: the body tips over the other two, and nothing pulls it down but gravity.
#[test]
fn a_body_that_tips_does_not_sink_faster_than_it_would_fall() {
    for lifted in [[0, 1], [0, 3]] {
        let mut rig = Rig::on(SimulatedPlant::new(&titan8::MODEL).with_servos(INSTANT));
        rig.move_to(stance(-330.0));
        let mut feet = stance(-330.0);
        for leg in lifted {
            feet[leg][2] = -150.0;
        }
        let (mut before, mut speed) = (corners(&rig), 0.0_f64);
        for cycle in 0..40 {
            rig.tell(&feet);
            let now = corners(&rig);
            let sunk = before.iter().zip(now).map(|(before, now)| before - now);
            let sunk = sunk.fold(0.0, f64::max);
            let free = speed * DT + GRAVITY * DT * DT / 2.0;
            assert!(sunk <= free + 1e-6, "{lifted:?} {cycle}: {sunk} {free}");
            speed += GRAVITY * DT;
            before = now;
            assert!(carried(&rig) < WEIGHT + 1e-3, "{cycle}: {}", carried(&rig));
        }
        assert_eq!(rig.plant.falls(), 1);
        assert!((carried(&rig) - WEIGHT).abs() < 1e-3);
    }
}

fn turned(rig: &mut Rig, change: impl Fn(&mut [[f64; 3]; 4])) {
    let mut joints = [[0.0, 0.0, 90.0]; 4];
    change(&mut joints);
    for _ in 0..60 {
        rig.command(joints.map(|leg| leg.map(JointCommand::at)), 20.0);
    }
}

/// Turns both legs on the left towards each other, and measures their distances in each cycle.
fn measured(rig: &mut Rig, angle: f64) -> Clearance {
    let mut joints = [[0.0, 0.0, 90.0]; 4];
    (joints[0][0], joints[2][0]) = (-angle, angle);
    let gap = |rig: &Rig| rig.plant.gap().expect("its legs are compared");
    let mut clearance = Clearance::new(gap(rig));
    for cycle in 0..60 {
        rig.command(joints.map(|leg| leg.map(JointCommand::at)), 20.0);
        clearance.update(gap(rig), cycle);
    }
    clearance
}

#[test]
fn legs_that_go_through_each_other_are_counted() {
    // Both legs on the left turn by 60 degrees towards each other: they cross where the thighs end.
    let mut rig = Rig::new();
    let found = measured(&mut rig, 60.0);
    assert!(
        found.collisions > 10 && found.least.distance < 0.0,
        "{found:?}"
    );
    assert_eq!(found.least.parts, [Part::Link(3, 2), Part::Link(1, 2)]);
    assert_eq!(seen(&rig).crossings, 0, "they are counted once");
    // By 20 degrees they stay apart.
    let mut rig = Rig::new();
    let found = measured(&mut rig, 20.0);
    assert_eq!(found.collisions, 0);
    assert!(found.least.distance > 0.0, "{found:?}");
}

#[test]
fn legs_that_go_through_the_floor_are_counted() {
    // The knee is 240 sin 60° = 208 mm below a hip that is 200 mm above the floor.
    let mut rig = Rig::new();
    turned(&mut rig, |joints| joints[0] = [0.0, -60.0, 150.0]);
    assert!(seen(&rig).crossings > 10);
    let mut rig = Rig::new();
    turned(&mut rig, |joints| joints[0] = [0.0, -50.0, 150.0]);
    assert_eq!(seen(&rig).crossings, 0);
}

/// Returns the number of ten cycles in which a robot that stands 50 mm above the floor is in a
/// block.
fn in_block(x: [f64; 2], y: [f64; 2], height: f64) -> u32 {
    let scene = Scene::EMPTY.with_block(Block { x, y, height });
    let plant = SimulatedPlant::new(&titan8::MODEL);
    let mut rig = Rig::on(plant.with_scene(&scene.expect("a block")));
    rig.move_to(stance(-250.0));
    let before = seen(&rig).crossings;
    for _ in 0..10 {
        rig.tell(&stance(-250.0));
    }
    seen(&rig).crossings - before
}

#[test]
fn bodies_and_legs_that_go_through_blocks_are_counted() {
    let middle = [-50.0, 50.0];
    assert_eq!(in_block(middle, middle, 40.0), 0, "under the belly");
    assert_eq!(in_block(middle, middle, 60.0), 10, "in the belly");
    let across = [-2000.0, 2000.0];
    assert_eq!(in_block(across, middle, 40.0), 0, "between the legs");
    assert_eq!(in_block(across, middle, 60.0), 10, "through the body");
    assert_eq!(in_block(middle, [240.0, 300.0], 900.0), 0, "ahead of it");
    assert_eq!(in_block(middle, [220.0, 300.0], 900.0), 10, "in its front");
    // F1 is at (-391, 201), its thigh at the height of the hip.
    let leg = [191.0, 211.0];
    assert_eq!(in_block([-401.0, -381.0], leg, 20.0), 10, "a foot");
    assert_eq!(in_block([-250.0, -240.0], leg, 300.0), 10, "a thigh");
    assert_eq!(in_block([-500.0, -450.0], leg, 300.0), 0, "beside it");
}

#[test]
fn joints_that_are_to_turn_faster_than_their_servos_are_counted() {
    let mut rig = Rig::on(SimulatedPlant::new(&high_bellied()));
    let turning = |rate: f64| {
        let mut joints = angles(&stance(-200.0)).map(|leg| leg.map(JointCommand::at));
        let JointCommand::Angle { angle, .. } = joints[1][0] else {
            unreachable!("it was just made")
        };
        joints[1][0] = JointCommand::Angle { angle, rate };
        joints
    };
    rig.command(turning(360.0), 20.0);
    rig.command(turning(-360.0), 20.0);
    assert_eq!(rig.plant.tracking_errors().hurries, 0);
    rig.command(turning(-361.0), 20.0);
    rig.command(turning(859.0), 20.0);
    assert_eq!(rig.plant.tracking_errors().hurries, 2);
}

#[test]
fn a_foot_beside_its_line_is_counted() {
    let slanting = |speed: f64| {
        let lag = 15.0;
        let plant = SimulatedPlant::new(&high_bellied()).with_servos(ServoDynamics { lag, speed });
        let mut rig = Rig::on(plant);
        // Outwards and forwards: the yaw has farther to turn than the other joints.
        for cycle in 1..=30 {
            let mut feet = stance(-200.0);
            let gone = 5.0 * f64::from(cycle);
            feet[1] = [391.0 - gone, 201.0 + gone, -180.0];
            rig.tell(&feet);
        }
        rig.plant.tracking_errors()
    };
    let fast = slanting(360.0);
    assert_eq!(fast.strays, 0, "{fast:?}");
    assert!(fast.farthest_stray < 10.0);
    let slow = slanting(20.0);
    assert!(slow.strays > 5 && slow.farthest_stray > 10.0, "{slow:?}");
}
