//! The interface of a servo family: all that the drives and the commands ask of servos, and what a model of a family is. One file
//! per family implements it; [`model`](crate::model) lists families and models.
//!
//! Methods that address one servo repeat a request without an answer, unless they say that they ask once. A value that a family
//! cannot measure is `None`.

use crate::bus::{BusError, Timing, Wire};
use core::fmt;

/// A servo model.
#[derive(Debug, PartialEq)]
pub struct Model {
    /// Name in a robot file.
    pub name: &'static str,
    /// Number that the servo reports; `None` if the maker states none.
    pub number: Option<u16>,
    /// Its family.
    pub family: &'static dyn Family,
    /// Counts of a full turn.
    pub turn: f64,
    /// The largest position, counts; the smallest is 0.
    pub largest: i32,
    /// Position at a motor angle of 0, counts.
    pub middle: f64,
    /// Speed of one unit of the speed register, deg/s; `None` if it has none.
    pub speed_unit: Option<f64>,
    /// Speed without load at the rated voltage, deg/s.
    pub speed: f64,
    /// Load register at the stall torque; `None` if it has none.
    pub full_load: Option<f64>,
    /// Value of the torque limit at full torque; `None` if it has none.
    pub full_torque: Option<u16>,
}

impl Model {
    /// Returns the motor angle at a position, deg.
    pub fn angle(&self, counts: f64) -> f64 {
        (counts - self.middle) * 360.0 / self.turn
    }

    /// Returns the position at a motor angle, deg: counts, not rounded.
    pub fn counts(&self, angle: f64) -> f64 {
        self.middle + angle * self.turn / 360.0
    }

    /// Returns the value of its torque limit at a part of the full torque; `None` if it has none.
    pub fn torque_limit(&self, part: f64) -> Option<i32> {
        let full = f64::from(self.full_torque?);
        Some((part * full) as i32)
    }

    /// Returns the value of its speed limit at a speed of the motor, deg/s.
    pub fn speed_limit(&self, speed: f64) -> i32 {
        let units = libm::ceil(speed / self.speed_unit.unwrap_or(1.0));
        // 0 would be as fast as it can.
        (units as i32).clamp(1, 1023.max(self.largest))
    }
}

/// A servo to be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Query {
    /// Identity of the servo.
    pub id: u8,
    /// Number of readings of this servo before this one.
    pub turn: u32,
    /// True if its last answer is missing, and may still come.
    pub is_late: bool,
}

/// The contents of an answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Error byte.
    pub error: u8,
    /// Position, counts.
    pub position: i32,
    /// Load, in units of its register.
    pub load: Option<i32>,
    /// Supply voltage, V.
    pub voltage: Option<f64>,
    /// Temperature, °C.
    pub temperature: Option<f64>,
    /// True if the torque is on.
    pub is_on: Option<bool>,
    /// Torque limit, in units of its register.
    pub torque_limit: Option<i32>,
    /// Speed limit, in units of its register.
    pub speed_limit: Option<i32>,
    /// False if a register has a value that nothing here leaves in it: the answer is damaged.
    pub is_plausible: bool,
}

/// A command to a servo.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setpoint {
    /// Identity of the servo.
    pub id: u8,
    /// Its model.
    pub model: &'static Model,
    /// Position, counts.
    pub position: i32,
    /// Speed limit of the motor, deg/s.
    pub speed: f64,
    /// Torque limit, as a part of the full torque.
    pub torque: f64,
    /// Time until the next command, ms.
    pub period: f64,
    /// Time without commands after which the servo stops, ms; `None` for never.
    pub timeout: Option<f64>,
}

/// A register that gives a goal another meaning than the description does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mismatch {
    /// Address of the register, or number of the command that reads it.
    pub register: u16,
    /// Its name in the maker's manual.
    pub name: &'static str,
    /// Its value.
    pub value: i32,
    /// The value to write into it.
    pub wanted: i32,
}

/// A family of servos.
pub trait Family: fmt::Debug + Sync {
    /// Returns the name in commands, such as "sts".
    fn key(&self) -> &'static str;

    /// Returns the name in messages, such as "Feetech STS".
    fn name(&self) -> &'static str;

    /// Returns the largest identity.
    fn last_id(&self) -> u8 {
        252
    }

    /// Returns true if one request reads all servos; else they are read one by one.
    fn reads_together(&self) -> bool {
        false
    }

    /// Returns the shortest and the longest time-out of the servo's watchdog, ms; `None` if it follows its last command forever.
    fn timeouts(&self) -> Option<(f64, f64)> {
        None
    }

    /// Returns true if the torque can be limited.
    fn limits_torque(&self) -> bool {
        true
    }

    /// Returns the time that reading one servo and commanding all of them take on the wire, µs, without adapter and driver.
    fn times(&self, timing: Timing, servos: usize) -> (u64, u64);

    /// Asks a servo once for the number of its model; `None` if it has none to report.
    ///
    /// # Errors
    /// The port is gone, or the servo does not answer.
    fn identify(&self, wire: &mut dyn Wire, id: u8) -> Result<Option<u16>, BusError>;

    /// Switches the torque of a servo off and gives it another identity, which it keeps without power.
    ///
    /// # Errors
    /// The port is gone, the servo does not answer, or the family has no such request.
    fn set_id(&self, wire: &mut dyn Wire, id: u8, to: u8) -> Result<(), BusError>;

    /// Returns the delay of a servo's answers, µs.
    ///
    /// # Errors
    /// The port is gone, or the servo does not answer.
    fn return_delay(&self, wire: &mut dyn Wire, id: u8) -> Result<u32, BusError>;

    /// Reads every register that changes the meaning of a goal, and returns the first whose value does not fit goals from `min` to
    /// `max`, counts.
    ///
    /// # Errors
    /// The port is gone, or the servo does not answer.
    fn check(
        &self,
        wire: &mut dyn Wire,
        servo: (u8, &'static Model),
        goals: (i32, i32),
    ) -> Result<Option<Mismatch>, BusError>;

    /// Reads servos, each once, and gives the answers with their places in `servos` to `take`. Where servos are read one by one, the
    /// last ones are left out when `limit`, a time of the port's clock, comes. With `fast`, servos answer in one frame if they can.
    /// Returns the number of servos that were asked.
    ///
    /// # Errors
    /// The port is gone.
    fn read(
        &self,
        wire: &mut dyn Wire,
        servos: &[Query],
        limit: u64,
        fast: bool,
        take: &mut dyn FnMut(usize, Reading),
    ) -> Result<usize, BusError>;

    /// Sets the limits, the watchdog and the position of a servo, and then switches its torque on.
    ///
    /// # Errors
    /// The port is gone, or the servo does not answer.
    fn hold(&self, wire: &mut dyn Wire, servo: &Setpoint) -> Result<(), BusError>;

    /// Sends positions. Nothing confirms them.
    ///
    /// # Errors
    /// The port is gone.
    fn write_goals(&self, wire: &mut dyn Wire, servos: &[Setpoint]) -> Result<(), BusError>;

    /// Sends torque limits to servos that hold their positions. Nothing confirms them.
    ///
    /// # Errors
    /// The port is gone, or the torque cannot be limited.
    fn write_torque_limits(&self, wire: &mut dyn Wire, servos: &[Setpoint])
    -> Result<(), BusError>;

    /// Sends time-outs of watchdogs, where a command does not hold them. Nothing confirms them.
    ///
    /// # Errors
    /// The port is gone.
    fn write_timeouts(&self, wire: &mut dyn Wire, servos: &[Setpoint]) -> Result<(), BusError> {
        let _ = (wire, servos);
        Ok(())
    }

    /// Switches the torque of servos off. Nothing confirms it.
    ///
    /// # Errors
    /// The port is gone.
    fn release(&self, wire: &mut dyn Wire, ids: &[u8]) -> Result<(), BusError>;

    /// Leaves a servo to itself, with its torque off, or holding `hold` without a watchdog. Returns true if its torque is so then.
    ///
    /// # Errors
    /// The port is gone, or the servo does not answer.
    fn leave(&self, wire: &mut dyn Wire, id: u8, hold: Option<&Setpoint>)
    -> Result<bool, BusError>;

    /// Returns the bits of an error byte that are alarms of the servo; the others are remarks on a request.
    fn alarms(&self, error: u8) -> u8 {
        error
    }

    /// Asks a servo once for its alarms, where the error byte only says that there are some.
    ///
    /// # Errors
    /// The port is gone, or the servo does not answer.
    fn alarm(&self, wire: &mut dyn Wire, id: u8, error: u8) -> Result<u8, BusError> {
        let _ = (wire, id);
        Ok(self.alarms(error))
    }

    /// Returns the cause of an alarm.
    fn cause(&self, alarm: u8) -> &'static str;
}

impl PartialEq for dyn Family {
    fn eq(&self, other: &Self) -> bool {
        self.key() == other.key()
    }
}
