//! LewanSoul and Hiwonder LX-16A and HTS-35H.
//!
//! Source: LewanSoul (Hiwonder), "Bus Servo Communication Protocol": "Table 2" (commands and their lengths), the notes on each
//! command, and "Table 4" (answers). Speeds are those of the product pages: LX-16A 0.19 s/60° at 6 V, HTS-35H 0.18 s/60° at 11.1 V.
//!
//! The document does not say whether a move loads the motor. This one does, so that a master which sends a goal too many is noticed.

use super::firmware::{Drive, Firmware, Shaft};
use super::wire::Wire;
use std::boxed::Box;
use std::vec;
use std::vec::Vec;

/// Commands.
mod command {
    pub(super) const MOVE_TIME_WRITE: u8 = 1;
    pub(super) const MOVE_TIME_READ: u8 = 2;
    pub(super) const MOVE_TIME_WAIT_WRITE: u8 = 7;
    pub(super) const MOVE_TIME_WAIT_READ: u8 = 8;
    pub(super) const MOVE_START: u8 = 11;
    pub(super) const MOVE_STOP: u8 = 12;
    pub(super) const ID_WRITE: u8 = 13;
    pub(super) const ID_READ: u8 = 14;
    pub(super) const ANGLE_OFFSET_ADJUST: u8 = 17;
    pub(super) const ANGLE_OFFSET_WRITE: u8 = 18;
    pub(super) const ANGLE_OFFSET_READ: u8 = 19;
    pub(super) const ANGLE_LIMIT_WRITE: u8 = 20;
    pub(super) const ANGLE_LIMIT_READ: u8 = 21;
    pub(super) const VIN_LIMIT_WRITE: u8 = 22;
    pub(super) const VIN_LIMIT_READ: u8 = 23;
    pub(super) const TEMP_MAX_LIMIT_WRITE: u8 = 24;
    pub(super) const TEMP_MAX_LIMIT_READ: u8 = 25;
    pub(super) const TEMP_READ: u8 = 26;
    pub(super) const VIN_READ: u8 = 27;
    pub(super) const POS_READ: u8 = 28;
    pub(super) const MODE_WRITE: u8 = 29;
    pub(super) const MODE_READ: u8 = 30;
    pub(super) const LOAD_OR_UNLOAD_WRITE: u8 = 31;
    pub(super) const LOAD_OR_UNLOAD_READ: u8 = 32;
}

/// "0~1000, corresponding to the servo angle of 0~240°".
const LAST: i16 = 1000;
const TRAVEL: f64 = 240.0;
/// "30000 ms" at most.
const MAX_MOVE: u16 = 30_000;

/// The settings that are kept without power.
#[derive(Clone, Copy, Debug)]
struct Kept {
    id: u8,
    offset: i8,
    limits: [i16; 2],
    /// mV
    voltages: [i16; 2],
    /// °C
    hottest: u8,
}

/// The firmware of an LX servo.
#[derive(Clone, Debug)]
pub(super) struct Lx {
    kept: Kept,
    /// Deviation in force; it is kept once it is written.
    offset: i8,
    is_loaded: bool,
    /// Motor mode, and its speed from -1000 to 1000.
    motor: Option<i16>,
    /// Goal, counts, and time of the move, ms, as they were sent.
    goal: (i16, u16),
    /// The move that waits for its start.
    waiting: (i16, u16),
    /// Goal within the limits, counts, and speed of the present move, counts/s.
    target: (i16, f64),
    top_speed: f64,
    /// Position, counts.
    here: f64,
}

impl Lx {
    /// Creates the firmware of a model, and returns its top speed, deg/s, and the voltage of its supply.
    pub(super) fn of(model: &str, id: u8) -> Option<(Box<dyn Firmware + Send + Sync>, f64, f64)> {
        let (top_speed, voltage) = match model {
            "LX-16A" => (60.0 / 0.19, 7.4),
            "HTS-35H" => (60.0 / 0.18, 11.1),
            _ => return None,
        };
        let lx = Lx {
            kept: Kept {
                id,
                offset: 0,
                limits: [0, LAST],
                voltages: [6500, 12_000],
                hottest: 85,
            },
            offset: 0,
            is_loaded: false,
            motor: None,
            goal: (0, 0),
            waiting: (0, 0),
            target: (0, 0.0),
            top_speed,
            here: 0.0,
        };
        Some((Box::new(lx), top_speed, voltage))
    }

    /// Begins a move: "rotated from current angle to parameter angle at uniform speed within the time".
    fn begin(&mut self, (goal, time): (i16, u16)) {
        let [min, max] = self.kept.limits;
        let target = goal.clamp(min, max);
        let distance = (f64::from(target) - self.here).abs();
        let speed = match time {
            0 => f64::INFINITY,
            time => distance * 1000.0 / f64::from(time),
        };
        (self.goal, self.target) = ((goal, time), (target, speed));
        (self.motor, self.is_loaded) = (None, true);
    }
}

impl Firmware for Lx {
    fn wire(&self) -> Wire {
        Wire::Lx
    }

    fn id(&self) -> u8 {
        self.kept.id
    }

    fn counts(&self, angle: f64) -> f64 {
        let whole = f64::from(LAST) / TRAVEL;
        angle * whole + f64::from(LAST) / 2.0 - f64::from(self.offset)
    }

    fn angle(&self, counts: f64) -> f64 {
        let whole = f64::from(LAST) / TRAVEL;
        (counts - f64::from(LAST) / 2.0 + f64::from(self.offset)) / whole
    }

    fn power_on(&mut self, shaft: &Shaft) {
        self.offset = self.kept.offset;
        (self.is_loaded, self.motor) = (false, None);
        self.here = self.counts(shaft.angle);
        let here = libm::round(self.here) as i16;
        (self.goal, self.waiting) = ((here, 0), (here, 0));
        self.target = (here, f64::INFINITY);
    }

    fn sense(&mut self, shaft: &Shaft, _now: u64) {
        self.here = self.counts(shaft.angle);
        let [low, high] = self.kept.voltages.map(|limit| f64::from(limit) / 1000.0);
        let is_hot = shaft.temperature > self.kept.hottest.into();
        // "The motor will be unloaded to protect the servo."
        if is_hot || !(low..=high).contains(&shaft.voltage) {
            self.is_loaded = false;
        }
    }

    fn drive(&self) -> Drive {
        if !self.is_loaded {
            return Drive::Free;
        }
        match self.motor {
            Some(speed) => Drive::Spin(f64::from(speed) / 1000.0 * self.top_speed),
            None => Drive::To {
                goal: self.angle(self.target.0.into()),
                speed: self.target.1 * TRAVEL / f64::from(LAST),
                torque: 1.0,
            },
        }
    }

    fn has_torque(&self) -> bool {
        self.is_loaded
    }

    fn goal(&self) -> f64 {
        self.goal.0.into()
    }

    /// There is none: it has all its torque, or nothing.
    fn torque_limit(&self) -> f64 {
        1.0
    }

    fn copy(&self) -> Box<dyn Firmware + Send + Sync> {
        Box::new(self.clone())
    }

    fn tells_position(&self, code: u8, _answer: &[u8]) -> bool {
        code == command::POS_READ
    }

    fn serve(&mut self, code: u8, payload: &[u8], shaft: &Shaft, _now: u64) -> Option<Vec<u8>> {
        use command as c;
        let two = |values: [i16; 2]| Some(values.map(i16::to_le_bytes).concat());
        let words = match *payload {
            [a, b, c, d] => Some([i16::from_le_bytes([a, b]), i16::from_le_bytes([c, d])]),
            _ => None,
        };
        let movement = words.filter(|[goal, time]| {
            (0..=LAST).contains(goal) && (0..=MAX_MOVE).contains(&(*time as u16))
        });
        let movement = movement.map(|[goal, time]| (goal, time as u16));
        let pair = |(goal, time): (i16, u16)| two([goal, time as i16]);
        let ordered = |low: i16, high: i16| {
            words.filter(|[min, max]| low <= *min && min < max && *max <= high)
        };
        match (code, payload) {
            (c::MOVE_TIME_WRITE, _) => self.begin(movement?),
            (c::MOVE_TIME_WAIT_WRITE, _) => self.waiting = movement?,
            (c::MOVE_START, []) => self.begin(self.waiting),
            (c::MOVE_STOP, []) => {
                let here = libm::round(self.here).clamp(0.0, LAST.into()) as i16;
                self.target = (here, f64::INFINITY);
            }
            (c::ID_WRITE, [id @ 0..=253]) => self.kept.id = *id,
            (c::ANGLE_OFFSET_ADJUST, [offset]) if (-125..=125).contains(&(*offset as i8)) => {
                self.offset = *offset as i8;
            }
            (c::ANGLE_OFFSET_WRITE, []) => self.kept.offset = self.offset,
            (c::ANGLE_LIMIT_WRITE, _) => self.kept.limits = ordered(0, LAST)?,
            (c::VIN_LIMIT_WRITE, _) => self.kept.voltages = ordered(4500, 12_000)?,
            (c::TEMP_MAX_LIMIT_WRITE, [limit @ 50..=100]) => self.kept.hottest = *limit,
            (c::MODE_WRITE, _) => {
                let [mode, speed] = words?;
                self.motor = (mode & 0xFF == 1).then_some(speed.clamp(-1000, 1000));
            }
            (c::LOAD_OR_UNLOAD_WRITE, [load @ 0..=1]) => {
                self.is_loaded = *load == 1;
                if *load == 1 {
                    let here = libm::round(self.here).clamp(0.0, LAST.into()) as i16;
                    self.target = (here, f64::INFINITY);
                }
            }
            (c::MOVE_TIME_READ, []) => return pair(self.goal),
            (c::MOVE_TIME_WAIT_READ, []) => return pair(self.waiting),
            (c::ID_READ, []) => return Some(vec![self.kept.id]),
            (c::ANGLE_OFFSET_READ, []) => return Some(vec![self.offset as u8]),
            (c::ANGLE_LIMIT_READ, []) => return two(self.kept.limits),
            (c::VIN_LIMIT_READ, []) => return two(self.kept.voltages),
            (c::TEMP_MAX_LIMIT_READ, []) => return Some(vec![self.kept.hottest]),
            (c::TEMP_READ, []) => return Some(vec![shaft.temperature as u8]),
            (c::VIN_READ, []) => {
                return Some(((shaft.voltage * 1000.0) as i16).to_le_bytes().to_vec());
            }
            // "Signed short": the shaft can be turned beyond the travel by hand.
            (c::POS_READ, []) => {
                return Some((libm::round(self.here) as i16).to_le_bytes().to_vec());
            }
            (c::MODE_READ, []) => {
                return two([
                    i16::from(self.motor.is_some()),
                    self.motor.unwrap_or_default(),
                ]);
            }
            (c::LOAD_OR_UNLOAD_READ, []) => return Some(vec![u8::from(self.is_loaded)]),
            _ => {}
        }
        None
    }
}
