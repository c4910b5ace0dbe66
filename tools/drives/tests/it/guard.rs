//! A robot ends in the state that its settings name, however the life of its guard ends: the torque of its servos is read afterwards.

use embedded_io::{ErrorType, Read, Write};
use std::cell::RefCell;
use std::convert::Infallible;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::rc::Rc;
use tip_drives::bus::{Bus, Port, Timing, Wire};
use tip_drives::drives::{Drives, Failure, Joint, Policy, Problem, Settings};
use tip_drives::guard::{Host, LEAVING_LIMIT, Request, Step, TorqueGuard};
use tip_drives::model::Model;
use tip_drives::simulated::{Faults, MemoryPort, Servo, SimulatedBus};
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, JointCommand, Outputs, Sensors};
use tip_runtime::model::Range;

/// A servo of each family.
const MODELS: [&str; 5] = ["AX-12", "XL430-W250", "STS3215", "LX-16A", "moteus-mj5208"];
/// Policies at the end and in an emergency.
const POLICIES: [(Policy, Policy); 2] =
    [(Policy::Relax, Policy::Hold), (Policy::Hold, Policy::Relax)];
/// Joints of a robot.
const JOINTS: usize = 3;
/// ms
const PERIOD: f64 = 20.0;

/// A port that the test sees, too, and that outlives the guard.
#[derive(Clone)]
struct SharedPort(Rc<RefCell<MemoryPort>>);

impl ErrorType for SharedPort {
    type Error = Infallible;
}

impl Read for SharedPort {
    fn read(&mut self, into: &mut [u8]) -> Result<usize, Infallible> {
        self.0.borrow_mut().read(into)
    }
}

impl Write for SharedPort {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        self.0.borrow_mut().write(bytes)
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().flush()
    }
}

impl Port for SharedPort {
    fn now(&mut self) -> u64 {
        self.0.borrow_mut().now()
    }

    fn wait(&mut self, until: u64) -> Result<bool, Infallible> {
        self.0.borrow_mut().wait(until)
    }
}

/// An operator who presses a key when the host is asked for the n-th time.
struct Operator {
    asked: usize,
    presses: (usize, Request),
}

impl Host<SharedPort> for Operator {
    fn wait(&mut self, port: &mut SharedPort, until: u64) {
        port.0.borrow_mut().pass(until);
    }

    fn request(&mut self) -> Option<Request> {
        self.asked += 1;
        (self.asked == self.presses.0).then_some(self.presses.1)
    }
}

type Robot = TorqueGuard<SharedPort, Operator>;

/// Robots whose joints rest at 0 deg.
fn robot(model: &str, policies: (Policy, Policy), presses: (usize, Request)) -> Robot {
    robot_with(model, policies, presses, Settings::default())
}

/// Robots with these settings, but for their policies.
fn robot_with(
    model: &str,
    policies: (Policy, Policy),
    presses: (usize, Request),
    settings: Settings,
) -> Robot {
    let model = Model::named(model).expect("a model");
    let joints: Vec<Joint> = (1..=JOINTS as u8)
        .map(|id| Joint {
            id,
            model,
            sign: 1.0,
            offset: 0.0,
            gear: 1.0,
            limits: Range::new(-90.0, 90.0),
            speed: 180.0,
            torque: if model.family.limits_torque() {
                0.8
            } else {
                1.0
            },
        })
        .collect();
    let rest = |joint: &Joint| Servo::new(model, joint.id, joint.counts(0.0).into());
    let timing = Timing {
        // Lines of a moteus are long, and USB is fast.
        baud: 4_000_000,
        return_delay: 0,
        latency: 2000,
    };
    let bus = SimulatedBus::new(joints.iter().map(rest).collect(), timing);
    let settings = Settings {
        at_end: policies.0,
        in_emergency: policies.1,
        ..settings
    };
    let port = SharedPort(Rc::new(RefCell::new(MemoryPort::new(bus))));
    let bus = Bus::new(port, timing);
    let drives = Drives::new(bus, &joints, settings).expect("few");
    let operator = Operator { asked: 0, presses };
    let mut robot = TorqueGuard::new(drives, operator, PERIOD);
    robot.connect().expect(model.name);
    robot
}

/// A key that nobody presses.
const NEVER: (usize, Request) = (usize::MAX, Request::End);

/// Lets something happen to the servos.
fn with_bus<T>(robot: &Robot, act: impl FnOnce(&mut SimulatedBus) -> T) -> T {
    act(&mut robot.drives().bus().port().0.borrow_mut().bus)
}

fn now(robot: &mut Robot) -> u64 {
    robot.drives_mut().bus_mut().now()
}

/// Returns the identities of servos with torque, after some time without the host.
fn stiff(port: &SharedPort) -> Vec<u8> {
    let mut port = port.0.borrow_mut();
    let later = port.now() + 5_000_000;
    port.pass(later);
    let on = port.bus.servos().iter().filter(|servo| servo.has_torque());
    on.map(Servo::id).collect()
}

fn stiff_of(robot: &Robot) -> Vec<u8> {
    stiff(robot.drives().bus().port())
}

fn wanted(policy: Policy) -> Vec<u8> {
    match policy {
        Policy::Hold => (1..=JOINTS as u8).collect(),
        Policy::Relax => Vec::new(),
    }
}

/// Minutes may pass between the question of a run and its key, and hands turn joints meanwhile.
#[test]
fn a_joint_that_was_turned_since_the_connection_is_held_where_it_is() {
    for model in MODELS {
        let mut robot = robot(model, POLICIES[0], NEVER);
        with_bus(&robot, |bus| bus.turn(2, 40.0));
        assert_eq!(robot.hold(), Ok(Step::Moving), "{model}");
        with_bus(&robot, |bus| {
            let servo = &bus.servos()[1];
            let own = Model::named(model).expect("a model");
            let degree = own.turn / 360.0;
            let away = (servo.goal() - servo.position()).abs() / degree;
            assert!(away < 1.0, "{model}: sent {away} deg away");
            let turned = servo.position() - own.counts(0.0);
            assert!(
                (turned / degree - 40.0).abs() < 2.0,
                "{model}: it stays there"
            );
        });
    }
}

/// Its limits are 90 deg. Nothing has torque, so that nothing is left.
#[test]
fn a_joint_that_was_turned_beyond_its_limits_is_not_held() {
    for model in MODELS {
        let mut robot = robot(model, POLICIES[1], NEVER);
        with_bus(&robot, |bus| bus.turn(2, 110.0));
        let failure = robot.hold().expect_err(model);
        let Problem::Outside(angle) = failure.problem else {
            panic!("{model}: {failure:?}");
        };
        assert!((angle - 110.0).abs() < 2.0, "{model}: {angle} deg");
        assert_eq!(failure.joint, Some(1), "{model}");
        assert!(!robot.has_torque() && robot.outcome().is_none(), "{model}");
        assert_eq!(stiff_of(&robot), [0; 0], "{model}");
    }
}

/// The operator may press a key in any cycle of the approach; it ends within this cycle.
#[test]
fn a_request_in_any_cycle_of_the_approach_is_obeyed_in_it() {
    let to = [10.0; JOINTS];
    for model in MODELS {
        for policies in POLICIES {
            for request in [Request::End, Request::EmergencyStop] {
                // 3 while the torque comes on, 17 on the way, 15 until it has settled.
                for asked in 1..35 {
                    let what = format!("{model} {policies:?} {request:?} {asked}");
                    let mut robot = robot(model, policies, (asked, request));
                    let begin = now(&mut robot);
                    let step = robot.approach(&to, 30.0).expect("well");
                    assert_eq!(step, Step::Left(request), "{what}");
                    let policy = match request {
                        Request::End => policies.0,
                        Request::EmergencyStop => policies.1,
                    };
                    let time = now(&mut robot) - begin;
                    let relaxing = if policy == Policy::Relax {
                        2_000_000
                    } else {
                        0
                    };
                    let cycles = (asked as u64 + 3) * (PERIOD * 1000.0) as u64;
                    assert!(time < relaxing + cycles, "{what}: {time} µs");
                    // Those that had torque have what is wanted, the others were never switched on.
                    let on = asked.saturating_sub(1).min(JOINTS);
                    let wanted = &wanted(policy)[..on.min(wanted(policy).len())];
                    assert_eq!(stiff_of(&robot), wanted, "{what}");
                    let outcome = robot.outcome().expect("left");
                    let limp: Vec<usize> = match policy {
                        Policy::Hold => (on..JOINTS).collect(),
                        Policy::Relax => Vec::new(),
                    };
                    assert_eq!(outcome.other[..], limp[..], "{what}: they were to hold");
                    assert!(outcome.unknown.is_empty(), "{what}");
                }
            }
        }
    }
}

#[test]
fn an_emergency_stop_in_any_cycle_of_leaving_changes_the_state() {
    for model in MODELS {
        for policies in POLICIES {
            // Asked 35 times before it has arrived.
            for asked in [36, 37, 38, 60, 100, 130] {
                let what = format!("{model} {policies:?} {asked}");
                let mut robot = robot(model, policies, (asked, Request::EmergencyStop));
                robot.approach(&[10.0; JOINTS], 30.0).expect("well");
                robot.leave();
                let was_pressed = robot.host_mut().asked >= asked;
                assert_eq!(robot.is_stopped(), was_pressed, "{what}");
                let policy = if was_pressed { policies.1 } else { policies.0 };
                assert_eq!(stiff_of(&robot), wanted(policy), "{what}");
                if policy == Policy::Hold {
                    // An LX servo has no torque limit.
                    let full = if model == "LX-16A" { 1.0 } else { 0.8 };
                    with_bus(&robot, |bus| {
                        for limit in bus.servos().iter().map(Servo::torque_limit) {
                            assert!((limit - full).abs() < 0.01, "{what}: {limit}");
                        }
                    });
                }
            }
        }
    }
}

/// A machine stops the robot, its host panics, or nobody says how it ends.
#[test]
fn a_stopped_machine_and_a_panic_leave_the_robot_as_in_an_emergency() {
    for model in MODELS {
        for policies in POLICIES {
            let approached = || {
                let mut robot = robot(model, policies, NEVER);
                robot.approach(&[10.0; JOINTS], 30.0).expect("well");
                robot
            };
            let what = format!("{model} {policies:?}");
            let mut stopped = approached();
            let stop = Hardware::<1, JOINTS>::stop(&mut stopped, &Fault::EmergencyKey);
            assert_eq!(stop, Ok(()), "{what}");
            stopped.leave();
            assert_eq!(stiff_of(&stopped), wanted(policies.1), "{what}");

            for ends in [drop::<Robot>, |robot| {
                let panicked = catch_unwind(AssertUnwindSafe(move || {
                    let _robot = robot;
                    resume_unwind(Box::new("the host"));
                }));
                assert!(panicked.is_err());
            }] {
                let robot = approached();
                let port = robot.drives().bus().port().clone();
                ends(robot);
                assert_eq!(stiff(&port), wanted(policies.1), "{what}");
            }
        }
    }
}

#[test]
fn a_machine_moves_only_a_robot_that_is_held() {
    let mut robot = robot("STS3215", POLICIES[0], NEVER);
    let mut sensors = Sensors::<1, JOINTS>::ZERO;
    let outputs = Outputs {
        joints: [[JointCommand::at(5.0); JOINTS]],
        slider: [0.0; 3],
        lamps: [0; 8],
        period: PERIOD,
    };
    let refused = |robot: &mut Robot, sensors: &mut Sensors<1, JOINTS>| {
        let (read, written) = (robot.read(sensors), robot.write(&outputs));
        let words = Problem::NotHeld.words();
        read.is_err_and(|it| it.cause == words) && written.is_err_and(|it| it.cause == words)
    };
    assert!(refused(&mut robot, &mut sensors), "before");
    robot.approach(&[0.0; JOINTS], 30.0).expect("well");
    for _ in 0..50 {
        robot.read(&mut sensors).expect("held");
        robot.write(&outputs).expect("held");
        robot.wait();
    }
    let [angles] = sensors.angles;
    assert!(
        angles.iter().all(|angle| (angle - 5.0).abs() < 0.5),
        "{angles:?}"
    );
    robot.leave();
    assert!(refused(&mut robot, &mut sensors), "after");
    // A second time changes nothing.
    let outcome = robot.outcome().cloned();
    robot.emergency_stop();
    robot.leave();
    assert_eq!(robot.outcome().cloned(), outcome);
}

/// One of five answers and commands is lost or damaged: the last command of each servo is repeated until it is confirmed.
#[test]
fn a_bus_that_fails_does_not_leave_a_servo_behind() {
    for model in MODELS {
        for policies in POLICIES {
            let mut robot = robot(model, policies, NEVER);
            robot.approach(&[10.0; JOINTS], 30.0).expect("well");
            with_bus(&robot, |bus| {
                *bus = bus.clone().with_faults(Faults::evenly(0.2), 5);
            });
            robot.leave();
            let what = format!("{model} {policies:?}");
            assert!(robot.outcome().expect("left").is_certain(), "{what}");
            assert_eq!(stiff_of(&robot), wanted(policies.0), "{what}");
        }
    }
}

#[test]
fn a_servo_that_is_gone_is_unknown_after_a_bounded_time() {
    for model in MODELS {
        for policies in POLICIES {
            let mut robot = robot(model, policies, NEVER);
            robot.approach(&[10.0; JOINTS], 30.0).expect("well");
            with_bus(&robot, |bus| bus.unplug(2));
            let begin = now(&mut robot);
            robot.leave();
            let time = now(&mut robot) - begin;
            assert!(time < 2_500_000 + LEAVING_LIMIT, "{model}: {time} µs");
            let outcome = robot.outcome().expect("left");
            assert_eq!(
                (&outcome.other[..], &outcome.unknown[..]),
                (&[][..], &[1][..])
            );
            // The others have their state.
            let others = wanted(policies.0);
            let others: Vec<u8> = others.into_iter().filter(|id| *id != 2).collect();
            let mut found = stiff_of(&robot);
            found.retain(|id| *id != 2);
            assert_eq!(found, others, "{model} {policies:?}");
        }
    }
}

/// An obstacle on the way: the failure is reported, and the robot is left as in an emergency.
#[test]
fn a_failure_on_the_way_leaves_the_robot_as_in_an_emergency() {
    // An LX servo does not tell its load, but that it stays behind.
    for (model, problem) in [
        ("AX-12", "overloaded"),
        ("STS3215", "overloaded"),
        ("LX-16A", "follow"),
    ] {
        for policies in POLICIES {
            let mut robot = robot(model, policies, NEVER);
            with_bus(&robot, |bus| bus.block(2));
            let failure = robot.approach(&[80.0; JOINTS], 60.0).expect_err("blocked");
            assert_eq!(failure.joint, Some(1), "{model}");
            assert!(failure.to_string().contains(problem), "{model}: {failure}");
            assert_eq!(stiff_of(&robot), wanted(policies.1), "{model} {policies:?}");
            assert!(!robot.has_torque());
        }
    }
}

/// Lets the host or a servo be away between two cycles, and returns the failure of the cycles that follow.
fn away(robot: &mut Robot, absence: impl FnOnce(&mut Robot)) -> Option<Failure> {
    let commands = [JointCommand::at(10.0); JOINTS];
    let mut absence = Some(absence);
    (0..60).find_map(|cycle| {
        if cycle == 20 {
            absence.take().expect("once")(robot);
        }
        let read = robot.read_cycle();
        let done = read.and_then(|()| robot.write_cycle(&commands, PERIOD));
        robot.wait();
        done.err()
    })
}

/// Servos with a watchdog refuse goals after ten cycles without their host, however soon it comes back. Those without one are
/// commanded again, but not after three times `silence`: a robot that goes on then surprises.
#[test]
fn a_host_that_was_away_goes_on_only_with_servos_that_follow() {
    for model in MODELS {
        let is_watched = matches!(model, "XL430-W250" | "moteus-mj5208");
        for policies in POLICIES {
            for (silence, time) in [(5, 100), (20, 170), (20, 240), (20, 600), (20, 3000)] {
                let what = format!("{model} {policies:?} {silence} {time}");
                let settings = Settings {
                    silence,
                    ..Settings::default()
                };
                let mut robot = robot_with(model, policies, NEVER, settings);
                robot.approach(&[10.0; JOINTS], 30.0).expect("well");
                let failure = away(&mut robot, |robot| {
                    let until = now(robot) + time * 1000;
                    robot.drives().bus().port().0.borrow_mut().pass(until);
                });
                let expected = match (is_watched, time) {
                    (_, ..200) => None,
                    (true, _) => Some(Problem::TimedOut(200.0)),
                    // 60 cycles are 1.2 s.
                    (false, 3000) => Some(Problem::NotRead(150)),
                    (false, _) => None,
                };
                let problem = failure.map(|failure| failure.problem);
                match (problem, expected) {
                    (Some(Problem::NotRead(cycles)), Some(Problem::NotRead(about))) => {
                        assert!((about..about + 3).contains(&cycles), "{what}: {cycles}");
                    }
                    _ => assert_eq!(problem, expected, "{what}"),
                }
                if expected.is_some() {
                    assert_eq!(failure.and_then(|it| it.servo), Some(1), "{what}");
                    robot.emergency_stop();
                    robot.leave();
                    let outcome = robot.outcome().expect("left").clone();
                    assert!(outcome.is_certain(), "{what}: {outcome:?}");
                    assert_eq!(stiff_of(&robot), wanted(policies.1), "{what}");
                    // No watchdog stops them any more.
                    with_bus(&robot, |bus| {
                        let servos = bus.servos().iter();
                        let stopped = servos.filter(|servo| {
                            let watchdog = servo.register(98, 1);
                            model == "XL430-W250" && watchdog != Some(0) || servo.mode() == Some(11)
                        });
                        assert_eq!(stopped.count(), 0, "{what}");
                    });
                }
            }
        }
    }
}

/// The line to one servo is interrupted for longer than its time-out, and shorter than `silence`.
#[test]
fn a_servo_that_was_away_for_its_time_out_stops_the_robot() {
    for model in MODELS {
        for (time, is_stopped) in [(100, false), (400, true)] {
            let settings = Settings {
                silence: 40,
                ..Settings::default()
            };
            let mut robot = robot_with(model, POLICIES[0], NEVER, settings);
            robot.approach(&[10.0; JOINTS], 30.0).expect("well");
            let commands = [JointCommand::at(10.0); JOINTS];
            let failure = (0..80).find_map(|cycle| {
                match cycle * 20 {
                    200 => with_bus(&robot, |bus| bus.unplug(2)),
                    at if at == 200 + time => with_bus(&robot, |bus| bus.plug(2)),
                    _ => {}
                }
                let read = robot.read_cycle();
                let done = read.and_then(|()| robot.write_cycle(&commands, PERIOD));
                robot.wait();
                done.err()
            });
            let is_watched = matches!(model, "XL430-W250" | "moteus-mj5208");
            let expected =
                (is_watched && is_stopped).then_some((Some(2), Problem::TimedOut(200.0)));
            let found = failure.map(|failure| (failure.servo, failure.problem));
            assert_eq!(found, expected, "{model} {time}");
        }
    }
}
