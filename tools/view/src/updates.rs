//! A recording as updates: what a page is told of a run, in JSON. `page/src/session.js` lists them. A page that replays a run
//! holds all of them; a page of a run that goes on gets them one by one.

use crate::recording::{Frame, Occurrence, Outcome, Recording, Script, Skeleton};
use serde::Serialize;
use serde_json::{Value as Json, json};
use std::collections::BTreeMap;
use tip_runtime::command::Target;
use tip_runtime::controller::Mode;
use tip_runtime::model::Range;
use tip_runtime::plant::{self, Object, Shape};
use tip_sim::{IssuedCommand, Summary};

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
/// cycles from `from` on. A column of cycles or motion holds the differences between its numbers.
#[derive(Serialize)]
struct More {
    r#type: &'static str,
    run: u64,
    first: u64,
    from: u64,
    cycles: u64,
    log: Columns,
    /// Cycles, then each channel.
    frames: Vec<Vec<i64>>,
    /// The posture of the last cycle, unless it is among the frames.
    now: Option<Vec<Vec<i64>>>,
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
    json(&More {
        r#type: "more",
        run: part.run,
        first: part.first,
        from,
        cycles: part.cycles,
        log: log(recording, part),
        frames: columns(&channels, frames),
        now,
    })
}

/// Cycles and values under each key.
type Columns = BTreeMap<String, (Vec<i64>, Vec<Json>)>;

/// Returns the log of a part, with differences between cycles.
fn log(recording: &Recording, part: &Part<'_>) -> Columns {
    let mut log = Columns::new();
    let mut add = |key, cycle, value| {
        let (cycles, values) = log.entry(key).or_default();
        cycles.push(cycle as i64);
        values.push(value);
    };
    let is_told = |cycle: u64| (part.from..part.until).contains(&cycle);
    let clock = recording.clock.iter();
    for tick in clock.filter(|tick| is_told(tick.cycle)) {
        let value = json!([tick.cycle, tick.time, tick.period]);
        add("clock".to_owned(), tick.cycle, value);
    }
    let place = |cycle| recording.log.partition_point(|entry| entry.cycle < cycle);
    for entry in &recording.log[place(part.from)..place(part.until)] {
        for key in keys(&entry.what, recording.robot.legs.len()) {
            add(key, entry.cycle, value(&entry.what));
        }
    }
    let events = recording.events.iter();
    for event in events.filter(|event| is_told(event.cycle)) {
        add("event".to_owned(), event.cycle, json!(event.event));
    }
    for (cycles, _) in log.values_mut() {
        *cycles = differences(cycles.iter().copied());
    }
    log
}

/// Returns the keys of an occurrence on a page. A command has one for each leg that it moves.
fn keys(what: &Occurrence, legs: usize) -> Vec<String> {
    let leg = |leg: u8| usize::from(leg)..=usize::from(leg);
    let legs = match what {
        Occurrence::Command(command) => match command.target {
            Target::All => 1..=legs,
            Target::Foot(of) | Target::Joint(of, _) => leg(of),
            Target::None | Target::Floor => return Vec::new(),
        },
        _ => return vec![what.key().into_owned()],
    };
    legs.map(|leg| format!("command.{leg}")).collect()
}

/// Returns the value under the key of an occurrence (`page/src/session.js`).
fn value(what: &Occurrence) -> Json {
    match what {
        Occurrence::Step(step) => json!(step),
        Occurrence::Thread(_, step) => json!(step),
        Occurrence::Timer { runs, time, .. } => json!([runs, time]),
        Occurrence::Locks(joints) => json!(listed(joints)),
        Occurrence::Message(text) => json!(text),
        Occurrence::Assigned { value, .. } => json!(value),
        Occurrence::Read { line, .. } => json!(line),
        Occurrence::Lamp(_, on) => json!(on),
        Occurrence::Command(command) => json!(words(command)),
        Occurrence::Contacts(touch) => json!(mask(touch)),
        Occurrence::Flags(flags) => json!(listed(flags)),
        Occurrence::Modes(modes) => json!(named(modes)),
        Occurrence::Fall {
            count,
            margin,
            kind,
        } => json!([count, margin, kind]),
        Occurrence::Collision(parts) => {
            json!(parts.map(|parts| parts.map(|part| part.to_string())))
        }
        Occurrence::Slip { distance, .. } => json!(distance),
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

/// Returns a command with its target and values.
fn words(command: &IssuedCommand) -> String {
    let IssuedCommand {
        op, target, values, ..
    } = command;
    format!("{} {target} {}", op.name(), listed(values))
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
                centre: body.inertial.map(|inertial| inertial.centre),
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
            centre: joint.inertial.map(|inertial| inertial.centre),
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
    all.push(channel("clearance".to_owned(), |frame| {
        Some(frame.gap?.distance)
    }));
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
