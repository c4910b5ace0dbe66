//! The robots that a program can be checked for.

use tip_runtime::command::Target;
use tip_runtime::model::{Range, generic, hand, titan8};
use tip_runtime::program::Signature;

/// A robot that the compiler knows by name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Robot {
    /// TITAN VIII: four legs of three joints.
    #[default]
    Titan8,
    /// Hiroshima Hand: three fingers of three joints, and a slider.
    Hand,
    /// The generic robot: four legs of three joints.
    Generic,
}

impl Robot {
    /// Every robot.
    pub const ALL: &'static [Robot] = &[Robot::Titan8, Robot::Hand, Robot::Generic];

    /// The robot of that name.
    pub fn from_name(name: &str) -> Option<Robot> {
        Robot::ALL
            .iter()
            .copied()
            .find(|robot| robot.name() == name)
    }

    /// The name that options use.
    pub const fn name(self) -> &'static str {
        self.signature().robot
    }

    /// What a program for it must state.
    pub const fn signature(self) -> Signature {
        match self {
            Robot::Titan8 => titan8::MODEL.signature(),
            Robot::Hand => hand::MODEL.signature(),
            Robot::Generic => generic::MODEL.signature(),
        }
    }

    /// The sampling times that it accepts: ms.
    pub(crate) const fn periods(self) -> Range {
        match self {
            Robot::Titan8 => titan8::MODEL.periods,
            Robot::Hand => hand::MODEL.periods,
            Robot::Generic => generic::MODEL.periods,
        }
    }

    /// How many lamps and relays it has.
    pub(crate) const fn lamps(self) -> u8 {
        match self {
            Robot::Titan8 => titan8::MODEL.lamps,
            Robot::Hand => hand::MODEL.lamps,
            Robot::Generic => generic::MODEL.lamps,
        }
    }

    /// Whether the robot has the leg, joint or slider.
    pub(crate) fn has(self, target: Target) -> bool {
        let Signature { legs, joints, .. } = self.signature();
        match target {
            Target::None | Target::All => true,
            Target::Floor => self == Robot::Hand,
            Target::Foot(leg) => leg <= legs,
            Target::Joint(leg, joint) => leg <= legs && joint <= joints,
        }
    }

    /// What the robot has, for help texts.
    pub(crate) fn inventory(self) -> String {
        let Signature {
            robot,
            legs,
            joints,
            ..
        } = self.signature();
        let floor = if self == Robot::Hand { ", FLOOR" } else { "" };
        format!("{robot} has F1…F{legs}, J11…J{legs}{joints}{floor}")
    }
}
