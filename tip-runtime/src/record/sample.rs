//! What a cycle measured and sent: a row of TITAN.LOG, and of what is written down of each cycle.

use crate::hardware::JointCommand;

/// What a cycle measured and sent. Joints come leg by leg.
#[derive(Clone, Copy, Debug)]
pub struct Sample<'a> {
    /// The program's cycle, from 0.
    pub cycle: u64,
    /// When the sensors were sampled, since the program's start: ms.
    pub time: f64,
    /// Joints of each leg.
    pub joints_per_leg: usize,
    /// Measured: deg.
    pub angles: &'a [f64],
    /// Sent: deg, or the robot's torque unit.
    pub commands: &'a [JointCommand],
    /// Measured, in the robot's torque unit; empty for a robot that senses none.
    pub torques: &'a [f64],
    /// `PAW1…`: V.
    pub paws: &'a [f64],
    /// `VR1…`: V.
    pub knobs: &'a [f64],
    /// `ANTENNA`: V.
    pub antenna: f64,
}
