//! A real robot, or simulated servos in its place: from its description to joints that a run can move. Simulated servos may also
//! be on a pseudo-terminal, for other masters.

use super::realtime;
use crate::error::Error;
use crate::message::Driving;
use crate::{Status, interrupt, report};
use std::convert::Infallible;
use std::io;
use std::path::Path;
use std::str::FromStr;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use tip_drives::bus::{Bus, Port, Timing};
use tip_drives::drives::{Drives, Failure, Joint, Policy, Problem, Settings};
use tip_drives::model::Model;
use tip_drives::serial::Serial;
use tip_drives::simulated::{Faults, MemoryPort, Servo, SimulatedBus};
use tip_runtime::command::Target;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{HardwareFault, JointCommand};
use tip_runtime::realtime::Pacer;
use tip_sim::{Joints, Robot};
use tipc::description::{self, Description};
use tipc::message::Lang;

/// The name of a port with simulated servos.
pub(crate) const SIMULATED: &str = "simulated";

/// A serial port, or simulated servos.
#[derive(Debug)]
pub(crate) enum AnyPort {
    Serial(Serial),
    Memory(Box<MemoryPort>),
}

fn never<T>(never: Result<T, Infallible>) -> io::Result<T> {
    never.map_err(|never| match never {})
}

impl embedded_io::ErrorType for AnyPort {
    type Error = io::Error;
}

impl embedded_io::Read for AnyPort {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        match self {
            AnyPort::Serial(port) => port.read(into),
            AnyPort::Memory(port) => never(port.read(into)),
        }
    }
}

impl embedded_io::Write for AnyPort {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            AnyPort::Serial(port) => port.write(bytes),
            AnyPort::Memory(port) => never(port.write(bytes)),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            AnyPort::Serial(port) => port.flush(),
            AnyPort::Memory(port) => never(port.flush()),
        }
    }
}

impl Port for AnyPort {
    fn now(&mut self) -> u64 {
        match self {
            AnyPort::Serial(port) => port.now(),
            AnyPort::Memory(port) => port.now(),
        }
    }

    fn wait(&mut self, until: u64) -> io::Result<bool> {
        match self {
            AnyPort::Serial(port) => port.wait(until),
            AnyPort::Memory(port) => never(port.wait(until)),
        }
    }
}

pub(crate) fn open_serial(port: &str, baud: u32, lang: Lang) -> Result<AnyPort, Error> {
    let opened = Serial::open(Path::new(port), baud).map_err(|error| {
        let (name, error) = (port.to_owned().into(), error.to_string().into());
        let reason = match port.split(':').next() {
            Some(SIMULATED) => Driving::NoSimulatedPort,
            _ => Driving::CannotOpen { port: name, error },
        };
        Error::failed(reason, lang)
    })?;
    if let Some(time) = Serial::latency_timer(Path::new(port)).filter(|time| *time > 2) {
        realtime::warn(&[Driving::Adapter { time }], lang);
    }
    Ok(AnyPort::Serial(opened))
}

type Mishap = fn(&mut SimulatedBus, u8);

/// Faults of a simulated bus: `faults=0.01,unplug=3@1.5`, or `corrupt=0.01`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Mishaps {
    /// Probabilities of what happens to an answer.
    faults: Faults,
    /// Events of servos: time, s, in any order; event; identity.
    events: Vec<(f64, Mishap, u8)>,
}

impl FromStr for Mishaps {
    type Err = Driving;

    fn from_str(text: &str) -> Result<Self, Driving> {
        let wrong = || Driving::NotSimulated {
            text: text.to_owned(),
        };
        let mut mishaps = Mishaps::default();
        for part in text.split(',').filter(|part| !part.is_empty()) {
            let (name, value) = part.split_once('=').ok_or_else(wrong)?;
            let faults = &mut mishaps.faults;
            let probability = match name {
                "corrupt" => Some(&mut faults.corrupt),
                "drop" => Some(&mut faults.drop),
                "duplicate" => Some(&mut faults.duplicate),
                "delay" => Some(&mut faults.delay),
                "truncate" => Some(&mut faults.truncate),
                _ => None,
            };
            if name == "faults" || probability.is_some() {
                let part = value.parse().ok();
                let part = part.filter(|it| (0.0..=1.0).contains(it));
                let part = part.ok_or_else(wrong)?;
                match probability {
                    Some(probability) => *probability = part,
                    None => *faults = Faults::evenly(part),
                }
                continue;
            }
            let mishap: Mishap = match name {
                "unplug" => SimulatedBus::unplug,
                "reset" => SimulatedBus::reset,
                "overheat" => SimulatedBus::overheat,
                "block" => SimulatedBus::block,
                "sag" => SimulatedBus::sag,
                _ => return Err(wrong()),
            };
            let (id, time) = value.split_once('@').ok_or_else(wrong)?;
            let event = id.parse().ok().zip(time.parse().ok());
            let (id, time): (u8, f64) = event.ok_or_else(wrong)?;
            mishaps.events.push((time, mishap, id));
        }
        Ok(mishaps)
    }
}

impl Mishaps {
    /// Lets happen what is due at a time, µs.
    pub(crate) fn happen(&mut self, bus: &mut SimulatedBus, now: u64) {
        self.events.retain(|(time, mishap, id)| {
            let is_due = *time * 1e6 <= now as f64;
            if is_due {
                mishap(bus, *id);
            }
            !is_due
        });
    }
}

/// A described robot and the settings of its bus.
#[derive(Debug)]
pub(crate) struct Setup {
    pub(crate) bus: description::Bus,
    pub(crate) joints: Vec<Joint>,
    /// Joints of each leg.
    of_leg: usize,
    /// Initial posture, deg.
    initial: Vec<f64>,
    /// Sampling time, ms.
    period: f64,
}

impl Setup {
    /// Returns the drives of a description.
    ///
    /// # Errors
    /// It has none.
    pub(crate) fn new(file: &Path, description: &Description, lang: Lang) -> Result<Self, Error> {
        let file = file.display().to_string().into();
        let none = || Error::failed(Driving::NoBus { file }, lang);
        let bus = description.bus().ok_or_else(none)?;
        let robot = Robot::described(description).anatomy();
        let joints = bus.drives.iter().filter_map(|drive| {
            Some(Joint {
                id: drive.id,
                // The description was checked for these models.
                model: Model::named(&drive.model)?,
                sign: drive.sign,
                offset: drive.offset,
                gear: drive.gear,
                limits: drive.limits,
                speed: drive.speed,
                torque: drive.torque,
            })
        });
        Ok(Setup {
            joints: joints.collect(),
            of_leg: robot.joints,
            initial: robot
                .legs
                .iter()
                .flat_map(|leg| leg.initial.clone())
                .collect(),
            period: robot.standards.period,
            bus: bus.clone(),
        })
    }

    /// Returns the name of a joint.
    pub(crate) fn name(&self, joint: usize) -> String {
        let of_leg = self.of_leg.max(1);
        let [leg, joint] = [joint / of_leg, joint % of_leg].map(|it| it as u8 + 1);
        Target::Joint(leg, joint).to_string()
    }

    /// Returns simulated servos a little beside the initial posture.
    pub(crate) fn simulated(&self, mishaps: &Mishaps) -> SimulatedBus {
        let servos = self.joints.iter().zip(&self.initial).map(|(joint, angle)| {
            let angle = (angle + 5.0).min(joint.limits.max);
            Servo::new(joint.model, joint.id, joint.counts(angle).into())
        });
        let bus = SimulatedBus::new(servos.collect(), self.timing());
        bus.with_faults(mishaps.faults, 1)
    }

    fn timing(&self) -> Timing {
        Timing {
            baud: self.bus.baud,
            return_delay: 500,
            latency: (self.bus.latency * 1000.0) as u32,
        }
    }

    fn settings(&self) -> Settings {
        let description::Bus {
            silence,
            temperature,
            voltage,
            overload: [load, load_time],
            lag: [lag, lag_time],
            relaxes,
            together,
            ..
        } = self.bus;
        let [at_end, in_emergency] =
            relaxes.map(|relaxes| if relaxes { Policy::Relax } else { Policy::Hold });
        Settings {
            silence,
            temperature,
            voltage,
            overload: (load, load_time),
            lag: (lag, lag_time),
            at_end,
            in_emergency,
            fast: together,
            ..Settings::default()
        }
    }

    /// Opens the port of the command line, or that of the file.
    pub(crate) fn open(
        self,
        file: &Path,
        port: Option<&str>,
        lang: Lang,
    ) -> Result<Connection, Error> {
        let fail = |reason: Driving| Error::failed(reason, lang);
        let port = port.or(self.bus.port.as_deref()).map(str::to_owned);
        let Some(port) = port else {
            let file = file.display().to_string().into();
            return Err(fail(Driving::NoPort { file }));
        };
        let simulated = port
            .strip_prefix(SIMULATED)
            .map(|rest| rest.trim_start_matches(':'));
        let (opened, mishaps) = match simulated {
            Some(mishaps) => {
                let mishaps: Mishaps = mishaps.parse().map_err(fail)?;
                let port = MemoryPort::new(self.simulated(&mishaps));
                (AnyPort::Memory(Box::new(port)), Some(mishaps))
            }
            None => (open_serial(&port, self.bus.baud, lang)?, None),
        };
        if self.joints.is_empty() {
            let file = file.display().to_string().into();
            return Err(fail(Driving::NoBus { file }));
        }
        let bus = Bus::new(opened, self.timing());
        let drives = Drives::new(bus, &self.joints, self.settings());
        let drives = drives.map_err(|error| Error::Failed(error.to_string()))?;
        Ok(Connection {
            setup: self,
            port,
            reached: Reached {
                drives: Arc::new(Mutex::new(drives)),
                mishaps,
                cycle: 0,
                is_held: false,
            },
            lang,
        })
    }
}

/// An open bus with the joints of a robot.
#[derive(Debug)]
pub(crate) struct Connection {
    pub(crate) setup: Setup,
    port: String,
    reached: Reached,
    lang: Lang,
}

/// Drives that a run moves, and that report after it.
#[derive(Clone, Debug)]
struct Reached {
    drives: Arc<Mutex<Drives<AnyPort>>>,
    /// Faults to inject; `None` on a real bus.
    mishaps: Option<Mishaps>,
    /// Time of the next cycle of simulated servos, µs.
    cycle: u64,
    is_held: bool,
}

impl Reached {
    fn drives(&self) -> MutexGuard<'_, Drives<AnyPort>> {
        self.drives.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Lets the time of simulated servos pass to the next cycle.
    fn tick(&mut self, period: f64) {
        let Some(mishaps) = &mut self.mishaps else {
            return;
        };
        let mut drives = self.drives.lock().unwrap_or_else(PoisonError::into_inner);
        if let AnyPort::Memory(port) = drives.bus_mut().port_mut() {
            self.cycle = (self.cycle + (period * 1000.0) as u64).max(port.now());
            port.pass(self.cycle);
            mishaps.happen(&mut port.bus, self.cycle);
        }
    }
}

impl Connection {
    /// Returns true if the servos are simulated: nothing is in danger, and no time passes.
    pub(crate) fn is_simulated(&self) -> bool {
        self.reached.mishaps.is_some()
    }

    pub(crate) fn drives(&self) -> MutexGuard<'_, Drives<AnyPort>> {
        self.reached.drives()
    }

    /// Lets a cycle of simulated servos pass.
    pub(crate) fn tick(&mut self) {
        self.reached.tick(self.setup.period);
    }

    /// Returns the sampling time, ms.
    pub(crate) fn period(&self) -> f64 {
        self.setup.period
    }

    /// Finds the servos, and says which.
    pub(crate) fn connect(&mut self, quiet: bool) -> Result<(), Error> {
        let connected = self.drives().connect();
        connected.map_err(|failure| self.failed(failure))?;
        let Some(joint) = self.setup.joints.first().filter(|_| !quiet) else {
            return Ok(());
        };
        let connected = Driving::Connected {
            servos: self.setup.joints.len(),
            family: joint.model.family.name(),
            port: self.port.clone().into(),
            delay: self.drives().bus().timing().return_delay,
        };
        report::say(connected, self.lang);
        Ok(())
    }

    /// Says where the joints will go before the program starts.
    pub(crate) fn announce(&self) {
        let drives = self.drives();
        let way = |joint: usize| {
            let now = drives.angle(joint).unwrap_or_default();
            (self.setup.initial[joint] - now).abs()
        };
        let joints = 0..self.setup.joints.len();
        let farthest = joints.max_by(|one, other| way(*one).total_cmp(&way(*other)));
        if let Some(joint) = farthest {
            let start = Driving::Start {
                joint: self.setup.name(joint),
                angle: format!("{:.1}", way(joint)),
                speed: self.setup.bus.start,
            };
            report::say(start, self.lang);
        }
    }

    /// Switches the torque on, and moves slowly to the initial posture; `false` if it was interrupted.
    pub(crate) fn stand_ready(&mut self) -> Result<bool, Error> {
        let held = self.drives().hold();
        held.map_err(|failure| self.failed(failure))?;
        self.reached.is_held = true;
        let (mut pacer, mut settled) = (Pacer::start(), 0);
        let period = self.setup.period;
        // Some cycles more, so that the last command is reached.
        while settled < 15 {
            self.tick();
            let (initial, speed) = (&self.setup.initial, self.setup.bus.start);
            let left = self.drives().approach(initial, speed, period);
            let left = left.map_err(|failure| {
                self.finish(true);
                self.failed(failure)
            })?;
            settled += u32::from(left == 0.0);
            if interrupt::is_requested() {
                self.finish(false);
                return Ok(false);
            }
            if !self.is_simulated() {
                realtime::wait_until(pacer.due(period));
            }
        }
        Ok(true)
    }

    /// Returns the joints for a run.
    pub(crate) fn joints(&self) -> impl Joints + use<> {
        self.reached.clone()
    }

    /// Holds or relaxes the robot for good.
    pub(crate) fn finish(&mut self, in_emergency: bool) {
        if !std::mem::take(&mut self.reached.is_held) {
            return;
        }
        let mut drives = self.reached.drives();
        let settings = drives.settings();
        let policy = match in_emergency {
            true => settings.in_emergency,
            false => settings.at_end,
        };
        while !drives.rest(policy) && policy == Policy::Relax {
            if self.reached.mishaps.is_none() {
                std::thread::sleep(Duration::from_secs_f64(self.setup.period / 1000.0));
            }
        }
        drives.leave();
    }

    /// Returns the error for a failure.
    pub(crate) fn failed(&self, failure: Failure) -> Error {
        Error::Failed(self.explain(failure))
    }

    /// Returns the reason of a failure, and a way out.
    pub(crate) fn explain(&self, failure: Failure) -> String {
        let place = failure.joint.unwrap_or_default();
        let joint = self.setup.name(place);
        let Some(own) = self.setup.joints.get(place) else {
            return failure.to_string();
        };
        let (id, bus) = (u32::from(own.id), &self.setup.bus);
        let message = match failure.problem {
            Problem::Port => Driving::PortGone,
            Problem::Silent => Driving::Silent {
                joint,
                id,
                cycles: bus.silence,
            },
            Problem::Model(number) => Driving::OtherModel {
                joint,
                id,
                number: number.into(),
                model: own.model.name,
            },
            Problem::Register(wrong) => Driving::WrongRegister {
                joint,
                id,
                name: wrong.name,
                register: wrong.register.into(),
                value: wrong.value.to_string(),
                wanted: wrong.wanted.to_string(),
            },
            Problem::Hot(now) => Driving::Hot {
                joint,
                id,
                now,
                most: bus.temperature,
            },
            Problem::Voltage(now) => Driving::Voltage {
                joint,
                id,
                now,
                min: bus.voltage.min,
                max: bus.voltage.max,
            },
            Problem::Overload(load) => Driving::Overload {
                joint,
                id,
                load: format!("{load:.2}"),
                most: bus.overload[0],
            },
            Problem::Alarm(bits) => Driving::Alarm {
                joint,
                id,
                bits: bits.into(),
                meaning: own.model.family.cause(bits),
            },
            Problem::Reset => Driving::Reset { joint, id },
            Problem::Lags(angle) => Driving::Lags {
                joint,
                id,
                angle: format!("{angle:.1}"),
                most: bus.lag[0],
            },
            Problem::Outside(angle) => Driving::Outside {
                joint,
                id,
                angle: format!("{angle:.1}"),
                min: own.limits.min,
                max: own.limits.max,
            },
            Problem::Torque => Driving::NoTorques { joint },
            Problem::Load(load) => Driving::BusTooSlow {
                percent: format!("{:.0}", load.part * 100.0),
                cycles: load.cycles,
                silence: bus.silence,
            },
            Problem::Period(most) => Driving::PeriodTooLong {
                most: format!("{most:.0}"),
            },
        };
        message.in_lang(self.lang).to_string()
    }
}

impl Drop for Connection {
    /// A panic of this process leaves the robot as an emergency does.
    fn drop(&mut self) {
        self.finish(true);
    }
}

impl Joints for Reached {
    fn read(&mut self, angles: &mut [f64], ages: &mut [u32]) -> Result<(), HardwareFault> {
        let mut drives = self.drives.lock().unwrap_or_else(PoisonError::into_inner);
        drives.read_cycle()?;
        for (joint, angle) in angles.iter_mut().enumerate() {
            *angle = drives.angle(joint).unwrap_or(*angle);
        }
        for (joint, age) in ages.iter_mut().enumerate() {
            *age = drives.age(joint).unwrap_or_default();
        }
        Ok(())
    }

    fn write(&mut self, commands: &[JointCommand], period: f64) -> Result<(), HardwareFault> {
        self.drives().write_cycle(commands, period)?;
        self.tick(period);
        Ok(())
    }

    fn stop(&mut self, _why: &Fault) {
        let mut drives = self.drives();
        let policy = drives.settings().in_emergency;
        drives.rest(policy);
    }
}

/// Serves a bus until it is interrupted; `announce` gets the name of its port.
#[cfg(unix)]
pub(super) fn serve(
    setup: &Setup,
    mut mishaps: Mishaps,
    _: Lang,
    announce: impl FnOnce(String) -> Result<(), Error>,
) -> Result<Status, Error> {
    use nix::fcntl::{OFlag, open};
    use nix::poll::{PollFd, PollFlags, ppoll};
    use nix::pty::{grantpt, posix_openpt, ptsname_r, unlockpt};
    use nix::sys::stat::Mode;
    use nix::sys::termios::{SetArg, cfmakeraw, tcgetattr, tcsetattr};
    use nix::sys::time::TimeSpec;
    use nix::unistd::{read, write};
    use std::os::fd::AsFd;
    let failed = |error: nix::Error| Error::Failed(io::Error::from(error).to_string());

    let pty = posix_openpt(OFlag::O_RDWR | OFlag::O_NOCTTY).map_err(failed)?;
    grantpt(&pty).map_err(failed)?;
    unlockpt(&pty).map_err(failed)?;
    let name = ptsname_r(&pty).map_err(failed)?;
    // Kept open, so that masters can come and go.
    let flags = OFlag::O_RDWR | OFlag::O_NOCTTY;
    let other = open(name.as_str(), flags, Mode::empty()).map_err(failed)?;
    let mut settings = tcgetattr(&other).map_err(failed)?;
    cfmakeraw(&mut settings);
    tcsetattr(&other, SetArg::TCSANOW, &settings).map_err(failed)?;
    announce(name)?;

    let mut bus = setup.simulated(&mishaps);
    let start = Instant::now();
    while !interrupt::is_requested() {
        let now = start.elapsed().as_micros() as u64;
        bus.advance(now);
        mishaps.happen(&mut bus, now);
        let due = bus.take_bytes(now, 4096);
        let mut left = &due[..];
        while !left.is_empty() {
            let count = write(&pty, left).map_err(failed)?;
            left = &left[count..];
        }
        let until = bus.next_byte().unwrap_or(now + 5000);
        let wait = TimeSpec::from_duration(Duration::from_micros(until.saturating_sub(now)));
        let mut polled = [PollFd::new(pty.as_fd(), PollFlags::POLLIN)];
        match ppoll(&mut polled, Some(wait), None) {
            Ok(0) | Err(nix::Error::EINTR) => continue,
            Ok(_) => {}
            Err(error) => return Err(failed(error)),
        }
        let mut bytes = [0; 1024];
        let count = read(&pty, &mut bytes).map_err(failed)?;
        bus.receive(&bytes[..count], start.elapsed().as_micros() as u64);
    }
    Ok(Status::Interrupted)
}

#[cfg(not(unix))]
pub(super) fn serve(
    _: &Setup,
    _: Mishaps,
    lang: Lang,
    _: impl FnOnce(String) -> Result<(), Error>,
) -> Result<Status, Error> {
    let _ = (Instant::now(), interrupt::is_requested());
    Err(Error::failed(Driving::NotHere, lang))
}
