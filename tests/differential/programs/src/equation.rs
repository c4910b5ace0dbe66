//! Equations. Those of calm programs take only from variables after the one they fill, so that no value feeds on itself.

use crate::writer::{JOINTS, POSITIONS, Writer};

/// Order in which values flow in a calm program: each variable from those after it.
const FLOW: &[&str] = &[
    "D", "P.X", "S.J1", "B", "P.Y", "S.J2", "C", "P.Z", "S.J3", "Q.X", "T.J1", "Q.Y", "T.J2",
    "Q.Z", "T.J3",
];

/// Functions of every number.
const TOTAL: &[&str] = &["INT", "ABS", "SIN", "COS", "TAN", "DEG2RAD", "RAD2DEG"];
/// Functions of some.
const PARTIAL: &[&str] = &["SQRT", "ASIN", "ACOS", "ATAN"];

impl Writer {
    pub(crate) fn scalar_equation(&mut self) {
        match self.is_calm() {
            true => self.calm_scalar(),
            false => self.wild_scalar(),
        }
    }

    fn calm_scalar(&mut self) {
        let place = self.random.below(FLOW.len() as u64 - 1) as usize;
        let target = FLOW[place];
        let behind = &FLOW[place + 1..];
        let (a, b) = (self.pick(behind), self.pick(behind));
        let minus = self.pick(&["", "", "-"]);
        let constant = self.constant();
        let line = match self.random.below(12) {
            0 => format!("{target} = {minus}{a}"),
            1 => format!("{target} = {minus}{a} + {b}"),
            2 => format!("{target} = {constant} - {b}"),
            3 => format!("{target} = {a}*{constant}"),
            4 => format!("{target} = {a} / {}", self.pick(&["2", "-4", "0.1", "3"])),
            5 => format!("{target} = ATAN2 1 {minus}{a}"),
            6 => format!("{target} = NORM {}", self.pick(&["Q", "T"])),
            7 => format!("{target} {} 0.25", self.pick(&["+=", "-="])),
            8 => format!("{target} {} .5", self.pick(&["*=", "+="])),
            9 => {
                self.line(&format!("{target} = SIN {minus}{a}"));
                format!("{target} = {} {target}", self.pick(&PARTIAL[1..]))
            }
            10 => {
                self.line(&format!("{target} = ABS {a}"));
                format!("{target} = SQRT {target}")
            }
            _ => format!("{target} = {} {minus}{a}", self.pick(TOTAL)),
        };
        self.line(&line);
    }

    fn wild_scalar(&mut self) {
        let target = if self.random.once_in(3) {
            self.member()
        } else {
            self.variable().to_owned()
        };
        let update = self.pick(&["=", "=", "=", "+=", "-=", "*=", "/="]);
        let (a, b) = (self.scalar(), self.scalar());
        let value = match self.random.below(12) {
            0..=2 if update == "/=" => self.unless_constant(a),
            0..=2 => a,
            3..=7 => match self.pick(&["+", "-", "*", "/", "+"]) {
                "/" => format!("{a} / {}", self.unless_constant(b)),
                operator => format!("{a} {operator} {b}"),
            },
            8 => format!("{} {}", self.pick(PARTIAL), self.unless_constant(a)),
            9 => format!("{} {a}", self.pick(TOTAL)),
            10 => format!("ATAN2 {} {b}", self.unless_constant(a)),
            _ if self.reads() => format!("NORM {}", self.struct_reading(None)),
            _ => format!("NORM {}", self.pick(&["P", "Q", "S", "T"])),
        };
        self.line(&format!("{target} {update} {value}"));
    }

    pub(crate) fn struct_equation(&mut self) {
        let names = self.pick(&[POSITIONS, JOINTS]);
        let (first, last) = (names[0], names[1]);
        let [target, a, b] = match self.is_calm() {
            true => [first, last, last],
            false => [self.pick(names), self.pick(names), self.pick(names)],
        };
        let reading = self.reads().then(|| self.struct_reading(Some(names)));
        let a = reading.as_deref().unwrap_or(a);
        let rotation = self.pick(&["ROT_X", "ROT_Y", "ROT_Z"]);
        let updates: &[&str] = if self.is_calm() {
            &["="]
        } else {
            &["=", "=", "+=", "-=", "*=", "/="]
        };
        let update = self.pick(updates);
        let operations: &[&str] = if self.is_calm() {
            &["+", "-", "*"]
        } else {
            &["+", "-", "*", "/"]
        };
        let value = match self.random.below(5) {
            0 => a.to_owned(),
            1 if names == POSITIONS => format!("UNIT_VECT {a}"),
            2 | 3 if names == POSITIONS => {
                let angle = self.pick(&["D", "30", "-45", "C", "-B"]);
                format!("{rotation} {a} {angle}")
            }
            _ => format!("{a} {} {b}", self.pick(operations)),
        };
        self.line(&format!("{target} {update} {value}"));
    }
}
