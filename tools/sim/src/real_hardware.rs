//! A real robot as the hardware of a run: joints that this process reaches over a bus. A copy of such a run reaches none.
//!
//! Only joints are connected to the bus. Other inputs have the values that events give them. An input without a value
//! is NaN, and a `Sensor fault` if a program reads it.

use crate::event::{Events, STICK_AT_REST};
use crate::message::Linting;
use crate::motion::Limbs;
use crate::program_runner::ProgramRunner;
use crate::robot::Robot;
use crate::run::Run;
use crate::sim_hardware::{Commands, DynHardware, Reading, has_input};
use std::any::Any;
use std::fmt;
use tip_runtime::command::{Op, Port, Target};
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{HardwareFault, Inputs, JointCommand};
use tip_runtime::machine::Mismatch;
use tip_runtime::plant::{Distances, Gap};
use tip_runtime::program::Program;
use tipc::Loaded;
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::language::flags::{self, Cause};
use tipc::message::Text;
use tipc::program::{Action, Condition};

/// The joints of a real robot, leg by leg: [`Hardware`](tip_runtime::hardware::Hardware) for a robot of any size.
pub trait Joints: Send {
    /// Measures the angle of each joint, deg, and sets its age in cycles, which is above 0 if it could not be measured
    /// in this one.
    ///
    /// # Errors
    /// The fault; the machine answers with an emergency stop.
    fn read(&mut self, angles: &mut [f64], ages: &mut [u32]) -> Result<(), HardwareFault>;

    /// Sends a command to each joint, for a cycle of `period` ms.
    ///
    /// # Errors
    /// The fault; the machine answers with an emergency stop.
    fn write(&mut self, commands: &[JointCommand], period: f64) -> Result<(), HardwareFault>;

    /// Stops the robot: called in every cycle of an emergency, in place of [`write`](Self::write).
    ///
    /// # Errors
    /// The robot could not be stopped in this cycle.
    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault>;
}

impl Run {
    /// Puts a program on a real robot, before its first cycle.
    ///
    /// # Errors
    /// The program was checked for another robot.
    pub fn real(
        program: impl Program + Clone + Send + 'static,
        robot: &Robot,
        joints: impl Joints + 'static,
    ) -> Result<Self, Mismatch> {
        let description = robot.description();
        let legs = description.legs.len();
        let hardware = Box::new(RealHardware {
            joints: Some(Box::new(joints)),
            legs,
            soles: description.body.map_or(0, |_| legs),
            angles: Vec::new(),
            inputs: Inputs::all(f64::NAN),
            distances: robot.distances(),
        });
        let machine = robot.start_on(hardware, ProgramRunner::new(program));
        Ok(Run::on(machine?))
    }
}

impl Robot {
    /// Returns an error for each statement that reads an input which a real robot of this kind lacks, and which no event
    /// gives a value.
    pub fn unconnected(&self, loaded: &Loaded, events: &Events) -> Vec<Diagnostic> {
        let Some(program) = &loaded.program else {
            return Vec::new();
        };
        let description = self.description();
        let joints = description.legs.len() * description.joints;
        let soles = description.body.map_or(0, |_| description.legs.len());
        let is_given = |port: Port| events.ports().any(|given| given == port);
        let steps = loaded.module.steps().zip(program.steps());
        let read = steps.filter_map(|(statement, step)| {
            let mut ports = inputs(&step.action, joints, soles).into_iter();
            let port = ports.find(|port| !is_given(*port))?;
            let input = Text::from(port.to_string());
            let volts = match port {
                Port::Knob(_) => STICK_AT_REST,
                _ => 2.5,
            };
            let diagnostic = |reason| Diagnostic::new(Code::Argument, statement.span, reason);
            Some(match port {
                Port::Channel(_) => diagnostic(Linting::OpenChannel { channel: input }),
                _ => diagnostic(Linting::NotConnected {
                    input: input.clone(),
                })
                .help(Linting::GiveInput { input, volts }),
            })
        });
        read.collect()
    }
}

/// Returns the inputs that an action reads, joints excepted, on a robot with so many joints and soles.
fn inputs(action: &Action, joints: usize, soles: usize) -> Vec<Port> {
    match action {
        Action::AdIn { port, .. } => match port.by_name() {
            Port::Joint(..) => Vec::new(),
            Port::Channel(channel) if usize::from(channel) < joints => Vec::new(),
            port => vec![port],
        },
        Action::Command {
            op: Op::DetectFloor,
            target,
            ..
        } => {
            let searches =
                |leg: &u8| matches!(target, Target::All) || *target == Target::Foot(*leg);
            let legs = (1..).take(soles).filter(searches);
            legs.map(Port::Paw).collect()
        }
        action => match action.condition() {
            Some(Condition::Flag { flag, .. }) => match flags::row(*flag).map(|row| row.cause) {
                Some(Cause::Input(port)) => vec![port],
                _ => Vec::new(),
            },
            _ => Vec::new(),
        },
    }
}

struct RealHardware {
    /// None in a copy.
    joints: Option<Box<dyn Joints>>,
    legs: usize,
    soles: usize,
    /// The last measured angles, deg.
    angles: Vec<f64>,
    /// Values that events gave to inputs, V; NaN for all others.
    inputs: Inputs,
    distances: Distances,
}

impl fmt::Debug for RealHardware {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RealHardware").finish_non_exhaustive()
    }
}

/// The fault of a copy.
const COPY: HardwareFault = HardwareFault::new("a copy of a run has no robot");

impl DynHardware for RealHardware {
    fn boxed(&self) -> Box<dyn DynHardware> {
        Box::new(RealHardware {
            joints: None,
            angles: self.angles.clone(),
            distances: self.distances.clone(),
            ..*self
        })
    }

    fn plant(&self) -> &dyn Any {
        self
    }

    fn read(&mut self, into: Reading<'_>) -> Result<(), HardwareFault> {
        self.joints
            .as_mut()
            .ok_or(COPY)?
            .read(into.angles, into.ages)?;
        self.angles.clear();
        self.angles.extend_from_slice(into.angles);
        *into.inputs = self.inputs;
        Ok(())
    }

    fn write(&mut self, commands: &Commands<'_>) -> Result<(), HardwareFault> {
        let joints = self.joints.as_mut().ok_or(COPY)?;
        joints.write(commands.joints, commands.period)
    }

    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault> {
        self.joints.as_mut().ok_or(COPY)?.stop(why)
    }

    fn has_input(&self, port: Port) -> bool {
        has_input(self.soles, port)
    }

    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        self.has_input(port) && self.inputs.set(port, volts)
    }

    fn gap(&self) -> Option<Gap> {
        self.distances.at(&self.angles)
    }

    fn limbs(&self) -> Option<Limbs> {
        let of_leg = (self.angles.len() / self.legs.max(1)).max(1);
        let angles: Vec<Vec<f64>> = self.angles.chunks(of_leg).map(<[f64]>::to_vec).collect();
        (!angles.is_empty()).then(|| Limbs {
            angles,
            loads: Vec::new(),
            forces: Vec::new(),
            slips: Vec::new(),
            torques: Vec::new(),
        })
    }
}
