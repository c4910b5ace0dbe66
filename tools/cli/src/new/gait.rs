//! Steered gaits: the kinds, the numbers of a gait, and the choice of the fastest one that is safe.

mod figures;
mod plan;
mod program;
mod reach;

use crate::message::Making;
use clap::ValueEnum;
use figures::{Figures, Floor};
use plan::Plan;
use std::fmt;
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
const SLOWER: f64 = 0.85;
/// Maximum number of trials of a gait.
const TRIALS: u32 = 4;
/// Reserves of a crawl's balance that are tried, relative to what a slope takes. A body that leans far is slow.
const RESERVES: [f64; 3] = [1.5, 0.8, 0.3];

/// Finds the fastest gait that is safe, or a gait of a kind.
///
/// # Errors
/// The reason why there is none.
pub(in crate::new) fn find(robot: &Robot, kind: Option<Kind>) -> Result<Gait, Making> {
    let legs = robot.anatomy().legs.len();
    if robot.anatomy().body.is_none() {
        return Err(Making::BoltedDown);
    }
    if let Some(kind) = kind {
        return find_kind(robot, kind);
    }
    let (mut level_only, mut first) = (None, None);
    for kind in Kind::fastest_first(legs) {
        match find_kind(robot, *kind) {
            Ok(gait) if gait.is_safe_on_slope => return Ok(gait),
            Ok(gait) => _ = level_only.get_or_insert(gait),
            Err(reason) => _ = first.get_or_insert(reason),
        }
    }
    level_only.ok_or_else(|| first.unwrap_or(Making::TooFewLegs))
}

/// Returns a gait of a kind: one that is safe on a slope, else the first that is safe on a level floor.
///
/// # Errors
/// The robot cannot walk so, or falls in each trial.
fn find_kind(robot: &Robot, kind: Kind) -> Result<Gait, Making> {
    let anatomy = robot.anatomy();
    let (reserves, trials): (&[f64], u32) = match kind {
        Kind::Crawl => (&RESERVES, TRIALS / 2),
        _ => (&[0.0], TRIALS),
    };
    let (mut level_only, mut reason) = (None, None);
    for reserve in reserves {
        let mut plan = match Plan::derive(&anatomy, kind, *reserve) {
            Ok(plan) => plan,
            Err(why) => {
                reason = Some(why);
                continue;
            }
        };
        for _ in 0..trials {
            match try_on_floors(robot, &plan) {
                Ok(gait) if gait.is_safe_on_slope => return Ok(gait),
                Ok(gait) => _ = level_only.get_or_insert(gait),
                Err(why) => reason = Some(why),
            }
            plan.slow_down(SLOWER);
        }
    }
    level_only.ok_or_else(|| reason.unwrap_or(Making::Falls))
}

/// Tries a gait on all floors.
///
/// # Errors
/// The robot falls on a level floor, with mass or, unless the gait needs it, without.
fn try_on_floors(robot: &Robot, plan: &Plan) -> Result<Gait, Making> {
    let program = program::text(robot, plan, "");
    let mut rows = Vec::new();
    let (mut speed, mut is_safe_on_slope) = ([0.0; 3], true);
    for floor in Floor::ALL {
        let may_fall = plan.kind == Kind::Trot && !floor.has_mass();
        let figures = Figures::measure(robot, plan, &program, floor, may_fall);
        let is_safe = figures
            .as_ref()
            .is_ok_and(|figures| figures.falls == 0 || may_fall);
        if floor.is_level() && !is_safe {
            return Err(figures.err().unwrap_or(Making::Falls));
        }
        is_safe_on_slope &= is_safe;
        if let (Floor::Level, Ok(figures)) = (floor, &figures) {
            speed = figures.speed;
        }
        rows.push((floor, figures.ok()));
    }
    Ok(Gait {
        kind: plan.kind,
        program: program::text(robot, plan, &figures::comment(&rows)),
        speed,
        cycle: plan.cycle / 1000.0,
        is_safe_on_slope,
    })
}
