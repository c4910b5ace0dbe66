//! Runtime errors. `Display` writes the classical message of the language (T.I.P. 3.1 §9-3).
//!
//! ```
//! use tip_runtime::command::Target;
//! use tip_runtime::fault::{Fault, Kind};
//!
//! let fault = Fault::OutOfReach(Target::Foot(2));
//! assert_eq!(fault.to_string(), "Out of reach F2");
//! assert_eq!((fault.kind(), Fault::Domain.kind()), (Kind::Robot, Kind::Runtime));
//! ```

use crate::command::{Port, Target};
use core::fmt;

/// The class of an error, as the classical one-liner names it in parentheses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// The text could not be read (§9-1).
    Preprocess,
    /// The program cannot be loaded (§9-2).
    Syntax,
    /// The program failed while it ran (§9-3).
    Runtime,
    /// The robot itself failed.
    Robot,
}

impl Kind {
    /// Returns the classical name: `RuntimeError` and so on.
    pub const fn name(self) -> &'static str {
        match self {
            Kind::Preprocess => "PreprocessError",
            Kind::Syntax => "SyntaxError",
            Kind::Runtime => "RuntimeError",
            Kind::Robot => "RobotError",
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The cause of an emergency stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Fault {
    /// An operand outside the domain of its operation, or a result that is not finite.
    Domain,
    /// RETURN or SUBEND without a call to return from.
    InvalidReturn,
    /// A scalar read before it was assigned: its index in [`Program::scalar`](crate::program::Program::scalar).
    Unassigned(u32),
    /// The command does not fit the control mode of its target.
    InvalidMode,
    /// More than ten nested calls.
    TooDeep,
    /// A jump to a step that does not exist; no program made by this compiler can cause it.
    WrongStep,
    /// A joint reached its limit (leg and joint, from 1).
    JointLimit(u8, u8),
    /// The target, or the path to it, is out of reach.
    OutOfReach(Target),
    /// An input reads an invalid value.
    Sensor(Port),
    /// The sensor of the slider reads an invalid value.
    SliderSensor,
    /// A joint sensor reads an invalid value (leg and joint, from 1).
    JointSensor(u8, u8),
    /// The robot's hardware failed to read or to write.
    Hardware(HardwareFault),
    /// The RETURN key: software emergency stop.
    EmergencyKey,
}

impl Fault {
    /// Returns the class of the fault.
    pub const fn kind(&self) -> Kind {
        match self {
            Fault::Domain
            | Fault::InvalidReturn
            | Fault::Unassigned(_)
            | Fault::InvalidMode
            | Fault::TooDeep
            | Fault::WrongStep => Kind::Runtime,
            Fault::JointLimit(..)
            | Fault::OutOfReach(_)
            | Fault::Sensor(_)
            | Fault::SliderSensor
            | Fault::JointSensor(..)
            | Fault::Hardware(_)
            | Fault::EmergencyKey => Kind::Robot,
        }
    }
}

/// The message of [`Fault::Unassigned`], which is also a load error.
pub const UNASSIGNED: &str = "Possible use of Variable before definition";

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Domain => f.write_str("Domain error"),
            Fault::InvalidReturn => f.write_str("Invalid Return command"),
            Fault::Unassigned(_) => f.write_str(UNASSIGNED),
            Fault::InvalidMode => f.write_str("Invalid control mode"),
            Fault::TooDeep => f.write_str("Too deep subroutine call"),
            Fault::WrongStep => f.write_str("Wrong step number"),
            Fault::JointLimit(leg, joint) => {
                write!(f, "Joint limit {}", Target::Joint(*leg, *joint))
            }
            Fault::OutOfReach(target) => write!(f, "Out of reach {target}"),
            Fault::Sensor(Port::Channel(_)) => f.write_str("Sensor fault AD"),
            Fault::Sensor(Port::Joint(..)) => f.write_str("Sensor fault potentiometer"),
            Fault::Sensor(port) => write!(f, "Sensor fault {port}"),
            Fault::SliderSensor => write!(f, "Sensor fault {}", Target::Floor),
            Fault::JointSensor(leg, joint) => {
                write!(f, "Sensor fault {}", Target::Joint(*leg, *joint))
            }
            Fault::Hardware(fault) => write!(f, "Hardware fault {fault}"),
            Fault::EmergencyKey => f.write_str("Emergency stop key"),
        }
    }
}

impl core::error::Error for Fault {}

/// A failure of the robot to read, to write or to stop: its cause, and the joint and the servo where it happened, as
/// far as they are known.
///
/// `Display` writes `no answer`, `J23: no answer`, `servo 9: no answer` or `J23 (servo 9): no answer`.
///
/// ```
/// use tip_runtime::fault::{Fault, HardwareFault};
///
/// const SILENT: HardwareFault = HardwareFault::new("no answer");
/// assert_eq!(Fault::Hardware(SILENT).to_string(), "Hardware fault no answer");
/// assert_eq!(SILENT.at_joint(2, 3).of_servo(9).to_string(), "J23 (servo 9): no answer");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HardwareFault {
    /// Cause, in a few words.
    pub cause: &'static str,
    /// Leg and joint, from 1; `None` if no joint or more than one is concerned.
    pub joint: Option<(u8, u8)>,
    /// Identity of the servo on its bus.
    pub servo: Option<u16>,
}

impl HardwareFault {
    /// Returns a fault of the whole robot.
    pub const fn new(cause: &'static str) -> Self {
        HardwareFault {
            cause,
            joint: None,
            servo: None,
        }
    }

    /// Returns the fault, at a joint (leg and joint, from 1).
    pub const fn at_joint(self, leg: u8, joint: u8) -> Self {
        HardwareFault {
            joint: Some((leg, joint)),
            ..self
        }
    }

    /// Returns the fault, of the servo with this identity on its bus.
    pub const fn of_servo(self, id: u16) -> Self {
        HardwareFault {
            servo: Some(id),
            ..self
        }
    }
}

impl fmt::Display for HardwareFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let joint = self.joint.map(|(leg, joint)| Target::Joint(leg, joint));
        match (joint, self.servo) {
            (Some(joint), Some(id)) => write!(f, "{joint} (servo {id}): ")?,
            (Some(joint), None) => write!(f, "{joint}: ")?,
            (None, Some(id)) => write!(f, "servo {id}: ")?,
            (None, None) => {}
        }
        f.write_str(self.cause)
    }
}

impl core::error::Error for HardwareFault {}
