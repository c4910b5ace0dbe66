//! Events as the command line spells them: `--keys`, `--sensor` and `--halt` are short forms, `--events` is the full one.

use super::text::{KeyText, key_byte, port};
use super::{Event, EventError, Events, Timed};
use std::fmt;
use std::str::FromStr;

/// All that happens around a run, and how long it may take.
///
/// Its text is that of the options of `tip run`, in one line: `--keys 3:a --sensor VR1=8@300 --halt 500 --cycles 900`.
/// Events without a short form follow `--events`, without blanks around its commas.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inputs {
    /// The events.
    pub events: Events,
    /// The most cycles.
    pub cycles: Option<u64>,
}

impl fmt::Display for Inputs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (mut keys, mut sensors, mut halts, mut others) = (vec![], vec![], vec![], vec![]);
        for Timed { cycle, event } in self.events.all() {
            match event {
                Event::Key(byte) => keys.push(format!("{cycle}:{}", KeyText(*byte))),
                Event::Sensor(port, volts) => {
                    sensors.push(format!("--sensor {port}={volts}@{cycle}"));
                }
                Event::Halt => halts.push(format!("--halt {cycle}")),
                other => others.push(format!("{cycle}:{other}")),
            }
        }
        let mut options = Vec::new();
        if !keys.is_empty() {
            options.push(format!("--keys {}", keys.join(",")));
        }
        options.extend(sensors);
        options.extend(halts);
        if !others.is_empty() {
            options.push(format!("--events '{}'", others.join(",")));
        }
        options.extend(self.cycles.map(|cycles| format!("--cycles {cycles}")));
        f.write_str(&options.join(" "))
    }
}

impl FromStr for Inputs {
    type Err = EventError;

    fn from_str(text: &str) -> Result<Self, EventError> {
        let mut inputs = Inputs::default();
        let mut events = Vec::new();
        let mut rest = text.trim();
        while !rest.is_empty() {
            let (option, behind) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
            let (value, behind) = value(behind.trim_start());
            if value.is_empty() {
                return Err(EventError(format!("{option} needs a value")));
            }
            match option {
                "--keys" => events.extend(value.parse::<Keys>()?.0),
                "--sensor" => events.push(sensor(value, |_| true)?),
                "--halt" => events.push(Event::Halt.at(cycles(value)?)),
                "--events" => events.extend(value.parse::<Events>()?),
                "--cycles" => inputs.cycles = Some(cycles(value)?),
                _ => return Err(EventError(format!("'{option}' is not an option of a run"))),
            }
            rest = behind.trim_start();
        }
        inputs.events = Events::new(events);
        Ok(inputs)
    }
}

/// Returns a word, or the text between single quotes; and what follows.
fn value(text: &str) -> (&str, &str) {
    match text
        .strip_prefix('\'')
        .and_then(|text| text.split_once('\''))
    {
        Some(parts) => parts,
        None => text.split_once(char::is_whitespace).unwrap_or((text, "")),
    }
}

fn cycles(value: &str) -> Result<u64, EventError> {
    let wrong = |_| EventError(format!("'{value}' is not a number of cycles"));
    value.parse().map_err(wrong)
}

/// `--keys`: `CYCLE:CHAR,CYCLE:CHAR…`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Keys(pub Vec<Timed>);

impl FromStr for Keys {
    type Err = EventError;

    fn from_str(text: &str) -> Result<Self, EventError> {
        let keys: Result<Vec<Timed>, EventError> = text.split(',').map(key).collect();
        keys.map(Keys)
    }
}

fn key(text: &str) -> Result<Timed, EventError> {
    let wrong = || EventError(format!("'{text}' is not CYCLE:CHAR, such as 3:a or 3:0x1B"));
    let (cycle, key) = text.split_once(':').ok_or_else(wrong)?;
    let cycle = cycle.trim().parse().map_err(|_| wrong())?;
    let byte = key_byte(key).ok_or_else(wrong)?;
    Ok(Event::Key(byte).at(cycle))
}

/// `--sensor`: `NAME=VALUE@CYCLE`, where the value is a finite number.
#[derive(Clone, Debug, PartialEq)]
pub struct SensorAt(pub Timed);

impl FromStr for SensorAt {
    type Err = EventError;

    fn from_str(text: &str) -> Result<Self, EventError> {
        sensor(text, f64::is_finite).map(SensorAt)
    }
}

/// Returns an input that reads something from a cycle on, if it can read that.
fn sensor(text: &str, can_read: fn(f64) -> bool) -> Result<Timed, EventError> {
    let wrong = |what: &str| {
        EventError(format!(
            "{what}; expected NAME=VALUE@CYCLE, such as VR1=8@300"
        ))
    };
    let (name, rest) = text.split_once('=').ok_or_else(|| wrong("no '='"))?;
    let (volts, cycle) = rest.split_once('@').ok_or_else(|| wrong("no '@'"))?;
    let name = name.trim().to_ascii_uppercase();
    let port = port(&name).ok_or_else(|| wrong(&format!("'{name}' is not an input")))?;
    let number = volts.trim().parse().ok().filter(|volts| can_read(*volts));
    let volts = number.ok_or_else(|| wrong(&format!("'{volts}' is not a number of volts")))?;
    let cycle = cycle
        .trim()
        .parse()
        .map_err(|_| wrong(&format!("'{cycle}' is not a cycle")))?;
    Ok(Event::Sensor(port, volts).at(cycle))
}
