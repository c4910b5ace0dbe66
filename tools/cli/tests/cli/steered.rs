//! Gaits that random sticks steer on simulated servos, judged by the bytes on the wire. The decoder is written from the makers' manuals;
//! it shares no table with the drives.

use crate::drives::made;
use std::collections::BTreeMap;
use std::convert::Infallible;
use std::env;
use std::sync::{Arc, Mutex};
use tip_drives::bus::Port;
use tip_drives::described::{self, Described};
use tip_drives::guard::{Host, Request, Step, TorqueGuard};
use tip_drives::simulated::MemoryPort;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{HardwareFault, JointCommand};
use tip_runtime::program::End;
use tip_runtime::random::Random;
use tip_runtime::record::Ending;
use tip_sim::{Joints, Limit, Robot, Run};

/// Time of random sticks, s. `STEERED_SECONDS` sets another one.
const SECONDS: f64 = 4.0;

/// A port that records the bytes of the master, and the times at which they have been sent, µs.
struct Wiretap {
    port: MemoryPort,
    sent: Vec<(u64, Vec<u8>)>,
}

impl embedded_io::ErrorType for Wiretap {
    type Error = Infallible;
}

impl embedded_io::Read for Wiretap {
    fn read(&mut self, into: &mut [u8]) -> Result<usize, Infallible> {
        self.port.read(into)
    }
}

impl embedded_io::Write for Wiretap {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        let count = self.port.write(bytes)?;
        self.sent.push((self.port.now(), bytes[..count].to_vec()));
        Ok(count)
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        self.port.flush()
    }
}

impl Port for Wiretap {
    fn now(&mut self) -> u64 {
        self.port.now()
    }

    fn wait(&mut self, until: u64) -> Result<bool, Infallible> {
        self.port.wait(until)
    }
}

/// A host whose operator presses nothing.
struct Nobody;

impl Host<Wiretap> for Nobody {
    fn wait(&mut self, port: &mut Wiretap, until: u64) {
        port.port.pass(until);
    }

    fn request(&mut self) -> Option<Request> {
        None
    }
}

type Guard = TorqueGuard<Wiretap, Nobody>;

/// The joints of a run, with the times at which its cycles began, µs.
struct Timed {
    robot: Arc<Mutex<Guard>>,
    begins: Arc<Mutex<Vec<u64>>>,
    of_leg: usize,
}

impl Joints for Timed {
    fn read(&mut self, angles: &mut [f64], ages: &mut [u32]) -> Result<(), HardwareFault> {
        let mut robot = self.robot.lock().expect("nobody panics");
        let now = robot.drives_mut().bus_mut().port_mut().now();
        self.begins.lock().expect("nobody panics").push(now);
        let read = robot.read_cycle();
        read.map_err(|failure| failure.fault(self.of_leg))?;
        for (joint, (angle, age)) in angles.iter_mut().zip(ages).enumerate() {
            *angle = robot.drives().angle(joint).expect("measured");
            *age = robot.drives().age(joint).expect("measured");
        }
        Ok(())
    }

    fn write(&mut self, commands: &[JointCommand], period: f64) -> Result<(), HardwareFault> {
        let mut robot = self.robot.lock().expect("nobody panics");
        let written = robot.write_cycle(commands, period);
        written.map_err(|failure| failure.fault(self.of_leg))?;
        robot.wait();
        Ok(())
    }

    fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
        let mut robot = self.robot.lock().expect("nobody panics");
        let stopped = robot.stop_cycle();
        stopped.map_err(|failure| failure.fault(self.of_leg))
    }
}

/// Data of a servo from its maker's manual.
struct Manual {
    /// Address of the byte that switches the torque on.
    torque: usize,
    /// Address of the goal position, of two bytes, the low one first.
    goal: usize,
    /// Degrees of a count, and the count in the middle of the travel.
    count: f64,
    middle: f64,
}

/// ROBOTIS e-Manual, "AX-12A", "Control Table of RAM Area": 0 to 1023 are 300 deg, 512 is the middle.
const AX_12: Manual = Manual {
    torque: 24,
    goal: 30,
    count: 300.0 / 1024.0,
    middle: 512.0,
};

/// Feetech, "STS3215 memory table": 0 to 4095 are a turn.
const STS3215: Manual = Manual {
    torque: 40,
    goal: 42,
    count: 360.0 / 4096.0,
    middle: 2048.0,
};

/// A broadcast frame that sets the goals of all servos.
struct Goals {
    /// Time at which it has been sent, µs.
    time: u64,
    /// Goals by identity, counts.
    counts: BTreeMap<u8, f64>,
    /// Number of servos whose torque is on.
    stiff: usize,
}

/// Reads what a master has sent as frames of Dynamixel protocol 1: FF FF, identity, length, instruction, parameters, and a checksum
/// that makes the sum of all after the header 255. Returns the frames with goals, and the number of servos whose torque is on at the end.
fn decode(sent: &[(u64, Vec<u8>)], manual: &Manual) -> (Vec<Goals>, usize) {
    let (mut goals, mut torque) = (Vec::new(), BTreeMap::new());
    for (time, bytes) in sent {
        let [0xFF, 0xFF, id, length, instruction, parameters @ .., _] = &bytes[..] else {
            panic!("no frame: {bytes:02x?}");
        };
        let sum = bytes[2..].iter().map(|byte| u32::from(*byte)).sum::<u32>();
        assert_eq!((usize::from(*length), sum % 256), (bytes.len() - 4, 255));
        let (first, writes): (&u8, Vec<(u8, &[u8])>) = match instruction {
            // WRITE: address and bytes.
            3 => {
                assert_ne!(*id, 254, "to all servos");
                (&parameters[0], vec![(*id, &parameters[1..])])
            }
            // SYNC WRITE: address, number of bytes, and of each servo its identity and bytes.
            0x83 => {
                let each = usize::from(parameters[1]) + 1;
                let of_servos = parameters[2..].chunks_exact(each);
                assert!(of_servos.remainder().is_empty());
                let writes = of_servos.map(|part| (part[0], &part[1..]));
                (&parameters[0], writes.collect())
            }
            // PING, READ, SYNC READ.
            1 | 2 | 0x82 => continue,
            other => panic!("instruction {other:#x}"),
        };
        let mut counts = BTreeMap::new();
        for (id, bytes) in writes {
            let at = |address: usize| bytes.get(address.checked_sub(usize::from(*first))?);
            if let Some(on) = at(manual.torque) {
                torque.insert(id, *on);
            }
            if let (Some(low), Some(high)) = (at(manual.goal), at(manual.goal + 1)) {
                counts.insert(id, f64::from(u16::from_le_bytes([*low, *high])));
            }
        }
        if *instruction == 0x83 && !counts.is_empty() {
            let stiff = torque.values().filter(|on| **on == 1).count();
            goals.push(Goals {
                time: *time,
                counts,
                stiff,
            });
        }
    }
    (goals, torque.values().filter(|on| **on == 1).count())
}

/// Returns events for a control cycle in ms: a third of the time a stick rests, a third it is at an end, a third anywhere; now and then
/// all sticks are let go. At the end a halt is requested.
fn sticks(cycle: f64, seconds: f64, seed: u64) -> String {
    let mut random = Random::new(seed);
    let mut text = String::from("0:VR1=5, 0:VR2=5, 0:VR3=5");
    let mut time = 4.0;
    while time < 4.0 + seconds {
        let at = (time * 1000.0 / cycle) as u64;
        let is_let_go = random.once_in(6);
        for stick in 1..=3 {
            let anywhere = random.within(0.0, 10.0);
            let volts = match random.below(6) {
                _ if is_let_go => 5.0,
                0 | 1 => 5.0,
                2 => 0.0,
                3 => 10.0,
                _ => anywhere,
            };
            text += &format!(", {at}:VR{stick}={volts:.2}");
        }
        time += random.within(0.2, 3.0);
    }
    format!("{text}, {}:halt", (time * 1000.0 / cycle) as u64)
}

#[test]
fn a_tripod_keeps_limits_speeds_and_cycles_on_the_wire_whatever_the_sticks_do() {
    let example = include_str!("../../../../examples/published/tripod.prg");
    derived_and_example_walk_on_servos("phantomx", example, &AX_12);
}

#[test]
fn a_trot_keeps_limits_speeds_and_cycles_on_the_wire_whatever_the_sticks_do() {
    let example = include_str!("../../../../examples/published/trot-spotmicro.prg");
    derived_and_example_walk_on_servos("spotmicro", example, &STS3215);
}

/// Every cycle sends one frame of goals to all servos, none is beyond the limits of the description or farther from the last one than
/// its servo turns, and the servos are left as the description says. Of a gait that `tip new` derives for the servos at most one of
/// 10,000 commands is slowed down, of an example at most one of 1000.
fn derived_and_example_walk_on_servos(robot: &str, example: &str, manual: &Manual) {
    let seconds = env::var("STEERED_SECONDS").ok();
    let seconds = seconds.map_or(SECONDS, |text| text.parse().expect("a number"));
    let slowed = walk_on_servos(robot, &made(robot)[1], manual, "hold", seconds);
    assert!(slowed < 1e-4, "{robot}: slowed down {slowed}");
    let slowed = walk_on_servos(robot, example, manual, "relax", seconds);
    assert!(slowed < 1e-3, "{robot}, example: slowed down {slowed}");
}

/// Returns the share of commands that were slowed down to the speed of their servos.
fn walk_on_servos(robot: &str, program: &str, manual: &Manual, at_end: &str, seconds: f64) -> f64 {
    let text = made(robot)[0].clone();
    // Some servos are mounted the other way round.
    let text = ["J11", "J22"].iter().fold(text, |text, joint| {
        let (before, after) = text.split_once(&format!("\"{joint}\"\n")).expect("a drive");
        format!(
            "{before}\"{joint}\"\n{}",
            after.replacen("sign = 1", "sign = -1", 1)
        )
    });
    let text = text.replace("[bus]\n", &format!("[bus]\nat_end = \"{at_end}\"\n"));
    let description = described::read("robot.toml", text.as_bytes()).expect("sound");
    let setup = Described::new(&description).expect("a bus");
    let servos = setup.joints.len();

    let tap = Wiretap {
        port: MemoryPort::new(setup.simulated()),
        sent: Vec::new(),
    };
    let drives = setup.drives(tap).expect("a robot");
    let mut guard = TorqueGuard::new(drives, Nobody, setup.period);
    guard.connect().expect("all are there");
    let ready = guard.approach(&setup.initial, setup.bus.start);
    assert_eq!(ready, Ok(Step::Arrived));
    let (guard, begins) = (
        Arc::new(Mutex::new(guard)),
        Arc::<Mutex<Vec<u64>>>::default(),
    );
    let joints = Timed {
        robot: Arc::clone(&guard),
        begins: Arc::clone(&begins),
        of_leg: setup.of_leg,
    };
    let model = Robot::described(&description);
    let engine = tip_sim::load("walk.prg", program, &model).expect("a program");
    let run = Run::real(engine, &model, joints).expect("for this robot");
    let events = sticks(setup.period, seconds, 2026);
    let mut run = run.events(&events).expect("inputs");
    let most = ((seconds + 30.0) * 1000.0 / setup.period) as u64;
    let ending = run.to_end(Limit::cycles(most));
    assert_eq!(ending, Ending::Program(End::Exit), "{robot}");

    let mut guard = guard.lock().expect("nobody panics");
    let (counts, end) = (
        guard.drives().counts(),
        guard.drives_mut().bus_mut().port_mut().now(),
    );
    assert_eq!((counts.clipped, counts.missing), (0, 0), "{robot}");
    guard.leave();
    assert!(guard.outcome().is_some_and(|left| left.is_certain()));
    let tap = guard.drives().bus().port();
    let (goals, stiff) = decode(&tap.sent, manual);
    assert_eq!(stiff, if at_end == "hold" { servos } else { 0 }, "{robot}");
    let held = tap.port.bus.servos().iter().filter(|it| it.has_torque());
    assert_eq!(held.count(), stiff, "{robot}");

    // The cycles begin on time, and each sends one frame before the next one begins.
    let begins = begins.lock().expect("nobody panics");
    let period = (setup.period * 1000.0) as u64;
    for (number, begin) in begins.iter().enumerate() {
        assert_eq!(*begin, begins[0] + period * number as u64, "{robot}");
    }
    let walked: Vec<&Goals> = (goals.iter())
        .filter(|it| (begins[0]..end).contains(&it.time))
        .collect();
    assert_eq!(walked.len(), begins.len(), "{robot}: a frame for a cycle");
    let mut latest = 0;
    for (begin, frame) in begins.iter().zip(&walked) {
        assert!((*begin..begin + period).contains(&frame.time), "{robot}");
        assert_eq!((frame.counts.len(), frame.stiff), (servos, servos));
        latest = latest.max(frame.time - begin);
    }

    let bus = description.bus().expect("a bus");
    let (mut fastest, mut nearest) = (0.0_f64, f64::INFINITY);
    for drive in &bus.drives {
        let angle = |frame: &Goals| {
            let motor = (frame.counts[&drive.id] - manual.middle) * manual.count;
            (motor - drive.offset) / (drive.sign * drive.gear)
        };
        // A count is rounded to the nearest one.
        let half = manual.count / 2.0 + 1e-9;
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        for frame in goals.iter().filter(|frame| frame.time < end) {
            let now = angle(frame);
            assert!(
                now >= drive.limits.min - half,
                "{robot}: {} {now}",
                drive.id
            );
            assert!(
                now <= drive.limits.max + half,
                "{robot}: {} {now}",
                drive.id
            );
            (least, greatest) = (least.min(now), greatest.max(now));
        }
        nearest = nearest
            .min(least - drive.limits.min)
            .min(drive.limits.max - greatest);
        assert!(greatest - least > 2.0, "{robot}: {} stands", drive.id);
        for pair in walked.windows(2) {
            let step = (angle(pair[1]) - angle(pair[0])).abs();
            let most = drive.speed * setup.period / 1000.0 + 2.0 * half;
            assert!(step <= most, "{robot}: {} {step} deg", drive.id);
            fastest = fastest.max(step / setup.period * 1000.0);
        }
    }
    println!(
        "{robot}, {}: {} cycles of {} ms, sent {:.1} ms after their begin at the latest; fastest step {fastest:.0} of {:.0} deg/s, {} of \
         {} commands slowed down; nearest to a limit {nearest:.1} deg; {at_end}: torque on {stiff} of {servos} servos",
        program.lines().nth(1).unwrap_or_default(),
        begins.len(),
        setup.period,
        latest as f64 / 1000.0,
        bus.drives[0].speed,
        counts.slowed,
        begins.len() * servos,
    );
    counts.slowed as f64 / (begins.len() * servos) as f64
}
