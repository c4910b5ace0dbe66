//! Robots that are published: how they stand, by trigonometry of their figures.

use tip_runtime::model::{Inverse, Point};
use tip_runtime::program::End;
use tip_runtime::random::Random;
use tip_runtime::record::Ending;
use tip_sim::{Limit, Plant, Robot, RobotDescription, Run, load};

fn description(name: &str) -> RobotDescription {
    Robot::named(name).expect("a published robot").description()
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
    let robot = description("phantomx");
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
    let a1 = description("a1");
    stands(&a1, &four(47.0 + 83.8, 180.5, -400.0 * half));
    let solo12 = description("solo12");
    let side = 87.5 + 14.0 + 37.45 + 9.0;
    stands(&solo12, &four(side, 214.1 - 19.5, -320.0 * half));
    // The lower leg leans as far forward as the upper one back: 107.5 sin 45 deg = 130 sin a.
    let lean = (107.5 * half / 130.0).asin();
    let height = 107.5 * half + 130.0 * lean.cos();
    let spotmicro = description("spotmicro");
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
    let robot = description("trifinger");
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

/// A gait of examples/published: its robot and program, the least speeds ahead (mm/s) and to the left (deg/s), the way that its feet
/// make in one stride (mm), and the largest slip of a foot (mm).
struct Gait {
    robot: &'static str,
    program: &'static str,
    least: [f64; 2],
    stride: f64,
    slip: f64,
}

const GAITS: [Gait; 5] = [
    Gait {
        robot: "phantomx",
        program: include_str!("../../../../examples/published/tripod.prg"),
        least: [200.0, 50.0],
        stride: 205.0 * 0.6,
        slip: 2.0,
    },
    Gait {
        robot: "spotmicro",
        program: include_str!("../../../../examples/published/trot-spotmicro.prg"),
        least: [130.0, 35.0],
        // Three times the way of a foot: the body is not to stop within a fifth of a second.
        stride: 3.0 * 150.0 * 0.2,
        slip: 8.0,
    },
    Gait {
        robot: "a1",
        program: include_str!("../../../../examples/published/trot-a1.prg"),
        least: [370.0, 55.0],
        stride: 400.0 * 0.28,
        slip: 8.0,
    },
    Gait {
        robot: "solo12",
        program: include_str!("../../../../examples/published/trot-solo12.prg"),
        least: [260.0, 55.0],
        stride: 300.0 * 0.28,
        slip: 8.0,
    },
    Gait {
        robot: "titan8",
        program: include_str!("../../../../examples/published/crawl-titan8.prg"),
        least: [85.0, 5.0],
        stride: 90.0 * 2.76,
        slip: 5.0,
    },
];

impl Gait {
    /// Returns a run with mass and events.
    fn run(&self, events: &str) -> Run {
        let robot = Robot::named(self.robot).expect("it has a name");
        let robot = robot.with_plant(Plant::Dynamic);
        let program = load("walk.prg", self.program, &robot).expect("it loads");
        let run = Run::new(program, robot).expect("it was checked for it");
        run.events(events).expect("the robot has sticks")
    }

    /// Returns the cycle of a time, s.
    fn at(&self, seconds: f64) -> u64 {
        let period = match self.robot {
            "a1" | "solo12" => 0.01,
            _ => 0.02,
        };
        (seconds / period).round() as u64
    }
}

/// Runs until a cycle.
fn until(run: &mut Run, cycle: u64) {
    while run.cycles() < cycle && run.ending().is_none() {
        run.cycle();
    }
}

const REST: &str = "0:VR1=5, 0:VR2=5, 0:VR3=5";

/// The speeds that examples/published/README.md states, over whole strides of a crawl; and after the stick is let go, the robot
/// stands within one stride.
#[test]
fn gaits_walk_and_turn_as_fast_as_stated_and_stop_within_a_stride() {
    for gait in &GAITS {
        let at = |seconds| gait.at(seconds);
        let window = 2.76;
        for (stick, least) in (1..).zip(gait.least) {
            let (begin, end) = (at(4.0), at(10.0));
            let events = format!(
                "{REST}, {begin}:VR{stick}=10, {end}:VR{stick}=5, {}:halt",
                at(16.0)
            );
            let mut run = gait.run(&events);
            until(&mut run, at(10.0 - window));
            let from = run.travel().expect("it walks");
            until(&mut run, end);
            let to = run.travel().expect("it walks");
            let way = match stick {
                1 => to.y - from.y,
                _ => to.turn - from.turn,
            };
            let speed = way / window;
            assert!(speed >= least, "{}: VR{stick} {speed}", gait.robot);
            let ending = run.to_end(Limit::cycles(at(60.0)));
            assert_eq!(ending, Ending::Program(End::Exit), "{}", gait.robot);
            let motion = run.motion().expect("it walks");
            assert_eq!(motion.falls, 0, "{}", gait.robot);
            let slid = motion.travel.y - to.y;
            assert!(stick != 1 || slid <= gait.stride, "{}: {slid}", gait.robot);
        }
    }
}

/// Sticks that a seed moves, for 20 s. tests/external/gaits has ten minutes.
#[test]
fn gaits_do_not_fall_whatever_the_sticks_say() {
    for gait in &GAITS {
        let mut random = Random::new(49);
        let (mut events, mut time) = (REST.to_owned(), 4.0);
        while time < 24.0 {
            for stick in 1..=3 {
                let volts = match random.below(6) {
                    0 | 1 => 5,
                    2 => 0,
                    3 => 10,
                    _ => random.below(11),
                };
                events += &format!(", {}:VR{stick}={volts}", gait.at(time));
            }
            time += random.within(0.2, 2.2);
        }
        events += &format!(", {}:halt", gait.at(time));
        let mut run = gait.run(&events);
        let ending = run.to_end(Limit::cycles(gait.at(time + 30.0)));
        assert_eq!(ending, Ending::Program(End::Exit), "{}", gait.robot);
        let motion = run.motion().expect("it walks");
        assert_eq!(motion.falls, 0, "{}", gait.robot);
        assert!(motion.slip <= gait.slip, "{}: {}", gait.robot, motion.slip);
    }
}

/// The impulses that examples/published/README.md states, for 0.2 s from the side while the robot walks.
#[test]
fn gaits_stand_a_push() {
    for (gait, force) in GAITS.iter().zip([200, 30, 30, 15, 300]) {
        let cycles = gait.at(0.2);
        let events = format!(
            "{REST}, {}:VR1=10, {}:push {force} 0 0 for {cycles}, {}:halt",
            gait.at(4.0),
            gait.at(7.0),
            gait.at(10.0)
        );
        let mut run = gait.run(&events);
        let ending = run.to_end(Limit::cycles(gait.at(40.0)));
        assert_eq!(ending, Ending::Program(End::Exit), "{}", gait.robot);
        assert_eq!(
            run.motion().map(|motion| motion.falls),
            Some(0),
            "{}",
            gait.robot
        );
    }
}

/// Inputs without sticks read 0 V. W walks ahead, another key stops.
#[test]
fn keys_steer_a_robot_without_sticks() {
    let gait = &GAITS[0];
    let mut run = gait.run("100:key W, 300:key 0x20, 400:halt");
    let ending = run.to_end(Limit::cycles(1000));
    assert_eq!(ending, Ending::Program(End::Exit));
    let travel = run.travel().expect("it walks");
    // 200 cycles of 20 ms at 205 mm/s.
    assert!((700.0..900.0).contains(&travel.y), "{travel:?}");
}

/// The greatest distance of a TriFinger's fingertips from their circles, and from the planes of these: mm.
fn apart(plant: Plant) -> [f64; 2] {
    const RADIUS: f64 = 30.0;
    let robot = Robot::named("trifinger").expect("a published robot");
    let robot = robot.with_plant(plant);
    let description = robot.description();
    let circle = include_str!("../../../../examples/published/fingertips.prg");
    let program = load("fingertips.prg", circle, &robot).expect("it loads");
    let mut run = Run::new(program, robot).expect("it was checked for it");
    let (mut round, mut up, mut turned) = (0.0_f64, 0.0_f64, [false; 4]);
    while run.ending().is_none() {
        run.cycle();
        let angles = run.angles().chunks(description.joints);
        for ((limb, first), angles) in description.legs.iter().zip(&description.feet).zip(angles) {
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
