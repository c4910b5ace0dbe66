//! Values that a command may take, after its unit and its limit.

use crate::writer::Writer;
use tip_runtime::model::{Family, Range, generic, hand, titan8};
use tipc::language::commands::{Command, Limit};

/// Initial positions of feet and fingers, mm.
const FEET: [[f64; 3]; 4] = [
    [-391.0, 201.0, -200.0],
    [391.0, 201.0, -200.0],
    [-391.0, -201.0, -200.0],
    [391.0, -201.0, -200.0],
];
const FINGERS: [[f64; 3]; 3] = [
    [-111.0, -122.0, 0.0],
    [111.0, -122.0, 0.0],
    [111.0, -122.0, 0.0],
];

impl Writer {
    /// A value of a command: small, and within its limit; wild programs break it now and then.
    pub(crate) fn number(&mut self, command: &Command, limit: Limit) -> String {
        if !self.is_calm() && self.random.once_in(12) {
            if self.is_later() {
                return "BAD".to_owned();
            }
            return self.pick(&["-1", "0", "1E9", "-0.0", "300"]).to_owned();
        }
        let Range { min, max } = self.robot.facts().periods;
        let period = self.robot.facts().period;
        let size = self.size(command.unit);
        let of = |writer: &mut Self, values: &[f64]| writer.pick(values).to_string();
        match limit {
            Limit::Any => of(
                self,
                &[-1.0, -0.5, -0.25, 0.0, 0.25, 0.5, 1.0].map(|share| share * size),
            ),
            Limit::NotNegative if command.unit == "ms" => {
                of(self, &[0.0, period, 2.5 * period, 4.0 * period])
            }
            Limit::NotNegative | Limit::Positive => {
                of(self, &[0.5, 1.0, 2.0, 3.3].map(|share| share * size))
            }
            Limit::Percent => of(self, &[1.0, 33.3, 75.0, 100.0]),
            Limit::Period => of(self, &[min, period, period, 2.0 * period, 0.1 * max]),
            Limit::Frequency => of(
                self,
                &[min, period, period, 2.0 * period, 0.1 * max].map(|time| 1000.0 / time),
            ),
            Limit::Lamp => self
                .random
                .below(u64::from(self.robot.facts().lamps))
                .to_string(),
            Limit::FloorType if self.is_hand() => of(self, &[1.0, 2.0]),
            Limit::FloorType | Limit::ObjectType => of(self, &[1.0, 2.5, 3.0]),
            Limit::Timer => of(self, &[0.0, 1.0, 2.9, 7.0]),
            Limit::Steps => of(self, &[1.0, 1.0, 2.0, 3.0, 5.5, 255.0]),
            Limit::Angles => of(self, &[0.0]),
        }
    }

    pub(crate) fn is_hand(&self) -> bool {
        self.robot.signature().family == Family::Hand
    }

    /// Returns a moderate amount of a unit on this robot.
    fn size(&self, unit: &str) -> f64 {
        match unit {
            "mm" => 8.0,
            "mm/s" => 60.0,
            "mm/s²" => 300.0,
            "deg/s" => 30.0,
            "deg/s²" => 200.0,
            "torque" if self.is_hand() => 100.0,
            "N/mm" => 0.2,
            _ => 4.0,
        }
    }

    /// Returns the start of a target in the unit of the command: a foot's position, or a leg's or joint's angles.
    pub(crate) fn home(&self, unit: &str, target: &str) -> Option<Vec<f64>> {
        let mut digits = target
            .bytes()
            .skip(1)
            .map(|digit| usize::from(digit.wrapping_sub(b'1')));
        let leg = digits.next()?;
        match (unit, target.as_bytes()) {
            ("mm", [b'F', _]) if self.is_hand() => Some(FINGERS.get(leg)?.to_vec()),
            ("mm", [b'F', _]) => Some(FEET.get(leg)?.to_vec()),
            ("mm", b"FLOOR") => Some(vec![0.0, -130.0, 0.0]),
            ("deg", [b'F', _]) => self.initial(leg),
            ("deg", [b'J', ..]) => Some(vec![*self.initial(leg)?.get(digits.next()?)?]),
            _ => None,
        }
    }

    pub(crate) fn initial(&self, leg: usize) -> Option<Vec<f64>> {
        let angles = match self.robot.signature().family {
            Family::Titan => titan8::MODEL.legs.get(leg)?.initial,
            Family::Generic => generic::MODEL.legs.get(leg)?.initial,
            Family::Hand => hand::MODEL.legs.get(leg)?.initial,
        };
        Some(angles.to_vec())
    }
}
