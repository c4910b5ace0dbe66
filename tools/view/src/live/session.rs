//! A program that runs on a simulated robot, the text that becomes the next one, and what viewers do to both.

use super::Host;
use super::request::{Answer, ClientRequest, Refusal, Request, is_stop, refuse, refuse_since};
use super::runner::Runner;
use super::text::{Buffer, CheckedText, TextChecker, UncheckedText};
use super::viewer::{self, Status, Viewer, Watched};
use crate::recording::{Frame, Recording};
use tip_runtime::command::Port;
use tip_sim::{Event, Events, Robot};
use tipc::{Loaded, Options};

/// Range of speeds of a run, as multiples of the robot's own.
const SPEEDS: std::ops::RangeInclusive<f64> = 0.05..=100.0;
/// A run that cannot keep up leaves out what is more than this: ms of the viewers' time.
const LATE: f64 = 100.0;
/// The most cycles of one step.
const STEP: i64 = 1000;

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
            Request::Edit { text, base, by } => self.buffer.take_edit(text, *base, by),
            Request::Save {} => self.buffer.save(host),
            Request::Reload {} => match host.read() {
                Ok(bytes) => {
                    self.load(&bytes);
                    Ok(())
                }
                Err(reason) => refuse_since("unread", reason),
            },
            Request::Take {} | Request::Give {} | Request::Drive(_) => refuse("simulated"),
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

    /// Returns the next update for a viewer; none if it has everything.
    pub fn update(&self, viewer: &mut Viewer) -> Option<String> {
        viewer::update(self, viewer)
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

impl Watched for Session {
    fn runs(&self) -> u64 {
        self.runs
    }

    fn recording(&self) -> &Recording {
        self.runner.recording()
    }

    fn taken(&self) -> u64 {
        self.runner.taken()
    }

    fn first(&self) -> u64 {
        self.runner.first()
    }

    fn pending(&self) -> Option<&Frame> {
        self.runner.pending()
    }

    fn cuts(&self) -> u64 {
        self.runner.cut_count
    }

    fn cut_since(&self, known: u64) -> Option<u64> {
        self.runner.cut_since(known)
    }

    fn buffer(&self) -> &Buffer {
        &self.buffer
    }

    fn inputs(&self) -> Vec<String> {
        let ports = (1..=3).map(Port::Knob).chain([Port::Antenna]);
        let ports = ports.chain((1..=9).map(Port::Paw));
        let owned = ports.filter(|port| self.robot.has_input(*port));
        owned.map(|port| port.to_string()).collect()
    }

    fn status(&self) -> Status<'_> {
        let runner = &self.runner;
        Status {
            playing: self.is_playing,
            speed: self.speed,
            late: self.is_late,
            over: runner.is_over(),
            summary: (!self.is_playing).then(|| runner.summary()),
            running: self.running,
        }
    }
}
