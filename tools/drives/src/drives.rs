//! The joints of a robot as servos on a bus, and the checks that keep a robot whole. Whoever has only these measures: torque and
//! commands belong to the [guard](crate::guard).
//!
//! Angles of this module are those of joints, in deg; counts are those of servos. Every command is limited here, before it leaves.

use crate::bus::{Bus, BusError, MAX_SERVOS, Port, Wire};
use crate::description;
pub use crate::description::{Invalid, Joint, Policy, Settings};
use crate::family::{Family, Mismatch, Query, Reading, Setpoint};
use core::fmt;
use heapless::Vec;
use tip_runtime::hardware::{HardwareFault, JointCommand};
use tip_runtime::model::Range;
use tip_runtime::plant::Gap;

/// A reason why the drives stop the robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Problem {
    /// The port cannot be read or written.
    Port,
    /// A servo did not answer for longer than allowed.
    Silent,
    /// A servo was not asked for so many cycles, because the host was late in each, or away.
    NotRead(u32),
    /// A servo is of another model, whose number this is.
    Model(u16),
    /// A register of a servo gives goals another meaning.
    Register(Mismatch),
    /// °C.
    Hot(f64),
    /// V.
    Voltage(f64),
    /// Load, as a part of the stall torque.
    Overload(f64),
    /// The servo has an alarm; the bits are those of its family.
    Alarm(u8),
    /// The servo has lost its torque and its settings.
    Reset,
    /// The servo's watchdog has stopped it, because it heard nothing for so many ms.
    TimedOut(f64),
    /// The joint is this far from its command, deg.
    Lags(f64),
    /// The joint is at this angle, outside of its limits, deg.
    Outside(f64),
    /// These two parts of the robot would overlap; the command was not sent.
    Collides(Gap),
    /// The joint is commanded a torque.
    Torque,
    /// The bus cannot carry the requests of a cycle.
    Load(Load),
    /// The sampling time is longer than this, ms, so that the watchdogs of the servos would stop a healthy robot.
    Period(f64),
    /// The robot was left, or its torque is not on yet.
    NotHeld,
}

impl Problem {
    /// Returns the cause in an emergency report, which names the servo before it.
    pub const fn words(&self) -> &'static str {
        match self {
            Problem::Port => "the port is gone",
            Problem::Silent => "does not answer",
            Problem::NotRead(_) => "was not read in time",
            Problem::Model(_) => "is of another model",
            Problem::Register(_) => "has other settings",
            Problem::Hot(_) => "is too hot",
            Problem::Voltage(_) => "supply voltage out of range",
            Problem::Overload(_) => "is overloaded",
            Problem::Alarm(_) => "has an alarm",
            Problem::Reset => "was reset",
            Problem::TimedOut(_) => "was stopped by its watchdog",
            Problem::Lags(_) => "does not follow its command",
            Problem::Outside(_) => "is outside of its limits",
            Problem::Collides(_) => "the robot would hit itself",
            Problem::Torque => "takes no torques",
            Problem::Load(_) => "the bus is too slow",
            Problem::Period(_) => "the sampling time is too long",
            Problem::NotHeld => "the robot is not held",
        }
    }
}

/// A problem with its joint and servo.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Failure {
    /// The joint, leg by leg from 0; `None` if all are concerned.
    pub joint: Option<usize>,
    /// Identity of the servo; `None` if all are concerned.
    pub servo: Option<u8>,
    /// The problem.
    pub problem: Problem,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(servo) = self.servo {
            write!(f, "servo {servo}: ")?;
        }
        f.write_str(self.problem.words())
    }
}

impl core::error::Error for Failure {}

impl Failure {
    /// Returns it as the fault of a robot with so many joints per leg.
    pub fn fault(self, of_leg: usize) -> HardwareFault {
        let fault = HardwareFault::new(self.problem.words());
        let fault = self.servo.map_or(fault, |id| fault.of_servo(id.into()));
        let place = |number: usize| u8::try_from(number + 1).ok();
        let leg = self.joint.and_then(|joint| joint.checked_div(of_leg));
        let joint = self.joint.and_then(|joint| joint.checked_rem(of_leg));
        let place = leg.and_then(place).zip(joint.and_then(place));
        place.map_or(fault, |(leg, joint)| fault.at_joint(leg, joint))
    }
}

/// A posture in which two parts of the robot overlap.
#[derive(Clone, Debug, PartialEq)]
pub struct Collision {
    /// The parts, with their distance.
    pub gap: Gap,
    /// The angles of the joints, deg.
    pub angles: Vec<f64, MAX_SERVOS>,
}

/// Returns the overlap of two parts, unless some parts overlap as much `before`: a robot that lies on its legs may be moved out of an
/// overlap.
fn new_overlap(now: Option<Gap>, before: impl FnOnce() -> Option<Gap>) -> Option<Gap> {
    let is_new = |now: &Gap| {
        now.distance < 0.0 && before().is_none_or(|before| now.distance < before.distance)
    };
    now.filter(is_new)
}

/// Least turn of the fastest joint between two postures that are judged on a way, deg.
const SAMPLE: f64 = 0.1;
/// Most postures that are judged on the way to a pose. Each command is judged again before it is sent.
const MAX_SAMPLES: usize = 20_000;

/// The failure of a port that is gone.
const GONE: Failure = Failure {
    joint: None,
    servo: None,
    problem: Problem::Port,
};

/// The last answer of a servo. A value that its family cannot measure, or has not yet, is `None`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Position, counts.
    pub counts: i32,
    /// Load, as a part of the stall torque.
    pub load: Option<f64>,
    /// V.
    pub voltage: Option<f64>,
    /// °C.
    pub temperature: Option<f64>,
    /// Time of the answer on the port's clock, µs.
    pub at: u64,
}

/// The requests of a cycle on a bus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// Time of reading all servos, ms.
    pub read: f64,
    /// Time of commanding all servos, ms.
    pub write: f64,
    /// Sampling time, ms.
    pub period: f64,
    /// Shortest sampling time with which the bus can carry a cycle, ms.
    pub shortest: f64,
    /// Number of cycles in which each servo is read once.
    pub cycles: u32,
}

impl Load {
    /// Returns the time that reading and commanding all servos takes, as a part of the sampling time.
    pub fn part(&self) -> f64 {
        (self.read + self.write) / self.period
    }
}

/// Counts of what the drives have done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Cycles that read.
    pub cycles: u64,
    /// Number of answers that were missing or damaged.
    pub missing: u64,
    /// Valid frames with a content that cannot be.
    pub implausible: u64,
    /// Commands that were slowed down.
    pub slowed: u64,
    /// Commands beyond the limits.
    pub clipped: u64,
    /// Longest time of reading and writing in a cycle, µs.
    pub longest: u64,
    /// Sum of these times, µs.
    pub busy: u64,
    /// Cycles that commanded, of which `busy` is the sum.
    pub commanded: u64,
    /// Sum of their sampling times, µs.
    pub time: u64,
}

/// A joint while it runs.
#[derive(Clone, Debug)]
struct State {
    joint: Joint,
    measured: Option<Measured>,
    /// An answer that was not believed: it is when the next one agrees.
    suspect: Option<Measured>,
    voltage: Slow,
    temperature: Slow,
    /// False until the position is known for sure.
    is_settled: bool,
    /// Number of requests.
    turn: u32,
    /// True if the last request was not answered.
    is_late: bool,
    /// Cycles since the last answer that was believed; 0 if it is of this cycle.
    age: u32,
    /// Number of requests since then.
    unanswered: u32,
    /// Number of answers that were missing or damaged.
    missing: u64,
    /// Error byte of the answers, and another one that came once.
    error: u8,
    other_error: Option<u8>,
    /// Its alarms, in bits of its family.
    alarm: u8,
    /// Answers in a row that say that the torque is off.
    off: u32,
    /// Begin of the last cycle in which the servo answered and its watchdog had not stopped it, µs.
    well: u64,
    /// Angle that was sent last, deg.
    sent: f64,
    /// Time with too much load, and too far away, s.
    overloaded: f64,
    lagging: f64,
}

/// A value that changes slowly, and is not in every answer.
#[derive(Clone, Copy, Debug, Default)]
struct Slow {
    /// The last value that was believed, and its time, µs.
    known: Option<(f64, u64)>,
    /// A value that was not believed: it is when the next one agrees.
    suspect: Option<f64>,
}

impl Slow {
    /// Returns true if a value can follow the last one, from which it differs by `most` and as much more in a second as `rate` says.
    fn accept(&mut self, new: Option<f64>, now: u64, (most, rate): (f64, f64)) -> bool {
        let (Some(new), Some((known, at))) = (new, self.known) else {
            return true;
        };
        let time = now.saturating_sub(at) as f64 / 1e6;
        let is_near = |other: f64, most: f64| (new - other).abs() <= most;
        let is_accepted = is_near(known, most + rate * time)
            || self.suspect.is_some_and(|suspect| is_near(suspect, most));
        self.suspect = (!is_accepted).then_some(new);
        is_accepted
    }

    /// Takes a value over, and returns the last one that is known.
    fn take(&mut self, new: Option<f64>, now: u64) -> Option<f64> {
        self.known = new.map(|new| (new, now)).or(self.known);
        self.known.map(|(value, _)| value)
    }
}

/// The servos of a robot.
#[derive(Debug)]
pub struct Drives<P> {
    bus: Bus<P>,
    settings: Settings,
    joints: Vec<State, MAX_SERVOS>,
    counts: Counts,
    failure: Option<Failure>,
    /// The joint that is read first, where they are read one by one.
    first: usize,
    /// Part of the torque limits that is left while the robot relaxes.
    torque: f64,
    is_held: bool,
    is_resting: bool,
    /// Time of reading in this cycle, µs.
    reading: u64,
    /// Begin of the last cycle, µs.
    begin: u64,
    /// Sampling time, ms.
    period: f64,
    /// Number of cycles that still send the time-outs of watchdogs, because one may not arrive.
    timeouts: u32,
    /// Time of reading all servos, µs.
    read_time: u64,
}

/// Maximum number of repeats of a request at the start and at the end.
const MAX_REPEATS: u32 = 20;
/// Time-out of a watchdog, cycles and ms at least.
const TIMEOUT: (f64, f64) = (10.0, 100.0);
/// Time-out while the servos are switched on one after the other, ms.
const TIMEOUT_AT_START: f64 = 2000.0;
/// Minimum time-out with which a healthy robot goes on, cycles.
const MIN_TIMEOUT: f64 = 3.0;
/// Number of readings in a row that agree about a position.
const AGREEING: u32 = 2;
/// Number of cycles that send a new time-out.
const TIMEOUT_REPEATS: u32 = 3;
/// Number of requests without an answer from which a servo counts as silent.
const MIN_UNANSWERED: u32 = 2;
/// Number of times `silence` after which a robot is stopped whose host cannot read it.
const MAX_NOT_READ: u32 = 3;
/// Least time after which a robot is stopped whose host was away, ms.
const MIN_AWAY: f64 = 1000.0;
/// A difference of positions that noise explains, counts.
const NOISE: f64 = 12.0;
/// The farthest that a servo is beside the way to its goal, deg.
const STRAY: f64 = 5.0;

impl<P: Port> Drives<P> {
    /// Creates the drives of a robot, joint by joint and leg by leg; nothing is sent.
    ///
    /// # Errors
    /// No robot can have such joints or settings.
    pub fn new(mut bus: Bus<P>, joints: &[Joint], settings: Settings) -> Result<Self, Invalid> {
        description::check(joints, &settings)?;
        let states = joints.iter().map(|joint| State {
            joint: *joint,
            measured: None,
            suspect: None,
            voltage: Slow::default(),
            temperature: Slow::default(),
            is_settled: false,
            turn: 0,
            is_late: false,
            age: 0,
            unanswered: 0,
            missing: 0,
            error: 0,
            other_error: None,
            alarm: 0,
            off: 0,
            well: 0,
            sent: 0.0,
            overloaded: 0.0,
            lagging: 0.0,
        });
        bus.set_tries(settings.silence.min(MAX_REPEATS) + 1);
        Ok(Drives {
            bus,
            settings,
            joints: states.collect(),
            counts: Counts::default(),
            failure: None,
            first: 0,
            torque: 1.0,
            is_held: false,
            is_resting: false,
            reading: 0,
            begin: 0,
            period: 20.0,
            timeouts: 0,
            read_time: 0,
        })
    }

    /// Returns the bus.
    pub const fn bus(&self) -> &Bus<P> {
        &self.bus
    }

    /// Returns the bus.
    pub const fn bus_mut(&mut self) -> &mut Bus<P> {
        &mut self.bus
    }

    /// Returns the limits.
    pub const fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Returns the joints.
    pub fn joints(&self) -> impl Iterator<Item = &Joint> {
        self.joints.iter().map(|state| &state.joint)
    }

    /// Returns the last answer of a joint's servo.
    pub fn measured(&self, joint: usize) -> Option<Measured> {
        self.joints.get(joint)?.measured
    }

    /// Returns the last angle of a joint, deg.
    pub fn angle(&self, joint: usize) -> Option<f64> {
        let state = self.joints.get(joint)?;
        Some(state.joint.angle(state.measured?.counts))
    }

    /// Returns the counts.
    pub const fn counts(&self) -> Counts {
        self.counts
    }

    /// Returns the problem that stopped the robot.
    pub const fn failure(&self) -> Option<Failure> {
        self.failure
    }

    /// Forgets the problem that was found, so that the next one is told: nothing has to stop a robot that only a hand moves.
    pub const fn clear_failure(&mut self) {
        self.failure = None;
    }

    /// Returns the family of the servos; `None` if there are no joints.
    pub fn family(&self) -> Option<&'static dyn Family> {
        self.joints.first().map(|state| state.joint.model.family)
    }

    /// Returns the number of cycles since the last answer of a joint's servo that was believed; 0 if it is of this cycle.
    pub fn age(&self, joint: usize) -> Option<u32> {
        self.joints.get(joint).map(|state| state.age)
    }

    /// Returns the number of answers of a joint's servo that were missing or damaged.
    pub fn missing(&self, joint: usize) -> Option<u64> {
        self.joints.get(joint).map(|state| state.missing)
    }

    /// Returns the alarms of a joint's servo, in bits of its family; 0 without one.
    pub fn alarm(&self, joint: usize) -> Option<u8> {
        self.joints.get(joint).map(|state| state.alarm)
    }

    /// Finds every servo, checks its model and its settings, takes over the delay of its answers, and reads its position. Nothing
    /// moves.
    ///
    /// # Errors
    /// A servo is missing or another one, is not well, or its joint is outside of its limits.
    pub fn connect(&mut self) -> Result<(), Failure> {
        self.find(true)
    }

    /// Does the same for a robot that nobody commands: its joints may be anywhere, and the limits in its servos are not compared.
    ///
    /// # Errors
    /// A servo is missing or another one, or is not well.
    pub fn connect_to_measure(&mut self) -> Result<(), Failure> {
        self.find(false)
    }

    fn find(&mut self, is_commanded: bool) -> Result<(), Failure> {
        self.failure = None;
        let mut delay = 0;
        for number in 0..self.joints.len() {
            let joint = self.joints[number].joint;
            let (id, model) = (joint.id, joint.model);
            let family = model.family;
            let is_another = |reported: &Option<u16>| {
                let pair = model.number.zip(*reported);
                pair.is_some_and(|(wanted, reported)| reported != wanted)
            };
            let reported = self.confirmed(number, is_another, |wire| {
                wire.repeat(|wire| family.identify(wire, id))
            })?;
            if let Some(reported) = reported.filter(|reported| is_another(&Some(*reported))) {
                return self.fail(Some(number), Problem::Model(reported));
            }
            let goals = match is_commanded {
                true => joint.goals(),
                // None that a limit could exclude.
                false => (i32::MAX, i32::MIN),
            };
            let wrong = self.confirmed(number, Option::is_some, |wire| {
                family.check(wire, (id, model), goals)
            })?;
            if let Some(mismatch) = wrong {
                return self.fail(Some(number), Problem::Register(mismatch));
            }
            let own = self.confirmed(
                number,
                |delay| *delay > 0,
                |wire| family.return_delay(wire, id),
            )?;
            delay = delay.max(own);
        }
        self.bus.set_return_delay(delay);
        if let Some(family) = self.family() {
            let (one, _) = family.times(self.bus.timing(), self.joints.len());
            self.read_time = one * self.joints.len() as u64;
        }
        let mut least = None;
        // Two readings that agree, so that a damaged one cannot be the first.
        for _ in 0..self.readings() {
            let begin = self.bus.now();
            self.measure(u64::MAX)?;
            if self.joints.iter().all(|state| state.age == 0) {
                let time = self.bus.now() - begin;
                least = Some(least.map_or(time, |least: u64| least.min(time)));
            }
        }
        // The shortest reading has the latency of the adapter, which is unknown before, and no delay of a busy host. Its answers may
        // be short ones.
        self.read_time = self.read_time.max(least.unwrap_or_default());
        self.settle(is_commanded)
    }

    /// Returns the number of readings in which the position of each servo is found, though some answers are missing.
    fn readings(&self) -> u32 {
        2 * (self.settings.silence.min(MAX_REPEATS) + 1)
    }

    /// Measures where the joints are now, whatever was measured before. Nothing moves.
    ///
    /// # Errors
    /// A servo does not answer or is not well, or its joint is outside of its limits.
    pub(crate) fn locate(&mut self) -> Result<(), Failure> {
        for state in &mut self.joints {
            (state.measured, state.suspect, state.is_settled) = (None, None, false);
        }
        let mut complete = 0;
        for _ in 0..self.readings() {
            self.measure(u64::MAX)?;
            let is_complete = self.joints.iter().all(|state| state.age == 0);
            complete = if is_complete { complete + 1 } else { 0 };
            if complete == AGREEING {
                break;
            }
        }
        self.settle(true)
    }

    /// Takes the measured positions for sure, and checks that the joints may be there.
    fn settle(&mut self, is_commanded: bool) -> Result<(), Failure> {
        for number in 0..self.joints.len() {
            let Some(angle) = self.angle(number) else {
                return self.fail(Some(number), Problem::Silent);
            };
            let state = &mut self.joints[number];
            (state.sent, state.is_settled) = (angle, true);
            let Range { min, max } = state.joint.limits;
            // A joint that hangs may hang a little too far.
            if is_commanded && !(min - 5.0..=max + 5.0).contains(&angle) {
                return self.fail(Some(number), Problem::Outside(angle));
            }
        }
        self.check(0.0)
    }

    /// Returns the joints whose torque is on, as their servos answer now. Those that do not answer are left out.
    pub fn stiff(&mut self) -> Vec<usize, MAX_SERVOS> {
        let tries = self.bus.tries();
        self.bus.set_tries(2);
        let is_stiff = |joint: &usize| {
            let Joint { id, model, .. } = self.joints[*joint].joint;
            model.family.is_stiff(&mut self.bus, id) == Ok(true)
        };
        let found = (0..self.joints.len()).filter(is_stiff).collect();
        self.bus.set_tries(tries);
        found
    }

    /// Returns the time of commanding all servos, ms.
    fn write_time(&self) -> f64 {
        let family = self.family();
        let times = family.map(|family| family.times(self.bus.timing(), self.joints.len()));
        times.map_or(0.0, |(_, write)| write as f64 / 1000.0)
    }

    /// Returns the time in which servos are read in a cycle, ms.
    fn reading_time(&self) -> f64 {
        let most = self.settings.reading * self.period;
        most.min(self.period - self.write_time()).max(0.0)
    }

    /// Returns the number of cycles without a reading after which the robot is stopped.
    fn most_not_read(&self) -> u32 {
        MAX_NOT_READ * self.settings.silence.max(1)
    }

    /// Returns the most cycles in which each servo must be read once: one missing answer must not stop the robot.
    fn most_cycles(&self) -> u32 {
        (self.settings.silence.saturating_add(1) / 2).max(1)
    }

    /// Returns the requests of a cycle, as they were measured by the last `connect`.
    pub fn load(&self) -> Load {
        let servos = self.joints.len();
        let (read, write) = (self.read_time as f64 / 1000.0, self.write_time());
        let together = self.family().is_none_or(|family| family.reads_together());
        let (in_a_cycle, least) = match together {
            true => (servos, servos),
            false => (
                (self.reading_time() * servos as f64 / read.max(0.001)) as usize,
                servos.div_ceil(self.most_cycles() as usize),
            ),
        };
        // One is read in any case.
        let cycles = servos.div_ceil(in_a_cycle.max(1)) as u32;
        let least = read * least as f64 / servos.max(1) as f64;
        Load {
            read,
            write,
            period: self.period,
            shortest: (least / self.settings.reading.max(0.01)).max(least + write),
            cycles,
        }
    }

    /// Returns the time-out of the servos' watchdogs, ms; `None` if they have none. It is ten cycles, as far as they can have it.
    pub fn timeout(&self) -> Option<f64> {
        let (shortest, longest) = self.family()?.timeouts()?;
        let (cycles, least) = TIMEOUT;
        Some((cycles * self.period).max(least).clamp(shortest, longest))
    }

    /// Checks that the bus and the watchdogs can have the sampling time.
    ///
    /// # Errors
    /// They cannot.
    pub(crate) fn check_period(&mut self) -> Result<(), Failure> {
        if let Some((_, longest)) = self.family().and_then(Family::timeouts)
            && longest < MIN_TIMEOUT * self.period
        {
            return self.fail(None, Problem::Period(longest / MIN_TIMEOUT));
        }
        let (load, time) = (self.load(), self.reading_time());
        let is_read = match self.family().is_none_or(|family| family.reads_together()) {
            true => load.read <= time,
            false => time > 0.0 && load.cycles <= self.most_cycles(),
        };
        if is_read || self.joints.is_empty() {
            return Ok(());
        }
        self.fail(None, Problem::Load(load))
    }

    /// Returns the command to a joint.
    fn setpoint(&self, joint: usize) -> Setpoint {
        let State { joint, sent, .. } = self.joints[joint];
        Setpoint {
            id: joint.id,
            model: joint.model,
            position: joint.counts(sent),
            speed: joint.speed * joint.gear,
            torque: joint.torque * self.torque,
            period: self.period,
            timeout: self.timeout(),
        }
    }

    fn setpoints(&self) -> Vec<Setpoint, MAX_SERVOS> {
        let joints = 0..self.joints.len();
        joints.map(|joint| self.setpoint(joint)).collect()
    }

    /// Sets speeds and torque limits, and switches the torque on, where each joint was located, as long as `goes_on` returns true,
    /// which is asked before each servo.
    ///
    /// # Errors
    /// A servo does not answer.
    pub(crate) fn hold_while(&mut self, mut goes_on: impl FnMut() -> bool) -> Result<(), Failure> {
        (self.is_held, self.is_resting, self.torque) = (true, false, 1.0);
        for number in 0..self.joints.len() {
            if !goes_on() {
                return Ok(());
            }
            let state = &mut self.joints[number];
            if let Some(measured) = state.measured {
                state.sent = state.joint.angle(measured.counts);
            }
            state.off = 0;
            let mut setpoint = self.setpoint(number);
            let family = setpoint.model.family;
            // Cycles begin when the last servo is on.
            setpoint.timeout = family.timeouts().map(|(shortest, longest)| {
                let time = setpoint.timeout.unwrap_or_default().max(TIMEOUT_AT_START);
                time.clamp(shortest, longest)
            });
            self.request(number, |wire| family.hold(wire, &setpoint))?;
            self.joints[number].well = self.bus.now();
        }
        self.timeouts = TIMEOUT_REPEATS;
        self.begin = self.bus.now();
        Ok(())
    }

    /// Sets the length of the cycles that follow, ms. The first one begins now.
    pub fn set_period(&mut self, period: f64) {
        self.period = period;
        self.begin = self.bus.now();
    }

    /// Moves every joint one cycle of `period` ms towards an angle, at this many deg/s at most, and returns the largest angle
    /// that is left, deg.
    ///
    /// # Errors
    /// Any failure that would stop a run.
    pub(crate) fn approach(
        &mut self,
        to: &[f64],
        speed: f64,
        period: f64,
        gap: impl Fn(&[f64]) -> Option<Gap>,
    ) -> Result<f64, Failure> {
        self.read_cycle()?;
        let mut commands: Vec<JointCommand, MAX_SERVOS> = Vec::new();
        let mut left: f64 = 0.0;
        for (state, to) in self.joints.iter().zip(to) {
            let step = speed.min(state.joint.speed) * period / 1000.0;
            let next = state.sent + (to - state.sent).clamp(-step, step);
            left = left.max((to - state.sent).abs());
            // As many as there are joints.
            let _ = commands.push(JointCommand::at(next));
        }
        self.write_cycle(&commands, period, gap)?;
        Ok(left)
    }

    /// Reads the joints at the beginning of a cycle. A joint without an answer keeps its angle.
    ///
    /// # Errors
    /// The reason to stop the robot.
    pub fn read_cycle(&mut self) -> Result<(), Failure> {
        let begin = self.bus.now();
        let away = begin.saturating_sub(self.begin) as f64 / 1000.0;
        self.begin = begin;
        let allowed = self.reading_time() * 1000.0;
        self.counts.cycles += 1;
        self.measure(begin.saturating_add(allowed as u64))?;
        self.reading = self.bus.now() - begin;
        // Angles are fresh again, but nobody expects a robot to go on after such a rest.
        let longest = f64::from(self.most_not_read()) * self.period;
        if self.is_held && away > longest.max(MIN_AWAY) {
            let cycles = away / self.period;
            return self.fail(Some(0), Problem::NotRead(cycles as u32));
        }
        self.check(self.period / 1000.0)
    }

    /// Returns the angles of the last commands, deg.
    fn sent(&self) -> Vec<f64, MAX_SERVOS> {
        self.joints.iter().map(|state| state.sent).collect()
    }

    /// Returns the first posture with a new overlap of two parts, if approaches at this many deg/s go from the angles of the last
    /// commands through these poses. `gap` returns the least distance of two parts.
    pub(crate) fn collision<'a>(
        &self,
        poses: impl IntoIterator<Item = &'a [f64]>,
        speed: f64,
        gap: impl Fn(&[f64]) -> Option<Gap>,
    ) -> Option<Collision> {
        let mut angles = self.sent();
        let mut before = gap(&angles);
        let speeds = self.joints.iter().map(|state| speed.min(state.joint.speed));
        let fastest = speeds.fold(0.0, f64::max);
        let time = (self.period / 1000.0).max(SAMPLE / fastest);
        for to in poses {
            for _ in 0..MAX_SAMPLES {
                let mut left: f64 = 0.0;
                for ((angle, state), to) in angles.iter_mut().zip(&self.joints).zip(to) {
                    let Range { min, max } = state.joint.limits;
                    let way = to.clamp(min, max) - *angle;
                    let step = speed.min(state.joint.speed) * time;
                    *angle += way.max(-step).min(step);
                    left = left.max(way.abs());
                }
                let now = gap(&angles);
                if let Some(gap) = new_overlap(now, || before) {
                    return Some(Collision { gap, angles });
                }
                before = now;
                if left == 0.0 {
                    break;
                }
            }
        }
        None
    }

    /// Checks that an approach would make no two parts of the robot overlap.
    ///
    /// # Errors
    /// It would, and such a command stops the robot.
    pub(crate) fn check_way(
        &mut self,
        to: &[f64],
        speed: f64,
        gap: impl Fn(&[f64]) -> Option<Gap>,
    ) -> Result<(), Failure> {
        let stops = self.settings.stops_collisions;
        match self.collision([to], speed, gap).filter(|_| stops) {
            Some(Collision { gap, .. }) => self.fail(None, Problem::Collides(gap)),
            None => Ok(()),
        }
    }

    /// Sends a command to each joint, at the end of a cycle of `period` ms. `gap` returns the least distance of two parts of the
    /// robot at the angles to be sent, if it is known.
    ///
    /// # Errors
    /// The port is gone, a joint is commanded a torque, two parts would overlap, or the bus or the watchdogs cannot have this sampling
    /// time.
    pub(crate) fn write_cycle(
        &mut self,
        commands: &[JointCommand],
        period: f64,
        gap: impl Fn(&[f64]) -> Option<Gap>,
    ) -> Result<(), Failure> {
        let begin = self.bus.now();
        if period != self.period {
            let former = self.period;
            self.period = period;
            self.timeouts = TIMEOUT_REPEATS;
            if self.is_held {
                let checked = self.check_period();
                // The robot is left with the one that the bus can carry.
                checked.inspect_err(|_| self.period = former)?;
            }
        }
        let is_torque = |command: &JointCommand| !matches!(command, JointCommand::Angle { .. });
        let mut own = commands.iter().take(self.joints.len());
        // Nothing is sent then, so that no joint counts as commanded.
        if let Some(number) = own.position(is_torque) {
            return self.fail(Some(number), Problem::Torque);
        }
        let mut before: Vec<f64, MAX_SERVOS> = Vec::new();
        for (state, command) in self.joints.iter_mut().zip(commands) {
            let JointCommand::Angle { angle, .. } = *command else {
                continue;
            };
            before.push(state.sent).ok();
            let Range { min, max } = state.joint.limits;
            let inside = angle.clamp(min, max);
            self.counts.clipped += u64::from((inside - angle).abs() > 1e-6);
            let step = state.joint.speed * period / 1000.0;
            let next = state.sent + (inside - state.sent).clamp(-step, step);
            self.counts.slowed += u64::from((next - inside).abs() > 1e-6);
            if !next.is_nan() {
                state.sent = next;
            }
        }
        if self.settings.stops_collisions
            && let Some(gap) = new_overlap(gap(&self.sent()), || gap(&before))
        {
            for (state, before) in self.joints.iter_mut().zip(before) {
                state.sent = before;
            }
            return self.fail(None, Problem::Collides(gap));
        }
        self.send_goals()?;
        let busy = self.bus.now() - begin + self.reading;
        self.counts.busy += busy;
        self.counts.commanded += 1;
        self.counts.time += (period * 1000.0) as u64;
        self.counts.longest = self.counts.longest.max(busy);
        Ok(())
    }

    /// Holds or relaxes the robot in place of a command; returns true when there is nothing left to do. Called in each cycle.
    ///
    /// # Errors
    /// The commands could not be sent.
    pub(crate) fn rest(&mut self, policy: Policy) -> Result<bool, Failure> {
        let Some(family) = self.family().filter(|_| self.is_held) else {
            return Ok(true);
        };
        if policy == Policy::Hold {
            if !self.is_resting {
                // Not where it was to be, which may be behind an obstacle.
                for state in &mut self.joints {
                    if let Some(measured) = state.measured {
                        state.sent = state.joint.angle(measured.counts);
                    }
                }
                self.is_resting = true;
            }
            if self.torque < 1.0 {
                // An emergency stop while it relaxes.
                self.torque = 1.0;
                let setpoints = self.setpoints();
                // Goals tell about a port that is gone.
                let _ = family.write_torque_limits(&mut self.bus, &setpoints);
            }
            return self.send_goals().map(|()| false).map_err(|_| GONE);
        }
        let step = self.period / 1000.0 / self.settings.relaxing.max(0.001);
        self.torque = (self.torque - step).max(0.0);
        if self.torque > 0.0 && family.limits_torque() {
            let setpoints = self.setpoints();
            let sent = family.write_torque_limits(&mut self.bus, &setpoints);
            self.is_held = sent.is_ok();
            return sent.map(|()| false).map_err(|_| GONE);
        }
        self.release().map(|()| true)
    }

    /// Switches the torque of all servos off. Nothing confirms it.
    ///
    /// # Errors
    /// The port is gone.
    pub fn release(&mut self) -> Result<(), Failure> {
        let joints = self.joints.iter();
        let ids: Vec<u8, MAX_SERVOS> = joints.map(|state| state.joint.id).collect();
        (self.is_held, self.torque) = (false, 0.0);
        let family = self.family();
        let sent = family.map_or(Ok(()), |family| family.release(&mut self.bus, &ids));
        sent.map_err(|_| GONE)
    }

    /// Returns true if each servo has answered since a time of the port's clock, µs.
    pub fn is_measured_since(&self, time: u64) -> bool {
        let mut answers = self.joints.iter().map(|state| state.measured);
        answers.all(|measured| measured.is_some_and(|measured| measured.at >= time))
    }

    /// Switches the torque of one servo off; returns true if the servo confirms it. It is tried once.
    ///
    /// # Errors
    /// The port is gone, or the servo does not answer.
    pub fn relax(&mut self, number: usize) -> Result<bool, BusError> {
        self.confirm(number, Policy::Relax)
    }

    /// Brings one servo into the state in which the robot is left, without watchdog; returns true if the servo confirms it, and
    /// false if it reports the other state. It is tried once.
    ///
    /// # Errors
    /// The port is gone, or the servo does not answer.
    pub(crate) fn confirm(&mut self, number: usize, policy: Policy) -> Result<bool, BusError> {
        let tries = self.bus.tries();
        self.bus.set_tries(1);
        let left = self.leave_one(number, policy);
        self.bus.set_tries(tries);
        left
    }

    fn leave_one(&mut self, number: usize, policy: Policy) -> Result<bool, BusError> {
        let mut setpoint = self.setpoint(number);
        (setpoint.timeout, setpoint.torque) = (None, self.joints[number].joint.torque);
        let (id, family) = (setpoint.id, setpoint.model.family);
        let hold = (policy == Policy::Hold).then_some(&setpoint);
        family.leave(&mut self.bus, id, hold)
    }

    /// Asks the servo of a joint.
    fn request<T>(
        &mut self,
        joint: usize,
        request: impl FnOnce(&mut dyn Wire) -> Result<T, BusError>,
    ) -> Result<T, Failure> {
        match request(&mut self.bus) {
            Ok(answer) => Ok(answer),
            Err(BusError::NoAnswer) => self.fail(Some(joint), Problem::Silent),
            Err(_) => self.fail(None, Problem::Port),
        }
    }

    /// Asks the servo of a joint, and again where the answer is doubtful: it counts when it comes twice in a row, because a checksum
    /// of 8 bits lets some damaged answers pass.
    fn confirmed<T: PartialEq>(
        &mut self,
        joint: usize,
        is_doubtful: impl Fn(&T) -> bool,
        request: impl Fn(&mut dyn Wire) -> Result<T, BusError>,
    ) -> Result<T, Failure> {
        let mut answer = self.request(joint, &request)?;
        for _ in 0..MAX_REPEATS {
            if !is_doubtful(&answer) {
                break;
            }
            let again = self.request(joint, &request)?;
            if again == answer {
                break;
            }
            answer = again;
        }
        Ok(answer)
    }

    fn fail<T>(&mut self, joint: Option<usize>, problem: Problem) -> Result<T, Failure> {
        let own = joint.and_then(|joint| self.joints.get(joint));
        let failure = Failure {
            joint,
            servo: own.map(|state| state.joint.id),
            problem,
        };
        Err(*self.failure.get_or_insert(failure))
    }

    /// Asks the servos until a time of the port's clock.
    fn measure(&mut self, limit: u64) -> Result<(), Failure> {
        let Some(family) = self.family() else {
            return Ok(());
        };
        let mut order: Vec<usize, MAX_SERVOS> = (0..self.joints.len()).collect();
        order.rotate_left(self.first);
        let queries: Vec<Query, MAX_SERVOS> = order
            .iter()
            .map(|number| {
                let state = &self.joints[*number];
                Query {
                    id: state.joint.id,
                    turn: state.turn,
                    is_late: state.is_late,
                }
            })
            .collect();
        let mut answers: Vec<Option<Reading>, MAX_SERVOS> = Vec::new();
        // As many as there are joints.
        let _ = answers.resize(order.len(), None);
        let fast = self.settings.fast;
        let read = family.read(
            &mut self.bus,
            &queries,
            limit,
            fast,
            &mut |place, reading| {
                answers[place] = Some(reading);
            },
        );
        let Ok(asked) = read else {
            return self.fail(None, Problem::Port);
        };
        let now = self.bus.now();
        let timeout = self.timeout().filter(|_| self.is_held);
        let mut alarmed = None;
        for state in &mut self.joints {
            state.age = state.age.saturating_add(1);
        }
        for (number, reading) in order.iter().zip(&answers).take(asked) {
            let state = &mut self.joints[*number];
            let taken = reading
                .as_ref()
                .is_some_and(|reading| state.accept(reading, now, self.is_held, self.torque));
            state.turn = state.turn.wrapping_add(1);
            state.is_late = reading.is_none();
            state.unanswered = state.unanswered.saturating_add(1);
            match reading {
                Some(_) => self.counts.implausible += u64::from(!taken),
                None => {
                    state.missing += 1;
                    self.counts.missing += 1;
                }
            }
            // A goal switches the torque of AX, MX and STS servos on again after a reset; their limits are not the robot's then.
            if let Some(reading) = reading.as_ref().filter(|reading| reading.is_on.is_some()) {
                let joint = &state.joint;
                let torque = joint.model.torque_limit(joint.torque * self.torque);
                let speed = joint.model.speed_limit(joint.speed * joint.gear);
                let is_reset = reading.is_on == Some(false)
                    || reading.torque_limit.is_some_and(|own| Some(own) != torque)
                    || reading.speed_limit.is_some_and(|own| own != speed);
                state.off = if is_reset { state.off + 1 } else { 0 };
            }
            if !taken {
                continue;
            }
            (state.age, state.unanswered) = (0, 0);
            let (id, error, rest) = (state.joint.id, state.error, now.saturating_sub(state.well));
            // A cycle more: it counts from the last command, which came before that cycle.
            let rest = rest as f64 / 1000.0 + self.period;
            // The host was away, or the line to the servo.
            if let Some(timeout) = timeout.filter(|timeout| rest > *timeout) {
                match family.has_timed_out(&mut self.bus, id) {
                    Ok(true) => {
                        return self.fail(Some(*number), Problem::TimedOut(timeout));
                    }
                    Ok(false) => self.joints[*number].well = self.begin,
                    // It is asked again in the next cycle.
                    Err(BusError::NoAnswer) => {}
                    Err(_) => return self.fail(None, Problem::Port),
                }
            } else {
                state.well = self.begin;
            }
            let mut bits = family.alarms(error);
            if bits != 0 {
                bits = family.alarm(&mut self.bus, id, error).unwrap_or(bits);
                // Other servos may have an alarm, too.
                alarmed = alarmed.or(Some((*number, bits)));
            }
            self.joints[*number].alarm = bits;
        }
        if let Some((number, bits)) = alarmed {
            return self.fail(Some(number), Problem::Alarm(bits));
        }
        if self.is_held
            && let Some(number) = self.joints.iter().position(|state| state.off > 1)
        {
            return self.fail(Some(number), Problem::Reset);
        }
        if !family.reads_together() {
            self.first = (self.first + asked) % self.joints.len();
        }
        Ok(())
    }

    /// Checks everything that was measured, after a cycle of `time` s.
    fn check(&mut self, time: f64) -> Result<(), Failure> {
        let (settings, is_held) = (self.settings, self.is_held);
        let most_not_read = self.most_not_read();
        let mut found = None;
        for (number, state) in self.joints.iter_mut().enumerate() {
            let Some(measured) = state.measured else {
                continue;
            };
            let since = |sum: f64, is_so: bool| if is_so { sum + time } else { 0.0 };
            let lag = (state.joint.angle(measured.counts) - state.sent).abs();
            let load = measured.load.map_or(0.0, f64::abs);
            state.overloaded = since(state.overloaded, load > settings.overload.0);
            // Without torque it goes where a hand turns it.
            state.lagging = since(state.lagging, is_held && lag > settings.lag.0);
            let hot = measured.temperature.filter(|it| *it > settings.temperature);
            let voltage = measured
                .voltage
                .filter(|it| !settings.voltage.contains(*it));
            // A host that is late in its cycles asks few servos; those that it did not ask are not silent.
            let is_silent = state.unanswered >= MIN_UNANSWERED.min(settings.silence + 1);
            let problem = if state.age > settings.silence && is_silent {
                Problem::Silent
            } else if state.age > most_not_read {
                Problem::NotRead(state.age)
            } else if let Some(temperature) = hot {
                Problem::Hot(temperature)
            } else if let Some(voltage) = voltage {
                Problem::Voltage(voltage)
            } else if state.overloaded > settings.overload.1 {
                Problem::Overload(load)
            } else if state.lagging > settings.lag.1 {
                Problem::Lags(lag)
            } else {
                continue;
            };
            found = found.or(Some((number, problem)));
        }
        found.map_or(Ok(()), |(number, problem)| self.fail(Some(number), problem))
    }

    fn send_goals(&mut self) -> Result<(), Failure> {
        let Some(family) = self.family() else {
            return Ok(());
        };
        let setpoints = self.setpoints();
        let mut sent = Ok(());
        if self.is_held && self.timeouts > 0 {
            // Before a cycle that may be longer than the last one.
            self.timeouts -= 1;
            sent = family.write_timeouts(&mut self.bus, &setpoints);
        }
        let sent = sent.and_then(|()| family.write_goals(&mut self.bus, &setpoints));
        match sent {
            Ok(()) => Ok(()),
            Err(_) => self.fail(None, Problem::Port),
        }
    }
}

impl State {
    /// Takes a reading over, unless no servo could give it: a checksum of 8 bits lets some damaged frames pass. Returns true if it
    /// was taken.
    fn accept(&mut self, reading: &Reading, now: u64, is_held: bool, torque: f64) -> bool {
        let model = self.joint.model;
        // An error byte counts when it has come twice.
        if reading.error != self.error {
            if self.other_error != Some(reading.error) {
                self.other_error = Some(reading.error);
                return false;
            }
            self.error = reading.error;
        }
        self.other_error = None;
        // The byte before the position belongs to one of these, or is the error byte.
        let sent = model.torque_limit(self.joint.torque * torque);
        let is_ours = reading.is_plausible
            && (!is_held || reading.torque_limit.is_none_or(|it| Some(it) == sent));
        let part = |load: i32| model.full_load.map(|full| f64::from(load) / full);
        let new = Measured {
            counts: reading.position,
            load: reading.load.and_then(part),
            voltage: reading.voltage,
            temperature: reading.temperature,
            at: now,
        };
        let possible = is_ours
            && (-model.largest..=2 * model.largest).contains(&new.counts)
            && new.load.is_none_or(|it| it.abs() <= 1.5)
            && new.voltage.is_none_or(|it| (1.0..=60.0).contains(&it))
            && new
                .temperature
                .is_none_or(|it| (-20.0..=120.0).contains(&it));
        let slow = possible
            && self.voltage.accept(new.voltage, now, (3.0, 0.0))
            && self.temperature.accept(new.temperature, now, (5.0, 20.0));
        let is_taken = slow && self.follows(&new, now, is_held);
        let old = self.measured;
        self.suspect = (possible && !is_taken).then_some(new);
        if is_taken {
            self.measured = Some(Measured {
                load: new.load.or(old.and_then(|old| old.load)),
                voltage: self.voltage.take(new.voltage, now),
                temperature: self.temperature.take(new.temperature, now),
                ..new
            });
        } else if !self.is_settled {
            // The one before may have been the damaged one.
            self.measured = None;
            (self.voltage, self.temperature) = (Slow::default(), Slow::default());
        }
        is_taken
    }

    /// Returns true if a position can follow the last one, or one that was not believed.
    fn follows(&self, new: &Measured, now: u64, is_held: bool) -> bool {
        let Some(old) = self.measured else {
            return true;
        };
        let model = self.joint.model;
        let degree = model.turn / 360.0;
        let can_follow = |old: &Measured| {
            let time = now.saturating_sub(old.at) as f64 / 1e6;
            let reach = 1.5 * model.speed * degree * time + NOISE.max(degree);
            f64::from((new.counts - old.counts).abs()) <= reach
        };
        // A servo that holds is between its last position and its goal, or close by.
        let goal = self.joint.counts(self.sent);
        let slack = (STRAY * degree) as i32;
        let (low, high) = (old.counts.min(goal) - slack, old.counts.max(goal) + slack);
        let is_on_its_way = !is_held || (low..=high).contains(&new.counts);
        can_follow(&old) && is_on_its_way || self.suspect.as_ref().is_some_and(can_follow)
    }
}
