//! The text of events, written and read.

use super::{Event, Events, Timed};
use std::fmt;
use std::str::FromStr;
use tip_runtime::command::Port;
use tip_runtime::plant::Noise;

/// A text that is not an event, or not a list of them, with the form that was expected.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EventError(pub(super) String);

impl fmt::Display for EventError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for EventError {}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Event::Key(byte) => write!(f, "key {}", KeyText(*byte)),
            Event::Halt => f.write_str("halt"),
            Event::Sensor(port, volts) => write!(f, "{port}={volts}"),
            Event::Set(name, value) => write!(f, "set {name}={value}"),
            Event::Touch(true) => f.write_str("touch on"),
            Event::Touch(false) => f.write_str("touch off"),
            Event::Push([x, y, z], cycles) => write!(f, "push {x} {y} {z} for {cycles}"),
            Event::Noise(Noise { angle, volts, seed }) => {
                write!(f, "noise {angle} {volts} seed {seed}")
            }
            Event::ReadFails => f.write_str("read fails"),
            Event::WriteFails => f.write_str("write fails"),
        }
    }
}

impl From<Event> for String {
    fn from(event: Event) -> Self {
        event.to_string()
    }
}

impl TryFrom<String> for Event {
    type Error = EventError;

    fn try_from(text: String) -> Result<Self, EventError> {
        text.parse()
    }
}

impl FromStr for Event {
    type Err = EventError;

    fn from_str(text: &str) -> Result<Self, EventError> {
        let text = text.trim();
        let wrong = || {
            EventError(format!(
                "'{text}' is not an event; expected one such as key F, halt, VR1=8, touch on, read fails"
            ))
        };
        match text {
            "halt" => return Ok(Event::Halt),
            "touch on" => return Ok(Event::Touch(true)),
            "touch off" => return Ok(Event::Touch(false)),
            "read fails" => return Ok(Event::ReadFails),
            "write fails" => return Ok(Event::WriteFails),
            _ => {}
        }
        if let Some(key) = text.strip_prefix("key ") {
            return key_byte(key.trim()).map(Event::Key).ok_or_else(wrong);
        }
        if let Some(push) = text.strip_prefix("push ") {
            return pushed(push).ok_or_else(wrong);
        }
        if let Some(noise) = text.strip_prefix("noise ") {
            return noisy(noise).ok_or_else(wrong);
        }
        let (name, value) = text.split_once('=').ok_or_else(wrong)?;
        if let Some(name) = name.strip_prefix("set ") {
            let value = value.trim().parse().map_err(|_| wrong())?;
            return Ok(Event::Set(name.trim().to_ascii_uppercase(), value));
        }
        let port = port(name.trim()).ok_or_else(wrong)?;
        let volts = value.trim().parse().map_err(|_| wrong())?;
        Ok(Event::Sensor(port, volts))
    }
}

/// Reads `X Y Z for C`: N, and cycles.
fn pushed(text: &str) -> Option<Event> {
    let (force, cycles) = text.split_once(" for ")?;
    let force = numbers(force)?;
    Some(Event::Push(force, cycles.trim().parse().ok()?))
}

/// Reads `A V seed N`: deg, V, and a whole number.
fn noisy(text: &str) -> Option<Event> {
    let (noise, seed) = text.split_once(" seed ")?;
    let [angle, volts] = numbers(noise)?;
    let seed = seed.trim().parse().ok()?;
    let noise = Noise { angle, volts, seed };
    (angle >= 0.0 && volts >= 0.0).then_some(Event::Noise(noise))
}

/// Reads `N` finite numbers with blanks between them.
fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let numbers: Option<Vec<f64>> = (text.split_whitespace())
        .map(|word| word.parse().ok().filter(|number: &f64| number.is_finite()))
        .collect();
    numbers?.try_into().ok()
}

impl fmt::Display for Timed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.cycle, self.event)
    }
}

impl FromStr for Timed {
    type Err = EventError;

    fn from_str(text: &str) -> Result<Self, EventError> {
        let parts = text.split_once(':');
        let cycle = parts.and_then(|(cycle, _)| cycle.trim().parse().ok());
        let (Some(cycle), Some((_, event))) = (cycle, parts) else {
            let text = text.trim();
            return Err(EventError(format!(
                "'{text}' is not CYCLE:EVENT, such as 10:key F or 300:VR1=8"
            )));
        };
        Ok(Timed {
            cycle,
            event: event.parse()?,
        })
    }
}

impl fmt::Display for Events {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (n, event) in self.all().iter().enumerate() {
            let comma = if n > 0 { ", " } else { "" };
            write!(f, "{comma}{event}")?;
        }
        Ok(())
    }
}

impl FromStr for Events {
    type Err = EventError;

    fn from_str(text: &str) -> Result<Self, EventError> {
        match text.trim().is_empty() {
            true => Ok(Events::NONE),
            false => text.split(',').map(str::parse).collect(),
        }
    }
}

/// One character, or the code of another one.
pub(super) struct KeyText(pub(super) u8);

impl fmt::Display for KeyText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            byte if byte.is_ascii_alphanumeric() => write!(f, "{}", char::from(byte)),
            byte => write!(f, "0x{byte:02X}"),
        }
    }
}

/// Reads one ASCII character, or its code as `0x1B`.
pub(super) fn key_byte(key: &str) -> Option<u8> {
    match (key.as_bytes(), key.strip_prefix("0x")) {
        (&[byte], _) if byte.is_ascii() => Some(byte),
        (_, Some(digits)) if digits.len() <= 2 && !digits.starts_with('+') => {
            u8::from_str_radix(digits, 16).ok()
        }
        _ => None,
    }
}

/// Returns the inputs by name, as AD_IN has them, in either case.
pub(super) fn port(name: &str) -> Option<Port> {
    name.to_ascii_uppercase().parse().ok()
}
