//! A run on a robot with servos that people watch and one of them drives. It goes forward alone.
//!
//! The run itself is elsewhere, on a thread that nothing here delays. A [`DrivenSession`] follows it: its host passes on each cycle
//! with a copy of the run ([`DrivenSession::take_cycle`]) and the [`RobotState`], and takes the [`Order`]s for it. No other request
//! reaches the robot. Who drives, and what happens when the driver falls silent, is a [`Driver`]'s.

use super::Host;
use super::driver::{Driver, Stage};
use super::request::{Answer, ClientRequest, Refusal, Request, is_stop, refuse, refuse_since};
use super::session::Setup;
use super::text::{Buffer, CheckedText, TextChecker, UncheckedText};
use super::viewer::{self, Status, Viewer, Watched};
use crate::RecordError;
use crate::recorder::Recorder;
use crate::recording::{Frame, Outcome, Recording, Script};
use crate::updates::json;
use serde::Serialize;
use tip_runtime::command::Port;
use tip_runtime::record::Ending;
use tip_sim::{Cycle, Event, Events, Interpreter, Robot, Run, Snapshot, Timed};
use tipc::Loaded;
use tipc::program::Program;

/// Something that the driver wants of the run.
#[derive(Clone, Debug)]
pub enum Order {
    /// A key, an input or a variable of the program, before the next step. No key is the emergency stop.
    Happen(Event),
    /// The robot, which has no torque or was left, is to run this program after the next start.
    Prepare(Box<Prepared>),
}

/// A program that a robot is to run.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// The program, without errors.
    pub loaded: Loaded,
    /// Its events.
    pub events: Events,
    /// The version of the text.
    version: u64,
}

/// The phase of a run on servos.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Phase {
    /// It is measured, without torque from this program, until somebody starts it.
    Ready,
    /// The torque is switched on, and joints move to the initial posture.
    Approach,
    /// The program runs, or is paused.
    Running,
    /// The servos get the state in which they are left.
    Leaving,
    /// They have it.
    Left,
}

/// A servo as it was measured last; `None` for what its family does not tell.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ServoState {
    /// The joint.
    pub joint: String,
    /// Identity on the bus.
    pub id: u8,
    /// deg; `None` where the last answer is too old.
    pub angle: Option<f64>,
    /// Part of the stall torque.
    pub load: Option<f64>,
    /// V
    pub voltage: Option<f64>,
    /// °C
    pub temperature: Option<f64>,
    /// Cycles since its last answer.
    pub age: u32,
    /// Number of answers that were missing or damaged.
    pub missing: u64,
    /// Its alarms, or what else is wrong with it.
    pub problem: Option<String>,
}

/// The state of a robot on servos.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RobotState {
    /// The phase of its run.
    pub phase: Phase,
    /// Leg by leg.
    pub servos: Vec<ServoState>,
    /// Answers that were asked for, and that came.
    pub answers: [u64; 2],
    /// Cycles that started late.
    pub late: u64,
    /// Mean time of reading and writing in the last cycles, ms; `None` while nothing is commanded.
    pub bus: Option<f64>,
    /// Sampling time, ms.
    pub period: f64,
    /// Time from the arrival of an emergency stop until the servos were told, ms.
    pub stopped_in: Option<f64>,
    /// The problem that was found last, as a sentence.
    pub problem: Option<String>,
}

impl RobotState {
    /// Creates the state of a robot of which nothing is known.
    pub const fn new() -> Self {
        RobotState {
            phase: Phase::Ready,
            servos: Vec::new(),
            answers: [0; 2],
            late: 0,
            bus: None,
            period: 0.0,
            stopped_in: None,
            problem: None,
        }
    }
}

impl Default for RobotState {
    fn default() -> Self {
        Self::new()
    }
}

/// Adds to the events of a program those that let its sticks rest.
pub type LetRest = fn(&Program, Events) -> Events;

/// A run on a robot with servos, which people watch and one of them drives: see the [module](crate::live).
pub struct DrivenSession {
    robot: Robot,
    events: Events,
    let_rest: LetRest,
    buffer: Buffer,
    recorder: Recorder,
    /// A copy of the run, which reaches no robot; `None` before the program starts.
    copy: Option<Run>,
    is_over: bool,
    first: u64,
    taken: u64,
    runs: u64,
    running: u64,
    state: RobotState,
    stage: Stage,
    orders: Vec<Order>,
}

impl DrivenSession {
    /// Creates the session of a robot without torque, with the order to prepare the program. The host checks the texts.
    ///
    /// # Errors
    /// The diagnostics of a text that is not a program for this robot, or nothing if it cannot run there.
    pub fn new(setup: Setup, let_rest: LetRest) -> Result<Self, Box<Loaded>> {
        let mut buffer = Buffer::new(setup.name, &setup.bytes, setup.options);
        let mut checker = TextChecker::new(setup.robot.clone());
        if let Some(unchecked) = buffer.unchecked() {
            buffer.keep(checker.read(unchecked));
        }
        buffer.forget_given();
        let Some(loaded) = buffer.program().cloned() else {
            let refused = tip_lint::load(buffer.name(), &setup.bytes, &setup.options);
            return Err(Box::new(refused));
        };
        let events = rested(let_rest, &loaded, &setup.events);
        let recorder = preview(&loaded, &setup.robot, &events);
        let recorder = recorder.map_err(|_| Box::new(loaded.clone()))?;
        let mut session = DrivenSession {
            robot: setup.robot,
            events: setup.events,
            let_rest,
            buffer,
            recorder,
            copy: None,
            is_over: false,
            first: 0,
            taken: 1,
            runs: 1,
            running: 1,
            state: RobotState::new(),
            stage: Stage::Paused,
            orders: Vec::new(),
        };
        session.prepare().map_err(|_| Box::new(loaded))?;
        Ok(session)
    }

    /// Orders that the checked text is prepared.
    ///
    /// # Errors
    /// It has errors, or reads inputs that nothing drives.
    fn prepare(&mut self) -> Result<(), Refusal> {
        let (Some(loaded), version) = (self.buffer.program().cloned(), self.buffer.checked())
        else {
            return refuse("errors");
        };
        let events = rested(self.let_rest, &loaded, &self.events);
        if let Some(open) = self.robot.unconnected(&loaded, &events).first() {
            return refuse_since("impossible", open.message());
        }
        self.orders.push(Order::Prepare(Box::new(Prepared {
            loaded,
            events,
            version,
        })));
        Ok(())
    }

    /// Does what a viewer asks for; no answer if the [`TextChecker`] has to give it, or to check the text first.
    pub fn ask(
        &mut self,
        asked: &ClientRequest,
        is_holder: bool,
        host: &mut dyn Host,
    ) -> Option<String> {
        let result = match &asked.request {
            Ok(Request::Hover { .. } | Request::Complete { .. }) => return None,
            Ok(Request::Restart {}) if !self.buffer.is_checked() => return None,
            Ok(request) => self.fulfil(request, is_holder, host),
            Err(refusal) => Err(refusal.clone()),
        };
        Some(Answer::new(asked.id, result.map(|()| None)).text())
    }

    fn fulfil(
        &mut self,
        request: &Request,
        is_holder: bool,
        host: &mut dyn Host,
    ) -> Result<(), Refusal> {
        match request {
            Request::Hover { .. } | Request::Complete { .. } => Ok(()),
            Request::Edit { text, base, by } => self.buffer.take_edit(text, *base, by),
            Request::Save {} => self.buffer.save(host),
            Request::Reload {} => {
                let bytes = host
                    .read()
                    .or_else(|reason| refuse_since("unread", reason))?;
                self.buffer.reload(&bytes);
                Ok(())
            }
            Request::Step { .. } | Request::Go { .. } | Request::Speed { .. } => refuse("forward"),
            // The host has done what it could.
            Request::Take {} | Request::Give {} | Request::Drive(_) => Ok(()),
            Request::Play {} | Request::Pause {} => Ok(()),
            Request::Event { event } if is_holder || is_stop(event) => self.give(event),
            Request::Restart {} if is_holder => self.restart(),
            Request::Restart {} | Request::Event { .. } => refuse("watching"),
        }
    }

    fn give(&mut self, event: &Event) -> Result<(), Refusal> {
        if is_stop(event) {
            // The host has stopped the robot.
            return Ok(());
        }
        let Some(run) = self.copy.as_ref().filter(|_| !self.is_over) else {
            return refuse("still");
        };
        match event {
            Event::Key(_) | Event::Halt | Event::Sensor(..) | Event::Set(..) => {}
            _ => return refuse("forward"),
        }
        run.accepts(event)
            .or_else(|reason| refuse_since("impossible", reason))?;
        self.orders.push(Order::Happen(event.clone()));
        Ok(())
    }

    /// Prepares the text of the editor for the next start.
    fn restart(&mut self) -> Result<(), Refusal> {
        if !matches!(self.state.phase, Phase::Ready | Phase::Left) {
            return refuse("moving");
        }
        let Some(loaded) = self.buffer.program() else {
            return refuse("errors");
        };
        let events = rested(self.let_rest, loaded, &self.events);
        let shown = preview(loaded, &self.robot, &events);
        let recorder = shown.or_else(|reason| refuse_since("impossible", reason))?;
        self.prepare()?;
        self.recorder = recorder;
        (self.copy, self.is_over) = (None, false);
        (self.first, self.taken) = (0, 1);
        self.runs += 1;
        self.running = self.buffer.checked();
        // Until the host says so, nobody asks for it again.
        self.state.phase = Phase::Ready;
        Ok(())
    }

    /// Takes the orders for the run.
    pub fn take_orders(&mut self) -> Vec<Order> {
        std::mem::take(&mut self.orders)
    }

    /// Begins a run: `copy` is one of it before its first cycle.
    pub fn begin(&mut self, copy: Run, prepared: &Prepared) {
        let Some(program) = &prepared.loaded.program else {
            return;
        };
        let script = Script::of(&prepared.loaded.source, program);
        self.recorder = Recorder::new(&self.robot, script);
        self.recorder.recording.events = copy.all_events().all().to_vec();
        (self.copy, self.is_over) = (Some(copy), false);
        (self.first, self.taken) = (0, 0);
        self.runs += 1;
        self.running = prepared.version;
    }

    /// Records something that happens to the run.
    pub fn take_event(&mut self, event: Timed) {
        self.recorder.recording.events.push(event);
    }

    /// Records a cycle, with the state of the run after it.
    pub fn take_cycle(&mut self, cycle: Cycle, after: &Snapshot) {
        let Some(copy) = &mut self.copy else {
            return;
        };
        copy.restore(after);
        self.taken = cycle.number + 1;
        self.recorder.take(cycle, copy, None);
        let (now, ending) = (copy.time(), copy.ending());
        if let Some(ending) = ending {
            self.end(ending);
        }
        if let Some(cycle) = self.recorder.recording.long_ago(now) {
            self.first = cycle;
            self.recorder.recording.forget(cycle);
        }
    }

    /// Records the end of the run.
    pub fn end(&mut self, ending: Ending) {
        if !std::mem::replace(&mut self.is_over, true) {
            self.recorder.recording.outcome = Outcome::from(ending);
        }
    }

    /// Sets the state of the robot, and what it may do.
    pub fn set_state(&mut self, state: RobotState, stage: Stage) {
        (self.state, self.stage) = (state, stage);
    }

    /// Takes over a changed file, unless an edited text stands in its place. Nothing runs because of it.
    pub fn file_changed(&mut self, bytes: &[u8]) {
        if self.buffer.is_file(bytes) {
            return;
        }
        match self.buffer.is_changed() {
            true => self.buffer.is_overtaken = true,
            false => self.buffer.reload(bytes),
        }
    }

    /// Returns the text that is to be checked, once.
    pub fn unchecked(&mut self) -> Option<UncheckedText> {
        self.buffer.unchecked()
    }

    /// Takes what was found in a text.
    pub fn checked(&mut self, reading: CheckedText) {
        self.buffer.keep(reading);
    }

    /// Returns the next update for a viewer, by the number that the driver knows it by; none if it has everything.
    pub fn update(&self, viewer: &mut Viewer, id: u64, driver: &Driver) -> Option<String> {
        if let Some(update) = viewer::update(self, viewer) {
            return Some(update);
        }
        let update = json(&RobotUpdate {
            r#type: "robot",
            driver: driver.holder() == Some(id),
            held: driver.holder().is_some(),
            asked: driver.asker().is_some(),
            hold: driver.rules().hold_to_drive,
            stage: self.stage,
            state: &self.state,
        });
        if viewer.robot == update {
            return None;
        }
        viewer.robot.clone_from(&update);
        Some(update)
    }
}

/// Returns the events of a program whose sticks rest.
fn rested(let_rest: LetRest, loaded: &Loaded, events: &Events) -> Events {
    match &loaded.program {
        Some(program) => let_rest(program, events.clone()),
        None => events.clone(),
    }
}

/// Returns a recording of the initial posture, by the first cycle of a simulated run: before the start there is something to see.
fn preview(loaded: &Loaded, robot: &Robot, events: &Events) -> Result<Recorder, RecordError> {
    let program = loaded.program.as_ref().ok_or(RecordError::NoProgram)?;
    let run = Run::new(Interpreter::new(program.clone()), robot.clone());
    let mut run = run.map_err(RecordError::Mismatch)?;
    let mut recorder = Recorder::new(robot, Script::of(&loaded.source, program));
    let cycle = run.cycle();
    recorder.take(cycle, &run, None);
    recorder.recording.events = events.all().to_vec();
    Ok(recorder)
}

#[derive(Serialize)]
struct RobotUpdate<'a> {
    r#type: &'static str,
    /// True if this viewer holds the robot.
    driver: bool,
    /// True if somebody does.
    held: bool,
    /// True if another one asks for it.
    asked: bool,
    /// True if the robot moves only while the button is held.
    hold: bool,
    stage: Stage,
    #[serde(flatten)]
    state: &'a RobotState,
}

impl Watched for DrivenSession {
    fn runs(&self) -> u64 {
        self.runs
    }

    fn recording(&self) -> &Recording {
        &self.recorder.recording
    }

    fn taken(&self) -> u64 {
        self.taken
    }

    fn first(&self) -> u64 {
        self.first
    }

    fn pending(&self) -> Option<&Frame> {
        self.recorder.pending.as_ref()
    }

    fn buffer(&self) -> &Buffer {
        &self.buffer
    }

    fn inputs(&self) -> Vec<String> {
        (1..=3).map(|n| Port::Knob(n).to_string()).collect()
    }

    fn status(&self) -> Status<'_> {
        let runs = self.state.phase == Phase::Running && self.stage != Stage::Paused;
        Status {
            playing: runs && !self.is_over,
            speed: 1.0,
            late: false,
            over: self.is_over,
            summary: (!runs).then(|| self.recorder.summary.summary()),
            running: self.running,
        }
    }
}

impl std::fmt::Debug for DrivenSession {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("DrivenSession")
            .field("run", &self.runs)
            .field("cycles", &self.taken)
            .field("state", &self.state)
            .finish_non_exhaustive()
    }
}
