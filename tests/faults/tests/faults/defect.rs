//! Kinds of defects.

use crate::place::Place;

/// Reading of a broken sensor from then on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Reading {
    NotANumber,
    Infinite(f64),
    /// A number that nothing can measure; the largest one of all overflows in every sum.
    Absurd(f64),
    /// One degree beyond what the potentiometer can read, above (1) or below (-1). Angles only.
    JustBeyond(f64),
    /// Last reading.
    Stuck,
}

impl Reading {
    pub(crate) const ALL: [Reading; 10] = [
        Reading::NotANumber,
        Reading::Infinite(1.0),
        Reading::Infinite(-1.0),
        Reading::Absurd(1e300),
        Reading::Absurd(-1e300),
        Reading::Absurd(f64::MAX),
        Reading::Absurd(-f64::MAX),
        Reading::JustBeyond(1.0),
        Reading::JustBeyond(-1.0),
        Reading::Stuck,
    ];
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Defect {
    Sensor(Place, Reading),
    /// The hardware fails to read, after half a reading of nonsense.
    ReadError,
    WriteError,
    /// One cycle's command never arrives, and no time passes.
    LostCommand,
    /// The robot goes on for two sampling times before it is asked again, from then on.
    LateCycles,
    /// Sampling times are between half and one and a half of what they should be, from then on.
    Jitter,
    /// Keys arrive faster than they can be taken, from then on.
    KeyFlood,
    /// RETURN after a thousand other keys.
    ReturnAfterKeys,
    /// TITAN.LOG takes no more rows.
    LogFull,
    /// ESC, or a host's request.
    Halt,
    ReturnKey,
    /// A host's emergency stop.
    HostStop,
}

impl Defect {
    /// All but those of sensors.
    pub(crate) const OTHERS: [Defect; 11] = [
        Defect::ReadError,
        Defect::WriteError,
        Defect::LostCommand,
        Defect::LateCycles,
        Defect::Jitter,
        Defect::KeyFlood,
        Defect::ReturnAfterKeys,
        Defect::LogFull,
        Defect::Halt,
        Defect::ReturnKey,
        Defect::HostStop,
    ];

    /// Place and fault, as the table has them.
    pub(crate) const fn name(self) -> (&'static str, &'static str) {
        match self {
            Defect::Sensor(place, reading) => (place.name(), reading.name()),
            Defect::ReadError => ("hardware", "fails to read"),
            Defect::WriteError => ("hardware", "fails to write"),
            Defect::LostCommand => ("hardware", "a command is lost"),
            Defect::LateCycles => ("time", "each cycle takes twice its time"),
            Defect::Jitter => ("time", "cycles take 50 % to 150 % of their time"),
            Defect::KeyFlood => ("keyboard", "1000 keys in every cycle"),
            Defect::ReturnAfterKeys => ("keyboard", "RETURN after 1000 keys"),
            Defect::LogFull => ("TITAN.LOG", "buffer is full"),
            Defect::Halt => ("keyboard or host", "halt request"),
            Defect::ReturnKey => ("keyboard", "RETURN"),
            Defect::HostStop => ("host", "emergency stop"),
        }
    }
}

impl Reading {
    const fn name(self) -> &'static str {
        match self {
            Reading::NotANumber => "reads NaN",
            Reading::Infinite(_) => "reads ±infinity",
            Reading::Absurd(-1e300..=1e300) => "reads ±1e300",
            Reading::Absurd(_) => "reads ±1.8e308",
            Reading::JustBeyond(_) => "reads 1 deg beyond the outer limit",
            Reading::Stuck => "stuck",
        }
    }
}
