//! Figures of a gait, measured in simulation before it is written.

use crate::message::Making;
use crate::new::gait::plan::{Plan, SLOPE};
use std::fmt::Write as _;
use tip_runtime::plant::{self, Scene, ServoDynamics};
use tip_sim::{Limit, Plant, Robot, Run, load};

/// A floor, and a robot with or without mass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Floor {
    Level,
    Slope,
    LevelWithoutMass,
    SlopeWithoutMass,
}

impl Floor {
    pub(super) const ALL: [Floor; 4] = [
        Floor::Level,
        Floor::Slope,
        Floor::LevelWithoutMass,
        Floor::SlopeWithoutMass,
    ];

    pub(super) fn has_mass(self) -> bool {
        matches!(self, Floor::Level | Floor::Slope)
    }

    pub(super) fn is_level(self) -> bool {
        matches!(self, Floor::Level | Floor::LevelWithoutMass)
    }

    fn name(self) -> &'static str {
        match self {
            Floor::Level => "with mass",
            Floor::Slope => "  5 deg uphill",
            Floor::LevelWithoutMass => "without mass",
            Floor::SlopeWithoutMass => "  5 deg uphill",
        }
    }

    /// Returns the robot on this floor.
    fn put(self, robot: &Robot) -> Option<Robot> {
        let mut scene = Scene::EMPTY;
        if !self.is_level() {
            scene.floor.slope = [0.0, SLOPE.to_radians().tan()];
        }
        let plant = match self.has_mass() {
            true => Plant::Dynamic,
            false => Plant::Simulated,
        };
        robot.clone().with_plant(plant).with_scene(&scene).ok()
    }
}

/// Figures of a run with full sticks.
#[derive(Clone, Debug)]
pub(super) struct Figures {
    /// mm/s ahead, mm/s to the right, deg/s
    pub(super) speed: [f64; 3],
    /// The fastest joint, from 1, and its speed, deg/s.
    joint: (usize, usize),
    rate: f64,
    /// Least distance of the centre of mass from the edge of the support polygon, mm.
    margin: f64,
    /// Largest slip of a foot in a stance, mm.
    slip: f64,
    pub(super) falls: u32,
}

/// Times of a trial, s: before the sticks move, for each stick besides whole strides, and between two.
const BEGIN: f64 = 4.0;
const PUSH: f64 = 2.0;
const REST: f64 = 2.0;
/// Positions of VR1, VR2 and VR3, V: ahead, to the right, turn, back, and all together.
const STICKS: [[f64; 3]; 5] = [
    [10.0, 5.0, 5.0],
    [5.0, 5.0, 10.0],
    [5.0, 10.0, 5.0],
    [0.0, 5.0, 5.0],
    [0.0, 0.0, 10.0],
];
/// Number of random positions of all sticks after them, and their longest time, s.
const RANDOM: u32 = 16;
const LONGEST: f64 = 2.0;
/// Maximum time for sitting down, s.
const SIT: f64 = 60.0;

impl Figures {
    /// Runs the program with full sticks, and with random ones.
    ///
    /// # Errors
    /// The robot falls unless it may, the program stops at a fault, or it does not sit down at its end.
    pub(super) fn measure(
        robot: &Robot,
        plan: &Plan,
        program: &str,
        floor: Floor,
        may_fall: bool,
    ) -> Result<Self, Making> {
        let fails = || Making::OutOfReach;
        let robot = floor.put(robot).ok_or_else(fails)?;
        let loaded = load("walk.prg", program, &robot).map_err(|_| fails())?;
        let cycle = plan.cycle / 1000.0;
        let at = |seconds: f64| (seconds / cycle).round() as u64;
        let mut events = "0:VR1=5, 0:VR2=5, 0:VR3=5".to_owned();
        let mut time = BEGIN;
        // Speeds are measured over whole strides: the body leans to both sides in each.
        let whole = (PUSH / plan.stride).ceil() * plan.stride;
        let push = PUSH.max(plan.stride) + whole;
        for sticks in STICKS {
            for (time, [one, two, three]) in [(time, sticks), (time + push, [5.0; 3])] {
                let now = at(time);
                // Writing to a String cannot fail.
                let _ = write!(
                    events,
                    ", {now}:VR1={one}, {now}:VR2={two}, {now}:VR3={three}"
                );
            }
            time += push + REST;
        }
        let measured = time;
        let mut random = Random(1);
        for _ in 0..RANDOM {
            let now = at(time);
            for stick in 1..=3 {
                // A third each: at rest, at an end, anywhere.
                let volts = match random.below(6) {
                    0 | 1 => 5.0,
                    2 => 0.0,
                    3 => 10.0,
                    _ => f64::from(random.below(101)) / 10.0,
                };
                let _ = write!(events, ", {now}:VR{stick}={volts}");
            }
            time += LONGEST * f64::from(10 + random.below(90)) / 100.0;
        }
        let _ = write!(events, ", {}:halt", at(time));
        let run = Run::new(loaded, robot).map_err(|_| fails())?;
        let mut run = run.events(&events).map_err(|_| fails())?;
        let mut figures = Figures {
            speed: [0.0; 3],
            joint: (1, 1),
            rate: 0.0,
            margin: f64::INFINITY,
            slip: 0.0,
            falls: 0,
        };
        let joints = plan_joints(&run, plan);
        while run.cycles() < at(BEGIN) && run.ending().is_none() {
            run.cycle();
        }
        let mut angles = run.angles().to_vec();
        let mut mark = None;
        while run.cycles() < at(time) && run.ending().is_none() {
            run.cycle();
            let is_measured = run.cycles() <= at(measured);
            for (place, (now, before)) in run.angles().iter().zip(&angles).enumerate() {
                let rate = (now - before).abs() / cycle;
                if is_measured && rate > figures.rate {
                    figures.rate = rate;
                    figures.joint = (place / joints + 1, place % joints + 1);
                }
            }
            angles.copy_from_slice(run.angles());
            let motion = run.motion();
            if motion.as_ref().is_some_and(|motion| motion.falls > 0) && !may_fall {
                return Err(Making::Falls);
            }
            if let Some(motion) = motion.filter(|_| is_measured) {
                figures.margin = figures.margin.min(motion.margin);
            }
            for (n, axis) in [0, 1, 2].into_iter().enumerate() {
                let end = BEGIN + n as f64 * (push + REST) + push;
                if run.cycles() == at(end - whole) {
                    mark = run.travel();
                }
                if let (true, Some(from), Some(to)) = (run.cycles() == at(end), mark, run.travel())
                {
                    figures.speed[axis] = speed(axis, from, to) / whole;
                }
            }
        }
        run.to_end(Limit::cycles(at(time + SIT)));
        let motion = run.motion().ok_or_else(fails)?;
        if run.emergency().is_some() || run.cycles() >= at(time + SIT) {
            return Err(fails());
        }
        figures.falls = motion.falls;
        figures.slip = motion.slip;
        // It walks as it should, and not on its belly.
        let wanted = plan.top[1];
        if floor.has_mass() && figures.speed[0] < 0.7 * wanted {
            return Err(Making::Slips);
        }
        Ok(figures)
    }
}

/// Random numbers that are the same for every robot (Numerical Recipes).
struct Random(u32);

impl Random {
    /// Returns a number from 0 to `count` - 1.
    fn below(&mut self, count: u32) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 16) % count
    }
}

fn plan_joints(run: &Run, plan: &Plan) -> usize {
    (run.angles().len() / plan.feet.len()).max(1)
}

/// Returns the way between two places along the robot's first direction: mm ahead, mm to the right, deg to the left.
fn speed(axis: usize, from: plant::Travel, to: plant::Travel) -> f64 {
    let heading = from.turn.to_radians();
    let [x, y] = [to.x - from.x, to.y - from.y];
    match axis {
        0 => y * heading.cos() - x * heading.sin(),
        1 => x * heading.cos() + y * heading.sin(),
        _ => to.turn - from.turn,
    }
}

/// Returns a table of figures as comments.
pub(super) fn comment(all: &[(Floor, Option<Figures>)]) -> String {
    let limit = ServoDynamics::default().speed;
    let mut text = format!(
        "// Tried in simulation with full sticks, friction 0.5; joints turn {limit:.0} deg/s at most:\n\
         //                  ahead, side, turn          fastest joint    margin  slip   falls\n"
    );
    for (floor, figures) in all {
        let Some(figures) = figures else {
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "// {:15}  it falls, stops at a fault, or slips",
                floor.name()
            );
            continue;
        };
        let Figures {
            speed: [ahead, side, turn],
            joint: (leg, joint),
            rate,
            margin,
            slip,
            falls,
        } = figures;
        // With mass, feet that take their load touch one after the other: the margin says nothing.
        let margin = match floor.has_mass() {
            true => "-".to_owned(),
            false => format!("{margin:.0} mm"),
        };
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "// {:15}  {:<26} {:<16} {margin:<7} {:<6} {falls}",
            floor.name(),
            format!("{ahead:.0} mm/s, {side:.0} mm/s, {turn:.0} deg/s"),
            format!("{rate:.0} deg/s (J{leg}{joint})"),
            format!("{slip:.1} mm"),
        );
    }
    text
}
