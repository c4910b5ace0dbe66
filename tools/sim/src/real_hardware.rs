//! A real robot as the hardware of a run: joints that this process reaches over a bus. A copy of such a run reaches none.

use crate::motion::Limbs;
use crate::program_runner::ProgramRunner;
use crate::robot::Robot;
use crate::run::Run;
use crate::sim_hardware::{Commands, DynHardware, Reading};
use std::any::Any;
use std::fmt;
use tip_runtime::command::Port;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{HardwareFault, JointCommand};
use tip_runtime::machine::Mismatch;
use tip_runtime::program::Program;

/// The joints of a real robot, leg by leg: [`Hardware`](tip_runtime::hardware::Hardware) for a robot of any size.
pub trait Joints: Send {
    /// Measures the angle of each joint, deg.
    ///
    /// # Errors
    /// The fault; the machine answers with an emergency stop.
    fn read(&mut self, angles: &mut [f64]) -> Result<(), HardwareFault>;

    /// Sends a command to each joint, for a cycle of `period` ms.
    ///
    /// # Errors
    /// The fault; the machine answers with an emergency stop.
    fn write(&mut self, commands: &[JointCommand], period: f64) -> Result<(), HardwareFault>;

    /// Stops the robot: called in every cycle of an emergency, in place of [`write`](Self::write).
    fn stop(&mut self, why: &Fault);
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
        let hardware = Box::new(RealHardware {
            joints: Some(Box::new(joints)),
            legs: robot.anatomy().legs.len(),
            angles: Vec::new(),
            knobs: [None; KNOBS],
        });
        let machine = robot.start_on(hardware, ProgramRunner::new(program));
        Ok(Run::on(machine?))
    }
}

struct RealHardware {
    /// None in a copy.
    joints: Option<Box<dyn Joints>>,
    legs: usize,
    /// The last measured angles, deg.
    angles: Vec<f64>,
    /// Readings of VR1 to VR3 that events set, V: the host of a robot without a control box has its sticks.
    knobs: [Option<f64>; KNOBS],
}

/// Number of knobs of the control box.
const KNOBS: usize = 3;

impl fmt::Debug for RealHardware {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RealHardware").finish_non_exhaustive()
    }
}

/// The fault of a copy.
const COPY: HardwareFault = HardwareFault("a copy of a run has no robot");

impl DynHardware for RealHardware {
    fn boxed(&self) -> Box<dyn DynHardware> {
        Box::new(RealHardware {
            joints: None,
            angles: self.angles.clone(),
            ..*self
        })
    }

    fn plant(&self) -> &dyn Any {
        self
    }

    fn read(&mut self, into: Reading<'_>) -> Result<(), HardwareFault> {
        self.joints.as_mut().ok_or(COPY)?.read(into.angles)?;
        self.angles.clear();
        self.angles.extend_from_slice(into.angles);
        for (number, volts) in (1..).zip(self.knobs) {
            if let Some(volts) = volts {
                into.inputs.set(Port::Knob(number), volts);
            }
        }
        Ok(())
    }

    fn write(&mut self, commands: &Commands<'_>) -> Result<(), HardwareFault> {
        let joints = self.joints.as_mut().ok_or(COPY)?;
        joints.write(commands.joints, commands.period)
    }

    fn stop(&mut self, why: &Fault) {
        if let Some(joints) = &mut self.joints {
            joints.stop(why);
        }
    }

    fn has_input(&self, port: Port) -> bool {
        matches!(port, Port::Knob(number) if (1..=KNOBS).contains(&usize::from(number)))
    }

    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        let place = match port {
            Port::Knob(number) => usize::from(number).checked_sub(1),
            _ => None,
        };
        let knob = place.and_then(|place| self.knobs.get_mut(place));
        knob.map(|knob| *knob = Some(volts)).is_some()
    }

    fn limbs(&self) -> Option<Limbs> {
        let of_leg = (self.angles.len() / self.legs.max(1)).max(1);
        let angles: Vec<Vec<f64>> = self.angles.chunks(of_leg).map(<[f64]>::to_vec).collect();
        (!angles.is_empty()).then(|| Limbs {
            angles,
            loads: Vec::new(),
            forces: Vec::new(),
            torques: Vec::new(),
        })
    }
}
