//! The news of a session for each of its viewers.

use super::request::PageDiagnostic;
use super::text::Buffer;
use crate::recording::{Frame, Recording};
use crate::updates::{self, Ended, Part, json};
use serde::Serialize;
use tip_sim::Summary;

/// The most frames of one update; who has seen nothing gets several.
const MOST_FRAMES: usize = 1000;
/// The most entries of the log in one update.
const MOST_ENTRIES: usize = 20_000;

/// The state that one viewer has.
#[derive(Clone, Debug, Default)]
pub struct Viewer {
    /// The run that it sees; the first one is 1.
    pub(super) run: u64,
    /// Cycle of that run up to which the viewer has everything.
    cycle: u64,
    /// Number of times that the run had been taken back.
    pub(super) cuts: u64,
    /// The text, by version.
    text: u64,
    /// Version of the text whose diagnostics the viewer has.
    findings: u64,
    /// Status of the run.
    status: String,
    /// State of a robot on servos, or of a lesson.
    pub(super) robot: String,
}

/// A session as its viewers see it.
pub(super) trait Watched {
    /// Returns the number of runs so far.
    fn runs(&self) -> u64;
    fn recording(&self) -> &Recording;
    /// Returns the number of recorded cycles.
    fn taken(&self) -> u64;
    /// Returns the first cycle that is still known.
    fn first(&self) -> u64;
    /// Returns the robot's last state, if it is not among the frames.
    fn pending(&self) -> Option<&Frame>;

    /// Returns the number of times that the run was taken back.
    fn cuts(&self) -> u64 {
        0
    }

    /// Returns the first cycle that all later cuts left, for someone who knows of so many cuts; none if that is too long ago.
    fn cut_since(&self, known: u64) -> Option<u64> {
        let _ = known;
        Some(u64::MAX)
    }

    fn buffer(&self) -> &Buffer;
    /// Returns the inputs that a page has sliders for.
    fn inputs(&self) -> Vec<String>;
    fn status(&self) -> Status<'_>;
}

/// The state of a run.
pub(super) struct Status<'a> {
    pub(super) playing: bool,
    pub(super) speed: f64,
    /// True if the run does not keep up with its speed.
    pub(super) late: bool,
    pub(super) over: bool,
    /// The figures so far, while the run rests.
    pub(super) summary: Option<&'a Summary>,
    /// The text that runs, by version.
    pub(super) running: u64,
}

#[derive(Serialize)]
struct TextUpdate<'a> {
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
struct StatusUpdate<'a> {
    r#type: &'static str,
    playing: bool,
    speed: f64,
    late: bool,
    over: bool,
    outcome: Option<Ended<'a>>,
    summary: Option<&'a Summary>,
    running: u64,
    changed: bool,
    overtaken: bool,
}

/// Returns the next update for a viewer; none if it has everything.
pub(super) fn update(session: &impl Watched, viewer: &mut Viewer) -> Option<String> {
    if viewer.run != session.runs() {
        return Some(begin(session, viewer));
    }
    if viewer.cycle < session.taken() || viewer.cuts != session.cuts() {
        let Some(cut) = session.cut_since(viewer.cuts) else {
            return Some(begin(session, viewer));
        };
        return Some(more(session, viewer, cut));
    }
    let buffer = session.buffer();
    if viewer.text != buffer.version {
        viewer.text = buffer.version;
        return Some(json(&TextUpdate {
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

fn begin(session: &impl Watched, viewer: &mut Viewer) -> String {
    viewer.run = session.runs();
    viewer.cycle = 0;
    viewer.cuts = session.cuts();
    viewer.status.clear();
    updates::begin(session.recording(), session.runs(), &session.inputs())
}

fn more(session: &impl Watched, viewer: &mut Viewer, cut: u64) -> String {
    let recording = session.recording();
    let from = viewer.cycle.min(cut).min(session.taken());
    let until = until(recording, from, session.taken());
    let is_all = until == session.taken();
    (viewer.cycle, viewer.cuts) = (until, session.cuts());
    let part = Part {
        run: session.runs(),
        first: session.first(),
        from,
        until,
        cycles: until,
        now: session.pending().filter(|_| is_all),
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
    let log = &recording.log;
    let entry = log.partition_point(|it| it.cycle < from);
    let limits = [
        after(frame, MOST_FRAMES, &|at| frames.get(at).map(|it| it.cycle)),
        after(entry, MOST_ENTRIES, &|at| log.get(at).map(|it| it.cycle)),
    ];
    limits.into_iter().fold(taken, u64::min)
}

fn status(session: &impl Watched) -> String {
    let status = session.status();
    let buffer = session.buffer();
    json(&StatusUpdate {
        r#type: "status",
        playing: status.playing,
        speed: status.speed,
        late: status.late,
        over: status.over,
        outcome: status.over.then(|| Ended::of(session.recording())),
        summary: status.summary,
        running: status.running,
        changed: buffer.is_changed(),
        overtaken: buffer.is_overtaken,
    })
}
