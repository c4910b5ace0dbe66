//! Drives on a simulated bus that fails.

use std::ops::{Deref, DerefMut};
use tip_drives::bus::{Bus, BusError, Timing, Wire};
use tip_drives::drives::{Drives, Failure, Joint, Policy, Problem, Settings};
use tip_drives::dynamixel1::Protocol1;
use tip_drives::dynamixel2::Protocol2;
use tip_drives::family::Setpoint;
use tip_drives::guard::{Host, Request, Step, TorqueGuard};
use tip_drives::model::Model;
use tip_drives::moteus;
use tip_drives::registers::{Framing, instruction};
use tip_drives::simulated::{Faults, MemoryPort, Servo, SimulatedBus};
use tip_runtime::hardware::JointCommand;
use tip_runtime::model::Range;

const MBAUD: Timing = Timing {
    baud: 1_000_000,
    return_delay: 0,
    latency: 2000,
};
/// The timing of a model's bus.
pub(crate) fn timing(model: &Model) -> Timing {
    match model.family.key() {
        // Lines of text are long, and USB is fast.
        "moteus" => Timing {
            baud: 4_000_000,
            ..MBAUD
        },
        "lx" => Timing {
            baud: 115_200,
            ..MBAUD
        },
        _ => MBAUD,
    }
}

/// ms
const PERIOD: f64 = 20.0;

pub(crate) fn joint(id: u8, model: &'static Model) -> Joint {
    Joint {
        id,
        model,
        sign: if id.is_multiple_of(2) { -1.0 } else { 1.0 },
        offset: 0.0,
        gear: 1.0,
        limits: Range::new(-90.0, 90.0),
        speed: 180.0,
        torque: if model.family.limits_torque() {
            0.8
        } else {
            1.0
        },
    }
}

/// Robots of servos of one model, which rest at 0 deg.
pub(crate) fn robot(name: &str, servos: u8, faults: Faults) -> Drives<MemoryPort> {
    robot_with(name, servos, faults, Settings::default())
}

pub(crate) fn robot_with(
    name: &str,
    servos: u8,
    faults: Faults,
    settings: Settings,
) -> Drives<MemoryPort> {
    let model = Model::named(name).expect("a model");
    let joints: Vec<Joint> = (1..=servos).map(|id| joint(id, model)).collect();
    let rest = |joint: &Joint| Servo::new(model, joint.id, joint.counts(0.0).into());
    let timing = timing(model);
    let bus = SimulatedBus::new(joints.iter().map(rest).collect(), timing);
    let port = MemoryPort::new(bus.with_faults(faults, 11));
    let bus = Bus::new(port, timing);
    Drives::new(bus, &joints, settings).expect("not too many")
}

/// The master's side of a simulated bus.
pub(crate) fn bus_of(bus: SimulatedBus, model: &Model) -> Bus<MemoryPort> {
    Bus::new(MemoryPort::new(bus), timing(model))
}

/// An operator who presses nothing, and the torque limits of the first servo at the end of each cycle.
#[derive(Default)]
pub(crate) struct Nobody {
    limits: Vec<f64>,
}

impl Host<MemoryPort> for Nobody {
    fn wait(&mut self, port: &mut MemoryPort, until: u64) {
        port.pass(until);
        self.limits.push(port.bus.servos()[0].torque_limit());
    }

    fn request(&mut self) -> Option<Request> {
        None
    }
}

/// A robot with its guard.
pub(crate) struct Robot(pub(crate) TorqueGuard<MemoryPort, Nobody>);

impl Robot {
    /// Connected drives, with the sampling time in ms.
    pub(crate) fn new(drives: Drives<MemoryPort>, period: f64) -> Self {
        Robot(TorqueGuard::new(drives, Nobody::default(), period))
    }

    pub(crate) fn hold(&mut self) -> Result<(), Failure> {
        self.0.hold().map(drop)
    }

    pub(crate) fn write_cycle(
        &mut self,
        commands: &[JointCommand],
        period: f64,
    ) -> Result<(), Failure> {
        self.0.write_cycle(commands, period)
    }
}

impl Deref for Robot {
    type Target = Drives<MemoryPort>;

    fn deref(&self) -> &Self::Target {
        self.0.drives()
    }
}

impl DerefMut for Robot {
    fn deref_mut(&mut self) -> &mut Self::Target {
        self.0.drives_mut()
    }
}

/// A robot that holds itself.
pub(crate) fn held(name: &str, servos: u8, faults: Faults) -> Robot {
    held_with(robot(name, servos, faults))
}

pub(crate) fn held_with(drives: Drives<MemoryPort>) -> Robot {
    let mut robot = Robot::new(drives, PERIOD);
    robot.connect().expect("all are there");
    // Not long before the first cycle, because of watchdogs.
    robot.bus_mut().port_mut().pass((START - 5) * 20_000);
    robot.hold().expect("all are there");
    robot
}

/// A command to go to a position.
fn goal(joint: &Joint, position: i32) -> Setpoint {
    Setpoint {
        id: joint.id,
        model: joint.model,
        position,
        speed: 180.0,
        torque: 1.0,
        period: PERIOD,
        timeout: Some(200.0),
    }
}

fn wave(cycle: u64) -> f64 {
    30.0 * libm::sin(cycle as f64 * 0.02)
}

/// Runs one cycle on the time grid; returns the problem.
pub(crate) fn cycle(drives: &mut Robot, number: u64, angle: f64) -> Result<(), Problem> {
    let begin = number * (PERIOD * 1000.0) as u64;
    drives.bus_mut().port_mut().pass(begin);
    let commands = vec![JointCommand::at(angle); drives.joints().count()];
    let read = drives.read_cycle();
    let done = read.and_then(|()| drives.write_cycle(&commands, PERIOD));
    done.map_err(|failure| failure.problem)
}

/// Returns the number of joints whose angle of this cycle is not what the servo sent.
fn wrong(drives: &Drives<MemoryPort>, since: u64) -> usize {
    let servos = drives.bus().port().bus.servos();
    let is_wrong = |number: &usize| {
        let measured = drives.measured(*number).expect("settled");
        let reported = servos[*number].reported().expect("asked");
        let difference = measured.counts.abs_diff(reported);
        let joint = drives.joints().nth(*number).expect("a joint");
        let allowed = match joint.model.family.key() {
            "moteus" => moteus::BETWEEN,
            _ => 0,
        };
        measured.at >= since && difference > allowed
    };
    (0..servos.len()).filter(is_wrong).count()
}

pub(crate) const START: u64 = 50;

#[test]
fn each_family_follows_its_commands() {
    for (name, servos) in [
        ("AX-12", 18),
        ("XL430-W250", 12),
        ("STS3215", 12),
        ("LX-16A", 6),
        ("moteus-mj5208", 12),
    ] {
        let mut drives = held(name, servos, Faults::default());
        for number in START..START + 500 {
            cycle(&mut drives, number, wave(number - START)).expect(name);
        }
        let counts = drives.counts();
        assert_eq!((counts.missing, counts.implausible), (0, 0), "{name}");
        for number in 0..usize::from(servos) {
            let angle = drives.angle(number).expect("measured");
            let lag = (angle - wave(499)).abs();
            assert!(lag < 3.0, "{name} {number}: {lag}");
        }
        // The robot has 20 ms; frames of an LX take their time.
        let most = if name == "LX-16A" { 19_000 } else { 12_000 };
        assert!(counts.longest < most, "{name}: {} µs", counts.longest);
    }
}

#[test]
fn servos_of_protocol_2_answer_in_one_frame() {
    let model = Model::named("XM430-W350").expect("a model");
    let joints: Vec<Joint> = (1..=12).map(|id| joint(id, model)).collect();
    let rest = |joint: &Joint| Servo::new(model, joint.id, joint.counts(0.0).into());
    let bus = SimulatedBus::new(joints.iter().map(rest).collect(), MBAUD);
    let bus = Bus::new(MemoryPort::new(bus), MBAUD);
    let settings = Settings {
        fast: true,
        ..Settings::default()
    };
    let mut drives = held_with(Drives::new(bus, &joints, settings).expect("not too many"));
    for number in START..START + 200 {
        cycle(&mut drives, number, wave(number - START)).expect("no fault");
        assert_eq!(wrong(&drives, number * 20_000), 0);
    }
    assert_eq!(drives.counts().missing, 0);
}

/// The bar of a bus: no angle is silently wrong, each fault is counted, and no cycle waits for long.
#[test]
fn no_angle_is_wrong_on_a_bus_that_fails() {
    for (name, servos) in [
        ("AX-12", 12),
        ("XL430-W250", 12),
        ("STS3215", 12),
        ("LX-16A", 6),
        ("moteus-mj5208", 12),
    ] {
        // A late line of a moteus holds up all that follow, for more than a cycle.
        let settings = Settings {
            silence: 20,
            ..Settings::default()
        };
        let faults = Faults::evenly(0.05);
        let mut drives = held_with(robot_with(name, servos, faults, settings));
        for number in START..START + 3000 {
            let (begin, angle) = (number * 20_000, wave(number - START));
            cycle(&mut drives, number, angle).expect(name);
            assert_eq!(wrong(&drives, begin), 0, "{name}, cycle {number}");
        }
        let (counts, happened) = (drives.counts(), drives.bus().port().bus.happened());
        let harmful = happened.corrupt + happened.dropped + happened.truncated;
        let unused = counts.missing + counts.implausible;
        // Those of the beginning are repeated at once. What comes late may still be in time, or meet another answer on the wire.
        assert!(unused + 60 > harmful, "{name}: {counts:?} {happened:?}");
        // After one that is missing, the last that is asked may have no time left, where they are asked one by one.
        let in_a_row = if drives.joints().any(|it| it.model.family.reads_together()) {
            1
        } else {
            2
        };
        let most = in_a_row * harmful + 3 * happened.delayed + happened.duplicated;
        assert!(unused < most, "{name}: {counts:?} {happened:?}");
        assert!(counts.longest < 18_000, "{name}: {} µs", counts.longest);
    }
}

/// Every answer is damaged half of the time. `examples/long_run.rs` does the same with 10⁶ frames.
#[test]
fn damaged_frames_give_no_wrong_angle() {
    let faults = Faults {
        corrupt: 0.5,
        drop: 0.01,
        duplicate: 0.05,
        delay: 0.05,
        truncate: 0.1,
    };
    let (mut frames, mut right) = (0, 0);
    for name in ["AX-12", "XL430-W250", "STS3215", "LX-16A", "moteus-mj5208"] {
        let mut drives = held(name, 12, Faults::default());
        let bus = drives.bus().port().bus.clone();
        drives.bus_mut().port_mut().bus = bus.with_faults(faults, 5);
        let mut number = START;
        while drives.bus().counters().asked < 50_000 {
            number += 1;
            let begin = number * 20_000;
            drives.bus_mut().port_mut().pass(begin);
            // The drives would stop for their silence; the bus is what is tested.
            let _ = drives.read_cycle();
            assert_eq!(wrong(&drives, begin), 0, "{name}, cycle {number}");
        }
        frames += drives.bus().counters().asked;
        right += drives.bus().counters().answered;
    }
    assert!(frames > 200_000 && right > 60_000, "{frames} {right}");
}

#[test]
fn a_silent_servo_is_held_and_then_stops_the_robot() {
    let mut drives = held("STS3215", 12, Faults::default());
    for number in START..START + 50 {
        cycle(&mut drives, number, 0.0).expect("well");
    }
    drives.bus_mut().port_mut().bus.unplug(7);
    let silence = u64::from(drives.settings().silence);
    for number in START + 50..START + 50 + silence {
        cycle(&mut drives, number, 0.0).expect("held");
    }
    let stopped = cycle(&mut drives, START + 50 + silence, 0.0);
    assert_eq!(stopped, Err(Problem::Silent));
    let failure = drives.failure().expect("a failure");
    assert_eq!(failure.joint, Some(6));
    assert_eq!(drives.counts().missing, silence + 1);
    // The seventh joint is the first of the third leg of three joints, and the third of the second one of four.
    let faults = [3, 4].map(|of_leg| failure.fault(of_leg).to_string());
    let [of_three, of_four] =
        ["J31", "J23"].map(|joint| format!("{joint} (servo 7): does not answer"));
    assert_eq!(faults, [of_three, of_four]);
}

/// Runs until a problem, and returns it with the number of cycles before it.
fn until_problem(drives: &mut Robot) -> (Problem, u64) {
    for number in 0..1000 {
        if let Err(problem) = cycle(drives, START + 1 + number, wave(number)) {
            return (problem, number);
        }
    }
    panic!("no problem");
}

#[test]
fn a_servo_that_was_reset_is_noticed_by_its_torque() {
    for name in ["AX-12", "STS3215"] {
        let mut drives = held(name, 12, Faults::default());
        cycle(&mut drives, START, 0.0).expect("well");
        drives.bus_mut().port_mut().bus.reset(4);
        let (problem, cycles) = until_problem(&mut drives);
        assert_eq!(problem, Problem::Reset, "{name}");
        // Each third answer tells, and two are needed.
        assert!(cycles <= 12, "{name}: {cycles}");
    }
    // The torque limit of a servo with all its torque is what it has after a reset, and a goal switches its torque on again: its
    // speed limit tells.
    let model = Model::named("AX-12").expect("a model");
    let full = Joint {
        torque: 1.0,
        ..joint(1, model)
    };
    let servo = Servo::new(model, 1, full.counts(0.0).into());
    let bus = bus_of(SimulatedBus::new(vec![servo], timing(model)), model);
    let mut drives = held_with(Drives::new(bus, &[full], Settings::default()).expect("one"));
    cycle(&mut drives, START, 0.0).expect("well");
    drives.bus_mut().port_mut().bus.reset(1);
    let (problem, cycles) = until_problem(&mut drives);
    assert_eq!(problem, Problem::Reset);
    assert!(cycles <= 12, "{cycles}");
    // Its window does not hold the torque: it is noticed when it stays behind.
    let mut drives = held("XL430-W250", 12, Faults::default());
    cycle(&mut drives, START, 0.0).expect("well");
    drives.bus_mut().port_mut().bus.reset(4);
    let (problem, _) = until_problem(&mut drives);
    assert!(matches!(problem, Problem::Lags(_)), "{problem:?}");
}

#[test]
fn a_hot_servo_stops_the_robot() {
    for name in ["AX-12", "XL430-W250", "STS3215", "LX-16A", "moteus-mj5208"] {
        let mut drives = held(name, 6, Faults::default());
        cycle(&mut drives, START, 0.0).expect("well");
        drives.bus_mut().port_mut().bus.overheat(2);
        let (problem, _) = until_problem(&mut drives);
        assert!(matches!(problem, Problem::Hot(it) if it > 65.0), "{name}");
        assert_eq!(drives.failure().expect("a failure").joint, Some(1));
    }
}

/// Bit 2 of the error byte of an AX is its temperature alarm. A servo takes seconds to get hot.
#[test]
fn each_servo_with_an_alarm_is_known() {
    let settings = Settings {
        temperature: 120.0,
        ..Settings::default()
    };
    let mut drives = robot_with("AX-12", 4, Faults::default(), settings);
    drives.connect().expect("well");
    let bus = &mut drives.bus_mut().port_mut().bus;
    bus.overheat(2);
    bus.overheat(4);
    let mut found = None;
    for number in START..START + 250 {
        drives.bus_mut().port_mut().pass(number * 20_000);
        found = drives.read_cycle().err();
        drives.clear_failure();
    }
    let failure = found.expect("two alarms");
    assert_eq!(failure.problem, Problem::Alarm(4));
    let alarms: Vec<_> = (0..4).map(|joint| drives.alarm(joint)).collect();
    assert_eq!(alarms, [Some(0), Some(4), Some(0), Some(4)]);
    assert_eq!(drives.alarm(4), None);
}

#[test]
fn commands_are_limited_in_angle_and_in_step() {
    let mut drives = held("STS3215", 2, Faults::default());
    let mut before = 0.0;
    for number in START..START + 60 {
        cycle(&mut drives, number, 170.0).expect("well");
        let angle = drives.angle(0).expect("measured");
        // 180 deg/s for 20 ms, and a count for the encoder.
        assert!(angle - before < 3.6 + 0.1, "{before} {angle}");
        assert!(angle < 90.1, "{angle}");
        before = angle;
    }
    assert!(before > 89.0, "{before}");
    assert!(drives.counts().clipped > 100 && drives.counts().slowed > 40);
}

#[test]
fn a_joint_without_torque_may_be_turned_by_hand() {
    let mut drives = robot("STS3215", 1, Faults::default());
    drives.connect().expect("it is there");
    let joint = *drives.joints().next().expect("one");
    // Another master is the hand.
    let held = joint
        .model
        .family
        .hold(drives.bus_mut(), &goal(&joint, 3000));
    held.expect("held");
    for number in START..START + 100 {
        drives.bus_mut().port_mut().pass(number * 20_000);
        drives.read_cycle().expect("nothing is commanded");
    }
    assert!(drives.angle(0).expect("measured") > 80.0);
}

#[test]
fn no_torque_can_be_commanded() {
    let mut drives = held("STS3215", 1, Faults::default());
    let refused = drives.write_cycle(&[JointCommand::Torque(1.0)], PERIOD);
    assert_eq!(refused.map_err(|it| it.problem), Err(Problem::Torque));
}

/// A joint goes 3.6 deg in a cycle of 20 ms at 180 deg/s. Register 42 of an STS is its goal.
#[test]
fn a_joint_beside_one_with_a_torque_does_not_count_as_commanded() {
    let mut drives = held("STS3215", 2, Faults::default());
    let to = JointCommand::at(60.0);
    let refused = drives.write_cycle(&[to, JointCommand::Torque(1.0)], PERIOD);
    let failure = refused.expect_err("a torque");
    assert_eq!((failure.joint, failure.problem), (Some(1), Problem::Torque));
    drives
        .write_cycle(&[to, JointCommand::at(0.0)], PERIOD)
        .expect("two angles");
    let goal = drives.joints().next().map(|joint| joint.counts(3.6));
    let goal = goal.expect("a joint") as u32;
    let servo = &drives.bus_mut().port_mut().bus.servos()[0];
    assert_eq!(servo.register(42, 2), Some(goal));
}

#[test]
fn the_start_is_slow() {
    let mut drives = held("AX-12", 18, Faults::default());
    let to = [45.0; 18];
    let mut cycles = 0;
    while drives.0.step(&to, 30.0) == Ok(Step::Moving) {
        cycles += 1;
    }
    // 45 deg at 30 deg/s.
    assert!((74..=77).contains(&cycles), "{cycles}");
}

#[test]
fn an_end_holds_or_relaxes() {
    let mut drives = held("STS3215", 3, Faults::default());
    for number in START..START + 20 {
        cycle(&mut drives, number, 20.0).expect("well");
    }
    drives.0.stop_cycle().expect("sent");
    drives.bus_mut().port_mut().pass((START + 100) * 20_000);
    let bus = &drives.bus().port().bus;
    assert!(
        bus.servos()
            .iter()
            .all(|servo| servo.has_torque() && servo.velocity() == 0.0)
    );

    let settings = Settings {
        at_end: Policy::Relax,
        ..Settings::default()
    };
    let mut drives = held_with(robot_with("STS3215", 3, Faults::default(), settings));
    for number in START..START + 20 {
        cycle(&mut drives, number, 20.0).expect("well");
    }
    drives.0.leave();
    let limits = &drives.0.host_mut().limits;
    // In 2 s, from 0.8 of the torque; the last of 100 cycles switches it off.
    assert_eq!(limits.len(), 99);
    assert!(limits.is_sorted_by(|a, b| a > b), "{limits:?}");
    let bus = &drives.bus().port().bus;
    assert!(bus.servos().iter().all(|servo| !servo.has_torque()));
}

#[test]
fn a_servo_with_a_watchdog_stops_without_its_host() {
    let mut drives = held("XL430-W250", 3, Faults::default());
    cycle(&mut drives, START, 0.0).expect("well");
    // The last command leads far away, as one of a faulty host would.
    let goals: Vec<Setpoint> = drives.joints().map(|joint| goal(joint, 4000)).collect();
    let family = goals[0].model.family;
    let sent = family.write_goals(drives.bus_mut(), &goals);
    sent.expect("sent");
    let port = drives.bus_mut().port_mut();
    let killed = (START + 1) * 20_000;
    // Its time-out is 10 cycles.
    port.pass(killed + 250_000);
    let stopped = port.bus.servos()[0].position();
    port.pass(killed + 2_000_000);
    assert!((port.bus.servos()[0].position() - stopped).abs() < 1.0);
    assert!(stopped < 3500.0, "{stopped}");
}

/// A moteus follows again after a stop only, which the next host sends when it takes over.
#[test]
fn a_moteus_that_timed_out_is_taken_over_by_the_next_host() {
    let mut drives = held("moteus-mj5208", 3, Faults::default());
    cycle(&mut drives, START, 20.0).expect("well");
    let killed = START * 20_000;
    drives.bus_mut().port_mut().pass(killed + 2_000_000);
    let servo = &drives.bus().port().bus.servos()[0];
    let limp = !servo.has_torque();
    assert!(limp && servo.velocity() == 0.0);
    // The old host would see that nothing follows.
    let late = START + 110;
    let noticed = cycle(&mut drives, late, 20.0);
    assert_eq!(noticed, Err(Problem::TimedOut(200.0)));

    let port = drives.bus().port().clone();
    let joints: Vec<Joint> = drives.joints().copied().collect();
    let bus = Bus::new(port, drives.bus().timing());
    let next = Drives::new(bus, &joints, Settings::default()).expect("three");
    let mut next = Robot::new(next, PERIOD);
    next.connect().expect("a time-out is no fault");
    next.hold().expect("well");
    for number in 0..100 {
        cycle(&mut next, late + 10 + number, 20.0).expect("well");
    }
    assert!((next.angle(0).expect("measured") - 20.0).abs() < 0.5);
}

#[test]
fn another_model_or_a_missing_servo_is_refused() {
    let model = Model::named("STS3215").expect("a model");
    let missing = {
        let bus = SimulatedBus::new(vec![Servo::new(model, 1, 2048.0)], MBAUD);
        let bus = Bus::new(MemoryPort::new(bus), MBAUD);
        let joints = [joint(1, model), joint(2, model)];
        let drives = Drives::new(bus, &joints, Settings::default());
        drives.expect("two").connect().expect_err("one is missing")
    };
    assert_eq!((missing.joint, missing.problem), (Some(1), Problem::Silent));
    let (mx, ax) = (
        Model::named("MX-28").unwrap(),
        Model::named("AX-12").unwrap(),
    );
    let bus = SimulatedBus::new(vec![Servo::new(mx, 1, 512.0)], MBAUD);
    let bus = Bus::new(MemoryPort::new(bus), MBAUD);
    let drives = Drives::new(bus, &[joint(1, ax)], Settings::default());
    let other = drives.expect("one").connect().expect_err("another model");
    assert_eq!(other.problem, Problem::Model(29));
}

/// Writes a register as another master would.
pub(crate) fn write(drives: &mut Drives<MemoryPort>, id: u8, address: u16, value: &[u8]) {
    let family = drives.family().expect("servos").key();
    let framing: &dyn Framing = if family == "x" {
        &Protocol2
    } else {
        &Protocol1
    };
    let mut parameters = address.to_le_bytes()[..framing.word()].to_vec();
    parameters.extend(value);
    let request = framing.request(id, instruction::WRITE, &parameters);
    let sent = drives.bus_mut().send(&request.expect("short"));
    sent.expect("sent");
}

#[test]
fn a_scan_finds_servos_and_an_identity_can_be_set() {
    for name in ["AX-12", "XL430-W250", "STS3215", "HTS-35H", "moteus-qdd100"] {
        let model = Model::named(name).expect("a model");
        let servos = vec![Servo::new(model, 3, 500.0), Servo::new(model, 9, 500.0)];
        let port = MemoryPort::new(SimulatedBus::new(servos, timing(model)));
        let mut bus = Bus::new(port, timing(model));
        let family = model.family;
        let mut found = Vec::new();
        for id in 0..20 {
            if let Ok(number) = family.identify(&mut bus, id) {
                found.push((id, number));
            }
        }
        assert_eq!(found, [(3, model.number), (9, model.number)], "{name}");
        let renamed = family.set_id(&mut bus, 9, 5);
        if family.key() == "moteus" {
            // The maker's tool does that.
            assert_eq!(renamed, Err(BusError::Unsupported));
            continue;
        }
        renamed.expect(name);
        assert_eq!(family.identify(&mut bus, 9), Err(BusError::NoAnswer));
        assert_eq!(family.identify(&mut bus, 5), Ok(model.number), "{name}");
    }
}
