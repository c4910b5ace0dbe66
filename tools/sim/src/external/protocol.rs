//! The protocol of external plants: JSON lines to and from the process, and the errors of answers.

use crate::message::Simulating;
use crate::model::RobotDescription;
use crate::sim_hardware::Commands;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::time::Duration;
use tip_runtime::command::Port;
use tip_runtime::hardware::JointCommand;
use tip_runtime::plant::Pose;
use tip_runtime::printable::Printable;
use tipc::message::{Lang, Text};

/// The version of the protocol.
const VERSION: u32 = 2;
/// Maximum length of an answer, bytes, without the end of the line.
pub(super) const MAX_ANSWER_BYTES: u64 = 65_536;

/// A line to the process.
#[derive(Serialize)]
#[serde(tag = "type", rename_all = "lowercase")]
pub(super) enum Request<'a> {
    /// The first line; the process answers with its version and the first readings.
    Hello {
        version: u32,
        robot: &'a str,
        legs: usize,
        /// Number of joints of each leg.
        joints: usize,
        /// ms.
        period: f64,
        /// The initial posture, leg by leg, deg.
        initial: &'a [f64],
        /// Fields that every answer must have.
        needs: Vec<&'static str>,
    },
    /// A control cycle; the process answers with its number and the readings after it.
    Cycle {
        n: u64,
        /// ms.
        period: f64,
        modes: Vec<&'static str>,
        /// deg or N·m.
        targets: Vec<f64>,
        /// deg/s.
        rates: Vec<f64>,
        /// mm.
        #[serde(skip_serializing_if = "Option::is_none")]
        slider: Option<[f64; 3]>,
    },
    /// An emergency; not answered.
    Stop { n: u64 },
    /// The last line; not answered.
    Bye,
}

impl Request<'_> {
    /// Returns the line with its end.
    pub(super) fn line(&self) -> String {
        // Serialisation fails only for maps with keys that are no strings, and there are none.
        serde_json::to_string(self).unwrap_or_default() + "\n"
    }
}

/// The readings of a robot, as the process sends them. A field that is not measured is absent.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Answer {
    /// Protocol version, in the first answer.
    version: Option<u32>,
    /// Number of the cycle, in all others.
    n: Option<u64>,
    /// deg.
    #[serde(default)]
    pub(super) angles: Vec<f64>,
    /// N·m.
    #[serde(default)]
    pub(super) torques: Vec<f64>,
    /// N.
    #[serde(default)]
    pub(super) loads: Vec<f64>,
    /// mm.
    pub(super) slider: Option<[f64; 3]>,
    /// mm and deg: x, y, z, roll, pitch, yaw.
    pose: Option<[f64; 6]>,
}

impl Answer {
    /// Returns the pose of the body, if the process gives it.
    pub(super) fn pose(&self) -> Option<Pose> {
        self.pose.map(|[x, y, z, roll, pitch, yaw]| Pose {
            position: [x, y, z],
            roll,
            pitch,
            yaw,
        })
    }
}

/// Reads the answer to a request. A quantity that the first answer measures is required in all others.
pub(super) fn read(
    line: &str,
    to: Head,
    layout: &Layout,
    before: &Answer,
) -> Result<Answer, PlantError> {
    if let (Head::Hello, Some(found)) = (to, version(line))
        && found != VERSION
    {
        return Err(PlantError::Version { found });
    }
    let wrong = |path: String, reason: String| PlantError::Wrong {
        to,
        line: line.to_owned(),
        path,
        reason,
    };
    let mut json = serde_json::Deserializer::from_str(line);
    let read = serde_path_to_error::deserialize(&mut json);
    let answer: Answer = read.map_err(|error| {
        let path = error.path().to_string();
        // JSON has no such numbers, but some libraries write these words. Answers hold no other text.
        let is_not_finite = ["NaN", "Infinity"].iter().any(|word| line.contains(word));
        if error.inner().is_syntax() && is_not_finite {
            PlantError::NotFinite { to, path }
        } else {
            wrong(path, error.inner().to_string())
        }
    })?;
    json.end()
        .map_err(|error| wrong(".".to_owned(), error.to_string()))?;

    let missing = |key: &str| wrong(".".to_owned(), format!("missing field `{key}`"));
    let unknown = |key: &str| wrong(key.to_owned(), format!("unknown field `{key}`"));
    match to {
        Head::Hello if answer.version.is_none() => return Err(missing("version")),
        Head::Hello if answer.n.is_some() => return Err(unknown("n")),
        Head::Hello => {}
        Head::Cycle(_) if answer.version.is_some() => return Err(unknown("version")),
        Head::Cycle(number) => match answer.n {
            None => return Err(missing("n")),
            Some(found) if found != number => return Err(PlantError::Cycle { to, found }),
            Some(_) => {}
        },
    }
    let joints = layout.legs * layout.joints;
    let has_torques = layout.has_torques || !before.torques.is_empty();
    for (key, values, wanted, is_needed) in [
        ("angles", &answer.angles, joints, true),
        ("torques", &answer.torques, joints, has_torques),
        (
            "loads",
            &answer.loads,
            layout.soles,
            !before.loads.is_empty(),
        ),
    ] {
        match values.len() {
            0 if is_needed => return Err(missing(key)),
            0 => {}
            found if found != wanted => {
                let reason = format!("invalid length {found}, expected {wanted} numbers");
                return Err(wrong(key.to_owned(), reason));
            }
            _ => {}
        }
    }
    if layout.has_slider != answer.slider.is_some() {
        return Err(if layout.has_slider {
            missing("slider")
        } else {
            unknown("slider")
        });
    }
    if before.pose.is_some() && answer.pose.is_none() {
        return Err(missing("pose"));
    }
    Ok(answer)
}

/// Returns the protocol version that the answer to the first line names, whatever else it holds.
fn version(line: &str) -> Option<u32> {
    #[derive(Deserialize)]
    struct Versioned {
        version: u32,
    }
    if line.split_ascii_whitespace().next() == Some("ready") {
        // Version 1 had words in place of JSON.
        return Some(1);
    }
    let versioned = serde_json::from_str::<Versioned>(line).ok()?;
    Some(versioned.version)
}

/// The facts of a robot that an external plant needs, and the sizes of its lists.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    robot: String,
    legs: usize,
    /// Number of joints of each leg.
    pub(super) joints: usize,
    /// ms.
    period: f64,
    /// The initial posture, leg by leg, deg.
    initial: Vec<f64>,
    /// Number of the robot's torque units in 1 N·m.
    pub(super) per_newton_metre: f64,
    /// True if it senses and gives torques.
    has_torques: bool,
    has_slider: bool,
    /// Number of soles: one on each leg of a robot that walks.
    soles: usize,
}

impl Layout {
    pub(super) fn of(robot: &str, description: &RobotDescription) -> Self {
        let legs = description.legs.len();
        let unit = description
            .forces
            .map(|forces| forces.unit.per_newton_metre());
        Layout {
            robot: robot.to_owned(),
            legs,
            joints: description.joints,
            period: description.standards.period,
            initial: description
                .legs
                .iter()
                .flat_map(|leg| &leg.initial)
                .copied()
                .collect(),
            per_newton_metre: unit.unwrap_or(1.0),
            has_torques: unit.is_some(),
            has_slider: description.slider.is_some(),
            soles: if description.body.is_some() { legs } else { 0 },
        }
    }

    /// Returns the inputs whose readings come from events.
    pub(super) fn inputs(&self) -> impl Iterator<Item = Port> {
        let soles = u8::try_from(self.soles).unwrap_or(u8::MAX);
        let knobs = Port::Knob(1).named();
        knobs
            .chain((1..=soles).map(Port::Paw))
            .chain([Port::Antenna])
    }

    /// Returns the first line.
    pub(super) fn hello(&self) -> Request<'_> {
        let mut needs = vec!["angles"];
        needs.extend(self.has_torques.then_some("torques"));
        needs.extend(self.has_slider.then_some("slider"));
        Request::Hello {
            version: VERSION,
            robot: &self.robot,
            legs: self.legs,
            joints: self.joints,
            period: self.period,
            initial: &self.initial,
            needs,
        }
    }

    /// Returns the line of a control cycle.
    pub(super) fn cycle(&self, number: u64, commands: &Commands<'_>) -> Request<'_> {
        let (mut modes, mut targets, mut rates) = (Vec::new(), Vec::new(), Vec::new());
        for command in commands.joints {
            let (mode, target, rate) = match *command {
                JointCommand::Angle { angle, rate } => ("angle", angle, rate),
                JointCommand::Torque(torque) => ("torque", torque / self.per_newton_metre, 0.0),
            };
            modes.push(mode);
            targets.push(target);
            rates.push(rate);
        }
        Request::Cycle {
            n: number,
            period: commands.period,
            modes,
            targets,
            rates,
            slider: self.has_slider.then_some(commands.slider),
        }
    }
}

/// The request that an answer belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Head {
    /// The first one.
    Hello,
    /// A control cycle.
    Cycle(u64),
}

impl fmt::Display for Head {
    /// Writes `hello`, or `cycle` with its number.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Head::Hello => f.write_str("hello"),
            Head::Cycle(number) => write!(f, "cycle {number}"),
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
    /// An answer breaks the protocol.
    Wrong {
        to: Head,
        line: String,
        /// Path to the wrong field, such as `angles[4]`; `.` for the whole answer.
        path: String,
        reason: String,
    },
    /// An infinity, or no number.
    NotFinite { to: Head, path: String },
    /// Another version of the protocol.
    Version { found: u32 },
    /// The answer to another cycle.
    Cycle { to: Head, found: u64 },
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
            PlantError::TooLong { .. } | PlantError::NotText { .. } | PlantError::Wrong { .. } => {
                "plant: wrong answer"
            }
        }
    }

    /// Returns the error and its place, as a message.
    pub fn message(&self) -> Simulating {
        let head = |to: &Head| Text::from(to.to_string());
        let text = |said: &String| Printable::line(said).to_string();
        let version = || Text::from(VERSION.to_string());
        match self {
            PlantError::NoAnswer { to, within } => {
                let seconds = within.as_secs_f64().to_string().into();
                match to {
                    Head::Hello => Simulating::NeverReady {
                        seconds,
                        version: version(),
                    },
                    Head::Cycle(_) => Simulating::NoAnswer {
                        to: head(to),
                        seconds,
                    },
                }
            }
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
                bytes: MAX_ANSWER_BYTES.to_string().into(),
            },
            PlantError::NotText { to } => Simulating::NotText { to: head(to) },
            PlantError::Wrong {
                to,
                line,
                path,
                reason,
            } if path == "." => Simulating::WrongAnswer {
                to: head(to),
                line: text(line),
                reason: text(reason),
            },
            PlantError::Wrong {
                to, path, reason, ..
            } => Simulating::WrongField {
                to: head(to),
                path: text(path),
                reason: text(reason),
            },
            PlantError::NotFinite { to, path } => Simulating::NotFinite {
                to: head(to),
                path: text(path),
            },
            PlantError::Version { found } => Simulating::OtherVersion {
                found: *found,
                version: version(),
            },
            PlantError::Cycle { to, found } => Simulating::OtherCycle {
                to: head(to),
                found: found.to_string().into(),
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
