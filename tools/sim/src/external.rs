//! A robot that another process simulates, such as MuJoCo, Gazebo or a simulator of your own.
//!
//! The process gets what the joints are commanded on its standard input, a JSON line for each control cycle, and answers each
//! with a JSON line of what the sensors measure on its standard output. Program and simulator wait for each other, so that the same answers
//! give the same run, however long they take. The protocol is in `docs/external-plant.md`.
//!
//! ```no_run
//! use tip_sim::{ExternalPlant, Limit, Robot, Run, load};
//!
//! let robot = Robot::named("titan8")?;
//! let program = load("rise.prg", "3.1\nStand up\nSTAND_UP 60\nWAIT_INPOS ALL\nEND\n", &robot)?;
//! let plant = ExternalPlant::new("python3", ["simulate.py", "titan8.xml"]);
//! let mut run = Run::external(program, &robot, &plant)?;
//! run.to_end(Limit::cycles(1000));
//! if let Some(error) = run.plant_error() {
//!     println!("{error}");
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A process cannot be copied or taken back. What runs a program again, such as a debugger, takes a [`Robot`], which never is
//! such a process; and a copy of a run, or one that was restored, has none: it stops with [`PlantError::Copy`] when it reads its
//! sensors.

mod link;
mod protocol;

pub use protocol::{Ended, Head, PlantError};

use crate::message::Simulating;
use crate::motion::Limbs;
use crate::program_runner::ProgramRunner;
use crate::robot::Robot;
use crate::run::Run;
use crate::sim_hardware::{Commands, DynHardware, Reading};
use link::{Link, Received};
use protocol::{Answer, Layout, Request};
use std::any::Any;
use std::ffi::{OsStr, OsString};
use std::fmt;
use std::sync::Arc;
use std::time::Duration;
use tip_runtime::command::Port;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{HardwareFault, Inputs};
use tip_runtime::machine::Mismatch;
use tip_runtime::plant::{Pose, Travel, volts_of_load};
use tip_runtime::program::Program;
use tipc::message::Lang;

/// A process that simulates a robot: how it is started, and how long it may take.
#[derive(Clone)]
pub struct ExternalPlant {
    program: OsString,
    arguments: Vec<OsString>,
    limits: TimeLimits,
    listener: Arc<dyn Fn(&str) + Send + Sync>,
}

/// Time limits of answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TimeLimits {
    /// Limit of the answer to `hello`: a simulator may have to load much.
    pub first: Duration,
    /// Limit of any other answer.
    pub later: Duration,
}

impl Default for TimeLimits {
    /// Returns 30 s and 5 s.
    fn default() -> Self {
        TimeLimits {
            first: Duration::from_secs(30),
            later: Duration::from_secs(5),
        }
    }
}

impl ExternalPlant {
    /// Creates a program with its arguments; no shell is between. What it writes to its standard
    /// error is dropped.
    pub fn new(
        program: impl AsRef<OsStr>,
        arguments: impl IntoIterator<Item = impl AsRef<OsStr>>,
    ) -> Self {
        let arguments = arguments.into_iter();
        ExternalPlant {
            program: program.as_ref().to_owned(),
            arguments: arguments.map(|word| word.as_ref().to_owned()).collect(),
            limits: TimeLimits::default(),
            listener: Arc::new(|_| ()),
        }
    }

    /// Sets the time limits of answers.
    #[must_use]
    pub fn with_time_limits(mut self, limits: TimeLimits) -> Self {
        self.limits = limits;
        self
    }

    /// Gives each line of its standard error to a function, printable and without its end, on a thread of its own.
    #[must_use]
    pub fn with_listener(mut self, listener: impl Fn(&str) + Send + Sync + 'static) -> Self {
        self.listener = Arc::new(listener);
        self
    }
}

impl fmt::Debug for ExternalPlant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ExternalPlant")
            .field("program", &self.program)
            .field("arguments", &self.arguments)
            .field("limits", &self.limits)
            .finish_non_exhaustive()
    }
}

/// Reason why a run on an external plant does not begin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StartError {
    /// The program is for another robot.
    Mismatch(Mismatch),
    /// The process cannot be started.
    Process {
        /// The executable.
        program: String,
        /// Message of the system.
        reason: String,
    },
}

impl StartError {
    /// Returns the message in a language. Messages of the runtime and the system are English.
    pub fn text(&self, lang: Lang) -> String {
        match self {
            StartError::Mismatch(mismatch) => mismatch.to_string(),
            StartError::Process { program, reason } => {
                let (program, reason) = (program.clone().into(), reason.clone().into());
                let message = Simulating::CannotStart { program, reason };
                message.in_lang(lang).to_string()
            }
        }
    }
}

impl fmt::Display for StartError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(Lang::English))
    }
}

impl std::error::Error for StartError {}

impl Run {
    /// Puts a program on a robot that another process simulates, before its first cycle, and starts the process. It ends with
    /// the run, or is ended.
    ///
    /// # Errors
    /// The program was checked for another robot, or the process cannot be started.
    pub fn external(
        program: impl Program + Clone + Send + 'static,
        robot: &Robot,
        plant: &ExternalPlant,
    ) -> Result<Self, StartError> {
        let plant = Box::new(ExternalHardware::start(robot, plant)?);
        let machine = robot.start_on(plant, ProgramRunner::new(program));
        Ok(Run::on(machine.map_err(StartError::Mismatch)?))
    }

    /// Returns the error of its external plant, if there is one.
    pub fn plant_error(&self) -> Option<&PlantError> {
        self.plant::<ExternalHardware>()?.error.as_ref()
    }
}

/// A robot whose sensors and joints another process simulates.
pub(crate) struct ExternalHardware {
    layout: Layout,
    /// None in a copy.
    link: Option<Link>,
    limits: TimeLimits,
    /// The request whose answer is awaited.
    awaits: Option<Head>,
    /// Number of the next control cycle.
    number: u64,
    measured: Answer,
    /// Values of inputs that events have set.
    overrides: Inputs<Option<f64>>,
    odometry: Option<Odometry>,
    error: Option<PlantError>,
    is_stopped: bool,
}

impl ExternalHardware {
    fn start(robot: &Robot, plant: &ExternalPlant) -> Result<Self, StartError> {
        let layout = Layout::of(robot.name(), &robot.description());
        let hello = layout.hello().line();
        let mut link = Link::start(&plant.program, &plant.arguments, plant.listener.clone())
            .map_err(|reason| StartError::Process {
                program: plant.program.to_string_lossy().into_owned(),
                reason: reason.to_string(),
            })?;
        link.request(hello);
        Ok(ExternalHardware {
            layout,
            link: Some(link),
            limits: plant.limits,
            awaits: Some(Head::Hello),
            number: 0,
            measured: Answer::default(),
            overrides: Inputs::all(None),
            odometry: None,
            error: None,
            is_stopped: false,
        })
    }

    /// Waits for the awaited answer up to a time. Returns true if none is awaited any more.
    fn wait(&mut self, longest: Duration) -> bool {
        let (Some(head), None) = (self.awaits, &self.error) else {
            return true;
        };
        let Some(link) = &mut self.link else {
            self.error = Some(PlantError::Copy);
            return true;
        };
        let within = match head {
            Head::Hello => self.limits.first,
            Head::Cycle(_) => self.limits.later,
        };
        let taken = match link.answer(longest, within) {
            Received::Nothing => return false,
            heard => self.take(head, heard, within),
        };
        self.awaits = None;
        if let Err(error) = taken {
            if let Some(link) = &mut self.link {
                link.skip_grace();
            }
            self.error = Some(error);
        }
        true
    }

    /// Takes an answer to a request.
    fn take(&mut self, to: Head, heard: Received, within: Duration) -> Result<(), PlantError> {
        let line = match heard {
            Received::Line(line) => line,
            Received::Nothing | Received::TooLate => {
                return Err(PlantError::NoAnswer { to, within });
            }
            Received::End(ended) => return Err(PlantError::Ended { to, ended }),
            Received::TooLong => return Err(PlantError::TooLong { to }),
            Received::NotText => return Err(PlantError::NotText { to }),
        };
        self.measured = protocol::read(&line, to, &self.layout, &self.measured)?;
        if let Some(pose) = self.measured.pose() {
            self.odometry = Some(Odometry::on(self.odometry, pose));
        }
        Ok(())
    }

    fn fault(&self) -> Result<(), HardwareFault> {
        let word = self.error.as_ref().map(PlantError::word);
        word.map_or(Ok(()), |word| Err(HardwareFault::new(word)))
    }
}

impl DynHardware for ExternalHardware {
    /// Returns a copy, which is connected to nothing.
    fn boxed(&self) -> Box<dyn DynHardware> {
        Box::new(ExternalHardware {
            layout: self.layout.clone(),
            link: None,
            // The copy awaits an answer that never comes, so that it fails.
            awaits: Some(Head::Cycle(self.number)),
            measured: self.measured.clone(),
            error: self.error.clone(),
            ..*self
        })
    }

    fn plant(&self) -> &dyn Any {
        self
    }

    fn is_ready(&mut self, longest: Duration) -> bool {
        self.wait(longest)
    }

    fn read(&mut self, into: Reading<'_>) -> Result<(), HardwareFault> {
        while !self.wait(Duration::MAX) {}
        self.fault()?;
        let unit = self.layout.per_newton_metre;
        into.angles.copy_from_slice(&self.measured.angles);
        // Sensors that a simulation does not drive read 0.
        into.torques.fill(0.0);
        *into.inputs = Inputs::all(0.0);
        for (into, torque) in into.torques.iter_mut().zip(&self.measured.torques) {
            *into = torque * unit;
        }
        for (number, load) in (1..).zip(&self.measured.loads) {
            into.inputs.set(Port::Paw(number), volts_of_load(*load));
        }
        for port in self.layout.inputs() {
            if let Some(volts) = self.overrides.get(port).flatten() {
                into.inputs.set(port, volts);
            }
        }
        *into.slider = self.measured.slider.unwrap_or_default();
        Ok(())
    }

    fn write(&mut self, commands: &Commands<'_>) -> Result<(), HardwareFault> {
        while !self.wait(Duration::MAX) {}
        self.fault()?;
        let line = self.layout.cycle(self.number, commands).line();
        if let Some(link) = &mut self.link {
            link.request(line);
        }
        self.awaits = Some(Head::Cycle(self.number));
        self.number += 1;
        Ok(())
    }

    fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
        if let (Some(link), None, false) = (&mut self.link, &self.error, self.is_stopped) {
            link.notify(Request::Stop { n: self.number }.line());
        }
        self.is_stopped = true;
        Ok(())
    }

    fn has_input(&self, port: Port) -> bool {
        self.layout.inputs().any(|input| input == port)
    }

    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        self.has_input(port) && self.overrides.set(port, Some(volts))
    }

    fn pose(&self) -> Option<Pose> {
        self.odometry.as_ref().map(Odometry::now)
    }

    fn limbs(&self) -> Option<Limbs> {
        let joints = self.layout.joints.max(1);
        let legs = |values: &[f64]| values.chunks(joints).map(<[f64]>::to_vec).collect();
        let unit = self.layout.per_newton_metre;
        let torques: Vec<f64> = self.measured.torques.iter().map(|it| it * unit).collect();
        let is_known = !self.measured.angles.is_empty();
        is_known.then(|| Limbs {
            angles: legs(&self.measured.angles),
            loads: self.measured.loads.clone(),
            forces: Vec::new(),
            slips: Vec::new(),
            torques: legs(&torques),
        })
    }

    fn travel(&self) -> Option<Travel> {
        self.odometry.as_ref().map(Odometry::travel)
    }
}

/// The start and the present pose of the body.
#[derive(Clone, Copy, Debug)]
struct Odometry {
    start: Pose,
    now: Pose,
    /// Sum of the whole turns so far, deg.
    turned: f64,
}

impl Odometry {
    /// Updates the motion by a new pose.
    fn on(before: Option<Self>, now: Pose) -> Self {
        let Some(before) = before else {
            return Odometry {
                start: now,
                now,
                turned: 0.0,
            };
        };
        // Headings are within half a turn, so whole turns are counted.
        let turn = now.yaw - before.now.yaw;
        let whole = if turn > 180.0 {
            -360.0
        } else if turn < -180.0 {
            360.0
        } else {
            0.0
        };
        Odometry {
            now,
            turned: before.turned + whole,
            ..before
        }
    }

    /// Returns the present pose.
    fn now(&self) -> Pose {
        self.now
    }

    /// Returns the distance that the body has come.
    fn travel(&self) -> Travel {
        let ([x, y, z], [x0, y0, z0]) = (self.now.position, self.start.position);
        let turn = self.now.yaw - self.start.yaw + self.turned;
        Travel::new([x - x0, y - y0, z - z0], turn)
    }
}
