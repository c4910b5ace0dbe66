//! The operator of a robot: signals of this process, and the names of servos that are not as they were to be left.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use tip_drives::TorqueGuard;
use tip_drives::described::{self, Described};
use tip_drives::drives::{Failure, Policy, Problem};
use tip_drives::guard::{Request, Step};
use tip_drives::operator::{self, Operator};
use tip_drives::port::AnyPort;
use tip_drives::simulated::{MemoryPort, Servo, SimulatedBus};
use tip_runtime::hardware::JointCommand;
use tip_runtime::model::Part;

/// Returns the robot of a description that has a bus.
fn described(text: &str) -> Described {
    let description = described::read("robot.toml", text.as_bytes()).expect("right");
    Described::new(&description).expect("it has a bus")
}

/// A robot of two joints.
fn robot(at_end: &str) -> Described {
    let text = format!(
        "name = \"two\"
joint = [
    {{ axis = \"z\", link = [100, 0, 0], limits = [-90, 90] }},
    {{ axis = \"z\", link = [100, 0, 0], limits = [-90, 90] }},
]
leg = [{{ base = [0, 0, 0] }}]
[bus]
servo = \"AX-12\"
at_end = \"{at_end}\"
[[drive]]
joint = \"J11\"
id = 1
[[drive]]
joint = \"J12\"
id = 2
"
    );
    described(&text)
}

/// Connects to the simulated servos of a robot whose program writes its signals here.
fn connected(robot: &Described, signal: &Arc<AtomicUsize>) -> TorqueGuard<AnyPort, Operator> {
    on(robot, robot.simulated(), signal)
}

/// Connects to the servos of a robot whose joints a hand has left at these angles, deg.
fn left_at(robot: &Described, angles: [f64; 4]) -> TorqueGuard<AnyPort, Operator> {
    let servos = robot.joints.iter().zip(angles);
    let servos = servos
        .map(|(joint, angle)| Servo::new(joint.model, joint.id, joint.counts(angle).into()))
        .collect();
    let bus = SimulatedBus::new(servos, robot.timing());
    on(robot, bus, &Arc::default())
}

fn on(
    robot: &Described,
    bus: SimulatedBus,
    signal: &Arc<AtomicUsize>,
) -> TorqueGuard<AnyPort, Operator> {
    let port = AnyPort::Memory(Box::new(MemoryPort::new(bus)));
    let drives = robot.drives(port).expect("right");
    let operator = Operator::of_signals(Arc::clone(signal)).of_robot(robot);
    let mut guard = TorqueGuard::new(drives, operator, robot.period);
    guard.connect().expect("both are there");
    guard
}

/// 15 is SIGTERM and 2 is SIGINT on every system. A second signal ends nothing and changes no status.
#[test]
fn the_first_signal_ends_an_approach_in_order() {
    let (robot, signal) = (robot("hold"), Arc::default());
    let mut guard = connected(&robot, &signal);
    assert_eq!(guard.hold(), Ok(Step::Moving));
    assert_eq!(guard.step(&robot.initial, 30.0), Ok(Step::Moving));
    signal.store(15, Ordering::Relaxed);
    let step = guard.step(&robot.initial, 30.0);
    assert_eq!(step, Ok(Step::Left(Request::End)));
    signal.store(2, Ordering::Relaxed);
    assert_eq!(guard.host_mut().status(), 128 + 15);
    assert_eq!(operator::leave(&mut guard, &robot), Ok(()));
}

#[test]
fn servos_that_are_not_left_as_they_were_to_be_are_named() {
    for (at_end, policy) in [("relax", Policy::Relax), ("hold", Policy::Hold)] {
        let robot = robot(at_end);
        let mut guard = connected(&robot, &Arc::default());
        let step = guard.approach(&robot.initial, 30.0);
        assert_eq!(step, Ok(Step::Arrived));
        let AnyPort::Memory(port) = guard.drives_mut().bus_mut().port_mut() else {
            panic!("they are simulated");
        };
        port.bus.unplug(2);
        let left = operator::leave(&mut guard, &robot).expect_err("one is silent");
        assert_eq!((left.policy, left.other.len()), (policy, 0));
        assert_eq!(left.unknown, ["J12 (servo 2)"]);
        let said = format!(
            "these did not confirm that they {at_end}: J12 (servo 2). Switch their power off"
        );
        assert_eq!(left.to_string(), said);
    }
}

/// Two legs 200 mm apart, of one link of 180 mm each, which turn in a plane: at 60 deg towards each other they cross.
fn two_legs(collisions: &str) -> Described {
    let text = format!(
        "name = \"two\"
joint = [{{ axis = \"z\", link = [20, 0, 0], limits = [-90, 90] }}, {{ axis = \"z\", link = [180, 0, 0], limits = [-90, 90] }}]
leg = [{{ base = [0, 100, 0] }}, {{ base = [0, -100, 0] }}]
[bus]
servo = \"AX-12\"
{collisions}
[[drive]]
joint = \"J11\"
id = 1
[[drive]]
joint = \"J12\"
id = 2
[[drive]]
joint = \"J21\"
id = 3
[[drive]]
joint = \"J22\"
id = 4
"
    );
    described(&text)
}

/// Goals of the servos as their registers have them: register 30 of an AX, two bytes.
fn goals(guard: &mut TorqueGuard<AnyPort, Operator>) -> Vec<i32> {
    let AnyPort::Memory(port) = guard.drives_mut().bus_mut().port_mut() else {
        panic!("they are simulated");
    };
    let servos = port.bus.servos().iter();
    let goals = servos.map(|servo| servo.register(30, 2).expect("it has goals"));
    goals.map(|goal| goal as i32).collect()
}

/// Turns both legs towards each other by a degree in each cycle, up to this angle. Returns the problem, and the goals of the servos
/// after the last cycle and the one before.
fn close(
    robot: &Described,
    to: u32,
) -> (
    Option<Problem>,
    [Vec<i32>; 2],
    TorqueGuard<AnyPort, Operator>,
) {
    let mut guard = connected(robot, &Arc::default());
    assert_eq!(guard.approach(&robot.initial, 30.0), Ok(Step::Arrived));
    let mut before = goals(&mut guard);
    for angle in 1..=to {
        let angle = f64::from(angle);
        guard.read_cycle().expect("they are well");
        let angles = [0.0, -angle, 0.0, angle].map(JointCommand::at);
        let written = guard.write_cycle(&angles, robot.period);
        let now = goals(&mut guard);
        if let Err(failure) = written {
            return (Some(failure.problem), [before, now], guard);
        }
        before = now;
        guard.wait();
    }
    let now = goals(&mut guard);
    (None, [before, now], guard)
}

/// The lines of both links are parallel to x at 0 deg and 200 mm apart; with radii of 9 mm (5 % of 180 mm) they meet where
/// 2 · 180 · sin(angle) = 200 - 18, at 30.4 deg.
#[test]
fn a_command_to_a_collision_never_reaches_the_servos() {
    let (problem, [before, after], mut guard) = close(&two_legs(""), 60);
    let Some(Problem::Collides(gap)) = problem else {
        panic!("{problem:?}");
    };
    assert!(gap.distance < 0.0, "{gap:?}");
    assert_eq!(gap.parts, [Part::Link(2, 2), Part::Link(1, 2)]);
    // An AX has 1024 counts for 300 deg, and 512 is the middle.
    let at = |angle: f64| (512.0 + angle * 1024.0 / 300.0).round() as i32;
    let last_apart = [at(0.0), at(-30.0), at(0.0), at(30.0)];
    for goals in [before, after] {
        let differ = goals
            .iter()
            .zip(last_apart)
            .map(|(one, other)| (one - other).abs());
        assert!(differ.max() <= Some(1), "{goals:?} are not {last_apart:?}");
    }
    // The emergency holds it where it is; no goal goes on to the collision.
    guard.stop_cycle().expect("the port is there");
    guard.leave();
    assert!(guard.is_stopped());
    let [_, one, _, other] = goals(&mut guard)[..] else {
        panic!("four servos");
    };
    assert!(one >= at(-31.0) && other <= at(31.0), "{one} {other}");
}

#[test]
fn a_robot_whose_file_says_warn_goes_on() {
    let (problem, _, _) = close(&two_legs("collisions = \"warn\""), 60);
    assert_eq!(problem, None);
    // Near misses go on with the default, too.
    let (problem, _, _) = close(&two_legs(""), 30);
    assert_eq!(problem, None);
}

/// Both links cross where each has turned by more than 30.4 deg towards the other. A leg that is level and one that has turned by 80 deg
/// are 200 - 180 · sin(80 deg) = 22.7 mm apart, less 18 mm of both radii; halfway from one such posture to the other, at 40 deg, they
/// cross.
#[test]
fn a_way_through_a_collision_gets_no_torque() {
    let (one, other) = ([0.0, -80.0, 0.0, 0.0], [0.0, 0.0, 0.0, 80.0]);
    let robot = two_legs("");
    for (to, hits) in [(&other[..], true), (&[0.0; 4][..], false)] {
        let mut guard = left_at(&robot, one);
        let collision = guard.collision([to], 30.0);
        assert_eq!(collision.is_some(), hits);
        let approached = guard.approach(to, 30.0);
        if !hits {
            assert_eq!(approached, Ok(Step::Arrived));
            continue;
        }
        let Err(Failure {
            problem: Problem::Collides(gap),
            ..
        }) = approached
        else {
            panic!("{approached:?}");
        };
        assert_eq!(gap.parts, [Part::Link(2, 2), Part::Link(1, 2)]);
        assert!(!guard.has_torque() && guard.outcome().is_none());
        // J12 comes back from -80 while J22 goes to 80, at the same speed: they meet before the middle.
        let collision = collision.expect("it hits itself");
        let [_, first, _, second] = collision.angles[..] else {
            panic!("{collision:?}");
        };
        assert!((second - first - 80.0).abs() < 1.0, "{collision:?}");
        assert!(second > 5.0 && second < 40.0, "{collision:?}");
        // Straight ways by the level posture are free.
        assert_eq!(guard.collision([&[0.0; 4][..], to], 30.0), None);
    }
    // Its file says to warn only.
    let warns = two_legs("collisions = \"warn\"");
    let mut guard = left_at(&warns, one);
    assert!(guard.collision([&other[..]], 30.0).is_some());
    assert_eq!(guard.approach(&other, 30.0), Ok(Step::Arrived));
}

/// A robot that holds is stopped before the command that makes two parts overlap.
#[test]
fn a_step_into_a_collision_stops_the_robot() {
    let mut guard = left_at(&two_legs(""), [0.0, -20.0, 0.0, 20.0]);
    assert_eq!(guard.hold(), Ok(Step::Moving));
    let reached = guard.reach(&[0.0, -60.0, 0.0, 60.0], 30.0);
    let problem = reached.map_err(|failure| failure.problem);
    assert!(matches!(problem, Err(Problem::Collides(_))), "{problem:?}");
    assert!(guard.is_stopped());
}

#[test]
fn a_robot_found_in_an_overlap_may_leave_it_and_go_no_deeper() {
    // 200 - 360 · sin(31 deg) = 14.6 mm, and 18 mm of both radii.
    let (robot, touching) = (two_legs(""), [0.0, -31.0, 0.0, 31.0]);
    let left = left_at(&robot, touching).approach(&[0.0; 4], 30.0);
    assert_eq!(left, Ok(Step::Arrived));
    let deeper = left_at(&robot, touching).approach(&[0.0, -40.0, 0.0, 40.0], 30.0);
    let problem = deeper.map_err(|failure| failure.problem);
    assert!(matches!(problem, Err(Problem::Collides(_))), "{problem:?}");
}
