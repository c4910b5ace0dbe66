//! What the page is told in words: the robot, the program, and what happened seldom enough to be listed.

use super::columns::Column;
use crate::recording::{self, Outcome, Recording};
use crate::skeleton::Skeleton;
use serde::Serialize;
use tip_runtime::command::{Flag, Target};
use tip_runtime::controller::Mode;
use tip_runtime::model::Range;
use tip_runtime::plant::{self, Object, Shape};
use tip_sim::{Asked, Event, Timed};

#[derive(Serialize)]
pub(crate) struct Header<'a> {
    robot: Robot<'a>,
    scene: Scene,
    script: Script<'a>,
    cycles: u64,
    clock: Vec<(u64, f64, f64)>,
    messages: Vec<(u64, &'a str)>,
    lamps: Vec<(u64, u8, bool)>,
    commands: Vec<(u64, &'static str, String, String)>,
    flags: Vec<(u64, String)>,
    modes: Vec<(u64, Vec<(String, &'static str)>)>,
    falls: Vec<(u64, f64)>,
    slips: Vec<(u64, usize, f64)>,
    events: Vec<(u64, &'a Event)>,
    outcome: Ended<'a>,
    columns: &'a [Column],
}

#[derive(Serialize)]
pub(crate) struct Robot<'a> {
    name: &'a str,
    body: Option<Body>,
    legs: Vec<Leg<'a>>,
    planar: bool,
    slider: Option<[f64; 3]>,
}

#[derive(Serialize)]
struct Body {
    x: [f64; 2],
    y: [f64; 2],
    z: [f64; 2],
    mass: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    centre: Option<[f64; 3]>,
}

#[derive(Serialize)]
struct Leg<'a> {
    base: [f64; 3],
    joints: Vec<Joint>,
    initial: &'a [f64],
}

#[derive(Serialize)]
struct Joint {
    axis: [f64; 3],
    link: [f64; 3],
    mass: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    centre: Option<[f64; 3]>,
}

#[derive(Serialize)]
pub(crate) struct Scene {
    height: f64,
    slope: [f64; 2],
    objects: Vec<Outline>,
    blocks: Vec<Block>,
}

/// A box that stands on the floor: from where to where along x and y, and its upper side, in the world: mm.
#[derive(Serialize)]
struct Block {
    x: [f64; 2],
    y: [f64; 2],
    height: f64,
}

/// A disc has a radius, a box a width and a height: mm.
#[derive(Serialize)]
#[serde(rename_all = "lowercase")]
enum Outline {
    Disc(f64),
    Box(f64, f64),
}

#[derive(Serialize)]
pub(crate) struct Script<'a> {
    name: &'a str,
    title: &'a str,
    text: &'a str,
    lines: &'a [u32],
    scalars: &'a [String],
}

#[derive(Default, Serialize)]
pub(crate) struct Ended<'a> {
    how: &'a str,
    error: Option<&'a str>,
    kind: Option<&'a str>,
    line: Option<u32>,
}

impl<'a> Header<'a> {
    pub(super) fn of(recording: &'a Recording, columns: &'a [Column]) -> Self {
        let Recording { robot, script, .. } = recording;
        let clock = recording.clock.iter();
        let falls = recording.falls.iter();
        Header {
            robot: Robot::of(robot),
            scene: Scene::of(&recording.scene),
            script: Script::of(script),
            cycles: recording.cycles,
            clock: clock
                .map(|tick| (tick.cycle, tick.time, tick.period))
                .collect(),
            messages: each(&recording.messages, |cycle, text| (cycle, &**text)),
            lamps: each(&recording.lamps, |cycle, (device, on)| {
                (cycle, *device, *on)
            }),
            commands: each(&recording.commands, |cycle, asked| {
                (
                    cycle,
                    asked.op.name(),
                    asked.target.to_string(),
                    values(asked),
                )
            }),
            flags: each(&recording.flags, |cycle, flags| (cycle, words(flags))),
            modes: each(&recording.modes, |cycle, modes| (cycle, named(modes))),
            falls: falls.map(|fall| (fall.cycle, fall.what)).collect(),
            slips: each(&recording.slips, |cycle, slip| {
                (cycle, slip.leg, slip.distance)
            }),
            events: recording.events.iter().map(event).collect(),
            outcome: Ended::of(recording),
            columns,
        }
    }

    /// No value of it can fail to be written.
    pub(super) fn to_json(&self) -> String {
        serde_json::to_string(self).unwrap_or_default()
    }
}

pub(crate) fn each<'a, T, U>(
    list: &'a [crate::recording::At<T>],
    of: impl Fn(u64, &'a T) -> U,
) -> Vec<U> {
    list.iter().map(|at| of(at.cycle, &at.what)).collect()
}

/// An event with its cycle.
pub(crate) fn event(timed: &Timed) -> (u64, &Event) {
    (timed.cycle, &timed.event)
}

/// Flags, with blanks between.
pub(crate) fn words(flags: &[Flag]) -> String {
    let words: Vec<_> = flags.iter().map(ToString::to_string).collect();
    words.join(" ")
}

/// Each target with what its mode is called.
pub(crate) fn named(modes: &[(Target, Mode)]) -> Vec<(String, &'static str)> {
    let modes = modes
        .iter()
        .map(|(target, mode)| (target.to_string(), called(*mode)));
    modes.collect()
}

/// As the page asks its words for it (`page/src/words.js`).
fn called(mode: Mode) -> &'static str {
    match mode {
        Mode::Rest => "rest",
        Mode::Position => "position",
        Mode::Compliance => "compliance",
        Mode::Velocity => "velocity",
        Mode::Effort => "effort",
    }
}

pub(crate) fn values(asked: &Asked) -> String {
    let values: Vec<_> = asked.values.iter().map(ToString::to_string).collect();
    values.join(" ")
}

impl Scene {
    pub(crate) fn of(scene: &plant::Scene) -> Self {
        let objects = scene.objects.iter().flatten();
        let blocks = scene.blocks.iter().flatten();
        Scene {
            height: scene.floor.height,
            slope: scene.floor.slope,
            objects: objects.map(Outline::of).collect(),
            blocks: blocks.map(Block::of).collect(),
        }
    }
}

impl<'a> Script<'a> {
    pub(crate) fn of(script: &'a recording::Script) -> Self {
        Script {
            name: &script.name,
            title: &script.title,
            text: &script.text,
            lines: &script.lines,
            scalars: &script.scalars,
        }
    }
}

impl<'a> Robot<'a> {
    pub(crate) fn of(robot: &'a Skeleton) -> Self {
        let ends = |range: Range| [range.min, range.max];
        Robot {
            name: &robot.name,
            body: robot.body.map(|body| Body {
                x: ends(body.x),
                y: ends(body.y),
                z: ends(body.z),
                mass: body.mass,
                centre: body.spread.map(|spread| spread.centre),
            }),
            legs: robot.legs.iter().map(Leg::of).collect(),
            planar: robot.is_planar,
            slider: robot.slider.map(|slider| slider.initial),
        }
    }
}

impl<'a> Leg<'a> {
    fn of(limb: &'a tip_sim::Limb) -> Self {
        let joints = limb.joints.iter().map(|joint| Joint {
            axis: joint.axis,
            link: joint.link,
            mass: joint.mass,
            centre: joint.spread.map(|spread| spread.centre),
        });
        Leg {
            base: limb.base,
            joints: joints.collect(),
            initial: &limb.initial,
        }
    }
}

impl Block {
    fn of(block: &plant::Block) -> Self {
        let plant::Block { x, y, height } = *block;
        Block { x, y, height }
    }
}

impl Outline {
    fn of(object: &Object) -> Self {
        match object.shape {
            Shape::Disc { radius } => Outline::Disc(radius),
            Shape::Box { width, height } => Outline::Box(width, height),
        }
    }
}

impl<'a> Ended<'a> {
    pub(crate) fn of(recording: &'a Recording) -> Self {
        match &recording.outcome {
            Outcome::Program(word) => Ended {
                how: word,
                ..Ended::default()
            },
            Outcome::Interrupted => Ended {
                how: "interrupted",
                ..Ended::default()
            },
            Outcome::Limit => Ended {
                how: "limit",
                ..Ended::default()
            },
            Outcome::Emergency(stop) => Ended {
                how: "emergency",
                error: Some(&stop.error),
                kind: Some(&stop.kind),
                line: recording.script.lines.get(stop.step as usize).copied(),
            },
        }
    }
}
