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
}

impl Gait {
    /// Returns true if a robot without mass falls.
    pub(in crate::new) fn needs_mass(&self) -> bool {
        self.kind == Kind::Trot
    }
}

/// Factor between the speeds of two trials.
const SLOWER: f64 = 0.85;
/// Maximum number of trials of a kind.
const TRIALS: u32 = 6;

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
    let mut first = None;
    for kind in Kind::fastest_first(legs) {
        match find_kind(robot, *kind) {
            Ok(gait) => return Ok(gait),
            Err(reason) => _ = first.get_or_insert(reason),
        }
    }
    Err(first.unwrap_or(Making::TooFewLegs))
}

/// Returns a gait of a kind, slowed down until the simulated robot does not fall.
fn find_kind(robot: &Robot, kind: Kind) -> Result<Gait, Making> {
    let mut plan = Plan::derive(&robot.anatomy(), kind)?;
    let mut reason = Making::Falls;
    for _ in 0..TRIALS {
        let bare = program::text(robot, &plan, "");
        match try_on_floors(robot, &plan, &bare) {
            Ok(figures) => {
                let speed = figures[0].speed;
                return Ok(Gait {
                    kind,
                    program: program::text(robot, &plan, &figures::comment(&figures)),
                    speed,
                    cycle: plan.cycle / 1000.0,
                });
            }
            Err(why) => reason = why,
        }
        plan.slow_down(SLOWER);
    }
    Err(reason)
}

/// Tries a program on all floors; the first must be passed with mass, and without mass unless the gait needs it.
fn try_on_floors(robot: &Robot, plan: &Plan, program: &str) -> Result<Vec<Figures>, Making> {
    let mut all = Vec::new();
    for floor in Floor::ALL {
        let figures = Figures::measure(robot, plan, program, floor)?;
        let may_fall = plan.kind == Kind::Trot && !floor.has_mass();
        if figures.falls > 0 && !may_fall {
            return Err(Making::Falls);
        }
        all.push(figures);
    }
    Ok(all)
}
