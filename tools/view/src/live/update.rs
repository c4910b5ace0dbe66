//! What a viewer does not know yet.

use super::finding::Finding;
use super::session::Session;
use crate::pack::header::{self, Ended, Robot, Scene, Script, words};
use crate::pack::{Channel, channels, each, event, mask, values};
use crate::recording::{At, Frame, Recording};
use serde::Serialize;
use tip_runtime::command::Port;
use tip_sim::Event;

/// The most frames of one update; who has seen nothing gets several.
const MOST_FRAMES: usize = 1000;
/// The most other things of one kind.
const MOST_THINGS: usize = 20_000;

/// How much one viewer knows.
#[derive(Clone, Debug, Default)]
pub struct Viewer {
    /// The run that it sees; the first one is 1.
    run: u64,
    /// Of that run, all before this cycle.
    cycle: u64,
    /// How often that was taken back.
    cuts: u64,
    /// The text, by version.
    text: u64,
    /// What is found in it, by the version that was checked.
    findings: u64,
    /// How the run is.
    status: String,
}

/// A run begins: what stays the same in it.
#[derive(Serialize)]
struct Begin<'a> {
    r#type: &'static str,
    run: u64,
    robot: Robot<'a>,
    scene: Scene,
    script: Script<'a>,
    channels: Vec<String>,
    inputs: Vec<String>,
}

/// What happened from one cycle to another; what the viewer has seen of cycles from `from` on is not so any more.
#[derive(Serialize)]
struct More<'a> {
    r#type: &'static str,
    run: u64,
    first: u64,
    from: u64,
    cycles: u64,
    clock: Vec<(u64, f64, f64)>,
    frames: Vec<(u64, Vec<f64>)>,
    /// The posture of the last cycle, unless it is among the frames.
    now: Option<(u64, Vec<f64>)>,
    steps: Vec<(u64, u32)>,
    contacts: Vec<(u64, u64)>,
    sets: Vec<(u64, usize, f64)>,
    messages: Vec<(u64, &'a str)>,
    lamps: Vec<(u64, u8, bool)>,
    commands: Vec<(u64, &'static str, String, String)>,
    flags: Vec<(u64, String)>,
    modes: Vec<(u64, Vec<(String, &'static str)>)>,
    falls: Vec<(u64, f64)>,
    slips: Vec<(u64, usize, f64)>,
    events: Vec<(u64, &'a Event)>,
}

#[derive(Serialize)]
struct Text<'a> {
    r#type: &'static str,
    version: u64,
    by: &'a str,
    text: &'a str,
}

#[derive(Serialize)]
struct Found<'a> {
    r#type: &'static str,
    version: u64,
    findings: &'a [Finding],
    good: bool,
}

#[derive(Serialize)]
struct Status<'a> {
    r#type: &'static str,
    playing: bool,
    speed: f64,
    late: bool,
    over: bool,
    outcome: Option<Ended<'a>>,
    /// The text that runs, by version.
    running: u64,
    changed: bool,
    overtaken: bool,
}

impl Session {
    /// Returns the next update for a viewer; none if it knows all.
    pub fn update(&self, viewer: &mut Viewer) -> Option<String> {
        next(self, viewer)
    }
}

fn next(session: &Session, viewer: &mut Viewer) -> Option<String> {
    if viewer.run != session.runs {
        return Some(begin(session, viewer));
    }
    let runner = &session.runner;
    if viewer.cycle < runner.taken() || viewer.cuts != runner.cut_count {
        let Some(cut) = runner.cut_since(viewer.cuts) else {
            return Some(begin(session, viewer));
        };
        return Some(more(session, viewer, cut));
    }
    let draft = &session.draft;
    if viewer.text != draft.version {
        viewer.text = draft.version;
        return Some(json(&Text {
            r#type: "text",
            version: draft.version,
            by: &draft.author,
            text: &draft.text,
        }));
    }
    if viewer.findings != draft.checked() {
        viewer.findings = draft.checked();
        return Some(json(&Found {
            r#type: "findings",
            version: draft.checked(),
            findings: draft.findings(),
            good: draft.program().is_some(),
        }));
    }
    let status = status(session);
    if viewer.status != status {
        viewer.status.clone_from(&status);
        return Some(status);
    }
    None
}

fn begin(session: &Session, viewer: &mut Viewer) -> String {
    let recording = session.runner.recording();
    viewer.run = session.runs;
    viewer.cycle = 0;
    viewer.cuts = session.runner.cut_count;
    viewer.status.clear();
    json(&Begin {
        r#type: "run",
        run: session.runs,
        robot: Robot::of(&recording.robot),
        scene: Scene::of(&recording.scene),
        script: Script::of(&recording.script),
        channels: named(recording).into_iter().map(|it| it.name).collect(),
        inputs: inputs(session),
    })
}

/// The channels of a recording; the first cycle has them all.
fn named(recording: &Recording) -> Vec<Channel> {
    recording.frames.first().map_or(Vec::new(), channels)
}

/// The inputs that a page has sliders for.
fn inputs(session: &Session) -> Vec<String> {
    let ports = (1..=3).map(Port::Knob).chain([Port::Antenna]);
    let ports = ports.chain((1..=9).map(Port::Paw));
    let owned = ports.filter(|port| session.robot().has_input(*port));
    owned.map(|port| port.to_string()).collect()
}

fn more(session: &Session, viewer: &mut Viewer, cut: u64) -> String {
    let runner = &session.runner;
    let recording = runner.recording();
    let from = viewer.cycle.min(cut).min(runner.taken());
    let until = until(recording, from, runner.taken());
    let is_all = until == runner.taken();
    (viewer.cycle, viewer.cuts) = (until, runner.cut_count);
    let channels = named(recording);
    let shown = |frame: &Frame| {
        let value = |channel: &Channel| hundredths((channel.value)(frame).unwrap_or(0.0));
        (frame.cycle, channels.iter().map(value).collect())
    };
    let frames = &recording.frames;
    let frames = &frames[frames.partition_point(|it| it.cycle < from)
        ..frames.partition_point(|it| it.cycle < until)];
    let span = Span { from, until };
    let ticks = recording.clock.iter();
    let ticks = ticks.filter(|tick| span.has(tick.cycle));
    let events = recording.events.iter().filter(|it| span.has(it.cycle));
    json(&More {
        r#type: "more",
        run: session.runs,
        first: runner.first(),
        from,
        cycles: until,
        clock: ticks
            .map(|tick| (tick.cycle, tick.time, tick.period))
            .collect(),
        frames: frames.iter().map(shown).collect(),
        now: runner.pending().filter(|_| is_all).map(shown),
        steps: each(span.of(&recording.steps), |cycle, step| (cycle, *step)),
        contacts: each(span.of(&recording.contacts), |cycle, touch| {
            (cycle, mask(touch))
        }),
        sets: each(span.of(&recording.sets), |cycle, set| {
            (cycle, set.scalar, set.value)
        }),
        messages: each(span.of(&recording.messages), |cycle, text| (cycle, &**text)),
        lamps: each(span.of(&recording.lamps), |cycle, (device, on)| {
            (cycle, *device, *on)
        }),
        commands: each(span.of(&recording.commands), |cycle, asked| {
            let target = asked.target.to_string();
            (cycle, asked.op.name(), target, values(asked))
        }),
        flags: each(span.of(&recording.flags), |cycle, flags| {
            (cycle, words(flags))
        }),
        modes: each(span.of(&recording.modes), |cycle, modes| {
            (cycle, header::named(modes))
        }),
        falls: each(span.of(&recording.falls), |cycle, margin| (cycle, *margin)),
        slips: each(span.of(&recording.slips), |cycle, slip| {
            (cycle, slip.leg, slip.distance)
        }),
        events: events.map(event).collect(),
    })
}

/// Up to which cycle one update may go.
fn until(recording: &Recording, from: u64, taken: u64) -> u64 {
    let after = |place: usize, most: usize, cycle: &dyn Fn(usize) -> Option<u64>| {
        cycle(place + most).map_or(taken, |cycle| cycle.max(from + 1))
    };
    let frames = &recording.frames;
    let frame = frames.partition_point(|it| it.cycle < from);
    let steps = &recording.steps;
    let step = steps.partition_point(|it| it.cycle < from);
    let sets = &recording.sets;
    let set = sets.partition_point(|it| it.cycle < from);
    let limits = [
        after(frame, MOST_FRAMES, &|at| frames.get(at).map(|it| it.cycle)),
        after(step, MOST_THINGS, &|at| steps.get(at).map(|it| it.cycle)),
        after(set, MOST_THINGS, &|at| sets.get(at).map(|it| it.cycle)),
    ];
    limits.into_iter().fold(taken, u64::min)
}

fn status(session: &Session) -> String {
    let runner = &session.runner;
    json(&Status {
        r#type: "status",
        playing: session.is_playing,
        speed: session.speed,
        late: session.is_late,
        over: runner.is_over(),
        outcome: runner.is_over().then(|| Ended::of(runner.recording())),
        running: session.running,
        changed: session.draft.is_changed(),
        overtaken: session.draft.is_overtaken,
    })
}

/// From a cycle up to another one.
#[derive(Clone, Copy)]
struct Span {
    from: u64,
    until: u64,
}

impl Span {
    fn has(self, cycle: u64) -> bool {
        (self.from..self.until).contains(&cycle)
    }

    fn of<T>(self, list: &[At<T>]) -> &[At<T>] {
        let place = |cycle| list.partition_point(|at| at.cycle < cycle);
        &list[place(self.from)..place(self.until)]
    }
}

/// Motion is rounded as in a page: 0.01 mm, deg or N.
fn hundredths(value: f64) -> f64 {
    let rounded = (value * 100.0).round() / 100.0;
    if rounded.is_finite() { rounded } else { 0.0 }
}

/// No value of it can fail to be written.
fn json(update: &impl Serialize) -> String {
    serde_json::to_string(update).unwrap_or_default()
}
