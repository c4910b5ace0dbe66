//! A real robot, or one of simulated servos: from its description to joints that a run can move.

use super::port::open_serial;
use super::realtime;
use super::simulated::FaultInjection;
use crate::error::Error;
use crate::interrupt::Cause;
use crate::message::{Driving, Stopping};
use crate::{Status, interrupt, report};
use std::borrow::{Borrow, BorrowMut};
use std::io;
use std::ops::Deref;
use std::path::Path;
use std::slice;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tip_drives::described::{Described, NotOnBus};
use tip_drives::drives::{Collision, Failure, Policy, Problem};
use tip_drives::guard::{Host, Request, Step, TorqueGuard};
use tip_drives::operator::{self, Operator, Unsettled};
use tip_drives::port::{AnyPort, SIMULATED};
use tip_drives::simulated::{MemoryPort, SimulatedBus};
use tip_runtime::console::Terminal;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{HardwareFault, JointCommand};
use tip_runtime::model::Part;
use tip_runtime::plant::Gap;
use tip_runtime::realtime::Pacer;
use tip_sim::Joints;
use tip_sim::import::not_compared;
use tip_view::live::ServoState;
use tipc::description::Description;
use tipc::message::Lang;
use tipc::message::list::List;

/// A described robot on a bus, for the commands.
#[derive(Clone, Debug)]
pub(crate) struct Setup(Described);

impl Deref for Setup {
    type Target = Described;

    fn deref(&self) -> &Described {
        &self.0
    }
}

impl Setup {
    /// Returns the drives of a description.
    ///
    /// # Errors
    /// It has none, or what they cannot do.
    pub(crate) fn new(file: &Path, description: &Description, lang: Lang) -> Result<Self, Error> {
        let described = Described::new(description).map_err(|refused| {
            let file = file.display().to_string().into();
            let reason = match refused {
                NotOnBus::NoBus => Driving::NoBus { file },
                NotOnBus::NoServo(table) => Driving::NotOnBus { file, table },
            };
            Error::failed(reason, lang)
        })?;
        Ok(Setup(described))
    }

    /// Returns simulated servos a little beside the initial posture.
    pub(crate) fn simulated(&self, injection: &FaultInjection) -> SimulatedBus {
        self.0.simulated().with_faults(injection.faults, 1)
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
        let simulated = match port.strip_prefix(SIMULATED) {
            Some("") => Some(""),
            Some(list) => list.strip_prefix(':'),
            None => None,
        };
        let (opened, injection) = match simulated {
            Some(injection) => {
                let mut injection = FaultInjection::new(injection, &self.ids()).map_err(fail)?;
                let mut bus = self.simulated(&injection);
                injection.inject(&mut bus, 0);
                (
                    AnyPort::Memory(Box::new(MemoryPort::new(bus))),
                    Some(injection),
                )
            }
            None => (open_serial(&port, self.bus.baud, lang)?, None),
        };
        let drives = self
            .drives(opened)
            .map_err(|error| Error::Failed(error.to_string()))?;
        let (is_simulated, period) = (injection.is_some(), self.period);
        let host = Attended {
            operator: Operator::of_signals(interrupt::signal()).of_robot(&self),
            injection,
            stop: Arc::default(),
            period,
        };
        let robot = TorqueGuard::new(drives, host, period);
        Ok(Connection {
            setup: self,
            port,
            robot: Arc::new(Mutex::new(robot)),
            is_simulated,
            lang,
        })
    }

    /// Returns the identities of the servos.
    pub(super) fn ids(&self) -> Vec<u8> {
        self.joints.iter().map(|joint| joint.id).collect()
    }
}

/// Returns lines about the servos that are not in the state in which a robot was to be left.
fn lines(left: Result<(), Unsettled>, lang: Lang) -> String {
    let Err(Unsettled {
        policy,
        other,
        unknown,
    }) = left
    else {
        return String::new();
    };
    let are = [&other, &unknown].map(|joints| !joints.is_empty());
    let messages = match policy {
        Policy::Relax => [
            Driving::StillStiff {
                joints: List(other),
            },
            Driving::PerhapsStiff {
                joints: List(unknown),
            },
        ],
        Policy::Hold => [
            Driving::WithoutTorque {
                joints: List(other),
            },
            Driving::PerhapsLimp {
                joints: List(unknown),
            },
        ],
    };
    let lines = messages.into_iter().zip(are).filter(|(_, are)| *are);
    lines
        .map(|(message, _)| format!("{}\n", message.in_lang(lang)))
        .collect()
}

/// The operator of a robot under the eyes of the thread that leaves it if this process is stuck, with faults of simulated servos.
#[derive(Debug)]
pub(crate) struct Attended {
    operator: Operator,
    /// Faults to inject; `None` on a real bus.
    injection: Option<FaultInjection>,
    /// True when somebody elsewhere has asked for the emergency stop.
    pub(crate) stop: Arc<AtomicBool>,
    /// The longest cycle of approaching and of leaving, ms.
    period: f64,
}

impl Borrow<Operator> for Attended {
    fn borrow(&self) -> &Operator {
        &self.operator
    }
}

impl BorrowMut<Operator> for Attended {
    fn borrow_mut(&mut self) -> &mut Operator {
        &mut self.operator
    }
}

/// Cycles that a watchdog should wait: it must not stop a robot whose host is late now and then.
const SAFE_TIMEOUT: f64 = 10.0;

impl Host<AnyPort> for Attended {
    fn wait(&mut self, port: &mut AnyPort, until: u64) {
        self.operator.wait(port, until);
        if let (AnyPort::Memory(port), Some(injection)) = (port, &mut self.injection) {
            injection.inject(&mut port.bus, until);
        }
    }

    fn request(&mut self) -> Option<Request> {
        interrupt::cycle(self.period);
        if self.stop.load(Ordering::Relaxed) {
            return Some(Request::EmergencyStop);
        }
        self.operator.request()
    }

    fn gap(&self, angles: &[f64]) -> Option<Gap> {
        self.operator.gap(angles)
    }
}

/// The result of leaving a robot.
#[derive(Debug)]
pub(crate) struct Finished {
    /// True if the emergency stop was pressed meanwhile.
    pub(crate) is_stopped: bool,
    /// Lines about the servos that are not in the state in which they should have been left; empty if there are none.
    pub(crate) complaint: String,
}

type SharedGuard = Mutex<TorqueGuard<AnyPort, Attended>>;

fn lock(robot: &SharedGuard) -> MutexGuard<'_, TorqueGuard<AnyPort, Attended>> {
    robot.lock().unwrap_or_else(PoisonError::into_inner)
}

/// An open bus with the joints of a robot. A run shares it, and so does the thread of signals, which leaves the robot if this
/// process is stuck.
#[derive(Debug)]
pub(crate) struct Connection {
    pub(crate) setup: Setup,
    port: String,
    robot: Arc<SharedGuard>,
    is_simulated: bool,
    lang: Lang,
}

impl Connection {
    /// Returns true if the servos are simulated: nothing is in danger, and no time passes.
    pub(crate) const fn is_simulated(&self) -> bool {
        self.is_simulated
    }

    /// Returns the robot, while nobody else uses it.
    pub(crate) fn robot(&self) -> MutexGuard<'_, TorqueGuard<AnyPort, Attended>> {
        lock(&self.robot)
    }

    /// Returns the oldest key that was typed and does not end the command.
    pub(crate) fn key(&self) -> Option<u8> {
        self.robot().host_mut().operator.key()
    }

    /// Reads the keys of a robot without torque from now on, and returns what the operator at the terminal asks for.
    pub(crate) fn request(&self) -> Option<Request> {
        let mut robot = self.robot();
        let operator = &mut robot.host_mut().operator;
        operator.take_keys();
        operator.request()
    }

    /// Returns the sampling time, ms.
    pub(crate) fn period(&self) -> f64 {
        self.setup.period
    }

    /// Finds the servos of a robot that is to move, and says which, and whether the bus can carry a cycle.
    pub(crate) fn connect(&self, quiet: bool) -> Result<(), Error> {
        let connected = self.robot().connect();
        self.connected(connected, quiet)?;
        let robot = self.robot();
        let (load, timeout, period) = (
            robot.drives().load(),
            robot.drives().timeout(),
            self.period(),
        );
        let mut warnings = Vec::new();
        if load.cycles > 1 {
            let (read, cycles) = (format!("{:.1}", load.read), load.cycles);
            warnings.push(Driving::BusLoad {
                read,
                period,
                cycles,
            });
        }
        if let Some(timeout) = timeout.filter(|timeout| *timeout < SAFE_TIMEOUT * period) {
            let (time, cycles) = (format!("{timeout:.0}"), format!("{:.1}", timeout / period));
            warnings.push(Driving::ShortTimeout { time, cycles });
        }
        realtime::warn(warnings, self.lang);
        realtime::warn(not_compared(self.setup.distances.left_out()), self.lang);
        Ok(())
    }

    /// Finds the servos of a robot that nobody is going to move, and says which.
    pub(crate) fn connect_to_measure(&self) -> Result<(), Error> {
        let connected = self.robot().drives_mut().connect_to_measure();
        self.connected(connected, false)
    }

    fn connected(&self, connected: Result<(), Failure>, quiet: bool) -> Result<(), Error> {
        connected.map_err(|failure| self.failed(failure))?;
        let Some(joint) = self.setup.joints.first().filter(|_| !quiet) else {
            return Ok(());
        };
        let connected = Driving::Connected {
            servos: self.setup.joints.len(),
            family: joint.model.family.name(),
            port: self.port.clone().into(),
            delay: self.robot().drives().bus().timing().return_delay,
        };
        report::say(connected, self.lang);
        Ok(())
    }

    /// Reads the joints for a cycle, without torque.
    pub(crate) fn measure(&self) -> Result<(), Failure> {
        let mut robot = self.robot();
        robot.wait();
        robot.drives_mut().read_cycle()
    }

    /// Returns the measured angle of each joint, deg.
    pub(crate) fn angles(&self) -> Vec<f64> {
        let robot = self.robot();
        let joints = 0..self.setup.joints.len();
        let angle = |joint| robot.drives().angle(joint).unwrap_or_default();
        joints.map(angle).collect()
    }

    /// Waits until a cycle is over where the servos are simulated, whose bus takes no time.
    pub(crate) fn pace(&self, pacer: &mut Pacer) {
        if self.is_simulated {
            realtime::wait_until(pacer.due(self.period()));
        }
    }

    /// Returns the state of each servo as a page shows it, where this is wrong with the robot.
    pub(crate) fn servos(&self, failure: Option<Failure>) -> Vec<ServoState> {
        let robot = self.robot();
        let drives = robot.drives();
        let joints = self.setup.joints.iter().enumerate();
        joints
            .map(|(place, joint)| {
                let measured = drives.measured(place);
                let age = drives.age(place).unwrap_or_default();
                let alarm = drives.alarm(place).filter(|bits| *bits != 0);
                let alarm = alarm.map(|bits| Failure {
                    joint: Some(place),
                    servo: Some(joint.id),
                    problem: Problem::Alarm(bits),
                });
                let own = failure.filter(|failure| failure.joint == Some(place));
                ServoState {
                    joint: self.setup.name(place),
                    id: joint.id,
                    angle: drives
                        .angle(place)
                        .filter(|_| age <= self.setup.bus.silence),
                    load: measured.and_then(|it| it.load),
                    voltage: measured.and_then(|it| it.voltage),
                    temperature: measured.and_then(|it| it.temperature),
                    age,
                    missing: drives.missing(place).unwrap_or_default(),
                    problem: alarm.or(own).map(|failure| self.explain(failure)),
                }
            })
            .collect()
    }

    /// Says where the joints will go before the program starts.
    pub(crate) fn announce(&self) {
        let robot = self.robot();
        let way = |joint: usize| {
            let now = robot.drives().angle(joint).unwrap_or_default();
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

    /// Reads keys from now on, and lets signals that end this process leave the robot first; with `is_watched`, so does a control loop
    /// that stands still. It comes before the first torque.
    pub(crate) fn take_over(&self, is_watched: bool) {
        self.robot().host_mut().operator.take_keys();
        // Not an owner: the robot is left when the last of them is gone.
        let (robot, setup) = (Arc::downgrade(&self.robot), self.setup.clone());
        let lang = self.lang;
        interrupt::leaves_first(is_watched, move |cause| {
            let Some(robot) = robot.upgrade() else {
                return Some(String::new());
            };
            let mut robot = lock(&robot);
            let mut words = String::new();
            if cause == Cause::Stall {
                // While this thread waited for the robot, a cycle may have ended, or the command.
                if !interrupt::is_stalled() || !robot.has_torque() {
                    return None;
                }
                robot.emergency_stop();
                words = format!("{}\n", Stopping::Stalled.in_lang(lang));
            }
            Some(words + &lines(operator::leave(&mut robot, &setup), lang))
        });
    }

    /// Returns the reason not to move through these poses, if two parts of the robot would overlap on the way from where it was last
    /// commanded to be, or measured without torque. Reports a warning instead if the file says so.
    pub(crate) fn refusal_of_way(&self, poses: &[Vec<f64>]) -> Option<String> {
        let poses = poses.iter().map(Vec::as_slice);
        let Collision { gap, angles } = self.robot().collision(poses, self.setup.bus.start)?;
        let ([one, other], by) = (gap.parts, format!("{:.1}", -gap.distance));
        let is_concerned = |joint: usize| {
            let leg = joint / self.setup.of_leg.max(1) + 1;
            gap.parts.iter().any(
                |part| matches!(part, Part::Link(concerned, _) if usize::from(*concerned) == leg),
            )
        };
        let angles = angles.iter().enumerate();
        let angles = angles
            .filter(|(joint, _)| is_concerned(*joint))
            .map(|(joint, angle)| format!("{} {angle:.1}", self.setup.name(joint)));
        let angles = List(angles.collect());
        if self.setup.bus.stops_collisions {
            let refused = Driving::WayCollides {
                one,
                other,
                by,
                angles,
            };
            return Some(refused.in_lang(self.lang).to_string());
        }
        let overlaps = Driving::WayOverlaps {
            one,
            other,
            by,
            angles,
        };
        realtime::warn([overlaps], self.lang);
        None
    }

    /// Switches the torque on, and moves slowly to the initial posture. Returns the status with which the command ends if the
    /// robot was stopped on the way.
    pub(crate) fn stand_ready(&self, is_watched: bool) -> Option<Status> {
        self.take_over(is_watched);
        if let Some(reason) = self.refusal_of_way(slice::from_ref(&self.setup.initial)) {
            return Some(self.refused(&reason));
        }
        let step = {
            let (initial, speed) = (&self.setup.initial, self.setup.bus.start);
            self.robot().approach(initial, speed)
        };
        self.ended(step)
    }

    /// Reports the end of a robot that was left in a step, and returns the status of the command.
    pub(crate) fn ended(&self, step: Result<Step, Failure>) -> Option<Status> {
        let status = match step {
            Ok(Step::Moving | Step::Arrived) => return None,
            Ok(Step::Left(Request::End)) => Status::Interrupted,
            Ok(Step::Left(Request::EmergencyStop)) => {
                self.say_stopped();
                Status::Emergency
            }
            Err(failure) => {
                let reason = self.explain(failure);
                if self.robot().outcome().is_none() {
                    // A hand has turned a joint where it must not be.
                    return Some(self.refused(&reason));
                }
                report::complain(&format!("{reason}\n"));
                Status::Emergency
            }
        };
        self.finish();
        Some(status)
    }

    /// Says who has pressed the emergency stop.
    fn say_stopped(&self) {
        let by_page = self.robot().host_mut().stop.load(Ordering::Relaxed);
        let pressed = match by_page {
            true => Stopping::PagePressed,
            false => Stopping::KeyPressed,
        };
        report::say(pressed, self.lang);
    }

    /// Reports the reason why no torque was switched on, and returns the status of the command.
    fn refused(&self, reason: &str) -> Status {
        report::complain(&format!("{reason}\n"));
        self.finish();
        report_stiff(self, self.lang);
        Status::Failure
    }

    /// Returns the joints for a run.
    pub(crate) fn joints(&self) -> impl Joints + use<> {
        RunJoints {
            robot: Arc::clone(&self.robot),
            is_simulated: self.is_simulated,
            of_leg: self.setup.of_leg,
            period: self.setup.period,
        }
    }

    /// Returns the keyboard, which nobody reads here then.
    pub(crate) fn keyboard(&self) -> Option<Terminal<io::Sink>> {
        self.robot().host_mut().operator.give_keys()
    }

    /// Holds or relaxes the robot for good, and reports servos that are in another state. The keyboard is read until then.
    pub(crate) fn finish(&self) -> Finished {
        let mut robot = self.robot();
        let was_stopped = robot.is_stopped();
        let left = operator::leave(&mut robot, &self.setup);
        interrupt::is_left();
        let complaint = lines(left, self.lang);
        report::complain(&complaint);
        let is_stopped = robot.is_stopped() && !was_stopped;
        drop(robot);
        if is_stopped {
            self.say_stopped();
        }
        Finished {
            is_stopped,
            complaint,
        }
    }

    /// Returns the problem that stopped the robot.
    pub(crate) fn failure(&self) -> Option<Failure> {
        self.robot().drives().failure()
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
            Problem::NotRead(cycles) => Driving::NotRead { joint, id, cycles },
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
            Problem::TimedOut(time) => Driving::TimedOut {
                joint,
                id,
                time: format!("{time:.0}"),
            },
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
            Problem::Collides(Gap {
                parts: [one, other],
                ..
            }) => Driving::Collides { one, other },
            Problem::Torque => Driving::NoTorques { joint },
            Problem::Load(load) => {
                let [period, read, write] =
                    [load.period, load.read, load.write].map(|time| format!("{time:.1}"));
                let shortest = format!("{:.0}", load.shortest.ceil());
                match own.model.family.reads_together() {
                    true => Driving::BusTooSlow {
                        period,
                        read,
                        write,
                        shortest,
                    },
                    false => Driving::BusTooSlowInTurn {
                        period,
                        read,
                        write,
                        shortest,
                        cycles: load.cycles,
                        silence: bus.silence,
                    },
                }
            }
            Problem::Period(most) => Driving::PeriodTooLong {
                most: format!("{:.0}", most.floor()),
            },
            Problem::NotHeld => Driving::NotHeld,
        };
        message.in_lang(self.lang).to_string()
    }
}

/// Says which servos an earlier command left stiff, where this one ends before its first torque: they stay so, because a robot that
/// they hold must not fall.
pub(crate) fn report_stiff(connection: &Connection, lang: Lang) {
    let stiff = connection.robot().drives_mut().stiff();
    if !stiff.is_empty() {
        let joints = List(connection.setup.names(&stiff));
        report::say(Driving::WereStiff { joints }, lang);
    }
}

/// The joints that a run moves.
#[derive(Debug)]
struct RunJoints {
    robot: Arc<SharedGuard>,
    is_simulated: bool,
    /// Joints of each leg.
    of_leg: usize,
    /// Sampling time, ms.
    period: f64,
}

impl Joints for RunJoints {
    fn read(&mut self, angles: &mut [f64], ages: &mut [u32]) -> Result<(), HardwareFault> {
        let mut robot = lock(&self.robot);
        let read = robot.read_cycle();
        read.map_err(|failure| failure.fault(self.of_leg))?;
        for (joint, angle) in angles.iter_mut().enumerate() {
            *angle = robot.drives().angle(joint).unwrap_or(*angle);
        }
        for (joint, age) in ages.iter_mut().enumerate() {
            *age = robot.drives().age(joint).unwrap_or_default();
        }
        Ok(())
    }

    fn write(&mut self, commands: &[JointCommand], period: f64) -> Result<(), HardwareFault> {
        self.period = period;
        let mut robot = lock(&self.robot);
        interrupt::cycle(period);
        let written = robot.write_cycle(commands, period);
        written.map_err(|failure| failure.fault(self.of_leg))?;
        // A run in real time has its own pace.
        if self.is_simulated {
            robot.wait();
        }
        Ok(())
    }

    fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
        let mut robot = lock(&self.robot);
        interrupt::cycle(self.period);
        let stopped = robot.stop_cycle();
        stopped.map_err(|failure| failure.fault(self.of_leg))
    }
}
