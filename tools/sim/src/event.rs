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

mod options;
mod text;

pub use options::{Inputs, Keys, SensorAt};
pub use text::EventError;

use serde::{Deserialize, Serialize};
use tip_runtime::command::Port;
use tip_runtime::plant::Noise;

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
    /// Every foot or finger begins to feel something, or ceases to. Simulated joints feel what is there; of these robots
    /// only the soles' sensors change.
    Touch(bool),
    /// A force in the world pushes the body at its origin for so many cycles: N. It takes the place of the push before.
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
/// `10:key F, 300:VR1=8, 900:halt`.
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

    /// Keeps so many of them, the first ones.
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
    /// This event before the step of a cycle.
    pub fn at(self, cycle: u64) -> Timed {
        Timed { cycle, event: self }
    }
}
