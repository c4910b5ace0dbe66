//! The owner of a robot whose torque is on: it connects, approaches the first posture, is stepped as the [`Hardware`] of a machine,
//! and leaves the servos in the state that their [`Settings`] name.
//!
//! A program that moves a robot holds a [`TorqueGuard`]. Dropping it leaves the robot as in an emergency, so that a panic of the host
//! ends in that state. Limits of commands and checks of answers belong to [`drives`](crate::drives).
//!
//! Time comes from the port's clock; the [`Host`] waits for it, and says in each cycle what the operator asks for.
//!
//! ```
//! use tip_drives::bus::{Bus, Port, Timing};
//! use tip_drives::drives::{Drives, Joint, Settings};
//! use tip_drives::guard::{Host, Request, Step, TorqueGuard};
//! use tip_drives::simulated::{MemoryPort, Servo, SimulatedBus};
//! use tip_drives::Model;
//! use tip_runtime::model::Range;
//!
//! /// A host whose operator presses nothing.
//! struct Nobody;
//!
//! impl Host<MemoryPort> for Nobody {
//!     fn wait(&mut self, port: &mut MemoryPort, until: u64) {
//!         port.pass(until);
//!     }
//!
//!     fn request(&mut self) -> Option<Request> {
//!         None
//!     }
//! }
//!
//! let model = Model::named("AX-12").unwrap();
//! let joint = Joint {
//!     id: 1,
//!     model,
//!     sign: 1.0,
//!     offset: 0.0,
//!     gear: 1.0,
//!     limits: Range::new(-90.0, 90.0),
//!     speed: 180.0,
//!     torque: 0.8,
//! };
//! let timing = Timing { baud: 1_000_000, return_delay: 0, latency: 2000 };
//! let servos = vec![Servo::new(model, 1, 512.0)];
//! let port = MemoryPort::new(SimulatedBus::new(servos, timing));
//! let bus = Bus::new(port, timing);
//! let drives = Drives::new(bus, &[joint], Settings::default())?;
//!
//! let mut robot = TorqueGuard::new(drives, Nobody, 20.0);
//! robot.connect()?;
//! assert_eq!(robot.approach(&[10.0], 30.0)?, Step::Arrived);
//! robot.leave();
//! assert!(robot.outcome().unwrap().is_certain());
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use crate::bus::{BusError, MAX_SERVOS, Port, Wire};
use crate::drives::{Collision, Drives, Failure, Policy, Problem, Settings};
use heapless::Vec;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, Inputs, JointCommand, Outputs, Sensors};
use tip_runtime::plant::Gap;

/// Time in which the servos confirm the state in which they are left, µs.
pub const LEAVING_LIMIT: u64 = 3_000_000;
/// Longest cycle of leaving, ms. A program may have set any sampling time.
const LEAVING_PERIOD: f64 = 20.0;
/// Cycles after the last command of an approach, in which the servos reach it.
pub const SETTLING: u32 = 15;
/// Cycles in which each servo is read once, where they are read one by one.
const READINGS: u32 = 4;

/// A request by the operator of a robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Request {
    /// The ordered end: the servos get the state of [`Settings::at_end`].
    End,
    /// The emergency stop: the servos get the state of [`Settings::in_emergency`].
    EmergencyStop,
}

/// The program that moves a robot: how it waits, and what its operator asks for.
pub trait Host<P> {
    /// Waits until a time of the port's clock, µs. It may return early, but not late.
    fn wait(&mut self, port: &mut P, until: u64);

    /// Returns what the operator asks for. It is called in each cycle of approaching and of leaving.
    fn request(&mut self) -> Option<Request>;

    /// Returns the least distance of two parts of the robot at these joint angles, deg, leg by leg; `None` where nobody knows it.
    /// A command to a posture in which two parts overlap is not sent, and stops the robot, if [`Settings::stops_collisions`] is true.
    /// A robot that was found in an overlap may still get commands that make it no deeper.
    fn gap(&self, angles: &[f64]) -> Option<Gap> {
        let _ = angles;
        None
    }
}

/// The state of a robot after a cycle of [`TorqueGuard::step`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// A joint is on its way.
    Moving,
    /// All joints were commanded their angles.
    Arrived,
    /// The operator asked for this, and the robot was left.
    Left(Request),
}

/// The state in which a robot was left.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The state that its servos were to have.
    pub policy: Policy,
    /// Joints whose servos have the other state: stiff in place of relaxed, or without torque in place of holding.
    pub other: Vec<usize, MAX_SERVOS>,
    /// Joints whose servos did not confirm their state in time.
    pub unknown: Vec<usize, MAX_SERVOS>,
}

impl Outcome {
    /// Returns true if each servo has confirmed the state that it was to have.
    pub fn is_certain(&self) -> bool {
        self.other.is_empty() && self.unknown.is_empty()
    }
}

#[allow(clippy::large_enum_variant, reason = "there is no allocator")]
#[derive(Debug)]
enum State {
    /// No torque was switched on yet.
    Off,
    /// The torque is on, or may be on.
    On,
    /// The robot was left.
    Left(Outcome),
}

/// The drives of a robot from the first torque to the last.
#[derive(Debug)]
pub struct TorqueGuard<P: Port, H: Host<P>> {
    drives: Drives<P>,
    host: H,
    /// Sampling time, ms.
    period: f64,
    state: State,
    /// Number of joints whose torque was switched on.
    switched_on: usize,
    /// True if the robot was stopped: it is left as in an emergency.
    is_stopped: bool,
    /// Time of the next cycle of approaching and leaving, µs.
    due: u64,
    /// Readings of inputs that are not on the bus.
    inputs: Inputs,
}

impl<P: Port, H: Host<P>> TorqueGuard<P, H> {
    /// Creates the guard of a robot without torque, with a sampling time in ms. Nothing is sent.
    pub const fn new(drives: Drives<P>, host: H, period: f64) -> Self {
        TorqueGuard {
            drives,
            host,
            period,
            state: State::Off,
            switched_on: 0,
            is_stopped: false,
            due: 0,
            inputs: Inputs::all(f64::NAN),
        }
    }

    /// Returns the drives.
    pub const fn drives(&self) -> &Drives<P> {
        &self.drives
    }

    /// Returns the drives, for reading and for requests on the bus.
    pub const fn drives_mut(&mut self) -> &mut Drives<P> {
        &mut self.drives
    }

    /// Returns the host.
    pub const fn host_mut(&mut self) -> &mut H {
        &mut self.host
    }

    /// Returns the readings of inputs that are not on the bus, V, such as sticks of the host, to be set before a cycle. NaN, which
    /// they are at first, where nothing is connected: a program that reads it is stopped.
    pub const fn inputs_mut(&mut self) -> &mut Inputs {
        &mut self.inputs
    }

    /// Returns true if the torque is on, or may be on.
    pub const fn has_torque(&self) -> bool {
        matches!(self.state, State::On)
    }

    /// Returns true if the robot was stopped: it is left as in an emergency.
    pub const fn is_stopped(&self) -> bool {
        self.is_stopped
    }

    /// Returns the state in which the robot was left; `None` before.
    pub const fn outcome(&self) -> Option<&Outcome> {
        match &self.state {
            State::Left(outcome) => Some(outcome),
            _ => None,
        }
    }

    /// Finds and checks the servos. Nothing moves.
    ///
    /// # Errors
    /// A servo is missing, is another one, or is not well, or the bus or the watchdogs cannot have the sampling time.
    pub fn connect(&mut self) -> Result<(), Failure> {
        self.drives.set_period(self.period);
        self.drives.connect()?;
        self.drives.check_period()
    }

    /// Switches the torque on, servo by servo, each where it is now: a hand may have turned it since [`connect`](Self::connect).
    ///
    /// # Errors
    /// A joint is where it must not be, or the robot cannot have its sampling time, and no torque was switched on; or a servo does not
    /// answer, and the robot was left as in an emergency.
    pub fn hold(&mut self) -> Result<Step, Failure> {
        self.locate()?;
        self.switch_on()
    }

    /// Measures where the robot is, which has no torque yet.
    fn locate(&mut self) -> Result<(), Failure> {
        self.is_stopped = false;
        self.drives.set_period(self.period);
        self.drives.check_period()?;
        self.drives.locate()
    }

    /// Switches the torque on, where the robot was measured to be.
    fn switch_on(&mut self) -> Result<Step, Failure> {
        self.state = State::On;
        let (host, mut asked, mut count) = (&mut self.host, None, 0);
        let held = self.drives.hold_while(|| {
            asked = asked.or(host.request());
            count += usize::from(asked.is_none());
            asked.is_none()
        });
        self.switched_on = count;
        self.due = self.now();
        match (held, asked) {
            (Err(failure), _) => Err(self.give_up(failure)),
            (Ok(()), Some(request)) => Ok(self.obey(request)),
            (Ok(()), None) => Ok(Step::Moving),
        }
    }

    /// Moves every joint for a cycle towards an angle, deg, at this many deg/s at most, and waits until the cycle is over.
    ///
    /// # Errors
    /// Any failure that would stop a run; the robot was left as in an emergency.
    pub fn step(&mut self, to: &[f64], speed: f64) -> Result<Step, Failure> {
        if let Some(request) = self.host.request() {
            return Ok(self.obey(request));
        }
        let host = &self.host;
        let gap = |angles: &[f64]| host.gap(angles);
        match self.drives.approach(to, speed, self.period, gap) {
            Err(failure) => Err(self.give_up(failure)),
            Ok(left) => {
                self.wait();
                Ok(match left > 0.0 {
                    true => Step::Moving,
                    false => Step::Arrived,
                })
            }
        }
    }

    /// Switches the torque on and moves every joint to an angle, deg, at this many deg/s at most.
    ///
    /// # Errors
    /// Two parts of the robot would overlap on the way, and no torque was switched on; or any failure that would stop a run, and the
    /// robot was left as in an emergency.
    pub fn approach(&mut self, to: &[f64], speed: f64) -> Result<Step, Failure> {
        self.locate()?;
        let host = &self.host;
        let gap = |angles: &[f64]| host.gap(angles);
        self.drives.check_way(to, speed, gap)?;
        match self.switch_on()? {
            Step::Left(request) => Ok(Step::Left(request)),
            Step::Moving | Step::Arrived => self.reach(to, speed),
        }
    }

    /// Returns the first posture in which two parts of the robot would overlap, if it went from where it was last commanded to be, or
    /// measured before it has torque, through these poses (deg), at this many deg/s at most. Nothing moves.
    pub fn collision<'a>(
        &self,
        poses: impl IntoIterator<Item = &'a [f64]>,
        speed: f64,
    ) -> Option<Collision> {
        let gap = |angles: &[f64]| self.host.gap(angles);
        self.drives.collision(poses, speed, gap)
    }

    /// Moves every joint of a robot that [holds](Self::hold) to an angle, deg, at this many deg/s at most, and gives the servos time to
    /// get there.
    ///
    /// # Errors
    /// Any failure that would stop a run; the robot was left as in an emergency.
    pub fn reach(&mut self, to: &[f64], speed: f64) -> Result<Step, Failure> {
        let mut settled = 0;
        loop {
            let step = self.step(to, speed)?;
            settled += u32::from(step == Step::Arrived);
            if settled == SETTLING || matches!(step, Step::Left(_)) {
                return Ok(step);
            }
        }
    }

    /// Makes [`leave`](Self::leave) treat the robot as in an emergency.
    pub const fn emergency_stop(&mut self) {
        self.is_stopped = true;
    }

    fn give_up(&mut self, failure: Failure) -> Failure {
        self.emergency_stop();
        self.leave();
        failure
    }

    /// Leaves the robot as the operator asks.
    pub fn obey(&mut self, request: Request) -> Step {
        self.is_stopped |= request == Request::EmergencyStop;
        self.leave();
        Step::Left(match self.is_stopped {
            true => Request::EmergencyStop,
            false => Request::End,
        })
    }

    /// Waits until the cycle is over: for a machine that nobody else paces.
    pub fn wait(&mut self) {
        self.pass(self.period);
    }

    /// Waits until a cycle of `period` ms is over.
    fn pass(&mut self, period: f64) {
        self.due = (self.due + (period * 1000.0) as u64).max(self.now());
        let port = self.drives.bus_mut().port_mut();
        self.host.wait(port, self.due);
    }

    const fn policy(&self) -> Policy {
        let Settings {
            at_end,
            in_emergency,
            ..
        } = *self.drives.settings();
        if self.is_stopped {
            in_emergency
        } else {
            at_end
        }
    }

    /// Holds or relaxes the robot for good: as at an end, or as in an emergency if there was one. An emergency stop in the
    /// meantime changes the state that is aimed at. It takes the time in which the torque falls, and [`LEAVING_LIMIT`] at most.
    pub fn leave(&mut self) {
        if !self.has_torque() {
            return;
        }
        let period = self.period.clamp(1.0, LEAVING_PERIOD);
        self.drives.set_period(period);
        self.due = self.now();
        let outcome = loop {
            let policy = self.policy();
            let is_at_rest = self.rest(policy, period);
            let outcome = is_at_rest.then(|| self.confirm(policy, period));
            if let Some(outcome) = outcome.flatten() {
                break outcome;
            }
        };
        self.state = State::Left(outcome);
    }

    fn now(&mut self) -> u64 {
        self.drives.bus_mut().now()
    }

    /// Returns true if the operator has not asked for another state than this.
    fn is_still(&mut self, policy: Policy) -> bool {
        if self.host.request() == Some(Request::EmergencyStop) {
            self.emergency_stop();
        }
        self.policy() == policy
    }

    /// Sends the commands to hold or to relax; returns false if the operator has asked for another state.
    fn rest(&mut self, policy: Policy, period: f64) -> bool {
        if policy == Policy::Hold && self.switched_on < self.drives.joints().count() {
            // A goal would switch the torque of some servos on. `confirm` holds those that have torque.
            return true;
        }
        let begin = self.now();
        let relaxing = (self.drives.settings().relaxing.clamp(0.0, 60.0) * 1e6) as u64;
        let limit = begin + relaxing + LEAVING_LIMIT;
        // A robot that holds does so where it is now. Its faults stop nothing any more.
        for _ in 0..READINGS {
            let _ = self.drives.read_cycle();
            if policy == Policy::Relax || self.drives.is_measured_since(begin) {
                break;
            }
        }
        while self.drives.rest(policy) == Ok(false) && policy == Policy::Relax && self.due < limit {
            self.pass(period);
            if !self.is_still(policy) {
                return false;
            }
            let _ = self.drives.read_cycle();
        }
        true
    }

    /// Repeats the last commands, servo by servo, until each servo has confirmed its state; `None` if the operator has asked for
    /// another state.
    fn confirm(&mut self, policy: Policy, period: f64) -> Option<Outcome> {
        let limit = self.now() + LEAVING_LIMIT;
        let joints = match policy {
            Policy::Hold => self.switched_on,
            Policy::Relax => self.drives.joints().count(),
        };
        let mut open: Vec<usize, MAX_SERVOS> = (0..joints).collect();
        let mut other: Vec<usize, MAX_SERVOS> = Vec::new();
        'rounds: while !open.is_empty() {
            for joint in open.clone() {
                if !self.is_still(policy) {
                    return None;
                }
                if self.now() >= limit {
                    break 'rounds;
                }
                other.retain(|it| *it != joint);
                match self.drives.confirm(joint, policy) {
                    Ok(true) => open.retain(|it| *it != joint),
                    // There are at most as many as joints.
                    Ok(false) => drop(other.push(joint)),
                    Err(BusError::Port) => break 'rounds,
                    Err(_) => {}
                }
            }
            if !open.is_empty() {
                self.pass(period);
            }
        }
        // A robot that was left while its torque was switched on holds with some of its servos.
        let stiff = match joints < self.drives.joints().count() {
            true => self.drives.stiff(),
            false => Vec::new(),
        };
        let limp = (joints..self.drives.joints().count()).filter(|it| !stiff.contains(it));
        other.extend(limp);
        let unknown = open.into_iter().filter(|it| !other.contains(it));
        Some(Outcome {
            policy,
            unknown: unknown.collect(),
            other,
        })
    }

    /// Measures the joints at the beginning of a cycle.
    ///
    /// # Errors
    /// The reason to stop the robot, or it is not held.
    pub fn read_cycle(&mut self) -> Result<(), Failure> {
        self.require_torque()?;
        self.drives.read_cycle()
    }

    const fn require_torque(&self) -> Result<(), Failure> {
        match self.state {
            State::On => Ok(()),
            State::Off | State::Left(_) => Err(NOT_HELD),
        }
    }

    /// Sends a command to each joint, at the end of a cycle of `period` ms.
    ///
    /// # Errors
    /// The reason to stop the robot, or it is not held.
    pub fn write_cycle(&mut self, commands: &[JointCommand], period: f64) -> Result<(), Failure> {
        self.require_torque()?;
        let host = &self.host;
        let gap = |angles: &[f64]| host.gap(angles);
        self.drives.write_cycle(commands, period, gap)?;
        self.period = period;
        Ok(())
    }

    /// Stops the robot, in place of a command: it is left as in an emergency from now on. Called in each cycle.
    ///
    /// # Errors
    /// The port is gone.
    pub fn stop_cycle(&mut self) -> Result<(), Failure> {
        self.emergency_stop();
        match self.has_torque() {
            true => self.drives.rest(self.policy()).map(drop),
            false => Ok(()),
        }
    }
}

impl<P: Port, H: Host<P>> Drop for TorqueGuard<P, H> {
    /// Leaves the robot as in an emergency, if nobody has left it.
    fn drop(&mut self) {
        self.emergency_stop();
        self.leave();
    }
}

/// The failure of a robot that was left, or was not yet held.
const NOT_HELD: Failure = Failure {
    joint: None,
    servo: None,
    problem: Problem::NotHeld,
};

impl<P: Port, H: Host<P>, const L: usize, const J: usize> Hardware<L, J> for TorqueGuard<P, H> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        self.read_cycle().map_err(|failure| failure.fault(J))?;
        for (number, angle) in into.angles.as_flattened_mut().iter_mut().enumerate() {
            *angle = self.drives.angle(number).unwrap_or(*angle);
        }
        for (number, age) in into.ages.as_flattened_mut().iter_mut().enumerate() {
            *age = self.drives.age(number).unwrap_or_default();
        }
        into.inputs = self.inputs;
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        let written = self.write_cycle(outputs.joints.as_flattened(), outputs.period);
        written.map_err(|failure| failure.fault(J))
    }

    fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
        self.stop_cycle().map_err(|failure| failure.fault(J))
    }
}
