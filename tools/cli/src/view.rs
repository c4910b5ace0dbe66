//! `tipc view`: a page that replays a run.

use super::arguments::{InputArguments, SourceArguments};
use super::error::Error;
use super::report::plural;
use super::{Status, input, interrupt, output, report, scene};
use clap::Args;
use std::path::{Path, PathBuf};
use tip_runtime::printable::Printable;
use tip_sim::Robot;
use tip_view::{BadTrace, Extent, NotRecorded, Outcome, Recording};
use tipc::Loaded;

/// How long a run is recorded unless `--cycles` says: minutes of the robot's time.
const MINUTES: f64 = 10.0;

/// `tipc view`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tipc view walk.prg                            runs it, and writes walk.html
  tipc view walk.prg -o monday.html --halt 300  all inputs of 'tipc run'
  tipc view --robot hand grasp.prg --scene scene.toml
  tipc view march.prg --robot hexapod.toml --cycles 2000
  tipc run walk.prg --trace walk.jsonl --trace-motion
  tipc view walk.jsonl --program walk.prg       the run of that trace

The page is one file that asks for nothing: it opens by double click, and can be sent or put into
another page. It shows the robot in three dimensions beside the line that runs, with messages,
falls, slips, forces and plots on one time axis. Its address takes #cycle=611.

A run is recorded for ten minutes of the robot's time, or for --cycles. However it ends, the page
is written.

Exit status: 0 written, 1 the program does not load or a file cannot be read or written,
2 wrong usage, 130 interrupted; what was recorded until then is written.")]
pub(super) struct View {
    /// The program; or, with --program, a trace that 'tipc run --trace-motion' wrote
    file: PathBuf,

    /// The program of a trace
    #[arg(long, value_name = "FILE.prg", conflicts_with_all = ["cycles", "keys", "halt", "sensors", "events"])]
    program: Option<PathBuf>,

    /// Write the page here; otherwise beside FILE, as FILE.html
    #[arg(short, long, value_name = "OUT.html")]
    out: Option<PathBuf>,

    #[command(flatten)]
    source: SourceArguments,

    #[command(flatten)]
    inputs: InputArguments,

    /// Say nothing but errors
    #[arg(long, short)]
    quiet: bool,
}

/// Records a run, or reads the trace of one, and writes the page that replays it.
pub(super) fn view(arguments: &View) -> Result<Status, Error> {
    interrupt::catch();
    let shown = arguments.source.shown;
    let robot = match arguments.source.robot.load() {
        Ok(robot) => robot,
        Err(loaded) => {
            report::findings(&loaded, shown);
            return Ok(Status::Failure);
        }
    };
    let Some(scene) = scene::load(arguments.inputs.scene.as_ref(), shown) else {
        return Ok(Status::Failure);
    };
    let robot = scene::around(robot.simulated()?, &scene)?;
    let program = arguments.program.as_deref().unwrap_or(&arguments.file);
    let loaded = input::load(program, &arguments.source.options(robot.options().robot));
    if loaded.program.is_none() || !arguments.quiet {
        report::findings(&loaded, shown);
    }
    if loaded.program.is_none() {
        return Ok(Status::Failure);
    }
    let out = arguments.out();
    output::refuse_inputs(&out, &arguments.inputs_of())?;
    let recording = match &arguments.program {
        Some(_) => arguments.read(&loaded, &robot)?,
        None => arguments.record(&loaded, &robot)?,
    };
    interrupt::hold();
    let page = recording.to_page();
    output::replace(&out, &page)?;
    if !arguments.quiet {
        report::complain(&summary(&recording, &out, page.len()));
        if recording.outcome == Outcome::Limit
            && arguments.inputs.inputs().cycles.is_none()
            && arguments.program.is_none()
        {
            report::complain(
                "  stopped after ten minutes of robot time; --cycles N records more, or less\n",
            );
        }
    }
    Ok(match recording.outcome {
        Outcome::Interrupted if interrupt::is_requested() => Status::Interrupted,
        _ => Status::Success,
    })
}

impl View {
    /// Where the page goes.
    fn out(&self) -> PathBuf {
        match &self.out {
            Some(out) => out.clone(),
            None if self.file.as_os_str() == "-" => PathBuf::from("run.html"),
            None => self.file.with_extension("html"),
        }
    }

    /// Every file that is read.
    fn inputs_of(&self) -> Vec<&Path> {
        let scene = self.inputs.scene.as_ref().and_then(|scene| scene.file());
        let others = [self.program.as_deref(), self.source.robot.file(), scene];
        others.into_iter().flatten().chain([&*self.file]).collect()
    }

    fn record(&self, loaded: &Loaded, robot: &Robot) -> Result<Recording, Error> {
        let inputs = self.inputs.inputs();
        let extent = match inputs.cycles {
            Some(cycles) => Extent::cycles(cycles),
            None => Extent::minutes(MINUTES),
        };
        let goes_on = || !interrupt::is_requested();
        let usage = |error: NotRecorded| Error::Usage(error.to_string());
        Recording::of(loaded, robot, &inputs.events, extent, goes_on).map_err(usage)
    }

    fn read(&self, loaded: &Loaded, robot: &Robot) -> Result<Recording, Error> {
        let name = Printable::line(self.file.display()).to_string();
        let failed = |error: &dyn std::fmt::Display| Error::Failed(format!("{name}: {error}"));
        let trace = std::fs::read_to_string(&self.file).map_err(|error| failed(&error))?;
        let read = Recording::from_trace(&trace, loaded, robot);
        read.map_err(|error: BadTrace| failed(&error))
    }
}

/// What was written.
fn summary(recording: &Recording, out: &Path, bytes: usize) -> String {
    let (name, cycles) = (
        Printable::line(out.display()),
        plural(recording.cycles as usize, "cycle"),
    );
    let time = recording.time(recording.cycles) / 1000.0;
    let falls = match recording.falls.len() {
        0 => String::new(),
        falls => format!(", {}", plural(falls, "fall")),
    };
    let size = (bytes as f64 / 1000.0).round();
    format!("{name}: {time:.3} s of robot time, {cycles}{falls}, {size} kB\n")
}
