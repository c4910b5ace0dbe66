//! `tipc run`: a program on the simulated robot, by the reference interpreter.

mod emergency;
mod interrupt;
mod logs;
mod progress;
mod screen;
mod targets;
mod trace;

use super::arguments::{InputArguments, SourceArguments};
use super::error::Error;
use super::{Status, input, report, scene};
use clap::Args;
use emergency::describe;
use progress::Progress;
use screen::Screen;
use std::path::PathBuf;
use tip_runtime::console::LogFiles;
use tip_runtime::record::{Ending, Sink};
use tip_sim::{Inputs, Interpreter, Observer, Robot};
use tipc::program::Program;
use tipc::source::Source;
use trace::Trace;

/// `tipc run`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tipc run walk.prg                             until END; messages on standard output
  tipc run walk.prg --cycles 500 --trace -      500 control cycles, the trace on standard output
  tipc run walk.prg --halt 300                  HALT_REQUEST is true from cycle 300 on
  tipc run ask.prg --keys '10:y,25:0x2C'        Y before cycle 10, a comma before cycle 25
  tipc run march.prg --robot hexapod.toml
  tipc run sense.prg --sensor VR1=8@300 --sensor PAW1=2.5@0
  tipc run --robot hand grasp.prg --scene cylinder
  tipc run walk.prg --out-dir logs              TITAN.LOG, EMG.log and the others go to logs/

One cycle is one step of the program: 20 ms of the robot's time, 2 ms of the hand's, unless the
program sets another. On a terminal, keys reach the program as they are pressed; RETURN is the
emergency stop and ESC the halt request; Ctrl-C ends the run and completes its files,
a second one ends a run that is stuck.

Exit status: 0 END, EXIT or --cycles used up, 1 the program does not load, 2 wrong usage,
3 emergency stop, 130 interrupted.")]
pub(super) struct Run {
    /// The program
    pub(super) file: PathBuf,

    #[command(flatten)]
    pub(super) source: SourceArguments,

    #[command(flatten)]
    pub(super) inputs: InputArguments,

    /// Write the trace, one JSON object a line, to a file, or to standard output for '-'
    #[arg(long, value_name = "OUT.jsonl|-")]
    pub(super) trace: Option<PathBuf>,

    /// End each record of the trace with a hash of the robot's commands and measurements
    #[arg(long, requires = "trace")]
    pub(super) trace_state: bool,

    /// Write the log files of the language into this folder
    #[arg(long, value_name = "DIR")]
    pub(super) out_dir: Option<PathBuf>,
}

/// Runs the program until it ends, the cycles are used up, or someone presses Ctrl-C.
pub(super) fn run(arguments: &Run) -> Result<Status, Error> {
    interrupt::catch();
    let robot = match arguments.source.robot.load() {
        Ok(robot) => robot,
        Err(loaded) => {
            report::findings(&loaded, arguments.source.shown);
            return Ok(Status::Failure);
        }
    };
    let Some(scene) = scene::load(arguments.inputs.scene.as_ref(), arguments.source.shown) else {
        return Ok(Status::Failure);
    };
    let robot = scene::around(robot.simulated()?, &scene)?;
    let inputs = arguments.inputs.inputs();
    check_inputs(&robot, &inputs)?;
    let loaded = input::load(
        &arguments.file,
        &arguments.source.options(robot.options().robot),
    );
    report::findings(&loaded, arguments.source.shown);
    if loaded.program.is_some() {
        targets::check(arguments)?;
    }
    // The trace first: it changes nothing before the end, and where it cannot be written no log is touched.
    let trace = match (&arguments.trace, &loaded.program) {
        (Some(path), Some(_)) => Some(Trace::begin(path, arguments.trace_state)?),
        _ => None,
    };
    let logs = match &arguments.out_dir {
        Some(folder) if input::was_read(&loaded) => Some(logs::claim(folder, &loaded)?),
        _ => None,
    };
    match loaded.program {
        Some(program) => simulate(program, robot, &inputs, &loaded.source, trace, logs),
        None => Ok(Status::Failure),
    }
}

/// Runs a program that was loaded, and reports how it ended.
fn simulate(
    program: Program,
    robot: Robot,
    inputs: &Inputs,
    source: &Source,
    mut trace: Option<Trace>,
    logs: Option<LogFiles<()>>,
) -> Result<Status, Error> {
    let messages = !trace.as_ref().is_some_and(Trace::takes_standard_output);
    let screen = Screen::new(Progress::new(inputs.cycles), messages, logs);
    let usage = |refused: &dyn std::fmt::Display| Error::Usage(refused.to_string());
    let mut run = tip_sim::Run::new(Interpreter::new(program), robot)
        .map_err(|mismatch| usage(&mismatch))?
        .with_events(&inputs.events)
        .map_err(|refused| usage(&refused))?
        .with_console(screen);
    let mut watch = Watch {
        trace: trace.as_mut(),
    };
    let ending = run.observed(inputs.cycles.into(), &mut watch);
    interrupt::hold();
    let logged = run.console_mut().map_or(Ok(()), Screen::close);
    if trace.as_ref().is_some_and(Trace::is_straight) {
        interrupt::release();
    }
    let traced = trace.map_or(Ok(()), |trace| trace.end(ending, run.cycles()));
    if let (Ending::Emergency(emergency), Some(program)) = (&ending, run.engine()) {
        report::complain(&describe(emergency, source, program));
    }
    traced.and(logged)?;
    Ok(status(&ending))
}

/// Writes the trace, and ends the run when it is interrupted.
struct Watch<'a> {
    trace: Option<&'a mut Trace>,
}

impl Observer for Watch<'_> {
    fn goes_on(&mut self) -> bool {
        !interrupt::is_requested()
    }

    fn sink(&mut self) -> Option<&mut dyn Sink> {
        self.trace.as_mut().map(|trace| trace.sink())
    }

    fn after(&mut self, run: &mut tip_sim::Run) {
        if run.ending().is_some() {
            return;
        }
        if self.trace.as_ref().is_some_and(|trace| !trace.is_open()) {
            interrupt::request();
        }
        let cycle = run.cycles().saturating_sub(1);
        if let Some(screen) = run.console_mut::<Screen>() {
            screen.at(cycle);
        }
    }
}

/// The exit status that belongs to an ending.
fn status(ending: &Ending) -> Status {
    match ending {
        Ending::Program(_) | Ending::Limit => Status::Success,
        Ending::Emergency(_) => Status::Emergency,
        Ending::Interrupted => Status::Interrupted,
    }
}

/// Refuses inputs that the robot lacks.
fn check_inputs(robot: &Robot, inputs: &Inputs) -> Result<(), Error> {
    let mut ports = inputs.events.ports();
    match ports.find(|port| !robot.has_input(*port)) {
        None => Ok(()),
        Some(port) => {
            let robot = robot.name();
            Err(Error::Usage(format!("{robot} has no input {port}")))
        }
    }
}
