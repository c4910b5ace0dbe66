//! What is checked before a robot moves: its description, the settings of its servos, the load of its bus, and the sampling time.

use crate::drives::{Robot, START, bus_of, held, joint, robot, robot_with, timing, write};
use embedded_io::{ErrorType, Read, Write};
use std::convert::Infallible;
use tip_drives::bus::{Bus, Port, Timing, Wire};
use tip_drives::drives::{Drives, Invalid, Joint, Problem, Settings};
use tip_drives::lx;
use tip_drives::model::Model;
use tip_drives::simulated::{Faults, MemoryPort, Servo, SimulatedBus};
use tip_runtime::hardware::JointCommand;
use tip_runtime::model::Range;

/// Returns a robot of one servo whose joint goes from -90 to 90 deg.
fn one(model: &'static Model, servo: Servo) -> Drives<MemoryPort> {
    let bus = SimulatedBus::new(vec![servo], timing(model));
    let drives = Drives::new(bus_of(bus, model), &[joint(1, model)], Settings::default());
    drives.expect("a robot")
}

/// Connects a robot of one servo, and returns register, value and wanted value of what is wrong.
fn mismatch(drives: &mut Drives<MemoryPort>) -> Option<(u16, i32, i32)> {
    match drives.connect() {
        Ok(()) => None,
        Err(failure) => {
            assert_eq!((failure.joint, failure.servo), (Some(0), Some(1)));
            let Problem::Register(wrong) = failure.problem else {
                panic!("{failure:?}");
            };
            assert!(!wrong.name.is_empty());
            Some((wrong.register, wrong.value, wrong.wanted))
        }
    }
}

/// Addresses, and the values that change the meaning of a goal, by the makers' tables. 90 deg are 307 counts of an AX and 1024 of
/// the others, from the middle at 512 and 2048.
#[test]
fn each_register_that_changes_a_goal_stops_the_start() {
    for (name, set, expected) in [
        // A wheel; limits of its own; answers to reading only.
        ("AX-12", &[(8, 0)][..], (8, 0, 1023)),
        ("AX-12", &[(8, 818)], (8, 818, 1023)),
        ("AX-12", &[(6, 206)], (6, 206, 0)),
        ("AX-12", &[(16, 1)], (16, 1, 2)),
        // Turns are counted.
        ("MX-28", &[(6, 4095), (8, 4095)], (6, 4095, 0)),
        ("MX-28", &[(8, 3071)], (8, 3071, 4095)),
        ("XL430-W250", &[(11, 4)], (11, 4, 3)),
        ("XL430-W250", &[(11, 1)], (11, 1, 3)),
        ("XL430-W250", &[(10, 1)], (10, 1, 0)),
        // The torque comes with a goal, which changes none: it stays.
        ("XL430-W250", &[(10, 12)], (10, 12, 8)),
        ("XL430-W250", &[(20, 100)], (20, 100, 0)),
        ("XL430-W250", &[(20, -100)], (20, -100, 0)),
        ("XL430-W250", &[(48, 3071)], (48, 3071, 4095)),
        ("XL430-W250", &[(52, 1025)], (52, 1025, 0)),
        ("STS3215", &[(33, 1)], (33, 1, 0)),
        ("STS3215", &[(30, 2)], (30, 2, 1)),
        // Bit 11 is the sign.
        ("STS3215", &[(31, 85)], (31, 85, 0)),
        ("STS3215", &[(31, 2048 + 85)], (31, -85, 0)),
        // The servo of the report: 4.2 deg to both sides.
        ("STS3215", &[(9, 2000), (11, 2096)], (11, 2096, 4095)),
        ("STS3215", &[(9, 1025)], (9, 1025, 0)),
        ("STS3215", &[(8, 0)], (8, 0, 1)),
    ] {
        let model = Model::named(name).expect("a model");
        let servo = Servo::of(name, 1, model.middle);
        let servo = set.iter().fold(servo, |servo, (address, value)| {
            servo.with(*address, *value)
        });
        let found = mismatch(&mut one(model, servo));
        assert_eq!(found, Some(expected), "{name} {set:?}");
    }
    // An X forgets this one without power.
    let model = Model::named("XL430-W250").expect("a model");
    let mut drives = one(model, Servo::of("XL430-W250", 1, 2048.0));
    write(&mut drives, 1, 68, &[1]);
    assert_eq!(mismatch(&mut drives), Some((68, 1, 2)));
}

/// Limits of a servo that are exactly those of its joint, and settings that change no goal.
#[test]
fn settings_that_fit_are_no_mismatch() {
    for (name, set) in [
        ("AX-12", &[(6, 205), (8, 819)][..]),
        ("MX-28", &[(6, 1024), (8, 3072)]),
        ("XL430-W250", &[(52, 1024), (48, 3072), (10, 8)]),
        ("STS3215", &[(9, 1024), (11, 3072)]),
    ] {
        let model = Model::named(name).expect("a model");
        let servo = Servo::of(name, 1, model.middle);
        let servo = set.iter().fold(servo, |servo, (address, value)| {
            servo.with(*address, *value)
        });
        assert_eq!(mismatch(&mut one(model, servo)), None, "{name}");
    }
}

/// Commands of the maker's table; 90 deg are 375 counts from the middle at 500.
#[test]
fn settings_of_an_lx_are_compared() {
    for (command, parameters, expected) in [
        (29, &[1, 0, 0, 0][..], Some((29, 1, 0))),
        (17, &[10], Some((17, 10, 0))),
        (17, &[0xF6], Some((17, -10, 0))),
        // Limits from 126 to 1000, and from 0 to 874.
        (20, &[126, 0, 0xE8, 3], Some((20, 126, 0))),
        (20, &[0, 0, 0x6A, 3], Some((20, 874, 1000))),
        (20, &[125, 0, 0x6B, 3], None),
    ] {
        let model = Model::named("LX-16A").expect("a model");
        let mut drives = one(model, Servo::of("LX-16A", 1, 500.0));
        let sent = drives.bus_mut().send(&lx::request(1, command, parameters));
        sent.expect("sent");
        assert_eq!(mismatch(&mut drives), expected, "{command} {parameters:?}");
    }
}

/// Register 0x00c: 0 is the position since the start, 1 that within a turn of the rotor, 2 that of the output. A qdd100 has a reducer
/// of 6, so that a turn of its rotor is 60 deg.
#[test]
fn a_moteus_must_know_where_it_is() {
    for (name, state, expected) in [
        ("moteus-mj5208", 0, Some((0x00C, 0, 2))),
        ("moteus-mj5208", 1, None),
        ("moteus-mj5208", 2, None),
        ("moteus-qdd100", 0, Some((0x00C, 0, 2))),
        ("moteus-qdd100", 1, Some((0x00C, 1, 2))),
        ("moteus-qdd100", 2, None),
    ] {
        let model = Model::named(name).expect("a model");
        let servo = Servo::of(name, 1, model.middle).with(0x00C, state);
        assert_eq!(mismatch(&mut one(model, servo)), expected, "{name} {state}");
    }
    // Beyond half a turn, where the position after a start is another one.
    let model = Model::named("moteus-mj5208").expect("a model");
    for (most, expected) in [(180.0, None), (181.0, Some((0x00C, 1, 2)))] {
        let limits = Range::new(-90.0, most);
        let joint = Joint {
            limits,
            ..joint(1, model)
        };
        let servo = Servo::of("moteus-mj5208", 1, model.middle).with(0x00C, 1);
        let bus = bus_of(SimulatedBus::new(vec![servo], timing(model)), model);
        let drives = Drives::new(bus, &[joint], Settings::default());
        assert_eq!(mismatch(&mut drives.expect("a robot")), expected, "{most}");
    }
}

#[test]
fn a_robot_that_is_only_measured_may_be_anywhere() {
    let model = Model::named("STS3215").expect("a model");
    // 158 deg, which the limits of its joint exclude, and those of the servo.
    let servo = Servo::of("STS3215", 1, 3850.0).with(9, 3800);
    let mut drives = one(model, servo.clone());
    drives.connect_to_measure().expect("it can be measured");
    assert!(drives.angle(0).expect("measured") < -150.0 || drives.angle(0) > Some(150.0));
    // What changes the meaning of a position counts here, too.
    let refused = one(model, servo.with(31, 85)).connect_to_measure();
    assert!(matches!(
        refused.map_err(|it| it.problem),
        Err(Problem::Register(_))
    ));
}

#[test]
fn the_first_failure_ends_with_the_next_connect() {
    let mut drives = Robot::new(robot("STS3215", 2, Faults::default()), 20.0);
    write(&mut drives, 2, 33, &[1]);
    let first = drives.connect().expect_err("a wheel");
    assert_eq!(drives.failure(), Some(first));
    write(&mut drives, 2, 33, &[0]);
    assert_eq!(drives.connect(), Ok(()));
    assert_eq!(drives.failure(), None);
    drives.hold().expect("well");
}

/// Runs cycles of a period from a time on; returns the time after them.
fn cycles(drives: &mut Robot, from: u64, period: f64, count: u64) -> u64 {
    let commands = vec![JointCommand::at(0.0); drives.joints().count()];
    let step = (period * 1000.0) as u64;
    for number in 0..count {
        drives.bus_mut().port_mut().pass(from + number * step);
        drives.read_cycle().expect("a healthy robot");
        drives
            .write_cycle(&commands, period)
            .expect("a healthy robot");
    }
    from + (count - 1) * step
}

/// Ten cycles, 100 ms at least. Register 98 of an X counts 20 ms, and 127 is its largest value.
#[test]
fn the_watchdog_is_ten_cycles_of_the_period_in_force() {
    for (period, units) in [
        (5.0, 5),
        (20.0, 10),
        (100.0, 50),
        (250.0, 125),
        (400.0, 127),
        (840.0, 127),
    ] {
        let mut drives = held("XL430-W250", 2, Faults::default());
        // A program that sets the sampling time has had another one before.
        let from = cycles(&mut drives, START * 20_000, 20.0, 5) + 20_000;
        cycles(&mut drives, from, period, 12);
        for servo in drives.bus().port().bus.servos() {
            assert_eq!(servo.register(98, 1), Some(units), "{period}");
        }
    }
    for (period, least, most) in [(5.0, 95, 110), (20.0, 195, 210), (250.0, 2450, 2600)] {
        let mut drives = held("moteus-mj5208", 2, Faults::default());
        let last = cycles(&mut drives, START * 20_000, period, 12);
        let port = drives.bus_mut().port_mut();
        port.pass(last + least * 1000);
        assert!(port.bus.servos().iter().all(Servo::has_torque), "{period}");
        port.pass(last + most * 1000);
        assert!(!port.bus.servos().iter().any(Servo::has_torque), "{period}");
    }
}

/// A watchdog of 2540 ms is three cycles of 846 ms.
#[test]
fn a_period_beyond_the_watchdog_is_refused() {
    let mut drives = Robot::new(robot("XL430-W250", 2, Faults::default()), 847.0);
    let refused = drives.0.connect().map_err(|it| it.problem);
    assert!(matches!(refused, Err(Problem::Period(most)) if (most - 846.67).abs() < 0.01));
    drives.hold().expect_err("nobody has changed it");
    assert!(!drives.bus().port().bus.servos()[0].has_torque());

    let mut drives = held("XL430-W250", 2, Faults::default());
    let commands = [JointCommand::at(0.0); 2];
    let refused = drives.write_cycle(&commands, 1000.0);
    assert!(matches!(
        refused.map_err(|it| it.problem),
        Err(Problem::Period(_))
    ));
    // Servos without a watchdog have no such limit.
    let mut drives = held("STS3215", 2, Faults::default());
    cycles(&mut drives, START * 20_000, 1000.0, 5);
    assert_eq!(drives.timeout(), None);
}

/// Robots with a sampling time, ms, and the result of connecting them.
fn connected(name: &str, servos: u8, period: f64) -> (Robot, Result<(), Problem>) {
    let mut drives = Robot::new(robot(name, servos, Faults::default()), period);
    let result = drives.0.connect().map_err(|failure| failure.problem);
    (drives, result)
}

/// 18 frames of 10 bytes at 115200 bit/s are 15.6 ms, and 14 bytes for each reading 22 ms.
#[test]
fn a_bus_that_cannot_carry_a_cycle_is_refused() {
    let (mut drives, refused) = connected("LX-16A", 18, 20.0);
    let load = drives.load();
    assert!(load.part() > 1.8 && load.cycles >= 5, "{load:?}");
    assert_eq!(refused, Err(Problem::Load(load)));
    assert_eq!(drives.hold().map_err(|it| it.problem), refused);
    let servos = drives.bus().port().bus.servos();
    assert!(!servos.iter().any(Servo::has_torque));
    // Not even the commands fit.
    let (_, refused) = connected("LX-16A", 18, 15.0);
    assert!(matches!(refused, Err(Problem::Load(_))));

    let (mut drives, result) = connected("LX-16A", 18, 35.0);
    let load = drives.load();
    assert!(
        (1.05..1.5).contains(&load.part()) && load.cycles == 2,
        "{load:?}"
    );
    assert_eq!(result, Ok(()));
    drives.hold().expect("it can be heard");
    cycles(&mut drives, START * 20_000, 35.0, 50);
    let (drives, _) = connected("STS3215", 12, 20.0);
    let load = drives.load();
    assert!(load.part() < 0.3 && load.cycles == 1, "{load:?}");
}

/// Servos that are read by one request must all answer in the part of a cycle that is for reading: those that are left out would
/// be the same ones in each cycle. At 1 Mbaud, the longest answers of 18 X, 36 bytes, take 6.5 ms, those of 12 STS, 30 bytes, 3.6 ms;
/// 60 % of a cycle are for reading.
#[test]
fn a_cycle_is_refused_in_which_not_all_servos_can_answer_together() {
    for (name, servos, refused, shortest) in [
        ("XL430-W250", 18, [2.0, 5.0, 10.0], 10.8..12.0),
        ("STS3215", 12, [1.0, 3.0, 5.0], 6.0..7.0),
    ] {
        for period in refused {
            let (mut drives, result) = connected(name, servos, period);
            let load = drives.load();
            assert_eq!(result, Err(Problem::Load(load)), "{name} {period}");
            assert!(load.period == period && load.read > 0.6 * period.min(load.read));
            assert!(shortest.contains(&load.shortest), "{name}: {load:?}");
            drives.hold().expect_err("it is no longer");
            let on = drives.bus().port().bus.servos();
            assert!(!on.iter().any(Servo::has_torque), "{name} {period}");
        }
        // With the shortest one, no answer is missing.
        let (drives, _) = connected(name, servos, 20.0);
        let period = drives.load().shortest.ceil() + 1.0;
        let (mut drives, result) = connected(name, servos, period);
        assert_eq!(result, Ok(()), "{name} {period}");
        drives.hold().expect("it can be heard");
        cycles(&mut drives, START * 20_000, period, 100);
        assert_eq!(drives.counts().missing, 0, "{name} {period}");
    }
}

/// A program that sets such a sampling time stops the robot, which is left with the one that it had.
#[test]
fn a_program_cannot_set_a_sampling_time_that_the_bus_cannot_carry() {
    for (name, servos, period) in [
        ("XL430-W250", 18, 5.0),
        ("STS3215", 12, 2.0),
        ("AX-12", 18, 2.0),
        ("moteus-mj5208", 12, 3.0),
        ("LX-16A", 6, 5.0),
    ] {
        let mut drives = held(name, servos, Faults::default());
        let from = START * 20_000;
        let last = cycles(&mut drives, from, 20.0, 5);
        let commands = vec![JointCommand::at(5.0); servos.into()];
        drives.bus_mut().port_mut().pass(last + 20_000);
        drives.read_cycle().expect("well");
        let refused = drives.write_cycle(&commands, period);
        let Err(Problem::Load(load)) = refused.map_err(|it| it.problem) else {
            panic!("{name}: {refused:?}");
        };
        assert!(load.period == period && load.shortest > period, "{load:?}");
        // Every servo is heard on the way out.
        drives.0.leave();
        assert_eq!(drives.counts().missing, 0, "{name}");
        let outcome = drives.0.outcome().expect("left");
        assert!(outcome.is_certain(), "{name}: {outcome:?}");
    }
}

/// With servos that are read in turn, `silence` is in cycles as well, and no old angle is a fresh one.
#[test]
fn silence_is_in_cycles() {
    let model = Model::named("AX-12").expect("a model");
    let slow = Timing {
        baud: 115_200,
        return_delay: 0,
        latency: 2000,
    };
    let joints: Vec<Joint> = (1..=12).map(|id| joint(id, model)).collect();
    let rest = |joint: &Joint| Servo::of("AX-12", joint.id, 512.0);
    let bus = SimulatedBus::new(joints.iter().map(rest).collect(), slow);
    let bus = Bus::new(MemoryPort::new(bus), slow);
    let drives = Drives::new(bus, &joints, Settings::default()).expect("a robot");
    let mut drives = Robot::new(drives, 20.0);
    drives.connect().expect("well");
    drives.bus_mut().port_mut().pass((START - 5) * 20_000);
    drives.hold().expect("well");
    let cycles_of_each = drives.load().cycles;
    assert!((2..=3).contains(&cycles_of_each), "{cycles_of_each}");
    let mut ages = [0; 12];
    let commands = [JointCommand::at(0.0); 12];
    let mut cycle = |drives: &mut Robot, number: u64| {
        let begin = (START + number) * 20_000;
        drives.bus_mut().port_mut().pass(begin);
        let read = drives.read_cycle();
        for (joint, age) in ages.iter_mut().enumerate() {
            let now = drives.age(joint).expect("a joint");
            let is_fresh = drives.measured(joint).is_some_and(|it| it.at >= begin);
            assert_eq!(now == 0, is_fresh, "{number} {joint}");
            assert_eq!(now, if is_fresh { 0 } else { *age + 1 });
            *age = now;
        }
        read.and_then(|()| drives.write_cycle(&commands, 20.0))
    };
    // Ages count from the last reading of the start.
    let _ = cycle(&mut drives, 0);
    for number in 1..60 {
        cycle(&mut drives, number).expect("well");
        let ages: Vec<u32> = (0..12).filter_map(|joint| drives.age(joint)).collect();
        assert!(ages.iter().all(|age| *age <= cycles_of_each), "{ages:?}");
    }
    drives.bus_mut().port_mut().bus.unplug(7);
    let before = u64::from(drives.age(6).expect("a joint"));
    let stopped = (60..80).find_map(|number| {
        let failure = cycle(&mut drives, number).err()?;
        assert_eq!((failure.problem, failure.servo), (Problem::Silent, Some(7)));
        Some(number - 59)
    });
    // More than 5 cycles since its last answer.
    assert_eq!(stopped, Some(6 - before));
}

#[test]
fn no_robot_has_impossible_joints() {
    let ax = Model::named("AX-12").expect("a model");
    let sts = Model::named("STS3215").expect("a model");
    let refused = |joints: &[Joint], settings: Settings| {
        let bus = SimulatedBus::new(vec![Servo::of("AX-12", 1, 512.0)], timing(ax));
        Drives::new(bus_of(bus, ax), joints, settings).err()
    };
    let good = joint(1, ax);
    let ordinary = Settings::default();
    assert_eq!(refused(&[good], ordinary), None);
    let value = |name| Some(Invalid::Value { joint: 0, name });
    for (joint, expected) in [
        (Joint { gear: 0.0, ..good }, value("gear")),
        (Joint { gear: -1.0, ..good }, value("gear")),
        (
            Joint {
                gear: f64::NAN,
                ..good
            },
            value("gear"),
        ),
        (Joint { sign: 0.5, ..good }, value("sign")),
        (
            Joint {
                offset: f64::INFINITY,
                ..good
            },
            value("offset"),
        ),
        (
            Joint {
                limits: Range::new(10.0, -10.0),
                ..good
            },
            value("limits"),
        ),
        (
            Joint {
                limits: Range::new(f64::NAN, 10.0),
                ..good
            },
            value("limits"),
        ),
        (Joint { speed: 0.0, ..good }, value("speed")),
        (
            Joint {
                torque: 1.1,
                ..good
            },
            value("torque"),
        ),
        (
            Joint {
                torque: 0.0,
                ..good
            },
            value("torque"),
        ),
        (Joint { id: 253, ..good }, value("id")),
        // An AX turns by 150 deg to each side.
        (
            Joint {
                offset: 61.0,
                ..good
            },
            Some(Invalid::Travel {
                joint: 0,
                angle: 151.0,
            }),
        ),
        (
            Joint {
                offset: 59.0,
                ..good
            },
            None,
        ),
        (
            Joint { gear: 2.0, ..good },
            Some(Invalid::Travel {
                joint: 0,
                angle: -180.0,
            }),
        ),
    ] {
        assert_eq!(refused(&[joint], ordinary), expected, "{joint:?}");
    }
    let same = refused(&[joint(3, ax), joint(4, ax), joint(3, ax)], ordinary);
    assert_eq!(same, Some(Invalid::SameIdentity { joint: 2, other: 0 }));
    let said = same.expect("refused").to_string();
    assert!(said.contains("joints 1 and 3"), "{said}");
    let other = refused(&[joint(3, ax), joint(4, sts)], ordinary);
    assert_eq!(other, Some(Invalid::OtherFamily { joint: 1, other: 0 }));
    let many: Vec<Joint> = (1..=82).map(|id| joint(id, ax)).collect();
    assert_eq!(refused(&many, ordinary), Some(Invalid::TooManyJoints));
    let lx = Model::named("LX-16A").expect("a model");
    let limited = Joint {
        torque: 0.9,
        ..joint(1, lx)
    };
    let expected = Some(Invalid::NoTorqueLimit { joint: 0 });
    assert_eq!(refused(&[limited], ordinary), expected);
    assert_eq!(refused(&[joint(1, lx)], ordinary), None);
    let nan = Settings {
        temperature: f64::NAN,
        ..ordinary
    };
    let name = "temperature";
    assert_eq!(refused(&[good], nan), Some(Invalid::Setting { name }));
}

/// 18 servos answer within 6 ms (AX) or 35 ms (LX), and a thousand cycles of silence are a matter of walking.
#[test]
fn a_start_is_short_whatever_silence_is_allowed() {
    for (model, longest) in [("AX-12", 500_000), ("LX-16A", 3_000_000)] {
        let settings = Settings {
            silence: 1000,
            ..Settings::default()
        };
        let mut drives = robot_with(model, 18, Faults::default(), settings);
        drives.connect().expect("well");
        let time = drives.bus_mut().now();
        assert!(time < longest, "{model}: {time} µs");
    }
}

/// An LX has no register for load or torque limit: what it cannot tell is unknown.
#[test]
fn an_lx_tells_what_it_can() {
    let settings = Settings::default();
    let mut drives = robot_with("LX-16A", 3, Faults::default(), settings);
    drives.connect().expect("well");
    let measured = drives.measured(0).expect("measured");
    assert_eq!(measured.load, None);
    assert!(measured.voltage.is_some_and(|it| (6.0..13.0).contains(&it)));
    assert!(
        measured
            .temperature
            .is_some_and(|it| (20.0..40.0).contains(&it))
    );
    let ax = {
        let mut drives = robot_with("AX-12", 1, Faults::default(), settings);
        drives.connect().expect("well");
        drives.measured(0).expect("measured")
    };
    assert!(ax.load.is_some());
}

/// A checksum of 8 bits lets one of 255 damaged answers pass: no healthy robot is refused for one.
#[test]
fn a_damaged_answer_at_the_start_refuses_no_servo() {
    let faults = Faults {
        corrupt: 0.2,
        ..Faults::default()
    };
    for (name, seeds) in [("AX-12", 300), ("STS3215", 300), ("LX-16A", 100)] {
        let model = Model::named(name).expect("a model");
        let joints: Vec<Joint> = (1..=6).map(|id| joint(id, model)).collect();
        for seed in 0..seeds {
            let servos = joints
                .iter()
                .map(|joint| Servo::new(model, joint.id, joint.counts(0.0).into()));
            let bus = SimulatedBus::new(servos.collect(), timing(model));
            let bus = bus_of(bus.with_faults(faults, seed), model);
            let settings = Settings {
                silence: 20,
                ..Settings::default()
            };
            let drives = Drives::new(bus, &joints, settings);
            let connected = drives.expect("six").connect();
            assert_eq!(connected, Ok(()), "{name}, {seed}");
        }
    }
}

/// A port whose host is taken away for some µs after each request.
struct Starved(MemoryPort, u64);

impl ErrorType for Starved {
    type Error = Infallible;
}

impl Read for Starved {
    fn read(&mut self, into: &mut [u8]) -> Result<usize, Infallible> {
        self.0.read(into)
    }
}

impl Write for Starved {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        let written = self.0.write(bytes);
        let now = self.0.now();
        self.0.pass(now + self.1);
        written
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

impl Port for Starved {
    fn now(&mut self) -> u64 {
        self.0.now()
    }

    fn wait(&mut self, until: u64) -> Result<bool, Infallible> {
        self.0.wait(until)
    }
}

/// Returns the drives of a robot whose host is starved after each request, as soon as it is connected.
fn starved(name: &str, servos: u8, delay: u64) -> Drives<Starved> {
    let model = Model::named(name).expect("a model");
    let joints: Vec<Joint> = (1..=servos).map(|id| joint(id, model)).collect();
    let rest = |joint: &Joint| Servo::of(name, joint.id, model.middle);
    let bus = SimulatedBus::new(joints.iter().map(rest).collect(), timing(model));
    let bus = Bus::new(Starved(MemoryPort::new(bus), 0), timing(model));
    let mut drives = Drives::new(bus, &joints, Settings::default()).expect("a robot");
    drives.connect().expect("well");
    drives.bus_mut().port_mut().1 = delay;
    drives
}

/// All answers came while the host slept, 1.7 times as long as a cycle: more than one read of the port gives.
#[test]
fn answers_that_came_while_the_host_slept_count() {
    for name in ["XL430-W250", "STS3215"] {
        let mut drives = starved(name, 12, 34_000);
        for number in START..START + 20 {
            drives.bus_mut().port_mut().0.pass(number * 20_000);
            drives.read_cycle().expect("well");
            let ages: Vec<u32> = (0..12).filter_map(|joint| drives.age(joint)).collect();
            assert_eq!(ages, [0; 12], "{name}");
        }
        assert_eq!(drives.counts().missing, 0, "{name}");
    }
}

/// One of 18 servos is asked in each cycle, and all answer: none is silent, but the robot cannot go on with angles of 16 cycles
/// ago. With two in each cycle it goes on.
#[test]
fn a_host_that_is_late_does_not_call_its_servos_silent() {
    for (delay, expected) in [(13_000, Some(15)), (7_000, None)] {
        let mut drives = starved("AX-12", 18, delay);
        let stopped = (0..60).find_map(|number| {
            drives
                .bus_mut()
                .port_mut()
                .0
                .pass((START + number) * 20_000);
            Some((number, drives.read_cycle().err()?.problem))
        });
        assert_eq!(drives.counts().missing, 0);
        let age = expected.map(|cycle| (cycle, Problem::NotRead(16)));
        assert_eq!(stopped, age, "{delay}");
    }
}
