//! Robots that are published: how they stand, by trigonometry of their figures.

use tip_runtime::model::{Inverse, Point};
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tip_sim::{Limit, Plant, Robot, RobotDescription, Run, load};

fn anatomy(name: &str) -> RobotDescription {
    Robot::named(name).expect("a published robot").anatomy()
}

#[track_caller]
fn stands(robot: &RobotDescription, feet: &[Point]) {
    assert_eq!(robot.feet.len(), feet.len());
    for (at, foot) in robot.feet.iter().zip(feet) {
        let apart = at.iter().zip(foot).map(|(a, b)| (a - b).abs());
        assert!(apart.fold(0.0, f64::max) < 0.02, "{at:?} is not {foot:?}");
    }
}

#[test]
fn a_phantomx_stands_as_its_controller_does() {
    // The feet 141 mm beside the first joints, those of the corners at 45 deg. It lies with these 30 mm high, and rises by 90 mm.
    let r = 141.0 * 0.5_f64.sqrt();
    let right = [
        [60.0 + r, 120.0 + r, -120.0],
        [241.0, 0.0, -120.0],
        [60.0 + r, -120.0 - r, -120.0],
    ];
    let pairs = right.map(|[x, y, z]| [[-x, y, z], [x, y, z]]);
    let robot = anatomy("phantomx");
    stands(&robot, pairs.as_flattened());
    assert_eq!(robot.inverse, Inverse::YawPitchPitch);
}

/// The feet of a quadruped that stands alike on all four.
fn four(x: f64, y: f64, z: f64) -> [Point; 4] {
    [[-x, y, z], [x, y, z], [-x, -y, z], [x, -y, z]]
}

#[test]
fn quadrupeds_stand_on_feet_below_their_thighs() {
    let half = 0.5_f64.sqrt();
    let a1 = anatomy("a1");
    stands(&a1, &four(47.0 + 83.8, 180.5, -400.0 * half));
    let solo12 = anatomy("solo12");
    let side = 87.5 + 14.0 + 37.45 + 9.0;
    stands(&solo12, &four(side, 214.1 - 19.5, -320.0 * half));
    // The lower leg leans as far forward as the upper one back: 107.5 sin 45 deg = 130 sin a.
    let lean = (107.5 * half / 130.0).asin();
    let height = 107.5 * half + 130.0 * lean.cos();
    let spotmicro = anatomy("spotmicro");
    stands(&spotmicro, &four(39.0 + 55.0, 93.0, -height));
    for robot in [&a1, &solo12, &spotmicro] {
        assert_eq!(robot.inverse, Inverse::RollPitchPitch);
    }
    // 6 kg of trunk and 1.935 kg a leg.
    let joints = a1.legs.iter().flat_map(|leg| &leg.joints);
    let legs: f64 = joints.map(|joint| joint.mass).sum();
    assert!((legs - 4.0 * 1.935).abs() < 1e-9, "{legs}");
}

#[test]
fn fingers_of_a_trifinger_stand_round_its_middle() {
    let (second, third) = (51.566_f64.to_radians(), (51.566_f64 - 97.403).to_radians());
    let x = 16.85 + 50.15 + 19.0;
    let y = 50.5 + 160.0 * second.sin() + 160.0 * third.sin();
    let z = 290.0 - 160.0 * second.cos() - 160.0 * third.cos();
    let turned = |angle: f64| {
        let (sin, cos) = angle.to_radians().sin_cos();
        [cos * x - sin * y, sin * x + cos * y, z]
    };
    let robot = anatomy("trifinger");
    stands(&robot, &[0.0, -120.0, -240.0].map(turned));
    assert!(robot.body.is_none() && robot.forces.is_some());
}

#[test]
fn a_name_that_no_robot_has_is_answered_by_those_that_are_there() {
    let Err(unknown) = Robot::named("asimo") else {
        panic!("there is no such robot");
    };
    let words = unknown.to_string();
    for name in ["titan8", "generic", "solo12", "description"] {
        assert!(words.contains(name), "{words}");
    }
}

/// Returns the distance that a program's robot goes without falling, mm.
#[track_caller]
fn goes(name: &str, plant: Plant, source: &str) -> f64 {
    let robot = Robot::named(name).expect("a published robot");
    let robot = robot.with_plant(plant);
    let program = load("walk.prg", source, &robot).expect("it loads");
    let mut run = Run::new(program, robot).expect("it was checked for it");
    assert_eq!(
        run.to_end(Limit::NONE),
        Ending::Program(End::Exit),
        "{name}"
    );
    let motion = run.motion().expect("it walks");
    assert_eq!(motion.falls, 0, "{name}");
    motion.travel.y
}

#[test]
fn quadrupeds_crawl_with_mass_and_without() {
    let crawl = include_str!("../../../../examples/published/crawl.prg");
    for name in ["a1", "solo12", "spotmicro"] {
        for plant in [Plant::Simulated, Plant::Dynamic] {
            // Four strides of 50 mm.
            let gone = goes(name, plant, crawl);
            assert!((195.0..205.0).contains(&gone), "{name} {plant:?}: {gone}");
        }
    }
}

#[test]
fn a_phantomx_walks_on_two_tripods_with_mass_and_without() {
    let tripod = include_str!("../../../../examples/published/tripod.prg");
    for plant in [Plant::Simulated, Plant::Dynamic] {
        // Half a step, ten whole ones and half a step, each of 50 mm.
        let gone = goes("phantomx", plant, tripod);
        assert!((545.0..555.0).contains(&gone), "{plant:?}: {gone}");
    }
}

#[test]
fn an_a1_trots_with_its_mass() {
    let trot = include_str!("../../../../examples/published/trot.prg");
    // Half a swing, sixteen whole ones and half a swing of 30 mm, of which the feet slip away a fifth at most.
    let gone = goes("a1", Plant::Dynamic, trot);
    assert!((408.0..510.0).contains(&gone), "{gone}");
}

/// The greatest distance of a TriFinger's fingertips from their circles, and from the planes of these: mm.
fn apart(plant: Plant) -> [f64; 2] {
    const RADIUS: f64 = 30.0;
    let robot = Robot::named("trifinger").expect("a published robot");
    let robot = robot.with_plant(plant);
    let anatomy = robot.anatomy();
    let circle = include_str!("../../../../examples/published/fingertips.prg");
    let program = load("fingertips.prg", circle, &robot).expect("it loads");
    let mut run = Run::new(program, robot).expect("it was checked for it");
    let (mut round, mut up, mut turned) = (0.0_f64, 0.0_f64, [false; 4]);
    while run.ending().is_none() {
        run.cycle();
        let angles = run.angles().chunks(anatomy.joints);
        for ((limb, first), angles) in anatomy.legs.iter().zip(&anatomy.feet).zip(angles) {
            let tip = limb.foot(angles);
            // They begin on the right of the circle.
            let [x, y] = [tip[0] - first[0] + RADIUS, tip[1] - first[1]];
            round = round.max((x.hypot(y) - RADIUS).abs());
            up = up.max((tip[2] - first[2]).abs());
            turned[usize::from(x < 0.0) + 2 * usize::from(y < 0.0)] = true;
        }
    }
    assert_eq!(run.ending(), Some(Ending::Program(End::Exit)));
    assert_eq!(turned, [true; 4], "all the way round");
    [round, up]
}

#[test]
fn fingertips_of_a_trifinger_go_round_a_circle() {
    // The chord of 5 deg is 30 (1 - cos 2.5 deg) inside the circle in its middle.
    let [round, up] = apart(Plant::Simulated);
    assert!(round < 0.03 && up < 0.03, "{round}, {up}");
    // With mass they hang below and follow later; 2 mm is what the program calls in position.
    let [round, up] = apart(Plant::Dynamic);
    assert!(round < 2.0 && up < 2.0, "{round}, {up}");
}
