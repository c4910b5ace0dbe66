//! Events that reach a robot from outside, and their cycles.
//!
//! ```
//! use tip_sim::event::{Event, Events};
//!
//! let events: Events = "900:halt, 10:key F, 300:VR1=8".parse()?;
//! assert_eq!(events.to_string(), "10:key F, 300:VR1=8, 900:halt");
//! assert_eq!(events.all()[2], Event::Halt.at(900));
//! assert!("10:jump".parse::<Events>().is_err());
//! # Ok::<(), tip_sim::event::EventError>(())
//! ```

use crate::message::Debugging;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;
use tip_runtime::command::Port;
use tip_runtime::machine::Mismatch;
use tip_runtime::plant::Noise;
use tip_runtime::program::VariableError;
use tipc::message::Lang;

/// Something that happens to a robot or to its program from outside.
///
/// Text form of events, in `--events`, files, tests, and as a string in JSON:
///
/// | event | text |
/// |---|---|
/// | a key is pressed: one ASCII character, or its code | `key F`, `key 0x2C` |
/// | a halt is requested | `halt` |
/// | an input reads this voltage from now on; it is called as in AD_IN, and may read nonsense | `VR1=8`, `J23=-0.5`, `ANTENNA=NaN` |
/// | the host assigns a variable of the program, which its steps read from now on | `set STRIDE=80`, `set P.X=-1.5` |
/// | every foot or finger begins to feel something, or ceases to | `touch on`, `touch off` |
/// | a force along x, y and z of the world pushes the body for some cycles: N | `push 50 0 -20 for 10` |
/// | joint angles (deg) and soles (V) are measured with normally distributed errors from now on | `noise 0.1 0.02 seed 7` |
/// | the robot cannot be read in this cycle | `read fails` |
/// | the robot cannot be written to any more | `write fails` |
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(into = "String", try_from = "String")]
#[non_exhaustive]
pub enum Event {
    /// A byte is typed. ESC requests a halt, RETURN stops the robot.
    Key(u8),
    /// A halt is requested: `HALT_REQUEST` is true from now on.
    Halt,
    /// An input reads so many volts from now on.
    Sensor(Port, f64),
    /// The host assigns a variable, as [`Program::set`](tip_runtime::program::Program::set) does.
    Set(String, f64),
    /// The contact sensors of all feet or fingers are switched on or off. Simulated joints feel real contacts; on their
    /// robots only the sensors of the soles change.
    Touch(bool),
    /// A force in the world pushes the body at its origin, N, for a number of cycles. It replaces an earlier push.
    Push([f64; 3], u32),
    /// Sensors have errors from now on.
    Noise(Noise),
    /// The robot cannot be read in this cycle.
    ReadFails,
    /// The robot cannot be written to any more.
    WriteFails,
}

/// An event, and the cycle before whose step it happens. As text: `10:key F`.
#[derive(Clone, Debug, PartialEq)]
pub struct Timed {
    /// The cycle, from 0.
    pub cycle: u64,
    /// The event.
    pub event: Event,
}

/// Events in order of their cycles; those of one cycle keep the order they were given in. As text:
/// `10:key F, 300:VR1=8, 900:halt`. `300..500:VR1=8` reads as two events: a stick springs back to 5 V, any other input to 0 V.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Events(Vec<Timed>);

impl Events {
    /// No events.
    pub const NONE: Self = Events(Vec::new());

    /// Puts events in order.
    pub fn new(mut events: Vec<Timed>) -> Self {
        events.sort_by_key(|event| event.cycle);
        Events(events)
    }

    /// Returns all events, in order.
    pub fn all(&self) -> &[Timed] {
        &self.0
    }

    /// Returns true if there is no event.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns the inputs that they change.
    pub fn ports(&self) -> impl Iterator<Item = Port> {
        self.0.iter().filter_map(|timed| match timed.event {
            Event::Sensor(port, _) => Some(port),
            _ => None,
        })
    }

    /// Keeps the first events, up to a number.
    pub(crate) fn truncate(&mut self, count: usize) {
        self.0.truncate(count);
    }

    /// Returns the number of events before a cycle.
    pub(crate) fn before(&self, cycle: u64) -> usize {
        self.0.partition_point(|event| event.cycle < cycle)
    }

    /// Adds an event after those of its cycle, and not before place `from`.
    pub(crate) fn insert(&mut self, from: usize, event: Timed) {
        let later = self.0.get(from..).unwrap_or_default();
        let place = from + later.partition_point(|other| other.cycle <= event.cycle);
        self.0.insert(place.min(self.0.len()), event);
    }
}

impl From<Vec<Timed>> for Events {
    fn from(events: Vec<Timed>) -> Self {
        Events::new(events)
    }
}

impl FromIterator<Timed> for Events {
    fn from_iter<I: IntoIterator<Item = Timed>>(events: I) -> Self {
        Events::new(events.into_iter().collect())
    }
}

impl IntoIterator for Events {
    type Item = Timed;
    type IntoIter = std::vec::IntoIter<Timed>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl Event {
    /// Returns the event, to happen before the step of a cycle.
    pub fn at(self, cycle: u64) -> Timed {
        Timed { cycle, event: self }
    }
}

/// A text that is not an event, or not a list of them, with the form that was expected.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EventError(String);

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

/// Reads `X Y Z for C`: a force, N, and a number of cycles.
fn pushed(text: &str) -> Option<Event> {
    let (force, cycles) = text.split_once(" for ")?;
    let force = numbers(force)?;
    Some(Event::Push(force, cycles.trim().parse().ok()?))
}

/// Reads `A V seed N`: standard deviations, deg and V, and a whole number.
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
                "'{text}' is not CYCLE:EVENT, such as 10:key F, 300:VR1=8 or 300..500:VR1=8"
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
        if text.trim().is_empty() {
            return Ok(Events::NONE);
        }
        let mut events = Vec::new();
        for item in text.split(',') {
            match while_of(item) {
                Some((from, until, port, volts)) => {
                    let until = Some(Moment::Cycle(until));
                    let from = Moment::Cycle(from);
                    let sensor = SensorAt {
                        port,
                        volts,
                        from,
                        until,
                    };
                    events.extend(sensor.events(1.0));
                }
                None => events.push(item.parse()?),
            }
        }
        Ok(Events::new(events))
    }
}

/// Reads `FROM..UNTIL:NAME=VALUE`: the reading of an input between two cycles.
fn while_of(text: &str) -> Option<(u64, u64, Port, f64)> {
    let (times, event) = text.split_once(':')?;
    let (from, until) = times.split_once("..")?;
    let (from, until) = (from.trim().parse().ok()?, until.trim().parse().ok()?);
    match event.parse() {
        Ok(Event::Sensor(port, volts)) if from < until => Some((from, until, port, volts)),
        _ => None,
    }
}

/// A key, shown as its character, or as its code if it has none.
struct KeyText(u8);

impl fmt::Display for KeyText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            byte if byte.is_ascii_alphanumeric() => write!(f, "{}", char::from(byte)),
            byte => write!(f, "0x{byte:02X}"),
        }
    }
}

/// Reads one ASCII character, or its code as `0x1B`.
fn key_byte(key: &str) -> Option<u8> {
    match (key.as_bytes(), key.strip_prefix("0x")) {
        (&[byte], _) if byte.is_ascii() => Some(byte),
        (_, Some(digits)) if digits.len() <= 2 && !digits.starts_with('+') => {
            u8::from_str_radix(digits, 16).ok()
        }
        _ => None,
    }
}

/// Returns the inputs by name, as AD_IN has them, in either case.
fn port(name: &str) -> Option<Port> {
    name.to_ascii_uppercase().parse().ok()
}

/// The events of a run, and its maximum length.
///
/// Its text is that of the options of `tip run`, in one line: `--keys 3:a --sensor VR1=8@300 --halt 500 --cycles 900`.
/// Events without a short form follow `--events`, without blanks around its commas.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inputs {
    /// The events.
    pub events: Events,
    /// Maximum number of cycles.
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
                "--sensor" => {
                    let sensor = sensor(value, |_| true)?;
                    if let (Moment::Seconds(_), _) = (sensor.from, sensor.until) {
                        let text = "the seconds of a --sensor need a robot: write cycles here";
                        return Err(EventError(text.to_owned()));
                    }
                    events.extend(sensor.events(1.0));
                }
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

/// Returns a word, or the text between single quotes, and the rest after it.
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

/// The value of `--keys`: `CYCLE:CHAR,CYCLE:CHAR…`.
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

/// A time in a run, as an option writes it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Moment {
    /// `300`: before the step of a cycle.
    Cycle(u64),
    /// `2s`: seconds, by the standard sampling time of the robot.
    Seconds(f64),
}

impl Moment {
    /// Returns the cycle, for a sampling time, ms.
    fn cycle(self, period: f64) -> u64 {
        match self {
            Moment::Cycle(cycle) => cycle,
            Moment::Seconds(seconds) => (1000.0 * seconds / period).round() as u64,
        }
    }
}

impl FromStr for Moment {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        match text.strip_suffix('s') {
            Some(seconds) => match seconds.parse::<f64>() {
                Ok(seconds) if seconds.is_finite() && seconds >= 0.0 => {
                    Ok(Moment::Seconds(seconds))
                }
                _ => Err(()),
            },
            None => text.parse().map(Moment::Cycle).map_err(|_| ()),
        }
    }
}

/// Reading of a stick at rest, the middle of its range: V.
pub const STICK_AT_REST: f64 = 5.0;

/// `--sensor`: `NAME=VALUE@TIME`, or `NAME=VALUE@TIME..TIME` for a while; the value is a finite number, and a time is a cycle or
/// seconds, as in `2s`.
///
/// After the second time a stick (VR1 to VR3) springs back to 5 V, and any other input to 0 V.
#[derive(Clone, Debug, PartialEq)]
pub struct SensorAt {
    port: Port,
    volts: f64,
    from: Moment,
    until: Option<Moment>,
}

impl SensorAt {
    /// Returns the events, for the robot's standard sampling time, ms.
    pub fn events(&self, period: f64) -> impl Iterator<Item = Timed> {
        let begin = Event::Sensor(self.port, self.volts).at(self.from.cycle(period));
        let back = match self.port {
            Port::Knob(_) => STICK_AT_REST,
            _ => 0.0,
        };
        let end = self
            .until
            .map(|until| Event::Sensor(self.port, back).at(until.cycle(period)));
        std::iter::once(begin).chain(end)
    }

    /// Returns the input, if it is a stick.
    pub fn stick(&self) -> Option<Port> {
        let is_stick = self.until.is_some() && matches!(self.port, Port::Knob(_));
        is_stick.then_some(self.port)
    }
}

impl FromStr for SensorAt {
    type Err = EventError;

    fn from_str(text: &str) -> Result<Self, EventError> {
        sensor(text, f64::is_finite)
    }
}

/// Reads `NAME=VALUE@TIME`, if the input can have the value.
fn sensor(text: &str, can_read: fn(f64) -> bool) -> Result<SensorAt, EventError> {
    let wrong = |what: &str| {
        EventError(format!(
            "{what}; expected NAME=VALUE@CYCLE, such as VR1=8@300, or a while, such as VR1=8@2s..5s"
        ))
    };
    let (name, rest) = text.split_once('=').ok_or_else(|| wrong("no '='"))?;
    let (volts, times) = rest.split_once('@').ok_or_else(|| wrong("no '@'"))?;
    let name = name.trim().to_ascii_uppercase();
    let port = port(&name).ok_or_else(|| wrong(&format!("'{name}' is not an input")))?;
    let number = volts.trim().parse().ok().filter(|volts| can_read(*volts));
    let volts = number.ok_or_else(|| wrong(&format!("'{volts}' is not a number of volts")))?;
    let moment = |text: &str| {
        let text = text.trim();
        let read = text.parse::<Moment>();
        read.map_err(|()| wrong(&format!("'{text}' is not a cycle, and not seconds")))
    };
    let (from, until) = match times.split_once("..") {
        Some((from, until)) => (moment(from)?, Some(moment(until)?)),
        None => (moment(times)?, None),
    };
    match (from, until) {
        (Moment::Cycle(from), Some(Moment::Cycle(until))) if until <= from => {
            return Err(wrong(&format!("'{times}' ends before it begins")));
        }
        (Moment::Seconds(from), Some(Moment::Seconds(until))) if until <= from => {
            return Err(wrong(&format!("'{times}' ends before it begins")));
        }
        (Moment::Cycle(_), Some(Moment::Seconds(_)))
        | (Moment::Seconds(_), Some(Moment::Cycle(_))) => {
            return Err(wrong(&format!("'{times}' mixes cycles and seconds")));
        }
        _ => {}
    }
    Ok(SensorAt {
        port,
        volts,
        from,
        until,
    })
}

/// The reason why an event cannot happen to a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refused {
    /// The program is for another robot.
    Mismatch(Mismatch),
    /// The robot has no such input.
    NoInput(Port),
    /// The program has no such variable, or it cannot have the value.
    Variable(String, VariableError),
    /// This event cannot happen to the robot: it has no mass.
    Massless(String),
    /// This event cannot happen to the robot: it is bolted down.
    BoltedDown(String),
    /// The text is not an event.
    Text(EventError),
}

impl Refused {
    /// Returns the message in a language. Messages of the runtime are English.
    pub fn text(&self, lang: Lang) -> String {
        let message = match self {
            Refused::Mismatch(mismatch) => return mismatch.to_string(),
            Refused::Text(error) => return error.to_string(),
            Refused::NoInput(port) => Debugging::NoInput {
                port: port.to_string().into(),
            },
            Refused::Variable(name, error) => return refused_variable(name, *error, lang),
            Refused::Massless(event) => Debugging::Massless {
                event: event.clone().into(),
            },
            Refused::BoltedDown(event) => Debugging::BoltedDown {
                event: event.clone().into(),
            },
        };
        message.in_lang(lang).to_string()
    }
}

/// Returns the message on an error of a variable.
pub(crate) fn refused_variable(variable: &str, error: VariableError, lang: Lang) -> String {
    let name = variable.to_owned().into();
    let message = match error {
        VariableError::Unknown => Debugging::NoSuchVariable { name },
        VariableError::Constant => Debugging::IsConstant { name },
        VariableError::NotFinite => Debugging::NotFinite { name },
        other => return format!("{variable}: {other}"),
    };
    message.in_lang(lang).to_string()
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(Lang::English))
    }
}

impl std::error::Error for Refused {}

impl From<Mismatch> for Refused {
    fn from(mismatch: Mismatch) -> Self {
        Refused::Mismatch(mismatch)
    }
}
