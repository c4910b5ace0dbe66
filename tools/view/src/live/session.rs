//! A program that runs, the text that becomes the next one, what viewers do to both, and the news for each viewer.

use super::request::{
    Answer, ClientRequest, PageDiagnostic, Refusal, Request, is_stop, refuse, refuse_since,
};
use super::runner::Runner;
use super::text::{Buffer, CheckedText, TextChecker, UncheckedText};
use super::{Host, MOST_BYTES};
use crate::recording::Recording;
use crate::updates::{self, Ended, Part, json};
use serde::Serialize;
use tip_runtime::command::Port;
use tip_sim::{Event, Events, Robot, Summary};
use tipc::{Loaded, Options};

/// Range of speeds of a run, as multiples of the robot's own.
const SPEEDS: std::ops::RangeInclusive<f64> = 0.05..=100.0;
/// A run that cannot keep up leaves out what is more than this: ms of the viewers' time.
const LATE: f64 = 100.0;
/// The most cycles of one step.
const STEP: i64 = 1000;
/// The longest name by which a viewer calls itself.
const NAME: usize = 64;

/// The setup of a session.
#[derive(Clone, Debug)]
pub struct Setup {
    /// The name of the program's file.
    pub name: String,
    /// The file.
    pub bytes: Vec<u8>,
    /// The robot, in its scene.
    pub robot: Robot,
    /// Options for reading the file.
    pub options: Options,
    /// Events of each run.
    pub events: Events,
    /// After how many cycles a run rests, if it has not been asked to earlier.
    pub rest: Option<u64>,
}

impl Setup {
    /// Creates a program on a robot to which nothing happens.
    pub fn new(name: &str, bytes: &[u8], robot: Robot) -> Self {
        Setup {
            name: name.to_owned(),
            bytes: bytes.to_owned(),
            options: robot.options(),
            robot,
            events: Events::NONE,
            rest: None,
        }
    }
}

/// A live run: see the [module](crate::live).
pub struct Session {
    robot: Robot,
    events: Events,
    rest: Option<u64>,
    /// The checker of the text, unless the host checks it.
    checker: Option<TextChecker>,
    buffer: Buffer,
    /// The text of this version runs once it is checked.
    runs_next: Option<u64>,
    runner: Runner,
    /// Counts the runs, from 1.
    runs: u64,
    /// The version of the text that runs.
    running: u64,
    is_playing: bool,
    speed: f64,
    /// Time of the robot that has passed and that it has not run, ms.
    owed: f64,
    /// True if the run was too slow for its speed just now.
    is_late: bool,
}

impl Session {
    /// Creates a program before its second cycle, at rest.
    ///
    /// # Errors
    /// The diagnostics of a text that is not a program for this robot, or nothing if the events
    /// cannot happen to it.
    pub fn new(setup: Setup) -> Result<Self, Box<Loaded>> {
        let Setup {
            name,
            bytes,
            robot,
            options,
            events,
            rest,
        } = setup;
        let mut buffer = Buffer::new(name.clone(), &bytes, options);
        let mut checker = TextChecker::new(robot.clone());
        if let Some(unchecked) = buffer.unchecked() {
            buffer.keep(checker.read(unchecked));
        }
        let refused = || Box::new(tip_lint::load(&name, &bytes, &options));
        let loaded = buffer.program().ok_or_else(refused)?;
        let runner =
            Runner::begin(loaded, &robot, &events).map_err(|_| Box::new(loaded.clone()))?;
        Ok(Session {
            robot,
            events,
            rest,
            checker: Some(checker),
            buffer,
            runs_next: None,
            runner,
            runs: 1,
            running: 1,
            is_playing: false,
            speed: 1.0,
            owed: 0.0,
            is_late: false,
        })
    }

    /// Lets the run go on from now on, unless it is over.
    pub fn play(&mut self) {
        self.is_playing = !self.runner.is_over();
    }

    /// Advances by the time that has passed for the viewers, ms, as long as `goes_on` agrees, and
    /// checks a text that was edited.
    pub fn advance(&mut self, elapsed: f64, mut goes_on: impl FnMut() -> bool) {
        self.check();
        if !self.is_playing {
            return;
        }
        self.owed += elapsed.max(0.0) * self.speed;
        self.is_late = false;
        loop {
            let period = self.runner.run().period().max(0.01);
            if self.owed < period {
                return;
            }
            if !goes_on() {
                self.is_late = self.owed > LATE * self.speed;
                self.owed = self.owed.min(LATE * self.speed);
                return;
            }
            self.owed -= period;
            self.runner.cycle();
            let rests = self.rest.is_some_and(|rest| self.runner.taken() >= rest);
            if rests {
                self.rest = None;
            }
            if rests || self.runner.is_over() {
                self.pause();
                return;
            }
        }
    }

    /// Does what a viewer asks for, a JSON object, and answers with another one. Nothing that is sent does harm: what is no
    /// request is refused.
    pub fn request(&mut self, text: &str, host: &mut dyn Host) -> String {
        let asked = ClientRequest::read(text);
        if let Some(answer) = self.ask(&asked, host) {
            return answer;
        }
        self.check();
        let answer = self.ask(&asked, host);
        let known = || self.checker.as_ref()?.answer(&asked);
        answer
            .or_else(known)
            .unwrap_or_else(|| asked.refused_many())
    }

    /// Does what a viewer asks for; no answer if the [`TextChecker`] has to give it, or to check the text first.
    pub fn ask(&mut self, asked: &ClientRequest, host: &mut dyn Host) -> Option<String> {
        let result = match &asked.request {
            Ok(Request::Hover { .. } | Request::Complete { .. }) => return None,
            Ok(Request::Restart {}) if !self.buffer.is_checked() => return None,
            Ok(request) => self.fulfil(request, host),
            Err(refusal) => Err(refusal.clone()),
        };
        Some(Answer::new(asked.id, result.map(|()| None)).text())
    }

    /// Stops checking texts in the session, because long texts take long. The caller then passes each
    /// [`Session::unchecked`] text to a [`TextChecker`], and its result to [`Session::checked`].
    pub fn hand_over(&mut self) {
        self.checker = None;
        self.buffer.forget_given();
    }

    /// Returns the text that is to be checked, once.
    pub fn unchecked(&mut self) -> Option<UncheckedText> {
        self.buffer.unchecked()
    }

    /// Takes what was found in a text.
    pub fn checked(&mut self, reading: CheckedText) {
        self.buffer.keep(reading);
        if self.runs_next == Some(self.buffer.checked()) {
            self.runs_next = None;
            // With errors in the text the run before goes on.
            let _ = self.restart();
        }
    }

    /// Checks the text, if it has changed and the host does not check it.
    fn check(&mut self) {
        let Some(mut checker) = self.checker.take() else {
            return;
        };
        if let Some(unchecked) = self.buffer.unchecked() {
            self.checked(checker.read(unchecked));
        }
        self.checker = Some(checker);
    }

    fn fulfil(&mut self, request: &Request, host: &mut dyn Host) -> Result<(), Refusal> {
        match request {
            // The reader answers.
            Request::Hover { .. } | Request::Complete { .. } => Ok(()),
            Request::Play {} if self.runner.is_over() => refuse("over"),
            Request::Play {} => {
                self.play();
                Ok(())
            }
            Request::Pause {} => {
                self.pause();
                Ok(())
            }
            Request::Step { cycles } => {
                let cycles = (*cycles).clamp(-STEP, STEP);
                self.go_to(self.runner.taken().saturating_add_signed(cycles));
                Ok(())
            }
            Request::Go { cycle } => self.go(*cycle),
            Request::Speed { times } if SPEEDS.contains(times) => {
                self.speed = *times;
                self.owed = 0.0;
                Ok(())
            }
            Request::Speed { times } => refuse_since("impossible", times),
            Request::Event { event } => self.give(event),
            Request::Restart {} => {
                self.restart()?;
                self.play();
                Ok(())
            }
            Request::Edit { text, base, by } => self.edit(text, *base, by),
            Request::Save {} => self.save(host),
            Request::Reload {} => match host.read() {
                Ok(bytes) => {
                    self.load(&bytes);
                    Ok(())
                }
                Err(reason) => refuse_since("unread", reason),
            },
        }
    }

    fn pause(&mut self) {
        self.is_playing = false;
        self.is_late = false;
        self.owed = 0.0;
    }

    fn go_to(&mut self, taken: u64) {
        self.pause();
        self.runner.go_to(taken);
    }

    fn go(&mut self, cycle: u64) -> Result<(), Refusal> {
        if cycle < self.runner.first() || cycle >= self.runner.taken() {
            return refuse_since("impossible", cycle);
        }
        self.go_to(cycle + 1);
        Ok(())
    }

    fn give(&mut self, event: &Event) -> Result<(), Refusal> {
        let stops = is_stop(event);
        if stops {
            self.runs_next = None;
        }
        self.runner.give(event.clone())?;
        // A robot at rest stops as well: the key is read in one cycle, and acts in it or in the next.
        if stops && !self.is_playing {
            self.runner.cycle();
            self.runner.cycle();
        }
        Ok(())
    }

    /// Runs the text from the beginning, as a changed file does: it rests if the run before it rests.
    fn restart(&mut self) -> Result<(), Refusal> {
        let Some(loaded) = self.buffer.program() else {
            return refuse("errors");
        };
        let rests = !self.is_playing && !self.runner.is_over();
        match Runner::begin(loaded, &self.robot, &self.events) {
            Ok(runner) => self.runner = runner,
            Err(reason) => return refuse_since("impossible", reason),
        }
        self.runs += 1;
        self.running = self.buffer.checked();
        self.owed = 0.0;
        self.is_playing = !rests && !self.runner.is_over();
        Ok(())
    }

    fn edit(&mut self, text: &str, base: u64, by: &str) -> Result<(), Refusal> {
        if base != self.buffer.version {
            return refuse("stale");
        }
        if by.len() > NAME || text.len() > MOST_BYTES {
            return refuse("long");
        }
        self.buffer.edit(text, by.to_owned());
        Ok(())
    }

    fn save(&mut self, host: &mut dyn Host) -> Result<(), Refusal> {
        let bytes = match self.buffer.bytes() {
            Ok(bytes) => bytes,
            Err(char) => return refuse_since("unspelled", char),
        };
        match host.write(&bytes) {
            Ok(()) => self.buffer.saved(&bytes),
            Err(reason) => return refuse_since("unsaved", reason),
        }
        Ok(())
    }

    /// Takes over a changed file. Its text takes the place of one that nobody has edited, and runs if it is a program; an edited
    /// text stays, and viewers learn of it.
    pub fn file_changed(&mut self, bytes: &[u8]) {
        if self.buffer.is_file(bytes) {
            return;
        }
        match self.buffer.is_changed() {
            true => self.buffer.is_overtaken = true,
            false => self.load(bytes),
        }
    }

    /// Takes the text of the file, and runs it once it is checked, if it is a program.
    fn load(&mut self, bytes: &[u8]) {
        self.buffer.reload(bytes);
        self.runs_next = Some(self.buffer.version);
        self.check();
    }

    /// Returns the number of cycles that have run, as far as the run has not been taken back.
    pub fn cycles(&self) -> u64 {
        self.runner.taken()
    }

    /// Returns a hash of the commands to each joint and its readings in the last cycle.
    pub fn state_hash(&self) -> u64 {
        self.runner.run().state_hash()
    }
}

impl std::fmt::Debug for Session {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Session")
            .field("run", &self.runs)
            .field("cycles", &self.cycles())
            .field("is_playing", &self.is_playing)
            .finish_non_exhaustive()
    }
}

/// The most frames of one update; who has seen nothing gets several.
const MOST_FRAMES: usize = 1000;
/// The most entries of the log in one update.
const MOST_ENTRIES: usize = 20_000;

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
    /// The figures so far, while the run rests.
    summary: Option<&'a Summary>,
    /// The text that runs, by version.
    running: u64,
    changed: bool,
    overtaken: bool,
}

impl Session {
    /// Returns the next update for a viewer; none if it has everything.
    pub fn update(&self, viewer: &mut Viewer) -> Option<String> {
        if viewer.run != self.runs {
            return Some(begin(self, viewer));
        }
        let runner = &self.runner;
        if viewer.cycle < runner.taken() || viewer.cuts != runner.cut_count {
            let Some(cut) = runner.cut_since(viewer.cuts) else {
                return Some(begin(self, viewer));
            };
            return Some(more(self, viewer, cut));
        }
        let buffer = &self.buffer;
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
        let status = status(self);
        if viewer.status != status {
            viewer.status.clone_from(&status);
            return Some(status);
        }
        None
    }
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
    let owned = ports.filter(|port| session.robot.has_input(*port));
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
    let log = &recording.log;
    let entry = log.partition_point(|it| it.cycle < from);
    let limits = [
        after(frame, MOST_FRAMES, &|at| frames.get(at).map(|it| it.cycle)),
        after(entry, MOST_ENTRIES, &|at| log.get(at).map(|it| it.cycle)),
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
        summary: (!session.is_playing).then(|| runner.summary()),
        outcome: runner.is_over().then(|| Ended::of(runner.recording())),
        running: session.running,
        changed: session.buffer.is_changed(),
        overtaken: session.buffer.is_overtaken,
    })
}
