//! `tip run`: a program on the simulated robot, by the reference interpreter.

mod console;
mod emergency;
pub(super) mod files;
mod refusal;
mod summary;
pub(super) mod trial;

use super::arguments::RunArguments;
use super::drives::realtime;
use super::drives::robot::{Connection, Setup, report_stiff};
use super::error::Error;
use super::loader::{self, Subject};
use super::report::Deny;
use super::setup::{ChosenRobot, PlantChoice};
use super::{Status, input, interrupt, output, report, sticks};
use crate::Action;
use crate::choices::Format;
use crate::message::{Driving, Running, Using, Weight};
use clap::{Args, ValueEnum};
use console::{Live, Progress, Screen};
use emergency::Stopped;
use files::Trace;
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};
use summary::{collision, driven, fall, json, summary, wait_circle};
use tip_runtime::console::{LogFiles, Terminal};
use tip_runtime::record::{Ending, Sink};
use tip_sim::{
    ExternalPlant, FallKind, Inputs, Interpreter, Observer, Robot, SummaryBuilder, WaitCircle,
    WaitDetector,
};
use tipc::Loaded;
use tipc::description::Description;
use tipc::message::Lang;
use tipc::program::Program;

pub(super) use summary::{line, wait_message};

/// Time without a motion after which a run probably waits for something that does not come, ms.
pub(super) const LONG_WAIT: f64 = 60_000.0;

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip run walk.prg                         until END; messages on standard output
  tip run walk.prg --cycles 500 --trace -  500 cycles, trace on standard output
  tip run walk.prg --halt 300              requests a halt from cycle 300 on
  tip run ask.prg --keys '10:y,25:0x2C'    Y before cycle 10, a comma before 25
  tip run march.prg --robot hexapod.toml
  tip run sense.prg --sensor VR1=8@300 --sensor PAW1=2.5@0
  tip run sense.prg --sensor VR1=8@2s..5s  for three seconds; a stick springs back to 5 V
  tip run --robot hand grasp.prg --scene scene.toml
  tip run walk.prg --out-dir logs          TITAN.LOG, EMG.log and the others go to logs/
  tip run walk.prg --realtime              as fast as the robot, with a status line and your keys
  tip run walk.prg --plant 'exec:python3 mine.py'  on a simulator of yours
  tip run walk.prg --hardware robot.toml   on the servos of a real robot
  tip run walk.prg --quiet --deny falls    for scripts: nothing but messages, and exit status 4 after a fall

One cycle is one step of the program: 20 ms of the robot's time, 2 ms of the hand's, unless the
program sets another. On a terminal, keys reach the program as they are pressed; RETURN is the
emergency stop and ESC the halt request; Ctrl-C ends the run and completes its files,
a second one ends a run that is stuck. On a real robot the keys count from the first torque
to the last, and no signal ends the process before the servos are as their file says. On standard error a run says when the robot falls, and at
its end what it did.

Exit status; the first that applies:
  2    wrong usage
  1    the program does not load or has a denied warning, or a file cannot be written
  130  interrupted
  3    emergency stop
  4    the robot fell, with --deny falls, or two of its parts met, with --deny collisions; the run goes on to its end
  0    END, EXIT or --cycles used up")]
pub(super) struct Run {
    #[command(flatten)]
    pub(super) run: RunArguments,

    /// Write the trace; '-' is standard output
    ///
    /// One JSON object per line
    #[arg(long, value_name = "OUT.jsonl|-")]
    pub(super) trace: Option<PathBuf>,

    /// Add a hash of the robot's state to each record
    ///
    /// Of the commands and measurements of its joints
    #[arg(long, requires = "trace")]
    pub(super) trace_state: bool,

    /// Add the robot's motion to each record
    ///
    /// Pose, angles, loads, margin, falls, and what a simulation without mass leaves out
    #[arg(long, requires = "trace")]
    pub(super) trace_motion: bool,

    /// Write the log files of the language there
    #[arg(long, value_name = "DIR")]
    pub(super) out_dir: Option<PathBuf>,

    /// Run in real time, with a status line and keys
    ///
    /// Keys come from the terminal
    #[arg(long)]
    pub(super) realtime: bool,

    /// Run on a real robot
    ///
    /// Its description has [bus] and [[drive]] (docs/drives.md)
    #[arg(long, value_name = "FILE.toml", conflicts_with_all = ["robot", "plant", "scene"])]
    pub(super) hardware: Option<PathBuf>,

    /// The robot's serial port, or 'simulated'
    ///
    /// 'simulated' needs no hardware. By default the port is that of the description
    #[arg(long, value_name = "PORT", requires = "hardware")]
    pub(super) port: Option<String>,

    /// Start without waiting for a key
    #[arg(long, requires = "hardware")]
    pub(super) yes: bool,

    /// Use SCHED_FIFO and lock the memory
    #[arg(long, requires = "hardware", hide_short_help = true)]
    pub(super) fifo: bool,

    #[command(flatten)]
    pub(super) deny: Deny,

    /// The summary: text, or json on standard output
    ///
    /// One object in place of the program's messages (docs/files.md)
    #[arg(
        long,
        value_name = "FORMAT",
        value_enum,
        default_value = "text",
        hide_short_help = true
    )]
    pub(super) format: SummaryFormat,

    /// Print only messages and errors that end a run
    #[arg(long, short)]
    pub(super) quiet: bool,
}

/// The values of `--format`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum SummaryFormat {
    /// Lines on standard error
    Text,
    /// One JSON object on standard output
    Json,
}

impl Run {
    fn lang(&self) -> Lang {
        self.run.source.output_options.lang()
    }
}

impl Action for Run {
    fn complete(&mut self) -> Result<(), Error> {
        if let Some(file) = &self.hardware {
            self.run.source.robot = Some(crate::setup::RobotChoice::File(file.clone()));
        }
        let given = self.run.complete(&self.run.file.clone())?;
        if let Some(given) = given.filter(|_| !self.quiet) {
            report::complain(&format!("{given}\n"));
        }
        Ok(())
    }

    fn format(&self) -> Option<Format> {
        Some(self.run.source.output_options.message_format)
    }

    fn execute(&self) -> Result<Status, Error> {
        run(self)
    }
}

/// Runs the program until it ends, the cycles are used up, or someone presses Ctrl-C.
fn run(arguments: &Run) -> Result<Status, Error> {
    let is_straight = arguments.trace.as_deref().is_some_and(input::is_standard);
    if is_straight && arguments.format == SummaryFormat::Json {
        return Err(Error::usage(Using::OneOutput, arguments.lang()));
    }
    interrupt::catch();
    let plant = arguments.run.inputs.plant.as_ref();
    let process = plant.and_then(PlantChoice::process);
    if process.is_some() {
        reject_built_in_options(arguments)?;
    }
    let Subject {
        mut loaded,
        chosen,
        robot,
    } = loader::load(&arguments.run.file, &arguments.run, None)?;
    let mut inputs = arguments.run.inputs.inputs(&robot);
    let is_live = arguments.realtime || arguments.hardware.is_some();
    let is_steered = is_live && io::stdin().is_terminal();
    // Sticks that keys move are inputs of a robot on servos.
    if let (true, Some(program)) = (is_steered, &loaded.program) {
        inputs.events = sticks::let_rest(program, inputs.events);
    }
    if arguments.hardware.is_some() {
        let unconnected = robot.unconnected(&loaded, &inputs.events);
        if !unconnected.is_empty() {
            loaded.program = None;
            loaded.report(unconnected.into());
        }
    }
    if loaded.program.is_none() || !arguments.quiet {
        report::diagnostics(&loaded, arguments.run.source.output_options);
    }
    if arguments.deny.rejects(&loaded) {
        return Ok(Status::Failure);
    }
    if loaded.program.is_some() {
        files::check(arguments)?;
    }
    let program = loaded.program.take();
    let connection = match (&arguments.hardware, chosen, &program) {
        (Some(file), ChosenRobot::Described(robot), Some(_)) => {
            match connected(arguments, file, &robot)? {
                Some(connection) => Some(connection),
                None => return Ok(Status::Interrupted),
            }
        }
        _ => None,
    };
    let mut job = Job {
        arguments,
        loaded: &loaded,
        inputs: &inputs,
        process,
        connection,
    };
    let prepared = job.prepare(program, &robot);
    if let (Err(_), Some(connection)) = (&prepared, &job.connection) {
        report_stiff(connection, arguments.lang());
    }
    let (begun, trace) = prepared?;
    // Nothing is opened any more that a reader may keep waiting.
    if let Some(connection) = &job.connection
        && let Some(status) = connection.stand_ready(job.is_live())
    {
        return Ok(status);
    }
    let logs = match &arguments.out_dir {
        Some(folder) if input::was_read(&loaded) => Some(files::claim(folder, &loaded)?),
        _ => None,
    };
    match begun {
        Some(begun) => job.simulate(begun, &robot, trace, logs),
        None => Ok(Status::Failure),
    }
}

/// A loaded program with the options of its run.
struct Job<'a> {
    arguments: &'a Run,
    /// The loaded source.
    loaded: &'a Loaded,
    inputs: &'a Inputs,
    /// The process that simulates the robot, if it is not a built-in plant.
    process: Option<ExternalPlant>,
    /// The real robot, if it is one.
    connection: Option<Connection>,
}

/// Returns the keyboard, if standard input is a terminal.
fn terminal() -> Option<Terminal<io::Sink>> {
    let is_terminal = io::stdin().is_terminal();
    is_terminal.then(|| Terminal::on(io::sink(), false).report_interrupts())
}

/// Finds the servos of a real robot, and waits for the key that starts it; `None` if the command was interrupted.
fn connected(
    arguments: &Run,
    file: &Path,
    description: &Description,
) -> Result<Option<Connection>, Error> {
    let lang = arguments.lang();
    let setup = Setup::new(file, description, lang)?;
    let connection = setup.open(file, arguments.port.as_deref(), lang)?;
    let is_wanted = agreed(arguments, &connection);
    if !matches!(is_wanted, Ok(true)) {
        report_stiff(&connection, lang);
        return is_wanted.map(|_| None);
    }
    if arguments.fifo {
        realtime::warn(realtime::prioritise(), lang);
    }
    Ok(Some(connection))
}

/// Finds the servos, and returns true if the operator wants the robot to move.
fn agreed(arguments: &Run, connection: &Connection) -> Result<bool, Error> {
    let lang = arguments.lang();
    connection.connect(arguments.quiet)?;
    if connection.is_simulated() || arguments.yes {
        return Ok(true);
    }
    connection.announce();
    if !io::stdin().is_terminal() {
        return Err(Error::usage(Driving::NeedsYes, lang));
    }
    input::forget_typed();
    report::say(Driving::PressReturn, lang);
    input::is_confirmed()
}

impl Job<'_> {
    /// Returns the run before its first cycle, and the file of its trace.
    fn prepare(
        &self,
        program: Option<Program>,
        robot: &Robot,
    ) -> Result<(Option<tip_sim::Run>, Option<Trace>), Error> {
        // A process that does not start leaves no file.
        let begun = match program {
            Some(program) => Some(self.new_run(program, robot)?),
            None => None,
        };
        // The trace comes next: it changes nothing before the end, and if it cannot be written, no log is touched.
        let trace = match (&self.arguments.trace, &begun) {
            (Some(path), Some(_)) => Some(Trace::begin(
                path,
                self.arguments.trace_state,
                self.arguments.trace_motion,
            )?),
            _ => None,
        };
        Ok((begun, trace))
    }

    /// Returns the run before its first cycle.
    fn new_run(&self, program: Program, robot: &Robot) -> Result<tip_sim::Run, Error> {
        let run = self.start(Interpreter::new(program), robot)?.followed();
        run.with_events(&self.inputs.events)
            .map_err(|refused| Error::Usage(refused.text(self.arguments.lang())))
    }

    /// Runs the program and reports the end.
    fn simulate(
        &mut self,
        begun: tip_sim::Run,
        robot: &Robot,
        mut trace: Option<Trace>,
        logs: Option<LogFiles<()>>,
    ) -> Result<Status, Error> {
        let is_traced = trace.as_ref().is_some_and(Trace::takes_standard_output);
        let messages = !is_traced && self.arguments.format == SummaryFormat::Text;
        let keyboard = match &self.connection {
            Some(connection) => connection.keyboard(),
            None => terminal(),
        };
        let mut screen = Screen::new(keyboard, self.progress(), messages, logs);
        let program = begun.engine::<Interpreter>().map(Interpreter::program);
        let has_sticks = self.is_live() && program.is_some_and(|program| sticks::are_read(program));
        if has_sticks {
            screen.steer();
        }
        let description = robot.description();
        let source = &self.arguments.run.source;
        let (options, lang) = (source.options(robot.options().robot), self.arguments.lang());
        let mut run = begun.with_console(screen);
        let is_live = self.is_live();
        let connection = self.connection.take();
        let mut watch = Watch {
            job: self,
            trace: trace.as_mut(),
            live: None,
            fell: false,
            collided: false,
            waits: WaitDetector::default(),
            circles: Vec::new(),
            has_waited: false,
            figures: SummaryBuilder::new(robot),
        };
        if is_live {
            watch.live = Some(Live::begin(self.arguments.quiet, has_sticks, lang));
        }
        let ending = run.observed(self.inputs.cycles.into(), &mut watch);
        let deny = &self.arguments.deny;
        let is_denied = watch.fell && deny.falls() || watch.collided && deny.collisions();
        let (live, wait) = (watch.live, watch.waits.now(&run));
        let figures = watch.figures;
        // From here on a signal ends nothing: neither the leaving of the robot nor the files.
        interrupt::hold();
        let is_stopped = connection.as_ref().is_some_and(|connection| {
            if let Some(screen) = run.console_mut::<Screen>() {
                screen.clear();
            }
            connection.finish().is_stopped
        });
        let logged = run.console_mut().map_or(Ok(()), Screen::close);
        if trace.as_ref().is_some_and(Trace::is_straight) {
            interrupt::release();
        }
        let traced = trace.map_or(Ok(()), |trace| trace.end(ending, run.cycles()));
        // The servo first: it is what people look at.
        if let Some(connection) = &connection
            && let Some(failure) = connection.failure()
        {
            report::complain(&format!("{}\n", connection.explain(failure)));
        }
        if let (Ending::Emergency(emergency), Some(program)) = (ending, run.engine()) {
            let stopped = Stopped {
                emergency,
                run: &run,
                program,
                loaded: self.loaded,
                options,
                robot,
                description: &description,
            };
            report::write_stderr(&stopped.report(source.output_options));
        }
        if !self.arguments.quiet {
            let dropped = run.console::<Screen>().map_or(0, Screen::dropped);
            if dropped > 0 {
                let texts = dropped.to_string();
                report::say(Running::LeftOut { texts }, lang);
            }
            let (source, figures) = (&self.loaded.source, figures.summary());
            let summary = summary(&run, ending, wait.as_ref(), figures, source, lang);
            report::complain(&summary);
            if let Some(live) = &live {
                report::complain(&live.pace(lang));
            }
            if let Some(connection) = &connection {
                report::complain(&driven(connection, live.as_ref().map(Live::jitter), lang));
            }
        }
        if self.arguments.format == SummaryFormat::Json {
            let source = &self.loaded.source;
            output::print(json(&run, ending, figures.summary(), source))?;
        }
        traced.and(logged)?;
        Ok(match is_stopped {
            true => Status::Emergency,
            false => self.status(&ending, is_denied),
        })
    }

    /// Puts the program on its robot.
    fn start(&self, program: Interpreter, robot: &Robot) -> Result<tip_sim::Run, Error> {
        if let Some(connection) = &self.connection {
            let run = tip_sim::Run::real(program, robot, connection.joints());
            return run.map_err(|mismatch| Error::Usage(mismatch.to_string()));
        }
        match &self.process {
            Some(process) => {
                let run = tip_sim::Run::external(program, robot, process);
                run.map_err(|refused| Error::Failed(refused.text(self.arguments.lang())))
            }
            None => tip_sim::Run::new(program, robot.clone())
                .map_err(|mismatch| Error::Usage(mismatch.to_string())),
        }
    }

    /// Returns true for a run in real time: a line of status follows it then.
    fn is_live(&self) -> bool {
        let moves = |connection: &Connection| !connection.is_simulated();
        self.arguments.realtime || self.connection.as_ref().is_some_and(moves)
    }

    fn progress(&self) -> Progress {
        match (self.arguments.quiet, self.is_live()) {
            (true, _) => Progress::hidden(),
            // The output of a process would be mixed with its line.
            (false, false) if self.process.is_some() => Progress::hidden(),
            (false, true) => Progress::live(),
            (false, false) => Progress::of(self.inputs.cycles),
        }
    }

    /// Returns the exit status of an ending.
    fn status(&self, ending: &Ending, is_denied: bool) -> Status {
        match ending {
            Ending::Interrupted => Status::Interrupted,
            Ending::Emergency(_) => Status::Emergency,
            Ending::Program(_) | Ending::Limit if is_denied => Status::Fell,
            Ending::Program(_) | Ending::Limit => Status::Success,
        }
    }
}

/// Writes the trace, reports the first fall, and ends the run when it is interrupted.
struct Watch<'a> {
    job: &'a Job<'a>,
    trace: Option<&'a mut Trace>,
    live: Option<Live>,
    fell: bool,
    collided: bool,
    waits: WaitDetector,
    /// Threads that wait for each other and were reported.
    circles: Vec<WaitCircle>,
    /// True if a long wait was reported.
    has_waited: bool,
    figures: SummaryBuilder,
}

impl Watch<'_> {
    /// Reports the first fall in its cycle.
    fn report_fall(&mut self, run: &tip_sim::Run) {
        let Some(found) = run.first_fall().filter(|_| !self.fell) else {
            return;
        };
        self.fell = true;
        if self.job.arguments.quiet {
            return;
        }
        let weight = match self.job.arguments.deny.falls() {
            true => Weight::Error,
            false => Weight::Warning,
        };
        if let (Some(program), Some(screen), Some(motion)) =
            (run.engine(), run.console::<Screen>(), run.motion())
        {
            let lang = self.job.arguments.lang();
            let kind = FallKind::of(&motion, found.is_upright);
            let source = &self.job.loaded.source;
            let text = fall(&found, &weight, kind, source, program, lang);
            screen.progress.above(|| report::complain(&text));
        }
    }

    /// Reports the first collision in its cycle.
    fn report_collision(&mut self, run: &tip_sim::Run) {
        let Some(found) = run.first_collision().filter(|_| !self.collided) else {
            return;
        };
        self.collided = true;
        if self.job.arguments.quiet {
            return;
        }
        let weight = match self.job.arguments.deny.collisions() {
            true => Weight::Error,
            false => Weight::Warning,
        };
        if let (Some(program), Some(screen)) = (run.engine(), run.console::<Screen>()) {
            let lang = self.job.arguments.lang();
            let source = &self.job.loaded.source;
            let text = collision(&found, &weight, source, program, lang);
            screen.progress.above(|| report::complain(&text));
        }
    }

    /// Reports threads that wait for each other, once.
    fn report_circles(&mut self, run: &tip_sim::Run) {
        if self.job.arguments.quiet {
            return;
        }
        for found in WaitCircle::all(run) {
            if self.circles.contains(&found) {
                continue;
            }
            if let (Some(program), Some(screen)) = (run.engine(), run.console::<Screen>()) {
                let lang = self.job.arguments.lang();
                let text = wait_circle(&found, run, &self.job.loaded.source, program, lang);
                screen.progress.above(|| report::complain(&text));
            }
            self.circles.push(found);
        }
    }

    /// Reports what a run waits for: in the line of progress on a terminal, else once after a long wait.
    fn report_wait(&mut self, run: &mut tip_sim::Run, cycle: u64) {
        let is_long = self.waits.rest(run) >= LONG_WAIT;
        let lang = self.job.arguments.lang();
        let Some(screen) = run.console::<Screen>() else {
            return;
        };
        if screen.progress.is_due(cycle) {
            let wait = self.waits.now(run);
            let text = wait.map(|wait| format!(" | {}", wait_message(&wait).in_lang(lang)));
            screen.progress.waits(text.unwrap_or_default());
        } else if is_long && !self.has_waited && self.live.is_none() && !self.job.arguments.quiet {
            let Some(wait) = self.waits.now(run) else {
                return;
            };
            let wait = wait_message(&wait);
            let progress = &screen.progress;
            progress.above(|| report::say(Running::GoesOn { wait }, lang));
        }
        self.has_waited = is_long;
    }
}

impl Observer for Watch<'_> {
    fn goes_on(&mut self) -> bool {
        !interrupt::is_requested()
    }

    fn sink(&mut self) -> Option<&mut dyn Sink> {
        self.trace.as_mut().map(|trace| trace.sink())
    }

    fn after(&mut self, run: &mut tip_sim::Run) {
        if let Some(trace) = &mut self.trace {
            trace.after(run);
        }
        self.report_fall(run);
        self.report_collision(run);
        if run.ending().is_some() {
            self.figures.after(run, None);
            return;
        }
        self.waits.after(run);
        self.report_circles(run);
        self.figures.after(run, self.waits.now(run));
        if self.trace.as_ref().is_some_and(|trace| !trace.is_open()) {
            interrupt::request();
        }
        let cycle = run.cycles().saturating_sub(1);
        if let Some(screen) = run.console_mut::<Screen>() {
            screen.progress.at(cycle);
        }
        self.report_wait(run, cycle);
        if let Some(live) = &mut self.live {
            live.after(run, &self.waits, &self.job.loaded.source);
        }
    }
}

/// Refuses options that need a built-in plant.
fn reject_built_in_options(arguments: &Run) -> Result<(), Error> {
    let refused = if arguments.run.inputs.scene.is_some() {
        Using::SceneIsElsewhere
    } else if arguments.deny.falls() || arguments.deny.collisions() {
        Using::FallsAreElsewhere
    } else {
        return Ok(());
    };
    Err(Error::usage(refused, arguments.lang()))
}
