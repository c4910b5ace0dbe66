//! The robots that a program can be checked for.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::{Mutex, PoisonError};
use tip_runtime::command::{MAX, Target};
use tip_runtime::model::{Family, Leg, Model, Range, generic, hand, titan8};
use tip_runtime::program::Signature;

/// A robot: one that the compiler knows by name, or one that someone described.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Robot {
    /// TITAN VIII: four legs of three joints.
    #[default]
    Titan8,
    /// Hiroshima Hand: three fingers of three joints, and a slider.
    Hand,
    /// The generic robot when no description is given: four legs of three joints.
    Generic,
    /// Any other robot.
    Described(Facts),
}

/// Properties of a robot that a program can meet: all that checking needs of a model or a description.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facts {
    /// Shape of the robot that its programs are made for.
    pub signature: Signature,
    /// The sampling time that programs begin with: ms.
    pub period: f64,
    /// The sampling times that it accepts: ms.
    pub periods: Range,
    /// Number of lamps and relays.
    pub lamps: u8,
    /// True if it senses and gives torques.
    pub has_forces: bool,
    /// True if it has a slider (`FLOOR`).
    pub has_slider: bool,
    /// The working limits of its joints.
    pub(crate) limits: Limits,
}

/// The working limits of the joints of a robot.
#[derive(Clone, Copy)]
pub(crate) struct Limits(&'static dyn LimitsOfJoints);

/// A robot whose joints have working limits.
trait LimitsOfJoints: Sync {
    /// Returns the limits of a joint, deg; leg and joint count from 0.
    fn get(&self, leg: usize, joint: usize) -> Option<Range>;
}

impl<const L: usize, const J: usize> LimitsOfJoints for Model<L, J> {
    fn get(&self, leg: usize, joint: usize) -> Option<Range> {
        Some(self.legs.get(leg)?.joints.get(joint)?.limits)
    }
}

impl LimitsOfJoints for Vec<Vec<Range>> {
    fn get(&self, leg: usize, joint: usize) -> Option<Range> {
        self.as_slice().get(leg)?.get(joint).copied()
    }
}

impl Limits {
    /// Keeps the limits of a robot, leg by leg. They stay in memory, once for all robots that have them.
    pub(crate) fn copied(legs: Vec<Vec<Range>>) -> Self {
        type Bits = Vec<Vec<[u64; 2]>>;
        static KNOWN: Mutex<BTreeMap<Bits, Limits>> = Mutex::new(BTreeMap::new());
        let bits = |range: &Range| [range.min.to_bits(), range.max.to_bits()];
        let bits = legs.iter().map(|leg| leg.iter().map(bits).collect());
        let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        let new = || Limits(Box::leak(Box::new(legs.clone())));
        *known.entry(bits.collect()).or_insert_with(new)
    }

    /// Iterates over the limits of all joints.
    fn each(self) -> impl Iterator<Item = Option<Range>> {
        (0..MAX).flat_map(move |leg| (0..MAX).map(move |joint| self.0.get(leg, joint)))
    }
}

impl PartialEq for Limits {
    fn eq(&self, other: &Self) -> bool {
        self.each().eq(other.each())
    }
}

impl fmt::Debug for Limits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.each().flatten()).finish()
    }
}

impl Facts {
    /// Returns the facts of a model that is a `static` or a constant; those of another model are [`copied`](Self::copied).
    pub const fn of<const L: usize, const J: usize>(model: &'static Model<L, J>) -> Self {
        Self::with(model, Limits(model))
    }

    /// Returns the facts of a model that need not stay in memory.
    pub fn copied<const L: usize, const J: usize>(model: &Model<L, J>) -> Self {
        let limits = |leg: &Leg<J>| leg.joints.iter().map(|joint| joint.limits).collect();
        Self::with(
            model,
            Limits::copied(model.legs.iter().map(limits).collect()),
        )
    }

    const fn with<const L: usize, const J: usize>(model: &Model<L, J>, limits: Limits) -> Self {
        Facts {
            signature: model.signature(),
            period: model.standards.period,
            periods: model.periods,
            lamps: model.lamps,
            has_forces: model.forces.is_some(),
            has_slider: model.slider.is_some(),
            limits,
        }
    }
}

impl Robot {
    /// Every robot that has a name of its own.
    pub const ALL: &'static [Robot] = &[Robot::Titan8, Robot::Hand, Robot::Generic];

    /// Returns the robot of that name.
    pub fn from_name(name: &str) -> Option<Robot> {
        Robot::ALL
            .iter()
            .copied()
            .find(|robot| robot.name() == name)
    }

    /// Returns the name that options and messages use.
    pub const fn name(self) -> &'static str {
        self.signature().robot
    }

    /// Returns the shape of the robot that its programs are made for.
    pub const fn signature(self) -> Signature {
        self.facts().signature
    }

    /// Returns what a program can meet on it.
    pub const fn facts(self) -> Facts {
        match self {
            Robot::Titan8 => Facts::of(&titan8::MODEL),
            Robot::Hand => Facts::of(&hand::MODEL),
            Robot::Generic => Facts::of(&generic::MODEL),
            Robot::Described(facts) => facts,
        }
    }

    /// Returns the working limits of a joint, deg; `None` for another target.
    pub(crate) fn limits(self, joint: Target) -> Option<Range> {
        let Target::Joint(leg, joint) = joint else {
            return None;
        };
        let [leg, joint] = [leg, joint].map(|n| usize::from(n).checked_sub(1));
        self.facts().limits.0.get(leg?, joint?)
    }

    /// Returns true if it has the commands and inputs of the Hiroshima Hand.
    pub(crate) fn is_hand(self) -> bool {
        self.signature().family == Family::Hand
    }

    /// Returns true if the robot has the leg, joint or slider.
    pub fn has(self, target: Target) -> bool {
        let Signature { legs, joints, .. } = self.signature();
        match target {
            Target::None | Target::All => true,
            Target::Floor => self.facts().has_slider,
            Target::Foot(leg) => leg <= legs,
            Target::Joint(leg, joint) => leg <= legs && joint <= joints,
        }
    }

    /// Returns its targets, in rows: `F1…F4`, `J11…J43`, `FLOOR`.
    pub(crate) fn inventory(self) -> Vec<String> {
        let Facts {
            signature,
            has_slider,
            ..
        } = self.facts();
        let Signature { legs, joints, .. } = signature;
        let feet = span(Target::Foot(1), Target::Foot(legs));
        let joints = span(Target::Joint(1, 1), Target::Joint(legs, joints));
        let floor = has_slider.then(|| Target::Floor.to_string());
        [feet, joints].into_iter().chain(floor).collect()
    }
}

/// Returns `first…last`, or one name if both are equal.
fn span(first: Target, last: Target) -> String {
    match first == last {
        true => first.to_string(),
        false => format!("{first}…{last}"),
    }
}
