//! Operands: constants, variables, members, and targets.

use crate::writer::{JOINTS, POSITIONS, VARS, Writer};

const CONSTANTS: &[&str] = &[
    "0",
    "1",
    "2.5",
    "-3",
    ".5",
    "7.",
    "90",
    "-0.125",
    "1E2",
    "+4",
    "0.3333333333333333",
    "CHAR_7",
    "-2.5E-3",
];

/// Constants of the DEFINEs that programs of 3.2 begin with.
const NAMED: &[&str] = &["HALF", "-HALF", "LESS", "-LESS", "DIGIT", "NONE"];

impl Writer {
    /// A number as it is written, or a name for one.
    pub(crate) fn constant(&mut self) -> &'static str {
        if self.is_later() && self.random.once_in(4) {
            return self.pick(NAMED);
        }
        self.pick(CONSTANTS)
    }

    /// A whole scalar variable.
    pub(crate) fn variable(&mut self) -> &'static str {
        match self.is_calm() {
            false if self.random.once_in(5) => "VAR_KEY",
            _ => self.pick(VARS),
        }
    }

    /// A member of a struct.
    pub(crate) fn member(&mut self) -> String {
        if self.random.once_in(2) {
            let axis = self.pick(&["X", "Y", "Z"]);
            format!("{}.{axis}", self.pick(POSITIONS))
        } else {
            self.joint_member()
        }
    }

    /// A member of a JOINT.
    pub(crate) fn joint_member(&mut self) -> String {
        let joint = 1 + self.random.below(u64::from(self.robot.signature().joints));
        format!("{}.J{joint}", self.pick(JOINTS))
    }

    /// Any scalar operand.
    pub(crate) fn scalar(&mut self) -> String {
        if self.reads() {
            return self.scalar_reading();
        }
        match self.random.below(8) {
            0..=2 => self.constant().to_owned(),
            3 => self.member(),
            4 => format!("-{}", self.variable()),
            5 => format!("-{}", self.member()),
            _ => self.variable().to_owned(),
        }
    }

    /// A foot or finger.
    pub(crate) fn foot(&mut self) -> String {
        let legs = self.robot.signature().legs;
        format!("F{}", 1 + self.random.below(u64::from(legs)))
    }

    /// A joint.
    pub(crate) fn joint(&mut self) -> String {
        let joints = self.robot.signature().joints;
        let joint = 1 + self.random.below(u64::from(joints));
        self.joint_numbered(joint)
    }

    /// The joint of that number of some leg.
    pub(crate) fn joint_numbered(&mut self, joint: u64) -> String {
        let legs = self.robot.signature().legs;
        format!("J{}{joint}", 1 + self.random.below(u64::from(legs)))
    }
}
