//! A run as data.

use crate::skeleton::Skeleton;
use std::fmt;
use tip_runtime::command::{Flag, Target};
use tip_runtime::controller::Mode;
use tip_runtime::model::Point;
use tip_runtime::plant::{Pose, Scene};
use tip_sim::{Asked, Timed, Wait};

/// What a program did, from its first cycle to its last.
///
/// Motion is there at 50 Hz at most; everything else in the cycle in which it was. Lists are in order of their cycles.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Recording {
    /// The robot.
    pub robot: Skeleton,
    /// What surrounded it.
    pub scene: Scene,
    /// The program.
    pub script: Script,
    /// How many cycles ran without a fault.
    pub cycles: u64,
    /// Where cycles began to take another time.
    pub clock: Vec<Tick>,
    /// What the robot did, at 50 Hz at most; the last cycle has one.
    pub frames: Vec<Frame>,
    /// The step that ran, where it was another one than in the cycle before.
    pub steps: Vec<At<u32>>,
    /// Messages; an empty one cleared the line.
    pub messages: Vec<At<String>>,
    /// Variables that were assigned another value.
    pub sets: Vec<At<Assigned>>,
    /// Lamps that were switched, and whether on.
    pub lamps: Vec<At<(u8, bool)>>,
    /// Commands that were accepted.
    pub commands: Vec<At<Asked>>,
    /// Which feet or fingertips touched something, where that changed; the first is that of cycle 0.
    pub contacts: Vec<At<Vec<bool>>>,
    /// The flags of conditions that were up, where that changed; the first is that of cycle 0. A trace does not say.
    pub flags: Vec<At<Vec<Flag>>>,
    /// How feet or joints, and a slider, were controlled, where that changed; the first is that of cycle 0. A trace does not say.
    pub modes: Vec<At<Vec<(Target, Mode)>>>,
    /// Falls, with the distance of the centre of mass from the edge of the support polygon: mm; negative outside.
    pub falls: Vec<At<f64>>,
    /// Feet that slipped while they stood.
    pub slips: Vec<At<Slip>>,
    /// What happened from outside: keys, halts, inputs. A trace does not say.
    pub events: Vec<Timed>,
    /// How it ended.
    pub outcome: Outcome,
    /// What the program waited for when someone else ended it, if it did. A trace does not say.
    pub wait: Option<Wait>,
}

/// Something in a cycle, counted from 0.
#[derive(Clone, Debug, PartialEq)]
pub struct At<T> {
    /// The cycle.
    pub cycle: u64,
    /// What.
    pub what: T,
}

/// From this cycle on each takes so long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tick {
    /// The cycle.
    pub cycle: u64,
    /// When it began: ms.
    pub time: f64,
    /// How long it and those after it take: ms.
    pub period: f64,
}

/// The program that ran, as its author sees it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Script {
    /// The name of its file, without folders.
    pub name: String,
    /// Its second line.
    pub title: String,
    /// Its text.
    pub text: String,
    /// The line of each step, from 1.
    pub lines: Vec<u32>,
    /// The names of its scalars, in order of declaration.
    pub scalars: Vec<String>,
}

/// What the robot did until the end of a cycle.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Frame {
    /// The cycle.
    pub cycle: u64,
    /// When it ended: ms.
    pub time: f64,
    /// Where the body is in the world; none for a robot that stays where it is.
    pub pose: Option<Pose>,
    /// Of each joint, leg by leg: deg.
    pub angles: Vec<Vec<f64>>,
    /// How much of the robot each foot carries, or how hard each fingertip pushes: N. Empty if it is not known.
    pub loads: Vec<f64>,
    /// With what force the ground pushes each foot, friction included, in the world: N. Empty where only loads are known. A trace
    /// does not say.
    pub forces: Vec<[f64; 3]>,
    /// What each motor gives, leg by leg: in the robot's torque unit, in N·m if it has none. A trace does not say.
    pub torques: Vec<Vec<f64>>,
    /// How far inside the support polygon the centre of mass is: mm; negative outside.
    pub margin: Option<f64>,
    /// With what force each fingertip pushes floor and objects: N. Empty for a robot that is not a hand.
    pub pushes: Vec<[f64; 3]>,
    /// Where the slider is that carries the floor: mm.
    pub slider: Option<Point>,
    /// The objects, in the order of the scene. A trace does not say.
    pub objects: Vec<Thing>,
    /// The flags of conditions that are up, for all joints and for each foot. A trace does not say.
    pub flags: Vec<Flag>,
    /// The joints that are driven by torque; the others are by angle. A trace does not say.
    pub torque_joints: Vec<Target>,
}

/// Where an object is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thing {
    /// Its centre: mm.
    pub position: Point,
    /// deg.
    pub angle: f64,
}

/// A variable has another value from now on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assigned {
    /// Its place among [`Script::scalars`].
    pub scalar: usize,
    /// The value.
    pub value: f64,
}

/// A foot has slipped while it stood.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slip {
    /// The leg, from 0.
    pub leg: usize,
    /// How far it slipped in that stance: mm.
    pub distance: f64,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// By the program's own word: END or EXIT.
    Program(String),
    /// Someone interrupted it.
    Interrupted,
    /// The cycles were used up.
    Limit,
    /// By an emergency stop.
    Emergency(Stop),
}

/// Why a robot stopped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stop {
    /// The classical message.
    pub error: String,
    /// The kind of fault.
    pub kind: String,
    /// The step that failed.
    pub step: u32,
}

impl Outcome {
    /// Whether something went wrong.
    pub fn is_emergency(&self) -> bool {
        matches!(self, Outcome::Emergency(_))
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Outcome::Program(word) => f.write_str(word),
            Outcome::Interrupted => f.write_str("interrupted"),
            Outcome::Limit => f.write_str("the cycles were used up"),
            Outcome::Emergency(stop) => write!(f, "emergency stop: {} ({})", stop.error, stop.kind),
        }
    }
}

/// How often the motion is kept.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pace {
    /// At 50 Hz at most, and in the last cycle.
    #[default]
    Smooth,
    /// In one cycle of so many; in each for 0.
    Every(u64),
}

impl Recording {
    /// When a cycle began: ms.
    pub fn time(&self, cycle: u64) -> f64 {
        let after = self.clock.partition_point(|tick| tick.cycle <= cycle);
        let tick = after.checked_sub(1).and_then(|at| self.clock.get(at));
        tick.map_or(0.0, |tick| {
            tick.time + (cycle - tick.cycle) as f64 * tick.period
        })
    }

    /// The step that ran in a cycle, if one did.
    pub fn step(&self, cycle: u64) -> Option<u32> {
        let after = self.steps.partition_point(|step| step.cycle <= cycle);
        let step = after.checked_sub(1).and_then(|at| self.steps.get(at))?;
        (cycle < self.cycles).then_some(step.what)
    }

    /// The source line that ran in a cycle, from 1, if a step did.
    pub fn line(&self, cycle: u64) -> Option<u32> {
        self.script.lines.get(self.step(cycle)? as usize).copied()
    }
}
