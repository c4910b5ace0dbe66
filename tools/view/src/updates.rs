//! A recording as updates: what a page is told of a run, in JSON. `page/src/session.js` lists them. A page that replays a run
//! holds all of them; a page of a run that goes on gets them one by one.

use crate::recording::{At, Frame, Outcome, Recording, Script, Skeleton};
use serde::Serialize;
use tip_runtime::command::Target;
use tip_runtime::controller::Mode;
use tip_runtime::model::Range;
use tip_runtime::plant::{self, Object, Shape};
use tip_sim::{Event, FallKind, IssuedCommand, Summary};

/// The grid on which motion is: mm, deg or N.
const GRID: f64 = 0.01;

/// Numbers beyond this are no robot's; JavaScript counts that far.
const BOUND: f64 = 1e15;

/// A run begins: what stays the same in it.
#[derive(Serialize)]
struct Begin<'a> {
    r#type: &'static str,
    run: u64,
    robot: Robot<'a>,
    scene: Scene,
    script: &'a Script,
    channels: Vec<String>,
    inputs: &'a [String],
}

/// Everything that happened from one cycle to another; it replaces what the viewer has seen of
/// cycles from `from` on. Large lists of numbers are in columns, and a column of cycles, steps or
/// motion holds the differences between its numbers.
#[derive(Serialize)]
struct More<'a> {
    r#type: &'static str,
    run: u64,
    first: u64,
    from: u64,
    cycles: u64,
    clock: Vec<(u64, f64, f64)>,
    /// Cycles, then each channel.
    frames: Vec<Vec<i64>>,
    /// The posture of the last cycle, unless it is among the frames.
    now: Option<Vec<Vec<i64>>>,
    /// Cycles and steps.
    steps: [Vec<i64>; 2],
    /// Cycles, and bits: the first foot or finger has the lowest.
    contacts: (Vec<i64>, Vec<u64>),
    /// Cycles, variables, and their values to the bit.
    sets: (Vec<i64>, Vec<usize>, Vec<f64>),
    messages: Vec<(u64, &'a str)>,
    lamps: Vec<(u64, u8, bool)>,
    commands: Vec<(u64, &'static str, String, String)>,
    flags: Vec<(u64, String)>,
    modes: Vec<(u64, Vec<(String, &'static str)>)>,
    /// Cycles, margins and kinds.
    falls: Vec<(u64, f64, Option<FallKind>)>,
    slips: Vec<(u64, usize, f64)>,
    /// Cycles, threads, and their steps, counted from 1; 0 where a thread is over.
    #[serde(skip_serializing_if = "Option::is_none")]
    threads: Option<(Vec<i64>, Vec<u8>, Vec<i64>)>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    timers: Vec<(u64, u8, bool, f64)>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    locks: Vec<(u64, String)>,
    events: Vec<(u64, &'a Event)>,
}

/// The end of a recorded run.
#[derive(Serialize)]
struct Over<'a> {
    r#type: &'static str,
    outcome: Ended<'a>,
    summary: &'a Summary,
}

/// Part of a run that an update tells.
pub(crate) struct Part<'a> {
    /// Number of the run, from 1.
    pub(crate) run: u64,
    /// The first cycle that is still known.
    pub(crate) first: u64,
    /// From this cycle on …
    pub(crate) from: u64,
    /// … up to this one.
    pub(crate) until: u64,
    /// Number of cycles of the run at its end.
    pub(crate) cycles: u64,
    /// The posture of the last cycle, unless it is among the frames.
    pub(crate) now: Option<&'a Frame>,
}

impl Recording {
    /// Returns the updates that tell a page everything, one a line.
    pub fn updates(&self) -> String {
        let frame = self.frames.last().map_or(0, |frame| frame.cycle + 1);
        let part = Part {
            run: 1,
            first: 0,
            from: 0,
            // Events that came too late are told as well.
            until: u64::MAX,
            cycles: self.cycles.max(frame),
            now: None,
        };
        let over = Over {
            r#type: "status",
            outcome: Ended::of(self),
            summary: &self.summary,
        };
        [begin(self, 1, &[]), more(self, &part), json(&over)].join("\n")
    }
}

/// Returns the update that begins a run.
pub(crate) fn begin(recording: &Recording, run: u64, inputs: &[String]) -> String {
    json(&Begin {
        r#type: "run",
        run,
        robot: Robot::of(&recording.robot),
        scene: Scene::of(&recording.scene),
        script: &recording.script,
        channels: channels(recording).into_iter().map(|it| it.name).collect(),
        inputs,
    })
}

/// Returns the update that tells a part of a run.
pub(crate) fn more(recording: &Recording, part: &Part<'_>) -> String {
    let Part { from, until, .. } = *part;
    let channels = channels(recording);
    let frames = &recording.frames;
    let place = |cycle| frames.partition_point(|frame| frame.cycle < cycle);
    let frames = &frames[place(from)..place(until)];
    let now = part
        .now
        .map(|frame| columns(&channels, std::slice::from_ref(frame)));
    let (steps, contacts) = (part.of(&recording.steps), part.of(&recording.contacts));
    let (sets, threads) = (part.of(&recording.sets), part.of(&recording.threads));
    let clock = recording.clock.iter();
    let clock = clock.filter(|tick| (from..until).contains(&tick.cycle));
    let events = recording.events.iter();
    let events = events.filter(|event| (from..until).contains(&event.cycle));
    json(&More {
        r#type: "more",
        run: part.run,
        first: part.first,
        from,
        cycles: part.cycles,
        clock: clock
            .map(|tick| (tick.cycle, tick.time, tick.period))
            .collect(),
        frames: columns(&channels, frames),
        now,
        steps: [
            cycles(steps),
            differences(steps.iter().map(|step| step.what.into())),
        ],
        contacts: (cycles(contacts), each(contacts, |_, touch| mask(touch))),
        sets: (
            cycles(sets),
            each(sets, |_, set| set.scalar),
            each(sets, |_, set| set.value),
        ),
        messages: each(part.of(&recording.messages), |cycle, text| (cycle, &**text)),
        lamps: each(part.of(&recording.lamps), |cycle, (device, on)| {
            (cycle, *device, *on)
        }),
        commands: each(part.of(&recording.commands), |cycle, asked| {
            let target = asked.target.to_string();
            (cycle, asked.op.name(), target, values(asked))
        }),
        flags: each(part.of(&recording.flags), |cycle, flags| {
            (cycle, listed(flags))
        }),
        modes: each(part.of(&recording.modes), |cycle, modes| {
            (cycle, named(modes))
        }),
        falls: each(part.of(&recording.falls), |cycle, fall| {
            (cycle, fall.margin, fall.kind)
        }),
        slips: slips(recording, part),
        threads: (!threads.is_empty()).then(|| {
            let number = |step| i64::from(step) + 1;
            let steps = threads.iter().map(|at| at.what.1.map_or(0, number));
            (
                cycles(threads),
                each(threads, |_, thread| thread.0),
                differences(steps),
            )
        }),
        timers: each(part.of(&recording.timers), |cycle, timer| {
            (cycle, timer.number, timer.runs, timer.time)
        }),
        locks: each(part.of(&recording.locks), |cycle, locks| {
            (cycle, listed(locks))
        }),
        events: events.map(|timed| (timed.cycle, &timed.event)).collect(),
    })
}

/// Returns the slips of a part, and before them the last one of each leg, which may have grown since it was told.
fn slips(recording: &Recording, part: &Part<'_>) -> Vec<(u64, usize, f64)> {
    let (list, new) = (&recording.slips, part.of(&recording.slips));
    let before = &list[..list.partition_point(|slip| slip.cycle < part.from)];
    let legs = 0..recording.robot.legs.len();
    let last = legs.filter_map(|leg| before.iter().rev().find(|slip| slip.what.leg == leg));
    let all = last.chain(new);
    all.map(|at| (at.cycle, at.what.leg, at.what.distance))
        .collect()
}

impl Part<'_> {
    fn of<'a, T>(&self, list: &'a [At<T>]) -> &'a [At<T>] {
        let place = |cycle| list.partition_point(|at| at.cycle < cycle);
        &list[place(self.from)..place(self.until)]
    }
}

/// Returns the update as JSON; no value of it can fail to be written.
pub(crate) fn json(update: &impl Serialize) -> String {
    serde_json::to_string(update).unwrap_or_default()
}

/// Returns the cycles of frames, and the motion in them.
fn columns(channels: &[Channel], frames: &[Frame]) -> Vec<Vec<i64>> {
    let cycles = frames.iter().map(|frame| frame.cycle as i64);
    let motion = channels.iter().map(|channel| {
        let mut last = 0.0;
        differences(frames.iter().map(|frame| {
            // What is not there, or not a number, is as before.
            let value = (channel.value)(frame).filter(|value| value.is_finite());
            last = value.unwrap_or(last);
            (last / GRID).round().clamp(-BOUND, BOUND) as i64
        }))
    });
    std::iter::once(differences(cycles)).chain(motion).collect()
}

fn cycles<T>(list: &[At<T>]) -> Vec<i64> {
    differences(list.iter().map(|at| at.cycle as i64))
}

/// Returns the first number, and how much each is more than the one before.
fn differences(numbers: impl Iterator<Item = i64>) -> Vec<i64> {
    let mut last = 0;
    let differences = numbers.map(|number| number - std::mem::replace(&mut last, number));
    differences.collect()
}

/// Returns the feet or fingertips that touch something, the first one in the lowest bit.
fn mask(touch: &[bool]) -> u64 {
    let feet = touch.iter().rev();
    feet.fold(0, |mask, touches| mask << 1 | u64::from(*touches))
}

#[derive(Serialize)]
struct Robot<'a> {
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
    limits: [f64; 2],
    mass: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    centre: Option<[f64; 3]>,
}

#[derive(Serialize)]
struct Scene {
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

/// A disc has a radius, a box a width and a height, mm.
#[derive(Serialize)]
#[serde(rename_all = "lowercase")]
enum Outline {
    Disc(f64),
    Box(f64, f64),
}

#[derive(Default, Serialize)]
pub(crate) struct Ended<'a> {
    how: &'a str,
    error: Option<&'a str>,
    kind: Option<&'a str>,
    line: Option<u32>,
    /// Time of the robot until then, ms.
    time: f64,
}

fn each<'a, T, U>(list: &'a [At<T>], of: impl Fn(u64, &'a T) -> U) -> Vec<U> {
    list.iter().map(|at| of(at.cycle, &at.what)).collect()
}

/// Returns words with blanks between.
fn listed(list: &[impl ToString]) -> String {
    let words: Vec<_> = list.iter().map(ToString::to_string).collect();
    words.join(" ")
}

/// Returns each target with the name of its mode.
fn named(modes: &[(Target, Mode)]) -> Vec<(String, &'static str)> {
    let modes = modes
        .iter()
        .map(|(target, mode)| (target.to_string(), called(*mode)));
    modes.collect()
}

/// Returns the name under which the page has its words (`page/src/words.js`).
fn called(mode: Mode) -> &'static str {
    match mode {
        Mode::Rest => "rest",
        Mode::Position => "position",
        Mode::Compliance => "compliance",
        Mode::Velocity => "velocity",
        Mode::Effort => "effort",
    }
}

fn values(asked: &IssuedCommand) -> String {
    let values: Vec<_> = asked.values.iter().map(ToString::to_string).collect();
    values.join(" ")
}

impl Scene {
    fn of(scene: &plant::Scene) -> Self {
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

impl<'a> Robot<'a> {
    fn of(robot: &'a Skeleton) -> Self {
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
            limits: [joint.limits.min, joint.limits.max],
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
        let by = |how| Ended {
            how,
            time: recording.time(recording.cycles),
            ..Ended::default()
        };
        match &recording.outcome {
            Outcome::Program(word) => by(word),
            Outcome::Interrupted | Outcome::Unknown => by("interrupted"),
            Outcome::Limit => by("limit"),
            Outcome::Emergency(stop) => Ended {
                error: Some(&stop.error),
                kind: Some(&stop.kind),
                line: recording.script.lines.get(stop.step as usize).copied(),
                ..by("emergency")
            },
        }
    }
}

/// A number of each frame.
struct Channel {
    name: String,
    value: Value,
}

/// Reads the value from a frame, if it is there.
type Value = Box<dyn Fn(&Frame) -> Option<f64>>;

/// Returns the channels of a recording; the first frame has them all.
fn channels(recording: &Recording) -> Vec<Channel> {
    let Some(first) = recording.frames.first() else {
        return Vec::new();
    };
    let mut channels = all(first);
    channels.retain(|channel| (channel.value)(first).is_some());
    channels
}

fn all(first: &Frame) -> Vec<Channel> {
    let mut all = Vec::new();
    for axis in 0..6 {
        all.push(channel(format!("pose.{axis}"), move |frame| {
            let pose = frame.pose?;
            let [x, y, z] = pose.position;
            Some([x, y, z, pose.roll, pose.pitch, pose.yaw][axis])
        }));
    }
    all.push(channel("margin".to_owned(), |frame| frame.margin));
    for (leg, angles) in first.angles.iter().enumerate() {
        for joint in 0..angles.len() {
            let of = move |all: &[Vec<f64>]| all.get(leg)?.get(joint).copied();
            let (angle, torque) = (
                format!("angle.{leg}.{joint}"),
                format!("torque.{leg}.{joint}"),
            );
            all.push(channel(angle, move |frame| of(&frame.angles)));
            all.push(channel(torque, move |frame| of(&frame.torques)));
            // Mostly 0, which takes no room.
            all.push(channel(format!("lag.{leg}.{joint}"), move |frame| {
                Some(of(&frame.setpoints)? - of(&frame.angles)?)
            }));
        }
        all.push(channel(format!("load.{leg}"), move |frame| {
            frame.loads.get(leg).copied()
        }));
        all.push(channel(format!("slip.{leg}"), move |frame| {
            frame.slips.get(leg).copied()
        }));
        for axis in 0..3 {
            let (force, push) = (format!("force.{leg}.{axis}"), format!("push.{leg}.{axis}"));
            all.push(channel(force, move |frame| {
                frame.forces.get(leg).map(|force| force[axis])
            }));
            all.push(channel(push, move |frame| {
                frame.pushes.get(leg).map(|push| push[axis])
            }));
        }
    }
    for axis in 0..3 {
        all.push(channel(format!("slider.{axis}"), move |frame| {
            Some(frame.slider?[axis])
        }));
    }
    for thing in 0..first.objects.len() {
        for axis in 0..3 {
            all.push(channel(format!("thing.{thing}.{axis}"), move |frame| {
                let thing = frame.objects.get(thing)?;
                let [x, y, _] = thing.position;
                Some([x, y, thing.angle][axis])
            }));
        }
    }
    all
}

fn channel(name: String, value: impl Fn(&Frame) -> Option<f64> + 'static) -> Channel {
    Channel {
        name,
        value: Box::new(value),
    }
}
