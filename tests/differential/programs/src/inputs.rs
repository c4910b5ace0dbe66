//! Commands that fill variables, and SPECIAL.

use crate::NATIVE;
use crate::writer::{JOINTS, POSITIONS, VARS, Writer};
use tip_runtime::command::Teach;
use tip_runtime::model::Family;
use tipc::language::commands::{Command, Meaning, Targets};

impl Writer {
    /// Measurements go into the variables that a calm program's values come from.
    pub(crate) fn teach(&mut self, command: &Command, targets: Targets) -> String {
        let target = self.target(targets);
        let into = match command.meaning {
            Meaning::Teach(Teach::Position | Teach::Force) => self.pick(POSITIONS),
            _ if target.starts_with('J') => return format!("{target} {}", self.scalar_target()),
            _ => self.pick(JOINTS),
        };
        format!("{target} {into}")
    }

    fn scalar_target(&mut self) -> String {
        match self.random.once_in(2) {
            true => self.joint_member(),
            false => self.pick(VARS).to_owned(),
        }
    }

    pub(crate) fn ad_in(&mut self) -> String {
        let family = self.robot.signature().family;
        let mut inputs = vec![
            "0 13".to_owned(),
            "0, 0".to_owned(),
            "VR1".to_owned(),
            "VR3".to_owned(),
            self.joint(),
        ];
        if family == Family::Titan {
            inputs.push(format!("PAW{}", 1 + self.random.below(4)));
        }
        if family != Family::Generic {
            inputs.push("ANTENNA".to_owned());
        }
        format!("{} {}", self.pick(&inputs), self.pick(VARS))
    }

    pub(crate) fn special(&mut self) -> String {
        if self.is_hand() && self.random.below(3) > 0 {
            return self.special_of_hand();
        }
        let [at_once, lasting, lamp, failing] = NATIVE;
        let last = if self.is_calm() { lamp } else { failing };
        match self.random.below(4) {
            0 => format!("{at_once}"),
            1 | 2 => format!("{lasting} {} {}", self.random.below(6), self.pick(VARS)),
            _ => format!("{last}"),
        }
    }

    fn special_of_hand(&mut self) -> String {
        let finger = self.random.below(3);
        match self.random.below(8) {
            0 => "1 20".to_owned(),
            1 => "2 15".to_owned(),
            2 => "5 2 10".to_owned(),
            3 => "6 1 -1".to_owned(),
            4 => "10".to_owned(),
            5 => format!(
                "{} {} {}",
                11 + finger,
                self.random.below(8),
                self.pick(&["0.5", "2"])
            ),
            6 => format!("{} {}", 14 + finger, self.pick(&["0", "20", "60"])),
            _ => format!("20 {} {}", self.random.below(2), self.random.below(2)),
        }
    }
}
