//! The robot on the ground: rest, friction, falls.

use crate::dynamic::rig::{GRAVITY, Numbers, all, falls, go, hold, loads, titan};
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, JointCommand};
use tip_runtime::kinematics::inverse;
use tip_runtime::model::titan8;
use tip_runtime::plant::dynamic::Twist;
use tip_runtime::plant::{Block, DynamicPlant, Floor, Motion, Plant, Scene, SimulatedPlant};

const WEIGHT: f64 = 20.0 * GRAVITY;

/// Returns angles with which the feet are `height` below the body, mm.
fn standing(height: f64) -> [[f64; 3]; 4] {
    let mut legs = titan8::MODEL.legs.iter();
    [[-1.0, 1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(|[side, end]| {
        let leg = legs.next().expect("four legs");
        let foot = [391.0 * side, 201.0 * end, -height];
        inverse(titan8::MODEL.inverse, leg, foot).expect("it reaches")
    })
}

fn initial() -> [[f64; 3]; 4] {
    titan8::MODEL.legs.map(|leg| leg.initial)
}

#[test]
fn at_rest_the_loads_are_the_weight_and_nothing_creeps() {
    let mut plant = titan();
    assert!((loads(&plant) - WEIGHT).abs() < 1e-6, "as it is set down");
    go(&mut plant, standing(250.0));
    hold(&mut plant, standing(250.0), 50);
    assert_eq!(plant.belly_load(), 0.0);
    let before = plant.body();
    for _ in 0..250 {
        hold(&mut plant, standing(250.0), 1);
        assert!(
            (loads(&plant) / WEIGHT - 1.0).abs() < 1e-3,
            "{} N",
            loads(&plant)
        );
    }
    let after = plant.body();
    for (before, after) in before.position.into_iter().zip(after.position) {
        assert!((after - before).abs() < 0.01, "{before} mm, {after} mm");
    }
    assert!((after.yaw - before.yaw).abs() < 0.01 && after.pitch.abs() < 0.1);
    assert_eq!(falls(&plant), 0);
    let height = after.position[2];
    assert!(
        (240.0..250.0).contains(&height),
        "servos give way a little: {height} mm"
    );
}

/// Returns a robot on its belly on a slope with friction 0.5.
fn on_slope(slope: f64) -> DynamicPlant<4, 3> {
    let mut scene = Scene::EMPTY;
    scene.floor = Floor {
        height: 100.0,
        slope: [0.0, slope],
    };
    titan().with_scene(&scene)
}

#[test]
fn on_a_slope_the_ground_pushes_straight_up_by_normal_force_and_friction() {
    let mut plant = on_slope(0.2);
    go(&mut plant, standing(250.0));
    hold(&mut plant, standing(250.0), 50);
    assert_eq!(plant.belly_load(), 0.0);
    let limbs = plant.limbs().expect("legs");
    let (forces, loads) = limbs.forces.zip(limbs.loads).expect("it walks");
    let sum = |axis: usize| forces.iter().map(|force| force[axis]).sum::<f64>();
    assert!((sum(2) / WEIGHT - 1.0).abs() < 1e-3, "{} N", sum(2));
    assert!(sum(0).abs() < 1e-3 * WEIGHT && sum(1).abs() < 1e-3 * WEIGHT);
    // The floor rises by 0.2 along y.
    let length = libm::hypot(0.2, 1.0);
    for ([x, y, z], load) in forces.into_iter().zip(loads) {
        let (push, along) = ((z - 0.2 * y) / length, (y + 0.2 * z) / length);
        assert!((push - load).abs() < 1e-9, "{push} N, {load} N");
        assert!(libm::hypot(x, along) <= 0.5 * load + 1e-9);
    }
}

#[test]
fn a_slope_below_the_friction_angle_holds() {
    for slope in [0.2, 0.45, -0.45] {
        let mut plant = on_slope(slope);
        hold(&mut plant, initial(), 50);
        let travel = plant.travel();
        let moved = [travel.x, travel.y, travel.z];
        assert!(
            moved.iter().all(|way| way.abs() < 1.5),
            "{slope}: {moved:?}"
        );
        // Where the feet stood on a level floor, before there was a slope, does not count.
        let slip = plant.motion().expect("it walks").slip;
        assert!(slip < 1.5, "{slope}: {slip} mm");
    }
}

#[test]
fn a_slope_above_the_friction_angle_lets_it_slide() {
    let slope: f64 = 0.6;
    let mut plant = on_slope(slope);
    // Until its bristles are bent it is free.
    hold(&mut plant, initial(), 10);
    let before = plant.twist().velocity;
    hold(&mut plant, initial(), 40);
    let after = plant.twist().velocity;
    let [x, y, z] = [0, 1, 2].map(|axis| (after[axis] - before[axis]) / 0.8);
    let cosine = 1.0 / (1.0 + slope * slope).sqrt();
    let down = 1000.0 * GRAVITY * cosine * (slope - 0.5);
    assert!(
        (y.hypot(z) / down - 1.0).abs() < 0.01,
        "{y}, {z}: {down} mm/s²"
    );
    assert!(y < 0.0 && x.abs() < 0.01 * down, "{x}, {y}, {z}");
    assert!((after[2] / after[1] - slope).abs() < 0.01, "{after:?}");
}

#[test]
fn a_body_that_loses_its_legs_on_one_side_falls_there() {
    let mut plant = titan();
    go(&mut plant, standing(250.0));
    assert_eq!(falls(&plant), 0);
    // Both legs on the left are drawn up.
    let mut lifted = standing(250.0);
    let up = standing(120.0);
    (lifted[0], lifted[2]) = (up[0], up[2]);
    hold(&mut plant, lifted, 100);
    let motion = plant.motion().expect("it walks");
    assert_eq!(motion.falls, 1);
    assert!(motion.pose.roll < -5.0, "{:?}", motion.pose);
    assert!(plant.first_fall().is_some_and(|fall| fall.cycle > 100));
    assert!(plant.belly_load() > 0.2 * WEIGHT);
}

#[test]
fn legs_that_meet_do_not_pass_through_each_other() {
    // Both legs on the left turn towards each other: straight through, their shanks would pass by 100 mm.
    let mut plant = titan().lifted(3000.0);
    let mut turned = initial();
    (turned[0][0], turned[2][0]) = (-60.0, 60.0);
    hold(&mut plant, turned, 30);
    let [front, _, rear, _] = plant.feet().map(|foot| foot.position);
    let apart = front[1] - rear[1];
    assert!(
        (15.0..25.0).contains(&apart),
        "shanks are 20 mm thick: {apart} mm"
    );
    assert!(
        plant.angles()[0][0] > -55.0 && plant.angles()[2][0] < 55.0,
        "{:?}",
        plant.angles()
    );
}

#[test]
fn a_robot_stands_on_a_block_and_is_stopped_by_one() {
    let block = |x, y, height| Block { x, y, height };
    let under = block([-500.0, 500.0], [-500.0, 500.0], 40.0);
    let scene = Scene::EMPTY.with_block(under).expect("a block");
    let mut plant = titan().with_scene(&scene);
    hold(&mut plant, initial(), 50);
    let height = plant.body().position[2];
    assert!((height - 240.0).abs() < 1.0, "{height} mm");
    assert!((loads(&plant) / WEIGHT - 1.0).abs() < 1e-3);

    // A wall 50 mm in front of the body, against which it is pushed with 300 N.
    let wall = block([-150.0, 150.0], [280.0, 400.0], 500.0);
    let scene = Scene::EMPTY.with_block(wall).expect("a block");
    let mut plant = titan().with_scene(&scene);
    assert!(plant.push([0.0, 300.0, 0.0], 200));
    hold(&mut plant, initial(), 200);
    let place = plant.body().position[1];
    assert!((place - 50.0).abs() < 5.0, "{place} mm");
}

#[test]
fn a_thigh_rests_on_what_is_between_its_ends() {
    // A post 10 mm under the front left thigh; the straight leg is lowered by 20 deg, its foot still above the floor.
    let mut low = initial();
    low[0] = [0.0, -20.0, 5.0];
    let body = |scene: &Scene| {
        let mut plant = titan().with_scene(scene);
        go(&mut plant, low);
        plant.body().position[2]
    };
    let free = body(&Scene::EMPTY);
    for x in [[-320.0, -220.0], [-245.0, -225.0], [-200.0, -190.0]] {
        let post = Block {
            x,
            y: [100.0, 300.0],
            height: 190.0,
        };
        let scene = Scene::EMPTY.with_block(post).expect("a block");
        let held = body(&scene);
        assert!(held > free + 2.0, "{held} mm on {x:?}, {free} mm without");
    }
}

#[test]
fn a_body_stops_at_what_is_narrower_than_it() {
    // A post 50 mm in front of the body's middle, higher than the body or not, against which it is pushed with 300 N.
    for height in [300.0, 800.0] {
        let post = Block {
            x: [-30.0, 30.0],
            y: [280.0, 340.0],
            height,
        };
        let scene = Scene::EMPTY.with_block(post).expect("a block");
        let mut plant = titan().with_scene(&scene);
        assert!(plant.push([0.0, 300.0, 0.0], 200));
        hold(&mut plant, initial(), 200);
        let place = plant.body().position[1];
        assert!((place - 50.0).abs() < 5.0, "{place} mm");
        assert_eq!(falls(&plant), 0);
    }
}

#[test]
fn a_body_rests_on_what_is_under_it() {
    // A stone whose corners are under the belly, beams across and along, which no corner of the body meets: legs that are drawn up
    // leave the body on it.
    let reach = [-2000.0, 2000.0];
    for (x, y) in [
        ([-60.0, 60.0], [-100.0, 100.0]),
        (reach, [-60.0, 60.0]),
        ([-60.0, 60.0], reach),
    ] {
        let height = 40.0;
        let scene = Scene::EMPTY.with_block(Block { x, y, height });
        let mut plant = titan().with_scene(&scene.expect("a block"));
        let begins = plant.body().position[2];
        assert!((begins - 240.0).abs() < 1.0, "{begins} mm");
        hold(&mut plant, [[0.0, 0.0, 60.0]; 4], 100);
        let body = plant.body();
        assert!((body.position[2] - 240.0).abs() < 1.0, "{body:?}");
        assert!((plant.belly_load() / WEIGHT - 1.0).abs() < 1e-3);
        assert!(body.pitch.abs() < 1.0 && body.roll.abs() < 1.0, "{body:?}");
    }
}

#[test]
fn nothing_is_flung_by_what_stands_around_it() {
    let mut random = Numbers(3);
    for round in 0..8 {
        let mut scene = Scene::EMPTY;
        for _ in 0..8 {
            let [x, y, wide, deep, high] = random.some(1.0);
            let (x, y) = (600.0 * x, 600.0 * y);
            let block = Block {
                x: [x, x + 110.0 + 100.0 * wide],
                y: [y, y + 110.0 + 100.0 * deep],
                height: 80.0 + 80.0 * high,
            };
            scene = scene.with_block(block).expect("a block");
        }
        let mut plant = titan().with_scene(&scene);
        let top = plant.body().position[2];
        for height in [200.0, 260.0, 180.0, 240.0] {
            for _ in 0..10 {
                hold(&mut plant, standing(height), 1);
                let Twist { velocity, rate } = plant.twist();
                let energy = plant.energy().kinetic;
                assert!(energy < 60.0, "{round}: {velocity:?}, {rate:?}, {energy} J");
                let z = plant.body().position[2];
                assert!(z > 100.0 && z < top + 150.0, "{round}: {z} mm of {top} mm");
            }
        }
    }
}

#[test]
fn equal_runs_have_equal_bits() {
    let run = || {
        let mut plant = titan();
        go(&mut plant, standing(230.0));
        let mut copy = plant.clone();
        hold(&mut plant, initial(), 30);
        hold(&mut copy, initial(), 30);
        let bits = |angles: [[f64; 3]; 4]| angles.map(|leg| leg.map(f64::to_bits));
        assert_eq!(bits(plant.angles()), bits(copy.angles()), "a copy");
        let [x, y, z] = plant.body().position.map(f64::to_bits);
        (bits(plant.angles()), x, y, z)
    };
    assert_eq!(run(), run());
}

#[test]
fn nonsense_moves_nothing_and_breaks_nothing() {
    let mut plant = titan();
    let before = plant.body();
    hold(&mut plant, [[f64::NAN; 3]; 4], 50);
    assert!((plant.body().position[2] - before.position[2]).abs() < 1.0);
    hold(&mut plant, [[f64::MAX; 3]; 4], 50);
    hold(&mut plant, [[-1e300; 3]; 4], 50);
    assert!(plant.body().position.iter().all(|place| place.is_finite()));
}

#[test]
fn a_simulation_that_diverges_says_so_and_stays_as_it_was() {
    for force in [1e300, f64::MAX, f64::NAN, f64::INFINITY] {
        let mut plant = titan();
        hold(&mut plant, initial(), 5);
        let before = (plant.body(), plant.angles());
        assert!(plant.push([force, 0.0, 0.0], 3));
        let outputs = all(initial().map(|leg| leg.map(JointCommand::at)), 20.0);
        let fault = plant.write(&outputs).expect_err("no robot bears it");
        let HardwareFault { cause, .. } = fault;
        assert!(cause.starts_with("the simulation diverged"), "{cause}");
        assert_eq!((plant.body(), plant.angles()), before);
        assert_eq!(plant.stop(&Fault::EmergencyKey), Err(fault));
        let limbs = plant.limbs().expect("legs");
        let loads = limbs.loads.expect("it walks");
        let numbers = limbs.angles.into_iter().flatten().chain(loads);
        assert!(numbers.into_iter().all(f64::is_finite), "{force}");
    }
}

/// Returns the motion after the feet have gone to `from` and then, without a pause, to `to`.
fn dropped(from: [[f64; 3]; 4], to: [[f64; 3]; 4]) -> Motion {
    let mut plant = titan();
    go(&mut plant, from);
    go(&mut plant, to);
    plant.motion().expect("it walks")
}

/// Returns the same motion without mass.
fn dropped_without_mass(from: [[f64; 3]; 4], to: [[f64; 3]; 4]) -> Motion {
    let mut plant = SimulatedPlant::new(&titan8::MODEL);
    for to in [from, to] {
        let from = plant.angles();
        for cycle in 1..=100 {
            let share = (f64::from(cycle) / 50.0).min(1.0);
            let mut angles = from;
            for (angle, to) in angles.iter_mut().flatten().zip(to.iter().flatten()) {
                *angle += (to - *angle) * share;
            }
            let outputs = all(angles.map(|leg| leg.map(JointCommand::at)), 20.0);
            plant.write(&outputs).expect("it is simulated");
        }
    }
    plant.motion().expect("it walks")
}

/// Returns angles of a stand at a height (mm), with the feet of some legs lifted.
fn lifted(height: f64, legs: &[usize], by: f64) -> [[f64; 3]; 4] {
    let (mut feet, up) = (standing(height), standing(height - by));
    for leg in legs {
        feet[*leg] = up[*leg];
    }
    feet
}

#[test]
fn both_plants_agree_on_what_brings_a_body_down() {
    // The height of the body, which feet are lifted by how much, and whether that leaves the body on the floor.
    for (height, legs, by, comes_down) in [
        // Left, right, front and rear: the body comes to lie on an edge.
        (260.0, &[0, 2][..], 120.0, true),
        (260.0, &[1, 3], 120.0, true),
        (260.0, &[0, 1], 120.0, true),
        (260.0, &[2, 3], 120.0, true),
        (230.0, &[0, 2], 80.0, true),
        (300.0, &[0, 2], 160.0, true),
        // One foot, over three that hold it or nearly do.
        (260.0, &[0], 60.0, false),
        // All feet: it sits down.
        (260.0, &[0, 1, 2, 3], 60.0, false),
        (260.0, &[0, 1, 2, 3], 100.0, false),
        // Nothing.
        (260.0, &[], 0.0, false),
    ] {
        let case = (standing(height), lifted(height, legs, by));
        for motion in [
            dropped(case.0, case.1),
            dropped_without_mass(case.0, case.1),
        ] {
            let down = motion.falls - motion.upright_falls;
            assert_eq!(down, u32::from(comes_down), "{legs:?} {by}: {motion:?}");
        }
    }
}

/// Feet 782 mm apart, of which two were lifted by 80 mm, let the body lean by 5.9 deg. Its edge stays 7 mm above the floor,
/// and all four feet carry it, but it came down on those that were lifted. By 50 mm it leans 3.7 deg.
#[test]
fn both_plants_agree_that_a_body_falls_onto_lifted_feet() {
    for legs in [[0, 2], [1, 3]] {
        let (from, to) = (standing(260.0), lifted(260.0, &legs, 80.0));
        for motion in [dropped(from, to), dropped_without_mass(from, to)] {
            assert_eq!((motion.falls, motion.upright_falls), (1, 1), "{motion:?}");
        }
    }
    let leaning = dropped(standing(260.0), lifted(260.0, &[0, 2], 50.0));
    assert_eq!(leaning.falls, 0, "{leaning:?}");
}

#[test]
fn a_push_makes_a_robot_fall_that_it_tips_or_throws() {
    // Friction, the force along x and y (N), and whether it falls. Where feet slide, nothing tips it over.
    for (friction, push, falls) in [
        (0.2, [1500.0, 0.0], false),
        (0.6, [1500.0, 0.0], false),
        (0.4, [0.0, 700.0], false),
        (0.8, [0.0, 700.0], true),
        (1.0, [0.0, 1500.0], true),
    ] {
        let mut scene = Scene::EMPTY;
        scene.friction = friction;
        let mut plant = titan().with_scene(&scene);
        go(&mut plant, standing(260.0));
        let [x, y] = push;
        assert!(plant.push([x, y, 0.0], 10));
        hold(&mut plant, standing(260.0), 150);
        let motion = plant.motion().expect("it walks");
        assert_eq!(motion.falls > 0, falls, "{friction} {push:?}: {motion:?}");
    }
    // Thrown up, it is in the air for 0.6 s.
    let mut plant = titan();
    go(&mut plant, standing(260.0));
    assert!(plant.push([0.0, 0.0, 500.0], 10));
    hold(&mut plant, standing(260.0), 150);
    let motion = plant.motion().expect("it walks");
    assert_eq!(motion.falls, 1, "{motion:?}");
}

#[test]
fn what_could_not_be_followed_is_counted_as_without_mass() {
    let mut heavy = titan();
    let mut light = SimulatedPlant::new(&titan8::MODEL);
    go(&mut heavy, standing(250.0));
    let follows = |motion: Option<Motion>| motion.expect("it walks").tracking_errors;
    assert!(follows(heavy.motion()).is_empty(), "{heavy:?}");
    // A foot outwards and forwards, faster than its yaw can turn: 500 deg/s for ten cycles.
    let mut angles = standing(250.0);
    for _ in 0..10 {
        angles[1][0] += 6.0;
        angles[1][2] -= 3.0;
        let mut joints = angles.map(|leg| leg.map(JointCommand::at));
        joints[1][0] = JointCommand::Angle {
            angle: angles[1][0],
            rate: 500.0,
        };
        let outputs = all(joints, 20.0);
        heavy.write(&outputs).expect("it is simulated");
        light.write(&outputs).expect("it is simulated");
    }
    let counted = [follows(heavy.motion()), follows(light.motion())];
    assert_eq!(counted.map(|counted| counted.hurries), [10, 10]);
    // Down to the floor and on: a foot that the floor holds is beside its path.
    let mut plant = titan();
    for cycle in 0..40 {
        let mut angles = initial();
        angles[0][1] -= f64::from(cycle);
        angles[0][0] += f64::from(cycle);
        hold(&mut plant, angles, 1);
    }
    assert!(follows(plant.motion()).farthest_stray > 1.0);
}
