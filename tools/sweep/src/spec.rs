//! The specification of a sweep: a JSON document, and the text forms of its axes.

use crate::error::SweepError;
use crate::message::{Sweeping, Texts};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;
use tip_runtime::plant::Simulation;
use tip_sim::{Robot, urdf};
use tipc::message::Message;
use tipc::published;

/// Everything that determines the results of a sweep.
///
/// Two equal specifications give equal results, bit by bit, however their cases are split over threads and machines.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Spec {
    /// The motion program.
    pub program: Text,
    /// The robot; `titan8` if it is left out.
    #[serde(default)]
    pub robot: RobotSpec,
    /// The text of a scene file, or the name of a scene; a level floor if it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene: Option<String>,
    /// The simulation of the robot's body.
    #[serde(default)]
    pub plant: PlantSpec,
    /// The quantities that vary.
    #[serde(default)]
    pub vary: Vec<Axis>,
    /// Sampling method of random axes.
    #[serde(default)]
    pub sampling: Sampling,
    /// Number of cases for each combination of listed values.
    #[serde(default = "one")]
    pub repeat: u64,
    /// Seed of random axes and of sensor noise.
    #[serde(default)]
    pub seed: u64,
    /// Events of every run, as `tip run --events` takes them.
    #[serde(default)]
    pub events: String,
    /// Longest time of a run on the robot, s.
    #[serde(default = "minute")]
    pub until: f64,
    /// Largest number of control cycles of a run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cycles: Option<u64>,
    /// Scalars of the program whose last values become columns, named `final_A`.
    #[serde(default)]
    pub record: Vec<String>,
}

const fn one() -> u64 {
    1
}

const fn minute() -> f64 {
    60.0
}

/// A file that is part of the specification.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Text {
    /// File name in messages.
    pub name: String,
    /// Contents.
    pub text: String,
}

/// A robot.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RobotSpec {
    /// A built-in or published robot.
    Name(String),
    /// The text of a TOML description.
    Description(String),
    /// The text of a URDF file, which is imported as `tip robot import` does without options.
    Urdf(String),
}

impl Default for RobotSpec {
    fn default() -> Self {
        RobotSpec::Name("titan8".to_owned())
    }
}

impl RobotSpec {
    /// Makes the robot.
    ///
    /// # Errors
    /// There is no robot of that name, or everything that is wrong with the text.
    pub fn robot(&self) -> Result<Robot, SweepError> {
        Ok(self.load()?.0)
    }

    /// Makes the robot, and returns the text of its description if it has one.
    pub(crate) fn load(&self) -> Result<(Robot, Option<String>), SweepError> {
        let described = |text: String| match Robot::description(&text) {
            Ok(robot) => Ok((robot, Some(text))),
            Err(error) => Err(SweepError::found(error.loaded())),
        };
        match self {
            RobotSpec::Description(text) => described(text.clone()),
            RobotSpec::Urdf(text) => match urdf::import("robot.urdf", text) {
                Ok(import) => described(import.toml),
                Err(error) => {
                    let text = Texts::of(|lang| error.message().in_lang(lang).to_string());
                    Err(Sweeping::Says { text }.into())
                }
            },
            RobotSpec::Name(name) => match published::find(name) {
                Some(published) => described(published.text.to_owned()),
                None => Ok((Robot::named(name).map_err(SweepError::says)?, None)),
            },
        }
    }
}

/// A simulation of the robot's body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PlantSpec {
    /// The one that the scene names; without mass if it names none and has no blocks.
    #[default]
    Scene,
    /// The body has no mass.
    QuasiStatic,
    /// The body has mass.
    Dynamic,
}

impl PlantSpec {
    /// Returns the simulation that overrides that of the scene.
    pub(crate) fn simulation(self) -> Option<Simulation> {
        match self {
            PlantSpec::Scene => None,
            PlantSpec::QuasiStatic => Some(Simulation::QuasiStatic),
            PlantSpec::Dynamic => Some(Simulation::Dynamic),
        }
    }
}

/// A sampling method of random axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sampling {
    /// Independent samples.
    #[default]
    Random,
    /// Latin hypercube: the repeats of a combination have one sample in each of as many equally likely intervals.
    LatinHypercube,
}

/// A quantity that varies, and its values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Axis {
    /// Name of the quantity ([`Quantity`](crate::Quantity) lists the forms).
    pub name: String,
    /// Its values.
    pub values: Values,
}

/// Values of an axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
pub enum Values {
    /// Each of these, combined with every value of other listed axes.
    List(Vec<f64>),
    /// Equally spaced values, both ends included where the step meets them.
    Range {
        /// First value.
        from: f64,
        /// Last value.
        to: f64,
        /// Distance of neighbours.
        step: f64,
    },
    /// Samples that are equally likely between two bounds.
    Uniform {
        /// Lower bound.
        low: f64,
        /// Upper bound.
        high: f64,
    },
    /// Normally distributed samples.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation.
        deviation: f64,
    },
}

/// Longest list of values of an axis.
const LIST_LIMIT: f64 = 1e6;

impl Values {
    /// Returns the listed values; `None` for random ones.
    ///
    /// # Errors
    /// The list is empty or too long, or a number is not usable.
    pub(crate) fn listed(&self) -> Result<Option<Vec<f64>>, Sweeping> {
        let are_finite = |numbers: &[f64]| numbers.iter().all(|number| number.is_finite());
        match self {
            Values::List(list) if list.is_empty() => Err(Sweeping::EmptyList),
            Values::List(list) if !are_finite(list) => Err(Sweeping::NotFinite),
            Values::List(list) => Ok(Some(list.clone())),
            Values::Range { from, to, step } => {
                if !are_finite(&[*from, *to, *step, to - from]) {
                    return Err(Sweeping::NotFinite);
                }
                if *step == 0.0 {
                    return Err(Sweeping::NoStep);
                }
                if (to - from) * step < 0.0 {
                    return Err(Sweeping::EmptyRange);
                }
                // A last value that only rounding keeps beyond the end belongs to the range.
                let steps = libm::floor((to - from) / step + 1e-9);
                if steps >= LIST_LIMIT {
                    return Err(Sweeping::LongRange);
                }
                let values = (0..=steps as u32).map(|index| from + f64::from(index) * step);
                Ok(Some(values.collect()))
            }
            Values::Uniform { low, high } if !are_finite(&[*low, *high, high - low]) => {
                Err(Sweeping::NotFinite)
            }
            Values::Uniform { low, high } if low > high => Err(Sweeping::UpsideDown),
            // No sample is farther from the mean than 10 deviations.
            Values::Normal { mean, deviation }
                if !are_finite(&[mean.abs() + 10.0 * deviation.abs()]) =>
            {
                Err(Sweeping::NotFinite)
            }
            Values::Normal { deviation, .. } if *deviation < 0.0 => {
                Err(Sweeping::NegativeDeviation)
            }
            Values::Uniform { .. } | Values::Normal { .. } => Ok(None),
        }
    }
}

/// A text that is no axis.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisError(Sweeping);

impl AxisError {
    /// Returns the message, which has a text in each language.
    pub fn message(&self) -> Message {
        self.0.clone().into()
    }
}

impl fmt::Display for AxisError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl std::error::Error for AxisError {}

impl FromStr for Axis {
    type Err = AxisError;

    /// Reads `NAME=100..300/20`, `NAME=200,300,400`, `NAME=uniform(0.4,1)` or `NAME=normal(20,2)`.
    fn from_str(text: &str) -> Result<Self, AxisError> {
        let whole = || text.to_owned();
        let (name, values) = text
            .split_once('=')
            .filter(|(name, values)| !name.trim().is_empty() && !values.trim().is_empty())
            .ok_or_else(|| AxisError(Sweeping::NoValues { text: whole() }))?;
        let number = |part: &str| {
            let word = part.trim().to_owned();
            let text = whole();
            let number = word.parse::<f64>();
            number.map_err(|_| AxisError(Sweeping::NotANumber { word, text }))
        };
        let pair = |kind: &str| {
            let inner = values.trim().strip_prefix(kind)?.trim_start();
            inner.strip_prefix('(')?.strip_suffix(')')?.split_once(',')
        };
        let values = if let Some((low, high)) = pair("uniform") {
            Values::Uniform {
                low: number(low)?,
                high: number(high)?,
            }
        } else if let Some((mean, deviation)) = pair("normal") {
            Values::Normal {
                mean: number(mean)?,
                deviation: number(deviation)?,
            }
        } else if let Some((from, rest)) = values.split_once("..") {
            let (to, step) = rest.split_once('/').unwrap_or((rest, "1"));
            Values::Range {
                from: number(from)?,
                to: number(to)?,
                step: number(step)?,
            }
        } else {
            Values::List(values.split(',').map(number).collect::<Result<_, _>>()?)
        };
        Ok(Axis {
            name: name.trim().to_owned(),
            values,
        })
    }
}
