//! The operator of a robot: signals of this process, and the names of servos that are not as they were to be left.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use tip_drives::TorqueGuard;
use tip_drives::described::{self, Described};
use tip_drives::drives::Policy;
use tip_drives::guard::{Request, Step};
use tip_drives::operator::{self, Operator};
use tip_drives::port::AnyPort;
use tip_drives::simulated::MemoryPort;

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
    let description = described::read("robot.toml", text.as_bytes()).expect("right");
    Described::new(&description).expect("it has a bus")
}

/// Connects to the simulated servos of a robot whose program writes its signals here.
fn connected(robot: &Described, signal: &Arc<AtomicUsize>) -> TorqueGuard<AnyPort, Operator> {
    let port = AnyPort::Memory(Box::new(MemoryPort::new(robot.simulated())));
    let drives = robot.drives(port).expect("right");
    let operator = Operator::of_signals(Arc::clone(signal));
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
