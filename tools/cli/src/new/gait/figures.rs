//! Figures of a gait, measured in simulation before it is written.

use crate::message::Making;
use crate::new::gait::plan::{Plan, SLOPE};
use std::fmt::Write as _;
use tip_runtime::command::Port;
use tip_runtime::hardware::JointCommand;
use tip_runtime::plant::{self, Scene, ServoDynamics};
use tip_runtime::random::Random;
use tip_sim::{Event, Limit, Plant, Robot, Run, load};

/// A level floor or a slope, and a robot with or without mass.
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
}

/// Maximum times for standing up and for sitting down, s.
const STAND_UP: f64 = 20.0;
const SIT_DOWN: f64 = 60.0;
/// The message of a program that follows its sticks from now on.
const READY: &str = "ready";
/// Least time over which a speed is measured, s.
const WINDOW: f64 = 0.5;
/// Positions of VR1, VR2 and VR3, V: ahead, to the right, and turning; their speeds are measured.
const FULL: [[f64; 3]; 3] = [[10.0, 5.0, 5.0], [5.0, 5.0, 10.0], [5.0, 10.0, 5.0]];
/// Number of random positions of all sticks after them, and the longest and the shortest time of one, s.
const RANDOM: u32 = 5;
const RANDOM_TIME: [f64; 2] = [0.3, 0.8];
/// Largest slip of a foot with mass on a level floor, mm.
const MOST_SLIP: f64 = 20.0;

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
    ) -> Result<Self, Making> {
        let fails = || Making::OutOfReach;
        let robot = floor.put(robot).ok_or_else(fails)?;
        let loaded = load("walk.prg", program, &robot).map_err(|_| fails())?;
        let run = Run::new(loaded, robot).map_err(|_| fails())?;
        let mut trial = Trial {
            joints: (run.angles().len() / plan.feet.len()).max(1),
            run,
            cycle: plan.cycle / 1000.0,
            angles: vec![],
            commands: vec![],
            commanded: 0.0,
            figures: Figures {
                speed: [0.0; 3],
                joint: (1, 1),
                rate: 0.0,
                margin: f64::INFINITY,
                slip: 0.0,
            },
        };
        trial.stand_up()?;
        for (axis, sticks) in FULL.into_iter().enumerate() {
            // Speeds are measured over whole strides: the body leans to both sides in each.
            let stride = plan.stride[[1, 0, 2][axis]];
            let whole = (WINDOW / stride).ceil() * stride;
            let start = plan.delay / 1000.0 + stride;
            trial.push(sticks)?;
            trial.walk(start)?;
            let from = trial.run.travel().ok_or_else(fails)?;
            trial.walk(whole)?;
            let to = trial.run.travel().ok_or_else(fails)?;
            trial.figures.speed[axis] = speed(axis, from, to) / whole;
            trial.push([5.0; 3])?;
            trial.walk(plan.delay / 1000.0)?;
        }
        // The same for every robot.
        let mut random = Random::new(1);
        for _ in 0..RANDOM {
            // A third each: at rest, at an end, anywhere.
            trial.push([1, 2, 3].map(|_| match random.below(6) {
                0 | 1 => 5.0,
                2 => 0.0,
                3 => 10.0,
                _ => random.within(0.0, 10.0),
            }))?;
            let [least, most] = RANDOM_TIME;
            trial.walk(random.within(least, most))?;
        }
        // A trial slows commands down to the speed of simulated servos, and its figures show the effect. Slower servos are not
        // simulated, so that the commands are compared with their speed.
        if plan.servos < ServoDynamics::default().speed && trial.commanded > plan.servos {
            return Err(Making::TooSlow { speed: plan.servos });
        }
        let figures = trial.sit_down()?;
        // It walks as it should, and not on its belly.
        let slips = floor == Floor::Level && figures.slip > MOST_SLIP;
        if slips || floor.has_mass() && figures.speed[0] < 0.7 * plan.top[1] {
            return Err(Making::Slips);
        }
        Ok(figures)
    }
}

/// A run of a gait whose figures are measured.
struct Trial {
    run: Run,
    /// Control cycle, s.
    cycle: f64,
    /// Joints of a leg.
    joints: usize,
    /// Joint angles of the cycle before, deg.
    angles: Vec<f64>,
    /// Commands of the cycle before.
    commands: Vec<JointCommand>,
    /// Largest speed of a command, deg/s.
    commanded: f64,
    figures: Figures,
}

impl Trial {
    /// Runs until the robot stands and its sticks rest.
    fn stand_up(&mut self) -> Result<(), Making> {
        self.push([5.0; 3])?;
        let cycles = (STAND_UP / self.cycle) as u64;
        while self.run.cycles() < cycles && self.run.ending().is_none() {
            if self.run.cycle().messages.iter().any(|text| text == READY) {
                self.angles = self.run.angles().to_vec();
                self.commands = self.run.commands().to_vec();
                return Ok(());
            }
        }
        Err(Making::OutOfReach)
    }

    /// Moves VR1, VR2 and VR3, V.
    fn push(&mut self, sticks: [f64; 3]) -> Result<(), Making> {
        for (number, volts) in (1..).zip(sticks) {
            let event = Event::Sensor(Port::Knob(number), volts);
            let added = self.run.add(event.at(self.run.cycles()));
            added.map_err(|_| Making::OutOfReach)?;
        }
        Ok(())
    }

    /// Runs for a time, s.
    fn walk(&mut self, seconds: f64) -> Result<(), Making> {
        let cycles = (seconds / self.cycle).round() as u64;
        for _ in 0..cycles {
            self.run.advance(None);
            if self.run.ending().is_some() {
                return Err(Making::OutOfReach);
            }
            let figures = &mut self.figures;
            for (place, (now, before)) in self.run.angles().iter().zip(&self.angles).enumerate() {
                let rate = (now - before).abs() / self.cycle;
                if rate > figures.rate {
                    figures.rate = rate;
                    figures.joint = (place / self.joints + 1, place % self.joints + 1);
                }
            }
            self.angles.copy_from_slice(self.run.angles());
            for pair in self.run.commands().iter().zip(&self.commands) {
                if let (
                    JointCommand::Angle { angle, .. },
                    JointCommand::Angle { angle: before, .. },
                ) = pair
                {
                    self.commanded = self.commanded.max((angle - before).abs() / self.cycle);
                }
            }
            self.commands.copy_from_slice(self.run.commands());
            let motion = self.run.motion().ok_or(Making::OutOfReach)?;
            if motion.falls > 0 {
                return Err(Making::Falls);
            }
            figures.margin = figures.margin.min(motion.margin);
        }
        Ok(())
    }

    /// Requests a halt; returns the figures when the robot sits.
    fn sit_down(mut self) -> Result<Figures, Making> {
        let halt = self.run.add(Event::Halt.at(self.run.cycles()));
        halt.map_err(|_| Making::OutOfReach)?;
        let end = self.run.cycles() + (SIT_DOWN / self.cycle) as u64;
        self.run.to_end(Limit::cycles(end));
        let motion = self.run.motion().ok_or(Making::OutOfReach)?;
        if self.run.emergency().is_some() || self.run.cycles() >= end {
            return Err(Making::OutOfReach);
        }
        if motion.falls > 0 {
            return Err(Making::Falls);
        }
        self.figures.slip = motion.slip;
        Ok(self.figures)
    }
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

/// Returns a table of figures as comments, and the speed of the servos, deg/s.
pub(super) fn comment(all: &[(Floor, Option<Figures>)], servos: f64) -> String {
    let mut text = format!(
        "// Tried in simulation with full sticks and with random ones, friction 0.5; joints turn {servos:.0} deg/s at most:\n\
         //                  ahead, side, turn          fastest joint    margin  slip\n"
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
        } = figures;
        // With mass, feet that take their load touch one after the other: the margin says nothing.
        let margin = match floor.has_mass() {
            true => "-".to_owned(),
            false => format!("{margin:.0} mm"),
        };
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "// {:15}  {:<26} {:<16} {margin:<7} {slip:.1} mm",
            floor.name(),
            format!("{ahead:.0} mm/s, {side:.0} mm/s, {turn:.0} deg/s"),
            format!("{rate:.0} deg/s (J{leg}{joint})"),
        );
    }
    text
}
