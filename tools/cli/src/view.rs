//! `tip view`: a page that replays a run.

use super::error::Error;
use super::loader::Subject;
use super::plant::Ours;
use super::recorded::RecordedArguments;
use super::report::plural;
use super::{Status, input, interrupt, output, report};
use clap::Args;
use std::path::{Path, PathBuf};
use tip_runtime::printable::Printable;
use tip_sim::Robot;
use tip_view::{BadTrace, Outcome, Pace, Recording};
use tipc::Loaded;

/// `tip view`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tip view walk.prg                            runs it, and writes walk.html
  tip view walk.prg -o monday.html --halt 300  all inputs of 'tip run'
  tip view --robot hand grasp.prg --scene scene.toml
  tip view march.prg --robot hexapod.toml --cycles 2000
  tip run walk.prg --trace walk.jsonl --trace-motion
  tip view walk.jsonl --program walk.prg       the run of that trace

The page is one file that asks for nothing: it opens by double click, and can be sent or put into
another page. It shows the robot in three dimensions beside the line that runs, with messages,
falls, slips, forces and plots on one time axis. Its address takes #cycle=611.

A run is recorded for ten minutes of the robot's time, or for --cycles; without --cycles it also ends
when it has waited for a minute without a motion. However it ends, the page
is written.

Exit status: 0 written, 1 the program does not load or a file cannot be read or written,
2 wrong usage, 130 interrupted; what was recorded until then is written.")]
pub(super) struct View {
    #[command(flatten)]
    pub(super) recorded: RecordedArguments,

    /// The program of FILE, which is a trace that 'tip run --trace-motion' wrote
    #[arg(long, value_name = "FILE.prg", conflicts_with_all = ["cycles", "keys", "halt", "sensors", "events"])]
    pub(super) program: Option<PathBuf>,

    /// Write the page here; otherwise beside FILE, as FILE.html
    #[arg(short, long, value_name = "OUT.html")]
    out: Option<PathBuf>,

    /// Say nothing but errors
    #[arg(long, short)]
    quiet: bool,
}

/// Records a run, or reads the trace of one, and writes the page that replays it.
pub(super) fn view(arguments: &View) -> Result<Status, Error> {
    let recorded = &arguments.recorded;
    let program = arguments.program.as_deref().unwrap_or(&recorded.file);
    let Some(Subject { loaded, robot, .. }) =
        recorded.load(program, arguments.quiet, Ours::Recorded("view"))?
    else {
        return Ok(Status::Failure);
    };
    let out = arguments.out();
    let read = recorded.files();
    let read: Vec<&Path> = read
        .into_iter()
        .chain(arguments.program.as_deref())
        .collect();
    output::refuse_inputs(&out, &read)?;
    let recording = match &arguments.program {
        Some(_) => arguments.read(&loaded, &robot)?,
        None => recorded.run(&loaded, &robot, Pace::Smooth)?,
    };
    interrupt::hold();
    let page = recording.to_page();
    output::replace(&out, &page)?;
    if !arguments.quiet {
        report::complain(&summary(&recording, &out, page.len()));
        if arguments.program.is_none() {
            recorded.say_wait(&recording);
        }
    }
    Ok(match recording.outcome {
        Outcome::Interrupted if interrupt::is_requested() => Status::Interrupted,
        _ => Status::Success,
    })
}

/// The size limit of a trace, MiB: some hours of the robot's time.
const LARGEST_TRACE: usize = 1024;

impl View {
    /// Where the page goes.
    fn out(&self) -> PathBuf {
        match &self.out {
            Some(out) => out.clone(),
            None if input::is_stream(&self.recorded.file) => PathBuf::from("run.html"),
            None => self.recorded.file.with_extension("html"),
        }
    }

    fn read(&self, loaded: &Loaded, robot: &Robot) -> Result<Recording, Error> {
        let name = Printable::line(self.recorded.file.display()).to_string();
        let failed = |error: &dyn std::fmt::Display| Error::Failed(format!("{name}: {error}"));
        let lang = self.recorded.source.shown.lang();
        let trace = input::read(&self.recorded.file, LARGEST_TRACE)
            .map_err(|reason| failed(&reason.in_lang(lang)))?;
        let trace = String::from_utf8(trace).map_err(|error| failed(&error))?;
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
