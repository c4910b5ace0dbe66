//! Steered gaits: the kinds, the numbers of a gait, and the choice of the fastest one that is safe.

mod crawl;
mod figures;
mod plan;
mod program;
mod reach;

use crate::message::Making;
use clap::ValueEnum;
use figures::{Figures, Floor};
use plan::Plan;
use std::fmt;
use tip_runtime::plant::ServoDynamics;
use tip_sim::Robot;

/// The order in which feet swing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::new) enum Kind {
    /// One foot at a time; the body leans over the others
    Crawl,
    /// One foot at a time; the body stays level
    Wave,
    /// Half of the feet at a time, every other one
    Tripod,
    /// Two diagonal feet at a time; needs mass
    Trot,
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = self.to_possible_value();
        f.write_str(value.as_ref().map_or("", |value| value.get_name()))
    }
}

impl Kind {
    /// Returns the kinds for a number of legs, the fastest first.
    fn fastest_first(legs: usize) -> &'static [Kind] {
        match legs {
            4 => &[Kind::Trot, Kind::Crawl],
            5 => &[Kind::Wave, Kind::Crawl],
            _ => &[Kind::Tripod, Kind::Wave, Kind::Crawl],
        }
    }
}

/// A gait that was tried in simulation.
#[derive(Debug)]
pub(in crate::new) struct Gait {
    pub(in crate::new) kind: Kind,
    pub(in crate::new) program: String,
    /// Speed with mass on a level floor: mm/s ahead, mm/s to the side, deg/s.
    pub(in crate::new) speed: [f64; 3],
    /// Control cycle, s.
    pub(in crate::new) cycle: f64,
    /// True if the robot does not fall on a slope.
    pub(in crate::new) is_safe_on_slope: bool,
}

impl Gait {
    /// Returns true if a robot without mass falls.
    pub(in crate::new) fn needs_mass(&self) -> bool {
        self.kind == Kind::Trot
    }
}

/// Factor between the speeds of two trials.
const SLOWER: f64 = 0.75;

/// Finds the fastest gait that is safe, or a gait of a kind, for a robot whose servos turn `speed` deg/s and no faster than simulated
/// ones.
///
/// # Errors
/// The reason why there is none.
pub(in crate::new) fn find(robot: &Robot, kind: Option<Kind>, speed: f64) -> Result<Gait, Making> {
    let speed = speed.min(ServoDynamics::default().speed);
    let legs = robot.description().legs.len();
    if robot.description().body.is_none() {
        return Err(Making::BoltedDown);
    }
    if let Some(kind) = kind {
        return find_kind(robot, kind, speed);
    }
    let (mut level_only, mut first) = (None, None);
    for kind in Kind::fastest_first(legs) {
        match find_kind(robot, *kind, speed) {
            Ok(gait) if gait.is_safe_on_slope => return Ok(gait),
            Ok(gait) => _ = level_only.get_or_insert(gait),
            Err(reason) => _ = first.get_or_insert(reason),
        }
    }
    level_only.ok_or_else(|| first.unwrap_or(Making::TooFewLegs))
}

/// Returns a gait of a kind: one that is safe on a slope, else the first that is safe on a level floor. Two speeds are tried, each for
/// about ten seconds on every floor.
///
/// # Errors
/// The robot cannot walk so, or falls in each trial.
fn find_kind(robot: &Robot, kind: Kind, speed: f64) -> Result<Gait, Making> {
    let description = robot.description();
    let plan = Plan::derive(&description, kind, speed)?;
    let (mut level_only, mut reason) = (None, None);
    for plan in [&plan, &plan.slower(SLOWER)] {
        match try_on_floors(robot, plan) {
            Ok(gait) if gait.is_safe_on_slope => return Ok(gait),
            Ok(gait) => _ = level_only.get_or_insert(gait),
            Err(why) => reason = Some(why),
        }
    }
    level_only.ok_or_else(|| reason.unwrap_or(Making::Falls))
}

/// Tries a gait on all floors; a trot, which no robot without mass can do, with mass only.
///
/// # Errors
/// The robot falls on a level floor.
fn try_on_floors(robot: &Robot, plan: &Plan) -> Result<Gait, Making> {
    let program = program::text(robot, plan, "");
    let mut rows = Vec::new();
    let (mut speed, mut is_safe_on_slope) = ([0.0; 3], true);
    let floors = Floor::ALL.into_iter();
    for floor in floors.filter(|floor| floor.has_mass() || plan.kind != Kind::Trot) {
        let figures = Figures::measure(robot, plan, &program, floor);
        let figures = match figures {
            Err(reason) if floor.is_level() => return Err(reason),
            figures => figures.ok(),
        };
        is_safe_on_slope &= figures.is_some();
        if let (Floor::Level, Some(figures)) = (floor, &figures) {
            speed = figures.speed;
        }
        rows.push((floor, figures));
    }
    Ok(Gait {
        kind: plan.kind,
        program: program::text(robot, plan, &figures::comment(&rows, plan.servos)),
        speed,
        cycle: plan.cycle / 1000.0,
        is_safe_on_slope,
    })
}
