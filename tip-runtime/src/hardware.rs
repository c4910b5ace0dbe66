//! The one trait that a real robot implements.
//!
//! Servos that are where they are commanded immediately, for a robot of one leg with two joints:
//!
//! ```
//! use tip_runtime::fault::Fault;
//! use tip_runtime::hardware::{Hardware, HardwareFault, JointCommand, Outputs, Sensors};
//!
//! struct Servos([f64; 2]);
//!
//! impl Hardware<1, 2> for Servos {
//!     fn read(&mut self, into: &mut Sensors<1, 2>) -> Result<(), HardwareFault> {
//!         into.angles = [self.0];
//!         Ok(())
//!     }
//!
//!     fn write(&mut self, outputs: &Outputs<1, 2>) -> Result<(), HardwareFault> {
//!         let [commands] = &outputs.joints;
//!         for (angle, command) in self.0.iter_mut().zip(commands) {
//!             match command {
//!                 JointCommand::Angle { angle: to, .. } => *angle = *to,
//!                 JointCommand::Torque(_) => return Err(HardwareFault::new("no torques")),
//!             }
//!         }
//!         Ok(())
//!     }
//!
//!     fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
//!         Ok(()) // They stay where they are.
//!     }
//! }
//!
//! let mut servos = Servos([0.0, 90.0]);
//! let mut outputs = Outputs {
//!     joints: [[JointCommand::at(5.0), JointCommand::at(80.0)]],
//!     slider: [0.0; 3],
//!     lamps: [0; 8],
//!     period: 20.0,
//! };
//! let mut sensors = Sensors::ZERO;
//! assert_eq!(servos.write(&outputs), Ok(()));
//! assert_eq!(servos.read(&mut sensors), Ok(()));
//! assert_eq!(sensors.angles, [[5.0, 80.0]]);
//!
//! outputs.joints[0][1] = JointCommand::Torque(2.0);
//! assert!(servos.write(&outputs).is_err());
//! ```

pub use crate::fault::HardwareFault;

use crate::command::Port;
use crate::fault::Fault;
use crate::model::Point;

/// The readings of one cycle. A reader fills in what it has. The rest stays absent ([`UNREAD`](Self::UNREAD)), and a program that
/// reads it is stopped by `Sensor fault`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensors<const L: usize, const J: usize> {
    /// Joint angles, deg.
    pub angles: [[f64; J]; L],
    /// Number of cycles since each angle was measured; 0 if it was in this one. An older angle keeps its rate, and the next rate is
    /// that of the time between the two measurements.
    pub ages: [[u32; J]; L],
    /// Torque of each joint on its link, in the robot's torque unit; NaN where nothing senses it.
    pub torques: [[f64; J]; L],
    /// The inputs that a program reads by name: knobs, pressure sensors of the soles and the feeler, V. The touch of a
    /// palm reads 1. NaN for an input that is not connected.
    pub inputs: Inputs,
    /// Place of the slider (`FLOOR`), mm; ignored without a slider.
    pub slider: Point,
}

impl<const L: usize, const J: usize> Sensors<L, J> {
    /// Readings that are all 0, as in a simulation without motion.
    pub const ZERO: Self = Sensors {
        angles: [[0.0; J]; L],
        ages: [[0; J]; L],
        torques: [[0.0; J]; L],
        inputs: Inputs::all(0.0),
        slider: [0.0; 3],
    };

    /// The readings before the first cycle: every joint at 0, and all else absent, which is a NaN.
    pub const UNREAD: Self = Sensors {
        angles: [[0.0; J]; L],
        ages: [[0; J]; L],
        torques: [[f64::NAN; J]; L],
        inputs: Inputs::all(f64::NAN),
        slider: [f64::NAN; 3],
    };
}

/// The readings of a robot of any number of legs, leg by leg.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SensorsView<'a, const J: usize> {
    pub(crate) angles: &'a [[f64; J]],
    pub(crate) ages: &'a [[u32; J]],
    pub(crate) torques: &'a [[f64; J]],
    pub(crate) inputs: &'a Inputs,
    pub(crate) slider: Point,
}

/// The readings of a robot of any number of legs, to be filled in.
#[derive(Debug)]
pub(crate) struct SensorsMut<'a, const J: usize> {
    pub(crate) angles: &'a mut [[f64; J]],
    pub(crate) torques: &'a mut [[f64; J]],
    pub(crate) inputs: &'a mut Inputs,
    pub(crate) slider: &'a mut Point,
}

impl<const L: usize, const J: usize> Sensors<L, J> {
    pub(crate) const fn view_mut(&mut self) -> SensorsMut<'_, J> {
        SensorsMut {
            angles: &mut self.angles,
            torques: &mut self.torques,
            inputs: &mut self.inputs,
            slider: &mut self.slider,
        }
    }

    pub(crate) const fn view(&self) -> SensorsView<'_, J> {
        SensorsView {
            angles: &self.angles,
            ages: &self.ages,
            torques: &self.torques,
            inputs: &self.inputs,
            slider: self.slider,
        }
    }
}

/// The command of one joint in one cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JointCommand {
    /// Position control.
    Angle {
        /// The angle, deg.
        angle: f64,
        /// Rate of the trajectory from the previous command to this angle over one sampling time, deg/s; 0 at rest. A
        /// drive can use it as a feed-forward velocity. Vibrations are included in the angle, but not in the rate.
        rate: f64,
    },
    /// Torque control, in the robot's torque unit.
    Torque(f64),
}

impl JointCommand {
    /// Returns the command to stay at an angle, deg.
    pub const fn at(angle: f64) -> Self {
        JointCommand::Angle { angle, rate: 0.0 }
    }

    /// Returns the angle (deg) or torque that is sent.
    pub const fn value(self) -> f64 {
        match self {
            JointCommand::Angle { angle, .. } => angle,
            JointCommand::Torque(torque) => torque,
        }
    }
}

/// The commands of one cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outputs<const L: usize, const J: usize> {
    /// One command for each joint.
    pub joints: [[JointCommand; J]; L],
    /// Commanded place of the slider (`FLOOR`), mm; zeros without a slider.
    pub slider: Point,
    /// Lamps and relays: bit n % 32 of word n / 32 is device n.
    pub lamps: [u32; 8],
    /// The sampling time for which the commands hold, ms.
    pub period: f64,
}

/// The commands to a robot of any number of legs, leg by leg.
#[derive(Debug)]
pub(crate) struct OutputsView<'a, const J: usize> {
    pub(crate) joints: &'a mut [[JointCommand; J]],
    pub(crate) slider: &'a mut Point,
    pub(crate) lamps: &'a mut [u32; 8],
    pub(crate) period: &'a mut f64,
}

impl<const L: usize, const J: usize> Outputs<L, J> {
    pub(crate) const fn view(&mut self) -> OutputsView<'_, J> {
        OutputsView {
            joints: &mut self.joints,
            slider: &mut self.slider,
            lamps: &mut self.lamps,
            period: &mut self.period,
        }
    }
}

/// A robot: simulated, or yours.
pub trait Hardware<const L: usize, const J: usize> {
    /// Samples every sensor, at the start of a cycle.
    ///
    /// # Errors
    /// The fault; the machine answers with an emergency stop.
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault>;

    /// Sends every joint command and output, at the end of a cycle.
    ///
    /// # Errors
    /// The fault; the machine answers with an emergency stop.
    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault>;

    /// Stops the robot: called in every cycle of an emergency, in place of [`write`](Self::write).
    ///
    /// # Errors
    /// The robot could not be stopped in this cycle. The machine keeps the first such fault
    /// ([`Emergency::stop_fault`](crate::machine::Emergency::stop_fault)), and calls again in the next cycle.
    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault>;
}

/// A value for each input that a robot may have. Inputs that a robot lacks keep their first value. Joints are not
/// included, since their potentiometers are read as angles; neither are channels, which lead to other inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inputs<T = f64>([T; Port::INPUTS]);

impl<T: Copy> Inputs<T> {
    /// Creates inputs that all have one value.
    pub const fn all(value: T) -> Self {
        Inputs([value; Port::INPUTS])
    }

    /// Returns the value of an input; `None` for a joint, a channel, or a number that no robot has.
    pub fn get(&self, port: Port) -> Option<T> {
        self.0.get(port.place()?).copied()
    }

    /// Returns the value of an input, mutably.
    pub fn get_mut(&mut self, port: Port) -> Option<&mut T> {
        self.0.get_mut(port.place()?)
    }

    /// Sets the value of an input. Returns false if [`get`](Self::get) returns `None` for it.
    pub fn set(&mut self, port: Port, value: T) -> bool {
        self.get_mut(port).map(|place| *place = value).is_some()
    }

    /// Returns the values of a kind, in the order of its numbers; `port` selects the kind.
    pub fn of(&self, port: Port) -> &[T] {
        self.0.get(port.places()).unwrap_or_default()
    }
}

impl Inputs {
    /// Replaces the readings of inputs that were set.
    pub(crate) fn replace(&mut self, set: &Inputs<Option<f64>>) {
        for (read, set) in self.0.iter_mut().zip(&set.0) {
            *read = set.unwrap_or(*read);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::MAX;

    // clauses: 7.32
    #[test]
    fn each_input_has_a_place_of_its_own() {
        let soles = (1..).take(MAX).map(Port::Paw);
        let ports = || {
            Port::Knob(1)
                .named()
                .chain(soles.clone())
                .chain([Port::Antenna])
        };
        let mut inputs = Inputs::all(0);
        for (number, port) in (1..).zip(ports()) {
            assert!(inputs.set(port, number), "{port}");
        }
        assert_eq!(ports().count(), Port::INPUTS);
        for (number, port) in (1..).zip(ports()) {
            assert_eq!(inputs.get(port), Some(number), "{port}");
        }
        assert_eq!(inputs.of(Port::Knob(1)), [1, 2, 3]);
        assert_eq!(inputs.of(Port::Antenna), [13]);
    }

    // clauses: 7.32
    #[test]
    fn what_is_no_input_by_itself_has_no_value() {
        let mut inputs = Inputs::all(1.0);
        for port in [
            Port::Knob(0),
            Port::Knob(4),
            Port::Paw(0),
            Port::Paw(10),
            Port::Joint(1, 1),
            Port::Channel(13),
        ] {
            assert!(!inputs.set(port, 2.0), "{port:?}");
            assert_eq!(inputs.get(port), None, "{port:?}");
        }
        assert_eq!(inputs, Inputs::all(1.0));
    }
}
