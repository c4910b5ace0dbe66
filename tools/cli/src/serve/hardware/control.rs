//! The control cycle of a served robot: from the servos without torque through the slow way to the initial posture and the run to the
//! state in which they are left, and again from there.

use crate::drives::realtime::{self, wait_until};
use crate::drives::robot::{Connection, report_stiff};
use crate::run::files::Trace;
use crate::serve::controls::Controls;
use crate::{Status, input, interrupt, report, sticks};
use std::io::{self, IsTerminal, Sink};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender};
use std::time::{Duration, Instant};
use tip_drives::drives::Failure;
use tip_drives::guard::{Request, SETTLING, Step};
use tip_runtime::command::Port;
use tip_runtime::console::{Console, Terminal};
use tip_runtime::realtime::Pacer;
use tip_runtime::record::Ending;
use tip_sim::{Cycle, Event, Interpreter, Robot, Run, Snapshot, Timed};
use tip_view::live::{DrivenSession, Order, Phase, Prepared, RobotState, STICKS, Stage};
use tipc::message::Lang;

/// Time between two measurements of a robot that does not move.
const MEASURING: Duration = Duration::from_millis(50);
/// Time between two reports of all servos.
const REPORTING: Duration = Duration::from_millis(200);
/// Most orders of one cycle.
const MAX_ORDERS: usize = 64;
/// The byte of the key RETURN.
const RETURN: u8 = 0x0D;

/// A report of the control cycle.
pub(super) enum Report {
    /// A run begins; this is a copy of it before its first cycle.
    Begun(Box<(Run, Arc<Prepared>)>),
    /// An event happens to the run.
    Happened(Timed),
    /// A cycle was run; the snapshot is the run's state after it.
    Cycle(Box<(Cycle, Snapshot)>),
    /// The run ends in order before its program does.
    Ended(Ending),
    /// The state of the robot, and what it may do.
    State(Box<RobotState>, Stage),
}

impl Report {
    /// Tells a session.
    pub(super) fn tell(self, session: &mut DrivenSession) {
        match self {
            Report::Begun(begun) => {
                let (copy, prepared) = *begun;
                session.begin(copy, &prepared);
            }
            Report::Happened(event) => session.take_event(event),
            Report::Cycle(cycle) => {
                let (cycle, after) = *cycle;
                session.take_cycle(cycle, &after);
            }
            Report::Ended(ending) => session.end(ending),
            Report::State(state, stage) => session.set_state(*state, stage),
        }
    }
}

/// The keys of a run: those of the terminal, and the emergency stop from anywhere.
struct Keys {
    controls: Arc<Controls>,
    keyboard: Option<Terminal<Sink>>,
}

impl Console for Keys {
    fn key(&mut self, cycle: u64) -> Option<u8> {
        if self.controls.is_stopped() {
            return Some(RETURN);
        }
        let keyboard = self.keyboard.as_mut()?;
        let key = keyboard.key(cycle);
        if keyboard.interrupted() {
            interrupt::request();
        }
        key
    }
}

/// The place from which a robot is started.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Starter {
    Page,
    Terminal,
}

/// The control cycle.
pub(super) struct Control {
    connection: Connection,
    robot: Robot,
    controls: Arc<Controls>,
    orders: Receiver<Order>,
    reports: Sender<Report>,
    /// The program that runs after the next start.
    next: Option<Arc<Prepared>>,
    state: RobotState,
    stage: Stage,
    /// The time of the next report of all servos.
    due: Instant,
    /// Time on the bus, µs, and number of commanded cycles until the last report.
    reported: (u64, u64),
    /// The file of the trace.
    trace: Option<PathBuf>,
    lang: Lang,
}

impl Control {
    pub(super) fn new(
        connection: Connection,
        robot: Robot,
        controls: Arc<Controls>,
        (orders, reports): (Receiver<Order>, Sender<Report>),
        trace: Option<PathBuf>,
        lang: Lang,
    ) -> Self {
        Control {
            state: RobotState {
                period: connection.period(),
                ..RobotState::new()
            },
            connection,
            robot,
            controls,
            orders,
            reports,
            next: None,
            stage: Stage::Paused,
            due: Instant::now(),
            reported: (0, 0),
            trace,
            lang,
        }
    }

    /// Works until the command is to end. The robot is left then.
    pub(super) fn work(mut self, has_priority: bool) -> Status {
        if has_priority {
            realtime::warn(realtime::prioritise(), self.lang);
        }
        let mut has_moved = false;
        while let Some(starter) = self.await_start() {
            if !self.drive(starter) {
                continue;
            }
            has_moved = true;
            self.controls.driver().end();
            if !self.await_program() {
                break;
            }
        }
        if !has_moved {
            report_stiff(&self.connection, self.lang);
        }
        Status::Interrupted
    }

    /// Measures the robot until somebody starts it; `None` if the command is to end.
    fn await_start(&mut self) -> Option<Starter> {
        input::forget_typed();
        let is_terminal = io::stdin().is_terminal();
        self.controls.reset();
        self.state.stopped_in = None;
        self.enter(Phase::Ready);
        loop {
            if interrupt::is_requested() {
                return None;
            }
            self.take_program();
            self.measure();
            if self.controls.is_stopped() {
                self.controls.reset();
            }
            // Keys other than the one that starts are discarded: the program must not read them later.
            while self.connection.key().is_some() {}
            let is_typed = is_terminal && self.connection.request() == Some(Request::EmergencyStop);
            let now = self.controls.now();
            let is_held = self.controls.driver().is_armed(now);
            let is_well = self.state.problem.is_none() && self.next.is_some();
            if (is_typed || is_held) && is_well {
                return Some(match is_typed {
                    true => Starter::Terminal,
                    false => Starter::Page,
                });
            }
            self.report_servos();
            wait_until(Instant::now() + MEASURING);
        }
    }

    /// Waits for a program to run after a robot was left; returns false if the command is to end.
    fn await_program(&mut self) -> bool {
        self.enter(Phase::Left);
        let problem = self.state.problem.take();
        loop {
            if interrupt::is_requested() {
                return false;
            }
            if self.take_program() {
                return true;
            }
            self.measure();
            // What ended the run is shown until the next one.
            self.state.problem.clone_from(&problem);
            self.report_servos();
            wait_until(Instant::now() + MEASURING);
        }
    }

    /// Takes the orders to a robot that does not move; returns true if there is another program.
    fn take_program(&mut self) -> bool {
        let mut is_new = false;
        while let Ok(order) = self.orders.try_recv() {
            if let Order::Prepare(prepared) = order {
                self.next = Some(Arc::new(*prepared));
                self.controls.driver().disarm();
                is_new = true;
            }
        }
        is_new
    }

    /// Reads the servos of a robot that does not move; one that did not answer is looked for again.
    fn measure(&mut self) {
        let measured = match self.state.problem {
            None => self.connection.measure(),
            Some(_) => self.connection.robot().connect(),
        };
        self.state.problem = measured
            .err()
            .map(|failure| self.connection.explain(failure));
    }

    /// Moves the robot to its initial posture, runs the program, and leaves the robot. Returns false if the torque was not switched
    /// on.
    fn drive(&mut self, starter: Starter) -> bool {
        let Some(prepared) = self.next.clone() else {
            return false;
        };
        let connected = self.connection.robot().connect();
        let run = match (connected, self.new_run(&prepared)) {
            (Ok(()), Ok(run)) => run,
            (Err(failure), _) => return self.refuse(self.connection.explain(failure)),
            (_, Err(reason)) => return self.refuse(reason),
        };
        let initial = self.connection.setup.initial.clone();
        if let Some(reason) = self.connection.refusal_of_way(&[initial]) {
            return self.refuse(reason);
        }
        // The file is opened before the torque is on, so that no control cycle waits for it.
        let opened = self
            .trace
            .as_deref()
            .map(|path| Trace::begin(path, false, true));
        let trace = match opened.transpose() {
            Ok(trace) => trace,
            Err(error) => return self.refuse(error.text(self.lang)),
        };
        let now = self.controls.now();
        self.controls.driver().begin(now);
        self.enter(Phase::Approach);
        self.connection.take_over(true);
        match self.approach(starter) {
            Ok(Step::Moving | Step::Arrived) => self.run(run, &prepared, trace),
            Ok(Step::Left(request)) => {
                if request == Request::EmergencyStop {
                    self.note_stop();
                }
                self.leave();
            }
            Err(failure) => {
                self.fail(failure);
                self.leave();
            }
        }
        true
    }

    /// Says why the robot does not start.
    fn refuse(&mut self, reason: String) -> bool {
        report::complain(&format!("{reason}\n"));
        self.state.problem = Some(reason);
        false
    }

    fn new_run(&self, prepared: &Prepared) -> Result<Run, String> {
        let Some(program) = prepared.loaded.program.clone() else {
            return Err(String::new());
        };
        let program = Interpreter::new(program);
        let run = Run::real(program, &self.robot, self.connection.joints());
        let run = run.map_err(|mismatch| mismatch.to_string())?;
        run.with_events(&prepared.events)
            .map_err(|refused| refused.text(self.lang))
    }

    /// Switches the torque on, moves slowly to the initial posture, and holds it until somebody drives. From the terminal it moves
    /// without the button.
    fn approach(&mut self, starter: Starter) -> Result<Step, Failure> {
        let mut step = self.connection.robot().hold()?;
        let (initial, speed) = (
            self.connection.setup.initial.clone(),
            self.connection.setup.bus.start,
        );
        let (mut settled, mut by_terminal) = (0, starter == Starter::Terminal);
        let mut pacer = Pacer::start();
        loop {
            if let Step::Left(_) = step {
                return Ok(step);
            }
            let mut stage = self.controls.stage();
            if by_terminal {
                if settled >= SETTLING {
                    // The driver of the page has time until now.
                    by_terminal = false;
                    let now = self.controls.now();
                    self.controls.driver().begin(now);
                }
                stage = Stage::Driven;
            }
            self.set_stage(stage);
            if settled >= SETTLING && stage == Stage::Driven && !by_terminal {
                return Ok(step);
            }
            step = match stage {
                Stage::Driven => self.connection.robot().step(&initial, speed)?,
                Stage::Paused => self.connection.robot().step(&initial, 0.0)?,
                Stage::Halt => self.connection.robot().obey(Request::End),
                Stage::Emergency => {
                    self.controls.stop();
                    self.connection.robot().step(&initial, 0.0)?
                }
            };
            settled += u32::from(step == Step::Arrived);
            self.report_servos();
            self.connection.pace(&mut pacer);
        }
    }

    /// Runs the program in real time until it ends, and leaves the robot.
    fn run(&mut self, run: Run, prepared: &Arc<Prepared>, mut trace: Option<Trace>) {
        let begun = Report::Begun(Box::new((run.clone(), Arc::clone(prepared))));
        self.tell(begun);
        self.enter(Phase::Running);
        let keys = Keys {
            controls: Arc::clone(&self.controls),
            keyboard: self.connection.keyboard(),
        };
        let program = prepared.loaded.program.as_ref();
        let has_sticks = program.is_some_and(sticks::are_read);
        let mut shown = [tip_sim::event::STICK_AT_REST; STICKS];
        let mut run = run.with_console(keys);
        let (mut pacer, mut is_asked) = (Pacer::start(), false);
        while run.ending().is_none() {
            if interrupt::is_requested() {
                self.tell(Report::Ended(Ending::Interrupted));
                break;
            }
            let stage = self.controls.stage();
            self.set_stage(stage);
            let sticks = self.controls.driver().sticks();
            for (n, (shown, volts)) in (1..).zip(shown.iter_mut().zip(sticks)) {
                if has_sticks && *shown != volts {
                    *shown = volts;
                    self.give(&mut run, Event::Sensor(Port::Knob(n), volts));
                }
            }
            match stage {
                Stage::Driven | Stage::Paused => {}
                Stage::Halt if is_asked => {}
                Stage::Halt => {
                    is_asked = true;
                    self.give(&mut run, Event::Halt);
                }
                Stage::Emergency => self.controls.stop(),
            }
            let orders: Vec<Order> = self.orders.try_iter().take(MAX_ORDERS).collect();
            for order in orders {
                match order {
                    // The signs of life say where sticks are.
                    Order::Happen(Event::Sensor(Port::Knob(_), _)) if has_sticks => {}
                    Order::Happen(event) => self.give(&mut run, event),
                    Order::Prepare(_) => {}
                }
            }
            run.pause(stage == Stage::Paused);
            let cycle = run.reported(trace.as_mut().map(Trace::sink));
            if let Some(trace) = &mut trace {
                trace.after(&run);
            }
            if stage != Stage::Paused || run.ending().is_some() {
                self.tell(Report::Cycle(Box::new((cycle, run.snapshot()))));
            }
            if let Some(Ending::Emergency(_)) = run.ending() {
                self.note_stop();
            }
            (self.state.late, self.state.period) = (pacer.overruns(), run.period());
            self.report_servos();
            wait_until(pacer.due(run.period()));
        }
        if let Some(failure) = self.connection.failure() {
            self.fail(failure);
        }
        let (ending, cycles) = (run.ending(), run.cycles());
        // Its console gives the keys of the terminal back.
        drop(run);
        self.leave();
        let written = trace.map(|trace| trace.end(ending.unwrap_or(Ending::Interrupted), cycles));
        if let Some(Err(error)) = written {
            report::complain(&format!("{}\n", error.text(self.lang)));
        }
    }

    /// Lets something happen to the run before its next step.
    fn give(&mut self, run: &mut Run, event: Event) {
        let event = event.at(run.cycles());
        if run.add(event.clone()).is_ok() {
            self.tell(Report::Happened(event));
        }
    }

    /// Keeps the time that an emergency stop took.
    fn note_stop(&mut self) {
        self.state.stopped_in = self.controls.since_stop();
    }

    fn fail(&mut self, failure: Failure) {
        let reason = self.connection.explain(failure);
        report::complain(&format!("{reason}\n"));
        self.state.problem = Some(reason);
    }

    /// Leaves the robot.
    fn leave(&mut self) {
        self.enter(Phase::Leaving);
        // A signal does not cut it short.
        interrupt::hold();
        let finished = self.connection.finish();
        if finished.is_stopped {
            self.note_stop();
        }
        interrupt::release();
        if !finished.complaint.is_empty() {
            let complaint = finished.complaint.trim_end().to_owned();
            self.state.problem.get_or_insert(complaint);
        }
    }

    fn enter(&mut self, phase: Phase) {
        self.state.phase = phase;
        self.due = Instant::now();
        self.report_servos();
    }

    fn set_stage(&mut self, stage: Stage) {
        if self.stage != stage {
            self.stage = stage;
            self.due = Instant::now();
        }
    }

    /// Reports the state of the robot now and then.
    fn report_servos(&mut self) {
        let now = Instant::now();
        if now < self.due {
            return;
        }
        self.due = now + REPORTING;
        let robot = self.connection.robot();
        let drives = robot.drives();
        let failure = drives.failure();
        let counts = drives.counts();
        let cycles = counts.commanded.saturating_sub(self.reported.1);
        let busy = counts.busy.saturating_sub(self.reported.0) as f64 / 1000.0;
        self.state.bus = (cycles > 0).then(|| busy / cycles as f64);
        self.reported = (counts.busy, counts.commanded);
        let counters = drives.bus().counters();
        self.state.answers = [counters.asked, counters.answered];
        drop(robot);
        self.state.servos = self.connection.servos(failure);
        let state = Box::new(self.state.clone());
        self.tell(Report::State(state, self.stage));
    }

    fn tell(&self, report: Report) {
        // Without a hub the command ends.
        let _ = self.reports.send(report);
    }
}
