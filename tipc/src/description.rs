//! Robots from descriptions: the text of a TOML file becomes a [`Description`], which gives models, facts for checking
//! and shapes.
//!
//! A description says where the legs are and what joints they have; everything else has a default.
//! All keys are in the table [`KEYS`]; `docs/robots.md` shows them with an example.
//!
//! ```
//! let text = br#"
//! name = "tripod"
//! joint = [
//!     { axis = "z", link = [50, 0, 0], limits = [-60, 60] },
//!     { axis = "-y", link = [100, 0, 0], limits = [-60, 75] },
//!     { axis = "y", link = [120, 0, 0], limits = [5, 150] },
//! ]
//! leg = [
//!     { base = [80, 0, 0] },
//!     { base = [-40, 70, 0], turn = 120 },
//!     { base = [-40, -70, 0], turn = 240 },
//! ]
//! "#;
//! let description = tipc::description::parse("tripod.toml", text).unwrap();
//! let options = tipc::Options { robot: description.robot(), ..tipc::Options::default() };
//! let program = b"3.1\nlift a foot\nREL_PTP F3 0 0 20\nWAIT_INPOS F3\nEND\n";
//! assert!(tipc::load("lift.prg", program, &options).program.is_some());
//! assert!(description.model::<3, 3>().is_some());
//! ```

mod drives;
mod keys;
mod legs;
mod model;
mod project;
mod rust;
mod scene;
mod section;
mod settings;

#[cfg(test)]
mod tests;

pub use drives::{Bus, Drive, Servo};
pub use keys::{KEYS, Key, Part};
pub use legs::{Form, Shape, Shapes};
pub use model::WithModel;
pub use project::{Project, Settings, parse_project};
pub use rust::{const_name, skeleton};
pub use scene::parse_scene;

use crate::diagnostic::Diagnostic;
use crate::load::Loaded;
use crate::message::Describing;
use crate::published::Published;
use crate::robot::Limits;
use crate::source::{Encoding, Source, Span};
use section::{Found, Section, fault};
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};
use tip_runtime::model::{Body, Forces, Inverse, Joint, Point, Range, Slider, Standards, TOUCHING};
use toml::de::DeTable;

/// A robot as its description defines it: 1 to 9 legs with 1 to 9 joints each, as many on every leg.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    source_name: String,
    source_hash: u64,
    name: &'static str,
    legs: Vec<Leg>,
    inverse: Inverse,
    body: Option<Body>,
    standards: Standards,
    periods: Range,
    contact: f64,
    lamps: u8,
    forces: Option<Forces>,
    slider: Option<Slider>,
    may_touch: [Option<[tip_runtime::model::Part; 2]>; TOUCHING],
    /// Shapes of the body.
    shapes: Vec<Shape>,
    bus: Option<Bus>,
    limits: Limits,
}

impl Description {
    /// Returns the bus of the real robot, if the description has one.
    pub const fn bus(&self) -> Option<&Bus> {
        self.bus.as_ref()
    }
}

/// A leg: the data of [`tip_runtime::model::Leg`] for any number of joints, and shapes.
#[derive(Clone, Debug, PartialEq)]
struct Leg {
    base: Point,
    joints: Vec<Joint>,
    initial: Vec<f64>,
    /// Shapes of the link after each joint.
    shapes: Vec<Vec<Shape>>,
}

/// Reads a description. `name` is the file's name in diagnostics.
///
/// The robot's name stays in memory until the process ends, since programs and models refer to it; equal names share
/// it.
///
/// # Errors
/// All faults of the file, each at its location, as a [`Loaded`] without a program.
pub fn parse(name: &str, bytes: &[u8]) -> Result<Description, Box<Loaded>> {
    parse_for_servos(name, bytes, &[])
}

/// Reads a description whose drives are servos of these models.
///
/// # Errors
/// Those of [`parse`], and what a servo cannot do.
pub fn parse_for_servos(
    name: &str,
    bytes: &[u8],
    servos: &[Servo],
) -> Result<Description, Box<Loaded>> {
    open(name, bytes, Part::Robot, |source, robot, found| {
        describe(source, robot, servos, found)
    })
}

impl Published {
    /// Reads the description.
    ///
    /// # Errors
    /// None: a test reads each of them.
    pub fn read(&self) -> Result<Description, Box<Loaded>> {
        parse(&self.file(), self.text.as_bytes())
    }
}

/// Reads a file whose top is `part`.
fn open<T>(
    name: &str,
    bytes: &[u8],
    part: Part,
    build: impl FnOnce(&Source, Section<'_>, &mut Found) -> Option<T>,
) -> Result<T, Box<Loaded>> {
    let (source, undecodable) = Source::decode(name, bytes, Encoding::Utf8);
    let outcome = match undecodable {
        Some(fault) => Err(vec![fault.into()]),
        None => read(&source, part, build),
    };
    outcome.map_err(|mut diagnostics| {
        diagnostics.sort_by_key(|diagnostic| diagnostic.span);
        Box::new(Loaded::refused(source, diagnostics))
    })
}

fn read<T>(
    source: &Source,
    part: Part,
    build: impl FnOnce(&Source, Section<'_>, &mut Found) -> Option<T>,
) -> Result<T, Found> {
    let (table, errors) = DeTable::parse_recoverable(source.text());
    if !errors.is_empty() {
        let not_toml = |error| not_toml(part, error);
        let mut found: Found = errors.iter().map(not_toml).collect();
        // Only the first fault of a line is reported: others follow from it.
        found.sort_by_key(|fault| fault.span);
        found.dedup_by_key(|fault| source.line_column(fault.span.start).0);
        return Err(found);
    }
    let mut found = Found::new();
    let top = Section::new(part, Span::default(), table.get_ref(), &mut found);
    match build(source, top, &mut found) {
        Some(built) if found.is_empty() => Ok(built),
        _ => Err(found),
    }
}

/// Reports the location where the text is not TOML.
fn not_toml(part: Part, error: &toml::de::Error) -> Diagnostic {
    let location = error.span().unwrap_or_default();
    let reason = Describing::NotToml {
        error: error.message().to_owned().into(),
    };
    let help = Describing::DescriptionsAreToml;
    fault(part, Span::new(location.start, location.end), reason, help)
}

/// Returns a name that stays in memory until the process ends; equal names share it.
fn lasting(name: &str) -> &'static str {
    static NAMES: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());
    let mut names = NAMES.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = names.get(name) {
        return known;
    }
    let name: &'static str = Box::leak(name.to_owned().into_boxed_str());
    names.insert(name);
    name
}

/// Reads everything before anything is given up, so that every fault is found.
fn describe(
    source: &Source,
    robot: Section<'_>,
    servos: &[Servo],
    found: &mut Found,
) -> Option<Description> {
    let name = settings::name(robot, found);
    let legs = legs::read(robot, found);
    let periods = settings::periods(robot, found);
    let standards = settings::standards(robot, periods, found);
    let contact = settings::contact(robot, found);
    let lamps = settings::lamps(robot, found);
    let (body, shapes) = settings::body(robot, found).unzip();
    let slider = settings::slider(robot, found);
    let chosen = settings::inverse(robot, found);
    let legs = legs?;
    let forces = settings::forces(robot, &legs, found);
    let inverse = model::inverse(robot, chosen, &legs, found)?;
    let may_touch = settings::may_touch(robot, &legs, body.is_some(), found);
    let bus = drives::read(robot, &legs, servos, found);
    // The name of a faulty description must not stay in memory.
    let name = name.filter(|_| found.is_empty())?;
    let limits = |leg: &Leg| leg.joints.iter().map(|joint| joint.limits).collect();
    Some(Description {
        source_name: source.name().to_owned(),
        source_hash: source.hash(),
        name: lasting(name),
        limits: Limits::copied(legs.iter().map(limits).collect()),
        legs,
        inverse,
        body,
        standards,
        periods,
        contact,
        lamps,
        forces,
        slider,
        may_touch,
        shapes: shapes.unwrap_or_default(),
        bus,
    })
}
