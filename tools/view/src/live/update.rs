//! The news for a viewer.

use super::language_service::PageDiagnostic;
use super::session::Session;
use crate::recording::Recording;
use crate::updates::{self, Ended, Part, json};
use serde::Serialize;
use tip_runtime::command::Port;

/// The most frames of one update; who has seen nothing gets several.
const MOST_FRAMES: usize = 1000;
/// The most other things of one kind.
const MOST_THINGS: usize = 20_000;

/// The state that one viewer has.
#[derive(Clone, Debug, Default)]
pub struct Viewer {
    /// The run that it sees; the first one is 1.
    run: u64,
    /// Cycle of that run up to which the viewer has everything.
    cycle: u64,
    /// Number of times that the run had been taken back.
    cuts: u64,
    /// The text, by version.
    text: u64,
    /// Version of the text whose diagnostics the viewer has.
    findings: u64,
    /// Status of the run.
    status: String,
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
    findings: &'a [PageDiagnostic],
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
    /// Returns the next update for a viewer; none if it has everything.
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
    let buffer = &session.buffer;
    if viewer.text != buffer.version {
        viewer.text = buffer.version;
        return Some(json(&Text {
            r#type: "text",
            version: buffer.version,
            by: &buffer.author,
            text: &buffer.text,
        }));
    }
    if viewer.findings != buffer.checked() {
        viewer.findings = buffer.checked();
        return Some(json(&Found {
            r#type: "findings",
            version: buffer.checked(),
            findings: buffer.findings(),
            good: buffer.program().is_some(),
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
    updates::begin(recording, session.runs, &inputs(session))
}

/// Returns the inputs that a page has sliders for.
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
    let part = Part {
        run: session.runs,
        first: runner.first(),
        from,
        until,
        cycles: until,
        now: runner.pending().filter(|_| is_all),
    };
    updates::more(recording, &part)
}

/// Returns the cycle up to which one update may go.
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
        changed: session.buffer.is_changed(),
        overtaken: session.buffer.is_overtaken,
    })
}
