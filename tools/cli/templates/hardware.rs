//! Our robot's drives: the one place that knows how its joints are reached.
//!
//! These are immediately where they are commanded to be. Put your bus into the three functions of `Hardware`; all else stays.

<<own>>use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, JointCommand, Outputs, Sensors};
<<model>>
/// Legs or fingers of the robot.
pub const LEGS: usize = <<legs>>;
/// Joints of each.
pub const JOINTS: usize = <<joints>>;

/// The drives, one for each joint. They own the torque: there is no copy of them.
#[derive(Debug)]
pub struct Drives {
    /// deg.
    angles: [[f64; JOINTS]; LEGS],
    /// In the robot's torque unit; only a robot that senses torques is commanded any.
    torques: [[f64; JOINTS]; LEGS],
    /// Place of the slider under a hand, mm.
    slider: [f64; 3],
}

impl Drives {
    /// Drives in the initial posture, without load.
    pub fn new() -> Self {
        Drives {
            angles: <<MODEL>>.legs.map(|leg| leg.initial),
            torques: [[0.0; JOINTS]; LEGS],
            slider: <<MODEL>>.slider.map_or([0.0; 3], |slider| slider.initial),
        }
    }
}

impl Default for Drives {
    fn default() -> Self {
        Self::new()
    }
}

impl Hardware<LEGS, JOINTS> for Drives {
    /// Measures. A drive that does not answer is an error, `Err(HardwareFault::new("no answer").at_joint(1, 2))`, which stops the
    /// robot: an angle that is not written here looks like a joint that stands still. Knobs and other inputs are absent until
    /// they are written to `into.inputs`; a program that reads an absent one stops with `Sensor fault`.
    fn read(&mut self, into: &mut Sensors<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        into.angles = self.angles; // sign and offset of a motor belong here and into `write`
        into.torques = self.torques;
        into.slider = self.slider;
        Ok(())
    }

    /// Sends one command to each joint, once in each cycle of `outputs.period` ms.
    fn write(&mut self, outputs: &Outputs<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        for (leg, commands) in outputs.joints.iter().enumerate() {
            for (joint, command) in commands.iter().enumerate() {
                match *command {
                    JointCommand::Angle { angle, .. } => self.angles[leg][joint] = angle,
                    JointCommand::Torque(torque) => self.torques[leg][joint] = torque,
                }
            }
        }
        self.slider = outputs.slider;
        Ok(())
    }

    /// Stops every joint. It is called in place of `write`, in each cycle of an emergency. An error is reported, and the next
    /// cycle tries again.
    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault> {
        let _ = why;
        Ok(())
    }
}

impl Drop for Drives {
    /// Leaves the robot: hold it, or take its torque away slowly. This comes at the end, whatever it is: a panic, too.
    fn drop(&mut self) {}
}
