//! A long run on a bus that fails, as fast as the machine can: `cargo run --release -p tip-drives --features std --example long_run
//! CYCLES [MODEL]`.
//!
//! It counts angles that are not what a servo sent, compares the faults that happened with those that were noticed, and shows
//! the time of the bus and the memory in use.
#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    reason = "an example talks to people"
)]

use std::error::Error;
use std::{env, fs};
use tip_drives::bus::{Bus, Timing};
use tip_drives::drives::{Drives, Joint, Settings};
use tip_drives::guard::{Host, Request, TorqueGuard};
use tip_drives::model::Model;
use tip_drives::moteus;
use tip_drives::simulated::{Faults, MemoryPort, Servo, SimulatedBus};
use tip_runtime::hardware::JointCommand;
use tip_runtime::model::Range;

/// Time of the first cycle, µs.
const START: u64 = 5_000_000;

/// A host whose operator presses nothing.
struct Nobody;

impl Host<MemoryPort> for Nobody {
    fn wait(&mut self, port: &mut MemoryPort, until: u64) {
        port.pass(until);
    }

    fn request(&mut self) -> Option<Request> {
        None
    }
}

/// The timing of a model's bus.
fn timing(model: &Model) -> Timing {
    Timing {
        baud: match model.family.key() {
            // Lines of text are long, and USB is fast.
            "moteus" => 4_000_000,
            "lx" => 115_200,
            _ => 1_000_000,
        },
        return_delay: 0,
        latency: 2000,
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let cycles = env::args().nth(1).map_or(Ok(100_000), |it| it.parse())?;
    let only = env::args().nth(2);
    println!(
        "servos               period  faults   cycles  wrong  by counts  unused  injected  mean ms  p99 ms  longest ms  memory kB"
    );
    let robots = [
        ("AX-12", 18, 20),
        ("XL430-W250", 12, 20),
        ("STS3215", 12, 10),
        // Their frames are long, and their bus is slow.
        ("LX-16A", 18, 40),
        ("moteus-mj5208", 12, 20),
    ];
    let is_meant = |name: &str| only.as_deref().is_none_or(|only| only == name);
    for (name, servos, period) in robots.into_iter().filter(|(name, ..)| is_meant(name)) {
        for (cycles, faults) in [
            (2000, Faults::default()),
            (cycles, Faults::evenly(0.01)),
            (
                cycles,
                Faults {
                    corrupt: 0.01,
                    ..Faults::default()
                },
            ),
            // Many frames, most of which are damaged; the drives would stop.
            (
                cycles / 3,
                Faults {
                    corrupt: 0.5,
                    delay: 0.05,
                    ..Faults::default()
                },
            ),
        ] {
            run(name, servos, period, cycles, faults)?;
        }
    }
    Ok(())
}

fn run(
    name: &str,
    servos: u8,
    period: u64,
    cycles: u64,
    faults: Faults,
) -> Result<(), Box<dyn Error>> {
    let model = Model::named(name).ok_or("no such model")?;
    let joints: Vec<Joint> = (1..=servos)
        .map(|id| Joint {
            id,
            model,
            sign: 1.0,
            offset: 0.0,
            gear: 1.0,
            limits: Range::new(-90.0, 90.0),
            speed: 180.0,
            torque: 1.0,
        })
        .collect();
    let servos: Vec<Servo> = joints
        .iter()
        .map(|joint| Servo::new(model, joint.id, joint.counts(0.0).into()))
        .collect();
    let timing = timing(model);
    let port = MemoryPort::new(SimulatedBus::new(servos, timing));
    let bus = Bus::new(port, timing);
    let drives = Drives::new(bus, &joints, Settings::default())?;
    let mut robot = TorqueGuard::new(drives, Nobody, period as f64);
    robot.connect()?;
    // Not long before the first cycle, because of watchdogs.
    robot
        .drives_mut()
        .bus_mut()
        .port_mut()
        .pass(START - 100_000);
    robot.hold()?;
    let bus = robot.drives().bus().port().bus.clone();
    robot.drives_mut().bus_mut().port_mut().bus = bus.with_faults(faults, 3);
    let (mut wrong, mut worst, mut times, mut stopped) = (0, 0, Vec::new(), 0);
    let allowed = match model.family.key() {
        "moteus" => moteus::BETWEEN,
        _ => 0,
    };
    for cycle in 0..cycles {
        let begin = START + cycle * period * 1000;
        robot.drives_mut().bus_mut().port_mut().pass(begin);
        let busy = robot.drives().counts().busy;
        stopped += u64::from(robot.read_cycle().is_err());
        let drives = robot.drives();
        for (number, servo) in drives.bus().port().bus.servos().iter().enumerate() {
            let measured = drives.measured(number).ok_or("not connected")?;
            let reported = servo.reported().ok_or("not asked")?;
            let difference = measured.counts.abs_diff(reported);
            let is_wrong = measured.at >= begin && difference > allowed;
            (wrong, worst) = match is_wrong {
                true => (wrong + 1, difference.max(worst)),
                false => (wrong, worst),
            };
        }
        let angle = 30.0 * libm::sin(cycle as f64 * 0.02);
        let commands = vec![JointCommand::at(angle); joints.len()];
        robot.write_cycle(&commands, period as f64)?;
        times.push((robot.drives().counts().busy - busy) as u32);
    }
    times.sort_unstable();
    let drives = robot.drives();
    let (counts, happened) = (drives.counts(), drives.bus().port().bus.happened());
    let injected = happened.corrupt
        + happened.dropped
        + happened.duplicated
        + happened.delayed
        + happened.truncated;
    let ms = |time: u32| f64::from(time) / 1000.0;
    let mean = counts.busy as f64 / cycles as f64 / 1000.0;
    let (p99, longest) = (
        ms(times[times.len() * 99 / 100]),
        ms(*times.last().ok_or("no cycles")?),
    );
    let shape = if stopped > 0 { "stops" } else { "goes on" };
    println!(
        "{:2} {name:13} {period:6} ms {:6.3} {cycles:8} {wrong:6} {worst:10} {:7} {injected:9} {mean:8.2} {p99:7.2} {longest:11.2} {:10} {shape}",
        joints.len(),
        faults.corrupt + faults.drop + faults.duplicate + faults.delay + faults.truncate,
        counts.missing + counts.implausible,
        memory(),
    );
    Ok(())
}

/// Returns the resident memory, kB; 0 where the system does not tell.
fn memory() -> u64 {
    let text = fs::read_to_string("/proc/self/statm").unwrap_or_default();
    let pages = text.split(' ').nth(1).and_then(|it| it.parse::<u64>().ok());
    pages.unwrap_or_default() * 4
}
