//! The specification of a sweep: a JSON document, the text forms of its axes, and the random numbers of a case. These depend on
//! seed, case and axis alone, so that any split of a sweep gives the same cases.

use crate::error::{SweepError, Sweeping, Texts};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;
use tip_runtime::plant::Simulation;
use tip_runtime::random::Random;
use tip_sim::{Robot, import};
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

impl Spec {
    /// Returns a hash of everything that determines the results.
    pub(crate) fn hash(&self) -> u64 {
        // The document has string keys and no values that JSON lacks.
        hash_bytes(&serde_json::to_vec(self).unwrap_or_default(), 0)
    }
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
    /// The text of a URDF or MJCF file, which is imported as `tip robot import` does without options.
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
        let described = |text: String| match Robot::from_description(&text) {
            Ok(robot) => Ok((robot, Some(text))),
            Err(error) => Err(SweepError::found(error.loaded())),
        };
        match self {
            RobotSpec::Description(text) => described(text.clone()),
            RobotSpec::Urdf(text) => match import::import("robot.urdf", text) {
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
        match self {
            Values::List(list) if list.is_empty() => Err(Sweeping::EmptyList),
            Values::List(list) => {
                usable(list, 0.0)?;
                Ok(Some(list.clone()))
            }
            Values::Range { from, to, step } => {
                usable(&[*from, *to, *step], to - from)?;
                if *step == 0.0 {
                    return Err(Sweeping::NoStep);
                }
                if (to - from) * step < 0.0 {
                    return Err(Sweeping::EmptyRange);
                }
                // A last value that only rounding keeps beyond the end belongs to the range.
                let ratio = (to - from) / step;
                let steps = libm::floor(ratio + 1e-9);
                if steps >= LIST_LIMIT {
                    return Err(Sweeping::LongRange);
                }
                let values = (0..=steps as u32).map(|index| from + f64::from(index) * step);
                let mut values: Vec<f64> = values.collect();
                if let Some(last) = values.last_mut().filter(|_| (ratio - steps).abs() < 1e-9) {
                    *last = *to;
                }
                Ok(Some(values))
            }
            Values::Uniform { low, high } => {
                usable(&[*low, *high], high - low)?;
                match low > high {
                    true => Err(Sweeping::UpsideDown),
                    false => Ok(None),
                }
            }
            Values::Normal { mean, deviation } => {
                // No sample is farther from the mean than 10 deviations.
                usable(&[*mean, *deviation], mean.abs() + 10.0 * deviation.abs())?;
                match *deviation < 0.0 {
                    true => Err(Sweeping::NegativeDeviation),
                    false => Ok(None),
                }
            }
        }
    }
}

/// Returns an error if a given number, or what is computed from them, is not finite.
fn usable(given: &[f64], computed: f64) -> Result<(), Sweeping> {
    if !given.iter().all(|number| number.is_finite()) {
        return Err(Sweeping::NotFinite);
    }
    match computed.is_finite() {
        true => Ok(()),
        false => Err(Sweeping::TooLarge),
    }
}

/// The error of a text that is not an axis, or not a condition.
#[derive(Clone, Debug, PartialEq)]
pub struct ArgumentError(pub(crate) Sweeping);

impl ArgumentError {
    /// Returns the message, which has a text in each language.
    pub fn message(&self) -> Message {
        self.0.clone().into()
    }
}

impl fmt::Display for ArgumentError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl std::error::Error for ArgumentError {}

impl FromStr for Axis {
    type Err = ArgumentError;

    /// Reads `NAME=100..300/20`, `NAME=200,300,400`, `NAME=uniform(0.4,1)` or `NAME=normal(20,2)`.
    fn from_str(text: &str) -> Result<Self, ArgumentError> {
        let whole = || text.to_owned();
        let (name, values) = text
            .split_once('=')
            .filter(|(name, values)| !name.trim().is_empty() && !values.trim().is_empty())
            .ok_or_else(|| ArgumentError(Sweeping::NoValues { text: whole() }))?;
        let number = |part: &str| {
            let word = part.trim().to_owned();
            let text = whole();
            let number = word.parse::<f64>();
            number.map_err(|_| ArgumentError(Sweeping::NotANumber { word, text }))
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

/// Identity of a random number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Draw {
    pub(crate) seed: u64,
    /// Combination of listed values, from 0.
    pub(crate) combination: u64,
    /// Repeat of that combination, from 0.
    pub(crate) repeat: u64,
    /// Number of repeats.
    pub(crate) repeats: u64,
    /// Axis, from 0.
    pub(crate) axis: u64,
}

impl Draw {
    /// Returns the sample of a random axis; `None` for a listed one.
    pub(crate) fn sample(self, values: &Values, sampling: Sampling) -> Option<f64> {
        match *values {
            Values::List(_) | Values::Range { .. } => None,
            Values::Uniform { low, high } => Some(low + (high - low) * self.unit(sampling)),
            Values::Normal { mean, deviation } => {
                Some(mean + deviation * standard_normal(self.unit(sampling)))
            }
        }
    }

    /// Returns a number in 0…1, both ends excluded.
    fn unit(self, sampling: Sampling) -> f64 {
        let own = hash([self.seed, self.combination, self.repeat, self.axis]);
        let unit = fraction(own);
        match sampling {
            Sampling::Random => unit,
            Sampling::LatinHypercube => {
                let key = hash([self.seed, self.combination, u64::MAX, self.axis]);
                let interval = permuted(self.repeat, self.repeats, key);
                (interval as f64 + unit) / self.repeats as f64
            }
        }
    }
}

/// Returns a seed for the sensor noise of a case.
pub(crate) fn noise_seed(seed: u64, case: u64) -> u64 {
    hash([seed, case, 0, u64::MAX])
}

/// Hashes words one after the other.
pub(crate) fn hash(words: [u64; 4]) -> u64 {
    let mixed = |state: u64, word| Random::new(state ^ word).next_u64();
    words.into_iter().fold(0, mixed)
}

/// Hashes bytes and their number.
pub(crate) fn hash_bytes(bytes: &[u8], seed: u64) -> u64 {
    let start = hash([seed, bytes.len() as u64, 0, 0]);
    bytes.chunks(8).fold(start, |state, bytes| {
        let mut word = [0; 8];
        word[..bytes.len()].copy_from_slice(bytes);
        hash([state, u64::from_le_bytes(word), 0, 0])
    })
}

/// Maps a word to 0…1, both ends excluded: 52 bits and a half.
fn fraction(word: u64) -> f64 {
    ((word >> 12) as f64 + 0.5) / (1_u64 << 52) as f64
}

/// Returns the place of `index` in a permutation of 0…count: a Feistel network over the next power of four, walked until the
/// result is below `count` (Black and Rogaway 2002).
fn permuted(index: u64, count: u64, key: u64) -> u64 {
    let bits = 64 - (count - 1).leading_zeros();
    let half = bits.div_ceil(2).max(1);
    let mask = (1_u64 << half) - 1;
    let mut place = index;
    loop {
        let (mut left, mut right) = (place >> half, place & mask);
        for round in 0..4 {
            (left, right) = (right, left ^ hash([key, round, right, 0]) & mask);
        }
        place = left << half | right;
        if place < count {
            return place;
        }
    }
}

/// Returns the standard normal quantile of a probability (Acklam's rational approximation, relative error below 1.2e-9).
fn standard_normal(p: f64) -> f64 {
    const A: [f64; 6] = [
        -3.969_683_028_665_376e1,
        2.209_460_984_245_205e2,
        -2.759_285_104_469_687e2,
        1.383_577_518_672_69e2,
        -3.066_479_806_614_716e1,
        2.506_628_277_459_239,
    ];
    const B: [f64; 6] = [
        -5.447_609_879_822_406e1,
        1.615_858_368_580_409e2,
        -1.556_989_798_598_866e2,
        6.680_131_188_771_972e1,
        -1.328_068_155_288_572e1,
        1.0,
    ];
    const C: [f64; 6] = [
        -7.784_894_002_430_293e-3,
        -3.223_964_580_411_365e-1,
        -2.400_758_277_161_838,
        -2.549_732_539_343_734,
        4.374_664_141_464_968,
        2.938_163_982_698_783,
    ];
    const D: [f64; 5] = [
        7.784_695_709_041_462e-3,
        3.224_671_290_700_398e-1,
        2.445_134_137_142_996,
        3.754_408_661_907_416,
        1.0,
    ];
    const TAIL: f64 = 0.024_25;
    let polynomial =
        |coefficients: &[f64], x: f64| coefficients.iter().fold(0.0, |sum, c| sum * x + c);
    let tail = |p: f64| {
        let q = libm::sqrt(-2.0 * libm::log(p));
        polynomial(&C, q) / polynomial(&D, q)
    };
    if p < TAIL {
        tail(p)
    } else if p > 1.0 - TAIL {
        -tail(1.0 - p)
    } else {
        let q = p - 0.5;
        polynomial(&A, q * q) * q / polynomial(&B, q * q)
    }
}
