//! How long a command takes, and how it can fail when it runs.

use super::{Command, Form, Limit, Values};
use tip_runtime::command::{Port, Target};
use tip_runtime::fault::Fault;

/// How many control cycles a command takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cycles {
    /// None: it is not a step.
    Zero,
    /// One; the program does not wait for what it sets off.
    One,
    /// At least one: the program stays until this holds.
    Until(&'static str),
}

/// A runtime error, and when it happens.
pub type Failure = (Fault, &'static str);

/// Nothing of its own.
pub(super) const NONE: &[Failure] = &[];

const NO_VALUE: Failure = (Fault::Unassigned(0), "a variable in it has no value yet");

/// It reads operands.
pub(super) const READS: &[Failure] = &[NO_VALUE];

pub(super) const REACH: &[Failure] = &[(
    Fault::OutOfReach(Target::Foot(1)),
    "the position, or the path to it, cannot be reached; under EMG_OFF the motion stops there",
)];

pub(super) const TURN: &[Failure] = &[(
    Fault::OutOfReach(Target::Joint(1, 1)),
    "the angle is beyond the joint's limits; under EMG_OFF the joint stops there",
)];

pub(super) const GLIDE: &[Failure] = &[
    (
        Fault::OutOfReach(Target::Foot(1)),
        "the foot reaches the end of its reach; under EMG_OFF it stops there",
    ),
    (
        Fault::JointLimit(1, 1),
        "a joint reaches its limit during the motion; under EMG_OFF it stops there",
    ),
];

pub(super) const SPIN: &[Failure] = &[(
    Fault::JointLimit(1, 1),
    "the joint reaches its limit; under EMG_OFF it stops there",
)];

pub(super) const UNCONTROLLED: &[Failure] = &[(
    Fault::InvalidMode,
    "no part of the foot or joint is under position or angle control",
)];

pub(super) const STAND: &[Failure] = &[
    (
        Fault::InvalidMode,
        "a torque, force or spring controls a joint",
    ),
    (
        Fault::OutOfReach(Target::Foot(1)),
        "a foot cannot reach that far; under EMG_OFF it stops there",
    ),
];

pub(super) const SWING: &[Failure] = &[(
    Fault::JointLimit(1, 1),
    "a joint that nothing stops swings past its limit; under EMG_OFF it is held there",
)];

pub(super) const FLOOR: &[Failure] = &[
    (
        Fault::Sensor(Port::Paw(1)),
        "a sole's sensor reads nonsense",
    ),
    (
        Fault::OutOfReach(Target::Foot(1)),
        "a foot reaches the end of its reach before it feels the floor",
    ),
    NOTHING_THERE,
];

pub(super) const OBJECT: &[Failure] = &[NOTHING_THERE];

const NOTHING_THERE: Failure = (
    Fault::JointLimit(1, 1),
    "a joint reaches its limit because nothing is there to touch",
);

pub(super) const INPUT: &[Failure] = &[(Fault::Sensor(Port::Knob(1)), "the input reads nonsense")];

pub(super) const COUNT: &[Failure] = &[
    NO_VALUE,
    (
        Fault::Domain,
        "the increment is 0, or a sum is too large for a number",
    ),
];

pub(super) const CALLS: &[Failure] = &[(Fault::TooDeep, "ten calls are open already")];

pub(super) const BRANCHES: &[Failure] = &[
    NO_VALUE,
    (Fault::TooDeep, "GOSUB: ten calls are open already"),
];

pub(super) const RETURNS: &[Failure] = &[(Fault::InvalidReturn, "no call is open")];

pub(super) const NATIVE: &[Failure] = &[(
    Fault::Domain,
    "no native code has this number, or it refuses the values",
)];

impl Command {
    /// Every runtime error of its own step.
    pub fn failures(&self) -> Vec<Failure> {
        let operands = if self.reads() { READS } else { NONE };
        let limit = self.limit().map(|when| (Fault::Domain, when));
        let own = self.failures.iter().copied();
        operands.iter().copied().chain(limit).chain(own).collect()
    }

    /// Which values stop the program.
    pub fn limit(&self) -> Option<&'static str> {
        let Form::Robot(arguments) = self.form else {
            return None;
        };
        match arguments.limit {
            Limit::Any => None,
            Limit::NotNegative => Some("below 0"),
            Limit::Positive => Some("0 and below"),
            Limit::Percent => Some("0 and below, above 100"),
            Limit::Period | Limit::Frequency => Some("outside the robot's range"),
            Limit::Lamp => Some("a device that is not fitted"),
            Limit::FloorType => Some("T: not 1–3; H: not 1–2"),
            Limit::ObjectType => Some("not 1–3"),
        }
    }

    fn reads(&self) -> bool {
        match self.form {
            Form::Robot(arguments) => arguments.values != Values::None,
            Form::Special => true,
            Form::Teach(_) | Form::AdIn | Form::KeyIn | Form::Words(_) => false,
        }
    }
}
