//! The measurements and commands of a cycle.

use crate::hardware::JointCommand;

/// The measurements and commands of a cycle: a row of TITAN.LOG. Joints come leg by leg.
#[derive(Clone, Copy, Debug)]
pub struct Sample<'a> {
    /// The program's cycle, from 0.
    pub cycle: u64,
    /// Time at which the sensors were sampled, from the program's start, ms.
    pub time: f64,
    /// Number of joints of each leg.
    pub joints_per_leg: usize,
    /// Measured angles, deg.
    pub angles: &'a [f64],
    /// Commands sent, deg, or the robot's torque unit.
    pub commands: &'a [JointCommand],
    /// Measured torques in the robot's torque unit; empty for a robot without torque sensors.
    pub torques: &'a [f64],
    /// `PAW1…`: V.
    pub paws: &'a [f64],
    /// `VR1…`: V.
    pub knobs: &'a [f64],
    /// `ANTENNA`: V.
    pub antenna: f64,
}
