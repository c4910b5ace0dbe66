//! Commands that record a run and write what it did: `tip view`, `tip log` and `tip plot`. `tip serve` loads programs in the same way.

use crate::Action;
use crate::arguments::RunArguments;
use crate::choices::count;
use crate::error::Error;
use crate::loader::{self, Subject};
use crate::message::{Running, Sweeping, Using};
use crate::report::plural;
use crate::run::{LONG_WAIT, wait_message};
use crate::{Status, input, interrupt, output, report, sweep};
use clap::{Args, ValueEnum};
use std::io::{self, Cursor};
use std::path::{Path, PathBuf};
use tip_log::Diagram;
use tip_runtime::printable::Printable;
use tip_sim::{Robot, urdf};
use tip_view::{DurationLimit, FrameRate, Outcome, Recording};
use tipc::Loaded;
use tipc::message::Lang;

/// Maximum length of a recording without `--cycles`, minutes of robot time.
const MAX_MINUTES: f64 = 10.0;

/// A recording and its robot.
struct Recorded {
    recording: Recording,
    robot: Robot,
}

impl Recorded {
    /// Returns the exit status for the end of the run.
    fn status(&self) -> Status {
        match self.recording.outcome {
            Outcome::Interrupted => Status::Interrupted,
            Outcome::Emergency(_) => Status::Emergency,
            Outcome::Program(_) | Outcome::Limit | Outcome::Unknown => Status::Success,
        }
    }
}

impl RunArguments {
    /// Runs the program until it ends, the time is over, or someone presses Ctrl-C.
    fn record(&self, pace: FrameRate, command: &'static str) -> Result<Recorded, Error> {
        let refusal = Using::ProcessIsRun { command };
        let Subject { loaded, robot, .. } = self.load(&self.file, false, refusal)?;
        let recording = self.recording(&loaded, &robot, pace)?;
        interrupt::hold();
        self.report_wait(&recording);
        if let Outcome::Emergency(_) = recording.outcome {
            report::complain(&format!("{}\n", recording.outcome));
        }
        Ok(Recorded { recording, robot })
    }

    /// Loads the program and the robot in its scene, and reports warnings unless `quiet`; `refusal` is the message that only the
    /// built-in plants can be used.
    pub(super) fn load(
        &self,
        program: &Path,
        quiet: bool,
        refusal: Using,
    ) -> Result<Subject, Error> {
        interrupt::catch();
        let subject = loader::load(program, self, Some(refusal))?;
        let (subject, _) = loader::sound(subject, self.source.output_options, quiet)?;
        Ok(subject)
    }

    /// Runs a loaded program.
    fn recording(
        &self,
        loaded: &Loaded,
        robot: &Robot,
        pace: FrameRate,
    ) -> Result<Recording, Error> {
        let inputs = self.inputs.inputs(robot);
        let extent = inputs
            .cycles
            .map_or(DurationLimit::minutes(MAX_MINUTES), DurationLimit::cycles);
        let goes_on = || !interrupt::is_requested();
        let recording = Recording::paced(loaded, robot, &inputs.events, extent, pace, goes_on);
        recording.map_err(|reason| Error::Usage(reason.to_string()))
    }

    /// Reports the wait at the end of a run, and the reason of an end that nobody asked for.
    fn report_wait(&self, recording: &Recording) {
        let lang = self.source.output_options.lang();
        let wait = recording.wait.as_ref().map(wait_message);
        let lasted = recording.time(recording.cycles);
        let is_cut_off = self.inputs.cycles.is_none() && recording.outcome == Outcome::Limit;
        let text = match wait {
            Some(wait) if is_cut_off && lasted < MAX_MINUTES * 60_000.0 => Running::StopsWaiting {
                wait,
                time: format!("{:.0}", LONG_WAIT / 1000.0),
            },
            Some(wait) if is_cut_off => Running::StopsInTimeWaiting {
                minutes: MAX_MINUTES.to_string(),
                wait,
            },
            None if is_cut_off => Running::StopsInTime {
                minutes: MAX_MINUTES.to_string(),
            },
            Some(wait) => Running::IsWaiting { wait },
            None => return,
        };
        report::say(text, lang);
    }
}

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip view walk.prg                            runs it, and writes walk.html
  tip view walk.prg -o monday.html --halt 300  all inputs of 'tip run'
  tip view --robot hand grasp.prg --scene scene.toml
  tip view march.prg --robot hexapod.toml --cycles 2000
  tip run walk.prg --trace walk.jsonl --trace-motion
  tip view walk.jsonl --program walk.prg       the run of that trace
  tip run walk.prg --trace slow.jsonl --trace-motion --events '20:set SPEED=200'
  tip view walk.jsonl slow.jsonl --program walk.prg   both, into walk-slow.html: plots over each other, the second robot as a ghost
  tip view walk.prg -o - > walk.html           to standard output
  tip view runs.csv                            the table of 'tip sweep': plots, and the worst cases first
  tip view runs.csv --case 3                   the run of a row of that table

The page is one file that makes no network requests: it opens by double click, and can be sent or
embedded in another page. It shows the robot in three dimensions next to the running line, with
messages, falls, slips, forces and plots on one time axis. Its address takes #cycle=611.

A run is recorded for ten minutes of the robot's time, or for --cycles; without --cycles it also ends
when it has waited for a minute without a motion. The page is written however the run ends.

Exit status: 0 written, 1 the program does not load or a file cannot be read or written,
2 wrong usage, 130 interrupted; what was recorded until then is written.")]
pub(super) struct View {
    #[command(flatten)]
    pub(super) run: RunArguments,

    /// A second program or trace, to compare
    #[arg(value_name = "OTHER")]
    other: Option<PathBuf>,

    /// The program of FILE, if that is a trace
    ///
    /// 'tip run --trace-motion' writes such a trace
    #[arg(long, value_name = "FILE.prg", conflicts_with_all = ["cycles", "keys", "halt", "sensors", "events"])]
    program: Option<PathBuf>,

    /// The row to replay, if FILE is a table
    ///
    /// 'tip sweep' writes such a table
    #[arg(long, value_name = "N", value_parser = count, allow_negative_numbers = true)]
    case: Option<u64>,

    /// The page; else FILE.html, FILE-OTHER.html here
    ///
    /// '-' is standard output
    #[arg(short, long, value_name = "OUT.html")]
    out: Option<PathBuf>,

    /// Print only errors
    #[arg(long, short)]
    quiet: bool,
}

impl Action for View {
    fn complete(&mut self) -> Result<(), Error> {
        // A table names its program and robot itself.
        if sweep::is_table(&self.run.file) {
            return Ok(());
        }
        let program = self.program(&self.run.file);
        self.run.complete(&program).map(drop)
    }

    fn execute(&self) -> Result<Status, Error> {
        view(self)
    }
}

/// Records a run, or reads the trace of one, and writes the page that replays it.
fn view(arguments: &View) -> Result<Status, Error> {
    let run = &arguments.run;
    let own = arguments.program.as_ref().map(|_| "--program");
    if sweep::is_table_of(run, own)? {
        return arguments.table();
    }
    if arguments.case.is_some() {
        return Err(Error::usage(Using::CaseNeedsTable, arguments.lang()));
    }
    let out = arguments.out();
    let mut read = run.files();
    read.extend(arguments.program.as_deref());
    read.extend(arguments.other.as_deref());
    output::refuse_inputs(&out, &read)?;
    let reading = arguments.reading();
    let mut recording = reading.recording(&run.file)?;
    let other = arguments.other.as_ref();
    let mut other = other.map(|other| reading.recording(other)).transpose()?;
    if let Some((other, file)) = other.as_mut().zip(arguments.other.as_deref()) {
        tell_apart([(&mut recording, &run.file), (other, file)]);
    }
    for trace in [Some(&recording), other.as_ref()].into_iter().flatten() {
        if trace.outcome == Outcome::Unknown && !arguments.quiet {
            let (file, cycle) = (trace.script.name.clone(), trace.cycles.to_string());
            report::say(Using::ShowsCutTrace { file, cycle }, arguments.lang());
        }
    }
    interrupt::hold();
    let page = match &other {
        Some(other) => recording.to_comparison(other),
        None => recording.to_page(),
    };
    output::replace(&out, &page)?;
    if !arguments.quiet {
        report::complain(&match &other {
            Some(other) => comparison(&recording, other, &out, page.len()),
            None => summary(&recording, &out, page.len()),
        });
        if !reading.is_trace(&run.file) {
            run.report_wait(&recording);
        }
    }
    Ok(match recording.outcome {
        Outcome::Interrupted if interrupt::is_requested() => Status::Interrupted,
        _ => Status::Success,
    })
}

/// Returns the path of a file in this folder, named after the program; `run` if that is a stream.
fn named_after(program: &Path, ending: &str) -> PathBuf {
    let name = program.file_name().filter(|_| !input::is_stream(program));
    PathBuf::from(name.unwrap_or("run".as_ref())).with_extension(ending)
}

/// Maximum size of a trace, MiB: some hours of robot time.
const MAX_TRACE: usize = 1024;

impl View {
    fn lang(&self) -> Lang {
        self.run.source.output_options.lang()
    }

    /// Returns the path of the page.
    fn out(&self) -> PathBuf {
        let page = named_after(&self.run.file, "html");
        match (&self.out, &self.other) {
            (Some(out), _) => out.clone(),
            (None, None) => page,
            // A page of the first run alone stays as it is.
            (None, Some(other)) => {
                let mut name = page.file_stem().unwrap_or_default().to_owned();
                name.push("-");
                name.push(named_after(other, "html").file_name().unwrap_or_default());
                page.with_file_name(name)
            }
        }
    }

    /// Writes the page of a table, or that of one of its runs.
    fn table(&self) -> Result<Status, Error> {
        let (file, lang) = (&self.run.file, self.lang());
        let out = match (&self.out, self.case) {
            (None, Some(case)) => named_after(file, &format!("{case}.html")),
            _ => self.out(),
        };
        if self.other.is_some() {
            return Err(Error::usage(Using::OneTable, lang));
        }
        output::refuse_inputs(&out, &[file, &sweep::specification(file)])?;
        if let Some(case) = self.case {
            let recording = sweep::record(file, case, lang)?;
            let page = recording.to_page();
            output::replace(&out, &page)?;
            if !self.quiet {
                report::complain(&summary(&recording, &out, page.len()));
            }
            return Ok(Status::Success);
        }
        let (page, runs) = sweep::page(file, false, lang)?;
        output::replace(&out, &page)?;
        if !self.quiet {
            let page = Sweeping::Page {
                file: Printable::line(out.display()).to_string().into(),
                runs: runs.to_string(),
                size: (page.len() / 1000).to_string(),
            };
            report::say(page, lang);
        }
        Ok(Status::Success)
    }

    /// Returns the program of a file: itself, or that of a trace, which is next to it by default.
    pub(super) fn program(&self, file: &Path) -> PathBuf {
        self.reading().program(file)
    }

    fn reading(&self) -> Reading<'_> {
        Reading {
            run: &self.run,
            program: self.program.as_deref(),
            is_alone: self.other.is_none(),
            quiet: self.quiet,
            command: "view",
        }
    }
}

/// The way in which files become recordings.
pub(super) struct Reading<'a> {
    pub(super) run: &'a RunArguments,
    /// The program of traces.
    pub(super) program: Option<&'a Path>,
    /// There is one file, so that `program` says that it is a trace.
    pub(super) is_alone: bool,
    pub(super) quiet: bool,
    pub(super) command: &'static str,
}

impl Reading<'_> {
    fn lang(&self) -> Lang {
        self.run.source.output_options.lang()
    }

    /// Returns true if a file is a trace, not a program.
    fn is_trace(&self, file: &Path) -> bool {
        let is_trace = file.extension().is_some_and(|ending| ending == "jsonl");
        is_trace || self.program.is_some() && self.is_alone
    }

    /// Returns the program of a file: itself, or that of a trace, which is next to it by default.
    pub(super) fn program(&self, file: &Path) -> PathBuf {
        match self.program {
            Some(program) if self.is_trace(file) => program.to_owned(),
            None if self.is_trace(file) => file.with_extension("prg"),
            _ => file.to_owned(),
        }
    }

    /// Runs a program, or reads a trace.
    pub(super) fn recording(&self, file: &Path) -> Result<Recording, Error> {
        let (is_trace, program) = (self.is_trace(file), self.program(file));
        if self.program.is_none() && is_trace && !program.exists() {
            let file = file.display().to_string().into();
            return Err(Error::usage(
                Using::TraceWithoutProgram { file },
                self.lang(),
            ));
        }
        let refusal = Using::ProcessIsRun {
            command: self.command,
        };
        let Subject { loaded, robot, .. } = self.run.load(&program, self.quiet, refusal)?;
        if !is_trace {
            return self.run.recording(&loaded, &robot, FrameRate::Smooth);
        }
        let (name, trace) = self.text(file)?;
        let read = Recording::from_trace(&trace, &loaded, &robot);
        let mut recording = read.map_err(|error| Error::Failed(format!("{name}: {error}")))?;
        // Two traces may be of one program.
        recording.script.name = name;
        Ok(recording)
    }

    /// Reads a trace or a table; returns its printable name, too.
    fn text(&self, file: &Path) -> Result<(String, String), Error> {
        let name = Printable::line(file.display()).to_string();
        let failed = |error: &dyn std::fmt::Display| Error::Failed(format!("{name}: {error}"));
        let read = input::read(file, MAX_TRACE);
        let read = read.map_err(|reason| failed(&reason.in_lang(self.lang())))?;
        let text = String::from_utf8(read).map_err(|error| failed(&error))?;
        Ok((name, text))
    }
}

/// Names two runs by the paths of their files if the names are equal.
pub(super) fn tell_apart(runs: [(&mut Recording, &Path); 2]) {
    if runs[0].0.script.name == runs[1].0.script.name {
        for (run, file) in runs {
            run.script.name = Printable::line(file.display()).to_string();
        }
    }
}

/// Returns the summary of a page.
fn summary(recording: &Recording, out: &Path, bytes: usize) -> String {
    let (name, size) = (Printable::line(output::name(out)), kilobytes(bytes));
    format!("{name}: {}, {size}\n", figures(recording))
}

/// Returns the summary of a page that compares two runs.
fn comparison(recording: &Recording, other: &Recording, out: &Path, bytes: usize) -> String {
    let (name, size) = (Printable::line(output::name(out)), kilobytes(bytes));
    let [one, other] = [recording, other]
        .map(|run| format!("{}: {}", Printable::line(&run.script.name), figures(run)));
    format!("{name}: {size}\n  {one}\n  {other}\n")
}

/// Returns how long a run took, and how often the robot fell.
fn figures(recording: &Recording) -> String {
    let cycles = plural(recording.cycles as usize, "cycle");
    let time = recording.time(recording.cycles) / 1000.0;
    let falls = match recording.falls().count() {
        0 => String::new(),
        falls => format!(", {}", plural(falls, "fall")),
    };
    format!("{time:.3} s of robot time, {cycles}{falls}")
}

/// Returns the size of a page.
fn kilobytes(bytes: usize) -> String {
    format!("{} kB", (bytes as f64 / 1000.0).round())
}

#[derive(Debug, Args)]
#[command(
    after_long_help = "run.mcap holds the robot and its frames, joint states, forces, trails, objects, and what the program did: step and line,
flags, messages, variables. Foxglove and Rerun show it. run.csv has a row for each cycle. docs/logs.md lists topics and columns.

Examples:
  tip log walk.prg           walk.mcap in this folder
  tip log grasp.prg --robot hand --scene scene.toml -o grasp.csv --every 10
  tip log walk.prg -o -      the table on standard output

A run without an end is recorded for ten minutes of the robot's time, or until it has waited for a minute without a motion;
--cycles sets another end.

Exit status: as for 'tip run'."
)]
pub(super) struct Log {
    #[command(flatten)]
    pub(super) run: RunArguments,

    /// The file; '-' is a table on standard output
    ///
    /// Its extension selects the format; by default FILE.mcap in this folder
    #[arg(short, long, value_name = "OUT.mcap|OUT.csv")]
    out: Option<PathBuf>,

    /// Keep the motion of every Nth cycle
    ///
    /// By default MCAP has 50 Hz at most, CSV every cycle
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    every: Option<u64>,
}

/// The format of a log.
#[derive(Clone, Copy)]
enum LogFormat {
    Mcap,
    Csv,
}

impl LogFormat {
    fn of(path: &Path) -> Result<Self, Error> {
        match path.extension().and_then(|ending| ending.to_str()) {
            None if input::is_standard(path) => Ok(LogFormat::Csv),
            Some("mcap") => Ok(LogFormat::Mcap),
            Some("csv") => Ok(LogFormat::Csv),
            _ => Err(Error::Usage(
                "the name of a log must end in .mcap or .csv, or be -".to_owned(),
            )),
        }
    }

    fn pace(self, every: Option<u64>) -> FrameRate {
        match (self, every) {
            (_, Some(cycles)) => FrameRate::Every(cycles),
            (LogFormat::Mcap, None) => FrameRate::Smooth,
            (LogFormat::Csv, None) => FrameRate::Every(1),
        }
    }
}

impl Action for Log {
    fn complete(&mut self) -> Result<(), Error> {
        self.run.complete(&self.run.file.clone()).map(drop)
    }

    fn execute(&self) -> Result<Status, Error> {
        log(self)
    }
}

/// Runs the program and writes the log.
fn log(arguments: &Log) -> Result<Status, Error> {
    let out = arguments.out.clone();
    let out = &out.unwrap_or_else(|| named_after(&arguments.run.file, "mcap"));
    let kind = LogFormat::of(out)?;
    output::refuse_inputs(out, &arguments.run.files())?;
    let recorded = arguments.run.record(kind.pace(arguments.every), "log")?;
    let recording = &recorded.recording;
    // A long log takes seconds, during which a signal ends the command. Nothing is written until all of it is there.
    interrupt::release();
    let mut bytes = Vec::new();
    let written: io::Result<()> = match kind {
        LogFormat::Mcap => tip_log::mcap(
            recording,
            &urdf::export(&recorded.robot),
            Cursor::new(&mut bytes),
        ),
        LogFormat::Csv => tip_log::csv(recording, &mut bytes),
    };
    written.map_err(|reason| Error::cannot_write(out, reason))?;
    output::replace_unless_interrupted(out, &bytes)?;
    let (cycles, frames) = (recording.cycles, recording.frames.len());
    report::complain(&format!(
        "{}: {cycles} cycles, poses and forces of {frames} cycles, {}\n",
        output::name(out),
        recording.outcome
    ));
    Ok(recorded.status())
}

#[derive(Debug, Args)]
#[command(
    after_long_help = "The diagrams have units on their axes and are readable on light and dark grounds; --lang ja titles them in Japanese.

Examples:
  tip plot walk.prg                            runs it, and writes walk.svg
  tip plot walk.prg -o -                       to standard output
  tip plot walk.prg -o gait.svg --of gait --of forces

Exit status: as for 'tip run'."
)]
pub(super) struct Plot {
    #[command(flatten)]
    pub(super) run: RunArguments,

    /// The file; else FILE.svg in this folder
    ///
    /// '-' is standard output
    #[arg(short, long, value_name = "OUT.svg")]
    out: Option<PathBuf>,

    /// gait, feet, angles, torques or forces
    ///
    /// The diagrams from top to bottom; by default all of them
    #[arg(long, value_name = "WHAT", value_enum)]
    of: Vec<DiagramName>,
}

/// The names of diagrams.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum DiagramName {
    /// The feet that carry the robot, or the fingertips that touch something
    Gait,
    /// The paths of the feet, mm
    Feet,
    /// The angle of each joint, deg
    Angles,
    /// The torque of each motor, N·m or mN·m
    Torques,
    /// The load of each foot, or the force of each fingertip, N
    Forces,
}

impl DiagramName {
    fn diagram(self) -> Diagram {
        match self {
            DiagramName::Gait => Diagram::Gait,
            DiagramName::Feet => Diagram::Feet,
            DiagramName::Angles => Diagram::Angles,
            DiagramName::Torques => Diagram::Torques,
            DiagramName::Forces => Diagram::Forces,
        }
    }
}

impl Action for Plot {
    fn complete(&mut self) -> Result<(), Error> {
        self.run.complete(&self.run.file.clone()).map(drop)
    }

    fn execute(&self) -> Result<Status, Error> {
        plot(self)
    }
}

/// Runs the program and writes the diagrams.
fn plot(arguments: &Plot) -> Result<Status, Error> {
    let out = arguments.out.clone();
    let out = &out.unwrap_or_else(|| named_after(&arguments.run.file, "svg"));
    output::refuse_inputs(out, &arguments.run.files())?;
    let recorded = arguments.run.record(FrameRate::Smooth, "plot")?;
    let diagrams: Vec<Diagram> = match arguments.of.as_slice() {
        [] => Diagram::ALL.into(),
        some => some.iter().map(|what| what.diagram()).collect(),
    };
    let lang = arguments.run.source.output_options.lang();
    let drawn = tip_log::plot(&recorded.recording, &diagrams, lang);
    let text = drawn.map_err(|reason| Error::cannot_write(out, reason))?;
    output::replace(out, text)?;
    if arguments.out.is_none() {
        report::complain(&format!("{}\n", out.display()));
    }
    Ok(recorded.status())
}
