//! The protocol of external plants: the lines that they get, what they answer, and what may be wrong with it.

use crate::message::Simulating;
use crate::model::Anatomy;
use crate::sim_hardware::Commands;
use std::fmt;
use std::fmt::Write as _;
use std::time::Duration;
use tip_runtime::command::Port;
use tip_runtime::command::Target;
use tip_runtime::hardware::JointCommand;
use tip_runtime::plant::Pose;
use tip_runtime::printable::Printable;
use tipc::message::{Lang, Text};

/// The readings that a process gives of its robot. Lists that it does not measure are empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Measured {
    /// deg.
    pub(super) angles: Vec<f64>,
    /// N·m.
    pub(super) torques: Vec<f64>,
    /// N.
    pub(super) loads: Vec<f64>,
    /// mm.
    pub(super) slider: [f64; 3],
    /// True if it gives the pose of the body.
    has_pose: bool,
}

/// An answer that is right.
pub(super) struct Answer {
    pub(super) measured: Measured,
    pub(super) pose: Option<Pose>,
}

/// Reads the answer to a line. What the first one measures all others have to measure.
pub(super) fn read(
    line: &str,
    to: Head,
    layout: &Layout,
    before: &Measured,
) -> Result<Answer, PlantError> {
    let begins = match to {
        Head::Hello => READY,
        Head::Cycle(_) => STATE,
    };
    let mut words = line.split_ascii_whitespace();
    if words.next() != Some(begins) {
        let line = line.to_owned();
        return Err(PlantError::Garbage { to, line, begins });
    }
    let mut fields = Fields::default();
    for word in words {
        fields.add(word, to)?;
    }
    match to {
        Head::Hello => version(fields.of(PROTOCOL, to)?)?,
        Head::Cycle(number) => cycle(fields.of(NUMBER, to)?, number, to)?,
    }
    let numbers = Numbers {
        fields: &fields,
        to,
        layout,
    };
    let joints = layout.legs * layout.joints;
    let is_first = to == Head::Hello;
    let torques = layout.has_torques || !is_first && !before.torques.is_empty();
    let loads = !is_first && !before.loads.is_empty();
    let pose = !is_first && before.has_pose;
    let slider = numbers.of(
        SLIDER,
        if layout.has_slider { 3 } else { 0 },
        layout.has_slider,
    )?;
    let pose = numbers.of(POSE, 6, pose)?;
    let pose = <[f64; 6]>::try_from(pose)
        .ok()
        .map(|[x, y, z, roll, pitch, yaw]| Pose {
            position: [x, y, z],
            roll,
            pitch,
            yaw,
        });
    let measured = Measured {
        angles: numbers.of(ANGLES, joints, true)?,
        torques: numbers.of(TORQUES, joints, torques)?,
        loads: numbers.of(LOADS, layout.soles, loads)?,
        slider: slider.try_into().unwrap_or_default(),
        has_pose: pose.is_some(),
    };
    Ok(Answer { measured, pose })
}

fn version(found: &str) -> Result<(), PlantError> {
    match found.parse::<u32>() {
        Ok(VERSION) => Ok(()),
        _ => Err(PlantError::Version {
            found: found.to_owned(),
        }),
    }
}

fn cycle(found: &str, number: u64, to: Head) -> Result<(), PlantError> {
    match found.parse::<u64>() {
        Ok(found) if number == found => Ok(()),
        _ => Err(PlantError::Cycle {
            to,
            found: found.to_owned(),
        }),
    }
}

/// The words of an answer by their keys.
#[derive(Default)]
struct Fields<'a>(Vec<(&'static str, &'a str)>);

impl<'a> Fields<'a> {
    fn add(&mut self, word: &'a str, to: Head) -> Result<(), PlantError> {
        let unknown = || PlantError::Word {
            to,
            word: word.to_owned(),
        };
        let (key, values) = word.split_once('=').ok_or_else(unknown)?;
        let own = match to {
            Head::Hello => PROTOCOL,
            Head::Cycle(_) => NUMBER,
        };
        let mut keys = [own, ANGLES, TORQUES, LOADS, SLIDER, POSE].into_iter();
        let key = keys.find(|known| *known == key).ok_or_else(unknown)?;
        if self.get(key).is_some() {
            return Err(PlantError::Twice { to, key });
        }
        self.0.push((key, values));
        Ok(())
    }

    fn get(&self, key: &str) -> Option<&'a str> {
        let found = self.0.iter().find(|(known, _)| *known == key);
        found.map(|(_, values)| *values)
    }

    fn of(&self, key: &'static str, to: Head) -> Result<&'a str, PlantError> {
        self.get(key).ok_or(PlantError::Missing { to, key })
    }
}

/// The numbers of an answer.
struct Numbers<'a> {
    fields: &'a Fields<'a>,
    to: Head,
    layout: &'a Layout,
}

impl Numbers<'_> {
    /// Reads the finite numbers of a key; none if the key is not there and not needed.
    fn of(
        &self,
        key: &'static str,
        wanted: usize,
        is_needed: bool,
    ) -> Result<Vec<f64>, PlantError> {
        let to = self.to;
        let Some(values) = self.fields.get(key) else {
            return if is_needed {
                Err(PlantError::Missing { to, key })
            } else {
                Ok(Vec::new())
            };
        };
        let words: Vec<&str> = values.split(',').filter(|_| !values.is_empty()).collect();
        if words.len() != wanted {
            let found = words.len();
            return Err(PlantError::Count {
                to,
                key,
                wanted,
                found,
            });
        }
        let numbers = words.iter().enumerate().map(|(index, word)| {
            let place = || place(self.layout, key, index);
            let word = (*word).to_owned();
            match word.parse::<f64>() {
                Ok(number) if number.is_finite() => Ok(number),
                Ok(_) => Err(PlantError::NotFinite {
                    to,
                    key,
                    place: place(),
                }),
                Err(_) => Err(PlantError::NotNumber {
                    to,
                    key,
                    place: place(),
                    word,
                }),
            }
        });
        numbers.collect()
    }
}

/// Returns the subject of a number of a list, such as a joint.
fn place(layout: &Layout, key: &str, index: usize) -> String {
    let at = |names: &[&str]| names.get(index).copied().unwrap_or_default().to_owned();
    let joints = layout.joints.max(1);
    let number = |number: usize| u8::try_from(number + 1).unwrap_or(u8::MAX);
    match key {
        SLIDER => at(&["x", "y", "z"]),
        POSE => at(&["x", "y", "z", "roll", "pitch", "yaw"]),
        LOADS => Target::Foot(number(index)).to_string(),
        _ => Target::Joint(number(index / joints), number(index % joints)).to_string(),
    }
}

/// The version of the protocol.
pub(super) const VERSION: u32 = 1;
/// The longest answer: bytes, without the end of the line.
pub(super) const LONGEST: u64 = 65_536;

pub(super) const HELLO: &str = "hello";
pub(super) const CYCLE: &str = "cycle";
pub(super) const READY: &str = "ready";
pub(super) const STATE: &str = "state";
/// The last line.
pub(super) const BYE: &str = "bye\n";

pub(super) const NUMBER: &str = "n";
pub(super) const PROTOCOL: &str = "version";
pub(super) const ANGLES: &str = "angles";
pub(super) const TORQUES: &str = "torques";
pub(super) const LOADS: &str = "loads";
pub(super) const SLIDER: &str = "slider";
pub(super) const POSE: &str = "pose";

/// The facts of a robot that an external plant has to know, and how many numbers belong to it.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    robot: String,
    pub(super) legs: usize,
    /// Number of joints of each leg.
    pub(super) joints: usize,
    /// ms.
    period: f64,
    /// The initial posture, leg by leg, deg.
    initial: Vec<f64>,
    /// Number of the robot's torque units in 1 N·m.
    pub(super) per_newton_metre: f64,
    /// True if it senses and gives torques.
    pub(super) has_torques: bool,
    pub(super) has_slider: bool,
    /// One on each leg if it stands on them.
    pub(super) soles: usize,
}

impl Layout {
    pub(super) fn of(robot: &str, anatomy: &Anatomy) -> Self {
        let legs = anatomy.legs.len();
        let unit = anatomy.forces.map(|forces| forces.unit.per_newton_metre());
        Layout {
            // Words end at blanks.
            robot: robot.replace(char::is_whitespace, "_"),
            legs,
            joints: anatomy.joints,
            period: anatomy.standards.period,
            initial: anatomy
                .legs
                .iter()
                .flat_map(|leg| &leg.initial)
                .copied()
                .collect(),
            per_newton_metre: unit.unwrap_or(1.0),
            has_torques: unit.is_some(),
            has_slider: anatomy.slider.is_some(),
            soles: if anatomy.body.is_some() { legs } else { 0 },
        }
    }

    /// Returns the inputs that read what events set.
    pub(super) fn inputs(&self) -> impl Iterator<Item = Port> {
        let soles = u8::try_from(self.soles).unwrap_or(u8::MAX);
        let knobs = Port::Knob(1).named();
        knobs
            .chain((1..=soles).map(Port::Paw))
            .chain([Port::Antenna])
    }

    /// Returns the first line.
    pub(super) fn hello(&self) -> String {
        let Layout {
            robot,
            legs,
            joints,
            period,
            ..
        } = self;
        let initial = list(self.initial.iter().copied());
        let needs = match (self.has_torques, self.has_slider) {
            (false, false) => ANGLES,
            (true, false) => "angles,torques",
            (false, true) => "angles,slider",
            (true, true) => "angles,torques,slider",
        };
        format!(
            "{HELLO} {PROTOCOL}={VERSION} robot={robot} legs={legs} joints={joints} \
             period={period:?} initial={initial} needs={needs}\n"
        )
    }

    /// Returns the line of a control cycle.
    pub(super) fn cycle(&self, number: u64, commands: &Commands<'_>) -> String {
        let unit = self.per_newton_metre;
        let (joints, period) = (commands.joints, commands.period);
        let modes: Vec<&str> = joints.iter().map(|command| mode(*command)).collect();
        let targets = list(joints.iter().map(|command| match command {
            JointCommand::Angle { angle, .. } => *angle,
            JointCommand::Torque(torque) => torque / unit,
        }));
        let rates = list(joints.iter().map(|command| match command {
            JointCommand::Angle { rate, .. } => *rate,
            JointCommand::Torque(_) => 0.0,
        }));
        let mut line = format!(
            "{CYCLE} {NUMBER}={number} period={period:?} modes={} targets={targets} rates={rates}",
            modes.join(",")
        );
        if self.has_slider {
            line = format!("{line} {SLIDER}={}", list(commands.slider.into_iter()));
        }
        line + "\n"
    }
}

/// Returns the line of an emergency.
pub(super) fn stop(number: u64) -> String {
    format!("stop {NUMBER}={number}\n")
}

fn mode(command: JointCommand) -> &'static str {
    match command {
        JointCommand::Angle { .. } => "angle",
        JointCommand::Torque(_) => "torque",
    }
}

/// Writes numbers with commas between, each the shortest that gives the same bits again.
fn list(numbers: impl Iterator<Item = f64>) -> String {
    let mut text = String::new();
    for (index, number) in numbers.enumerate() {
        let comma = if index == 0 { "" } else { "," };
        // Writing to a String cannot fail.
        let _ = write!(text, "{comma}{number:?}");
    }
    text
}

/// The line that an answer is to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Head {
    /// The first one.
    Hello,
    /// A control cycle.
    Cycle(u64),
}

impl fmt::Display for Head {
    /// Writes it as the line begins.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Head::Hello => f.write_str(HELLO),
            Head::Cycle(number) => write!(f, "{CYCLE} {NUMBER}={number}"),
        }
    }
}

/// The way in which a process ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// The process exited with this status.
    Exit(i32),
    /// A signal killed it.
    Killed,
    /// It goes on, but has closed its standard output.
    Closed,
}

/// Error of an external plant.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
#[expect(missing_docs, reason = "the fields are what the messages name")]
pub enum PlantError {
    /// An answer takes too long.
    NoAnswer { to: Head, within: Duration },
    /// The process ended before it answered.
    Ended { to: Head, ended: Ended },
    /// An answer has no end.
    TooLong { to: Head },
    /// An answer is not UTF-8.
    NotText { to: Head },
    /// A line that does not begin as an answer.
    Garbage {
        to: Head,
        line: String,
        begins: &'static str,
    },
    /// A word that is not `KEY=VALUES` with a key of this answer.
    Word { to: Head, word: String },
    /// A key that occurs twice.
    Twice { to: Head, key: &'static str },
    /// A key that is needed.
    Missing { to: Head, key: &'static str },
    /// Another version of the protocol.
    Version { found: String },
    /// The answer to another cycle.
    Cycle { to: Head, found: String },
    /// Too few numbers, or too many.
    Count {
        to: Head,
        key: &'static str,
        wanted: usize,
        found: usize,
    },
    /// Not a number.
    NotNumber {
        to: Head,
        key: &'static str,
        place: String,
        word: String,
    },
    /// Infinite, or not a number by name.
    NotFinite {
        to: Head,
        key: &'static str,
        place: String,
    },
    /// The run is a copy of one that has a process.
    Copy,
}

impl PlantError {
    /// Returns the word of the emergency stop.
    pub fn word(&self) -> &'static str {
        match self {
            PlantError::NoAnswer { .. } => "plant: no answer",
            PlantError::Ended { .. } => "plant: ended",
            PlantError::Copy => "plant: a copy has no process",
            PlantError::Version { .. } => "plant: other version",
            PlantError::Cycle { .. } => "plant: answer to another cycle",
            PlantError::NotFinite { .. } => "plant: answer is not finite",
            PlantError::TooLong { .. }
            | PlantError::NotText { .. }
            | PlantError::Garbage { .. }
            | PlantError::Word { .. }
            | PlantError::Twice { .. }
            | PlantError::Missing { .. }
            | PlantError::Count { .. }
            | PlantError::NotNumber { .. } => "plant: wrong answer",
        }
    }

    /// Returns the error and its place, as a message.
    pub fn message(&self) -> Simulating {
        let head = |to: &Head| Text::from(to.to_string());
        let text = |said: &String| Printable::line(said).to_string();
        match self {
            PlantError::NoAnswer { to, within } => Simulating::NoAnswer {
                to: head(to),
                seconds: within.as_secs_f64().to_string().into(),
            },
            PlantError::Ended { to, ended } => {
                let to = head(to);
                match ended {
                    Ended::Exit(status) => Simulating::Exited {
                        to,
                        status: status.to_string().into(),
                    },
                    Ended::Killed => Simulating::Killed { to },
                    Ended::Closed => Simulating::Closed { to },
                }
            }
            PlantError::TooLong { to } => Simulating::TooLong {
                to: head(to),
                bytes: LONGEST.to_string().into(),
            },
            PlantError::NotText { to } => Simulating::NotText { to: head(to) },
            PlantError::Garbage { to, line, begins } => Simulating::NotAnswer {
                to: head(to),
                line: text(line),
                begins,
            },
            PlantError::Word { to, word } => Simulating::UnknownWord {
                to: head(to),
                word: text(word),
            },
            PlantError::Twice { to, key } => Simulating::Twice { to: head(to), key },
            PlantError::Missing { to, key } => Simulating::Missing { to: head(to), key },
            PlantError::Version { found } => Simulating::OtherVersion {
                found: text(found),
                version: VERSION.to_string().into(),
            },
            PlantError::Cycle { to, found } => Simulating::OtherCycle {
                to: head(to),
                found: text(found),
            },
            PlantError::Count {
                to,
                key,
                wanted,
                found,
            } => Simulating::OtherCount {
                to: head(to),
                key,
                wanted: wanted.to_string().into(),
                found: found.to_string().into(),
            },
            PlantError::NotNumber {
                to,
                key,
                place,
                word,
            } => Simulating::NotNumber {
                to: head(to),
                key,
                place: place.clone().into(),
                word: text(word),
            },
            PlantError::NotFinite { to, key, place } => Simulating::NotFinite {
                to: head(to),
                key,
                place: place.clone().into(),
            },
            PlantError::Copy => Simulating::Copy,
        }
    }
}

impl fmt::Display for PlantError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().in_lang(Lang::English).fmt(f)
    }
}

impl std::error::Error for PlantError {}
