//! `tip sweep`: many runs of a program over ranges of its variables and of its surroundings, as one table.
//!
//! The table grows in `OUT.part`, in the order of cases, and gets its name when it is complete. The specification of the sweep is
//! written next to it; `--resume` and `tip view` read it.

mod summary;
mod table;

use crate::Action;
use crate::arguments::RunArguments;
use crate::choices::Format;
use crate::choices::{count, positive, quoted};
use crate::error::Error;
use crate::loader::{self, Subject};
use crate::message::{Sweeping, Using};
use crate::report::{Deny, RATE, progress_style};
use crate::setup::{PlantChoice, RobotChoice, SceneChoice};
use crate::{Status, input, interrupt, output, report};
use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::mpsc::{Sender, channel};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::{fmt, fs, thread};
use summary::Summary;
use table::Table;
pub(super) use table::{is_table, specification};
use tip_runtime::plant::Simulation;
use tip_runtime::printable::Printable;
use tip_sweep::{
    ArgumentError, Axis, Condition, Front, Goal, PlantSpec, Ranking, RobotSpec, Row, Sampling,
    Spec, SweepError, Text,
};
use tip_view::{DurationLimit, FrameRate, MAX_RUNS, Recording, SweepTable};
use tipc::message::Lang;

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip sweep walk.prg --vary STRIDE=160..240/20 --vary SPEED=200,300 --until 100s -o runs.csv
  tip sweep walk.prg --vary 'STRIDE=uniform(150,250)' --repeat 20 --seed 7 --until 60s --deny falls -o runs.csv
  tip sweep walk.prg --plant dynamic --vary push.x=0..40/20 --until 5s -o pushed.csv
  tip sweep grasp.prg --robot hand --scene scene.toml --vary scene.object.1.friction=0.3,0.6 -o grasps.csv
  tip sweep walk.prg --vary STRIDE=160..240/20 -o strides.csv --resume
  tip sweep walk.prg --vary SPEED=200..400/50 --maximize speed --maximize least_margin --where 'slip<5' -o runs.csv
  tip view runs.csv                      the page of the table
  tip view runs.csv --case 3             the replay page of a run

Names of quantities:
  STRIDE, P.X                     a variable of the program: its value replaces the constants that are assigned before its first use
  friction                        the floor's, short for scene.floor.friction
  scene.KEY, robot.KEY            a number of the scene file or of the robot's description, such as scene.floor.slope.1, robot.body.mass
  push.x, push.y, push.z          a force on a robot with mass, N; push.at and push.for are its start and duration, s (1 and 0.2)
  noise.angle, noise.sole         standard deviations of measured joint angles (deg) and soles (V)
  sensor.VR1                      the reading of an input, V

Goals and conditions name columns of the table; without a goal a walking robot is ranked by speed. A run that fell or
stopped is never ranked. With --resume other goals rank a table that is complete.

Lists and ranges are combined with one another; --repeat is the number of cases of each combination. Random values
differ from case to case and depend on --seed and the number of the case alone: a table is the same with
any number of threads. The table grows in OUT.csv.part and is renamed when it is complete; the specification goes to
OUT.sweep.json. Ctrl-C and kill keep finished runs, --resume goes on.

Exit status: 0 complete, 1 the program does not load or has a denied warning, or a file cannot be written, 2 wrong usage,
4 a robot fell, with --deny falls, or its parts met, with --deny collisions, 130 interrupted.")]
pub(super) struct Sweep {
    #[command(flatten)]
    pub(super) run: RunArguments,

    /// Vary a quantity
    ///
    /// NAME=FROM..TO/STEP, NAME=A,B,C, NAME=uniform(LOW,HIGH) or NAME=normal(MEAN,DEVIATION)
    #[arg(long, value_name = "NAME=VALUES", value_parser = argument::<Axis>)]
    vary: Vec<Axis>,

    /// Cases of each combination
    #[arg(long, value_name = "N", default_value = "1", value_parser = positive, allow_negative_numbers = true)]
    repeat: u64,

    /// The seed of random values
    #[arg(long, value_name = "N", default_value = "0", value_parser = count, allow_negative_numbers = true)]
    seed: u64,

    /// The sampling of random values
    #[arg(long, value_enum, default_value = "random", hide_short_help = true)]
    sampling: SamplingName,

    /// The longest run
    #[arg(long, value_name = "TIME", default_value = "60s", value_parser = seconds, allow_negative_numbers = true)]
    until: f64,

    /// Add last values of variables to the table
    #[arg(
        long,
        value_name = "NAME,...",
        value_delimiter = ',',
        hide_short_help = true
    )]
    record: Vec<String>,

    /// Rank the runs by a column: more is better
    ///
    /// Several goals give the Pareto front
    #[arg(long, value_name = "NAME")]
    maximize: Vec<String>,

    /// Rank the runs by a column: less is better
    #[arg(long, value_name = "NAME")]
    minimize: Vec<String>,

    /// Rank only the runs with such a number
    ///
    /// The name of a column, one of < <= > >= =, and a number
    #[arg(long = "where", value_name = "CONDITION", value_parser = argument::<Condition>)]
    conditions: Vec<Condition>,

    #[command(flatten)]
    deny: Deny,

    /// The table, or '-' for standard output
    #[arg(short, long, value_name = "OUT.csv|-")]
    out: PathBuf,

    /// Go on with an unfinished table
    #[arg(long)]
    resume: bool,

    /// Replace a table that exists
    #[arg(long, conflicts_with = "resume")]
    force: bool,

    /// The number of threads; else that of cores
    #[arg(
        long,
        value_name = "N",
        value_parser = threads,
        allow_negative_numbers = true,
        hide_short_help = true
    )]
    jobs: Option<u64>,

    /// Print only errors
    #[arg(long, short)]
    quiet: bool,
}

/// The names of sampling methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SamplingName {
    /// Independent samples
    Random,
    /// One sample in each of --repeat equally likely intervals
    LatinHypercube,
}

/// Parses an axis or a condition.
fn argument<T: FromStr<Err = ArgumentError>>(text: &str) -> Result<T, Using> {
    text.parse().map_err(|error: ArgumentError| {
        let reason = error.message();
        Using::NotAnArgument { reason }
    })
}

/// Parses a number of threads.
fn threads(text: &str) -> Result<u64, Using> {
    positive(text).map_err(|_| Using::NotThreads {
        text: text.to_owned(),
    })
}

/// Parses a time: `60s`, `500ms` or a number of seconds.
fn seconds(text: &str) -> Result<f64, Using> {
    let (number, unit) = match (text.strip_suffix("ms"), text.strip_suffix('s')) {
        (Some(number), _) => (number, 1e-3),
        (None, Some(number)) => (number, 1.0),
        (None, None) => (text, 1.0),
    };
    match number.trim().parse::<f64>() {
        Ok(time) if time > 0.0 && time.is_finite() => Ok(time * unit),
        _ => Err(Using::NotATime {
            text: text.to_owned(),
        }),
    }
}

/// Largest number of cases that a thread runs before it hands them over.
const MAX_CHUNK: u64 = 32;
/// Smallest number of chunks of a thread, if there are as many cases: the last threads to end do so at nearly the same time.
const CHUNKS: u64 = 4;
/// Largest number of threads.
const MAX_THREADS: u64 = 1024;
/// Largest number of chunks per thread that wait for one before them to be written.
const AHEAD: u64 = 16;

impl Action for Sweep {
    fn complete(&mut self) -> Result<(), Error> {
        self.run.complete(&self.run.file.clone()).map(drop)
    }

    fn format(&self) -> Option<Format> {
        Some(self.run.source.output_options.message_format)
    }

    fn execute(&self) -> Result<Status, Error> {
        sweep(self)
    }
}

/// Runs the cases and writes the table.
fn sweep(arguments: &Sweep) -> Result<Status, Error> {
    interrupt::catch();
    let run = &arguments.run;
    let lang = run.source.output_options.lang();
    let refusal = Using::ProcessRunsOnce { command: "sweep" };
    let subject = loader::load(&run.file, run, Some(refusal))?;
    let (subject, _) = loader::sound(subject, run.source.output_options, arguments.quiet)?;
    if arguments.deny.rejects(&subject.loaded) {
        return Ok(Status::Failure);
    }
    let spec = arguments.spec(&subject)?;
    let usage = |error: SweepError| Error::Usage(error.text(lang));
    let sweep = tip_sweep::Sweep::new(spec).map_err(usage)?;
    if let Some(axis) = sweep.idle_axis().filter(|_| !arguments.quiet) {
        let axis = axis.to_owned();
        report::say(Sweeping::Idle { axis }, lang);
    }
    let ranking = arguments.ranking().of(sweep.columns()).map_err(usage)?;
    let (mut table, mut summary) = match input::is_stream(&arguments.out) {
        true if arguments.resume => {
            return Err(Error::usage(Using::ResumesNothing, lang));
        }
        true => (Table::Stream, Summary::new(ranking)),
        false => {
            output::refuse_inputs(&arguments.out, &run.files())?;
            Table::open(
                &arguments.out,
                &sweep,
                ranking,
                arguments.resume,
                arguments.force,
                lang,
            )?
        }
    };
    let began = summary.runs;
    let cores = || thread::available_parallelism().map_or(1, |cores| cores.get() as u64);
    let threads = arguments.jobs.unwrap_or_else(cores);
    let work = Work::new(sweep.cases(), began, threads, lang);
    let bar = arguments.bar(work.cases, began, lang);
    let ended = work.run(&sweep, &mut table, &mut summary, &bar);
    let elapsed = bar.elapsed();
    bar.finish_and_clear();
    interrupt::hold();
    let complete = summary.runs == work.cases;
    if complete {
        table.finish(&sweep, summary.ranking(), lang)?;
    }
    let name = Printable::line(arguments.out.display()).to_string();
    if !arguments.quiet {
        let rate = (summary.runs - began, elapsed);
        report::complain(&summary.text(&name, table.is_stream(), arguments.until, rate, lang));
    }
    if complete {
        ended?;
        let has_fallen = arguments.deny.falls() && summary.fell() > 0;
        let has_collided = arguments.deny.collisions() && summary.collided() > 0;
        return Ok(match has_fallen || has_collided {
            true => Status::Fell,
            false => Status::Success,
        });
    }
    if !table.is_stream() {
        let kept = Sweeping::Kept {
            runs: summary.runs.to_string(),
            all: work.cases.to_string(),
            part: table::with_part(&arguments.out)
                .display()
                .to_string()
                .into(),
        };
        report::say(kept, lang);
    }
    ended?;
    Ok(match interrupt::is_requested() {
        true => Status::Interrupted,
        // The reader of standard output has closed it.
        false => Status::Success,
    })
}

impl Sweep {
    fn ranking(&self) -> Ranking {
        let goals = self.maximize.iter().cloned().map(Goal::Maximize);
        let goals = goals.chain(self.minimize.iter().cloned().map(Goal::Minimize));
        Ranking {
            goals: goals.collect(),
            conditions: self.conditions.clone(),
        }
    }

    /// Returns the specification of the sweep of a loaded program.
    fn spec(&self, subject: &Subject) -> Result<Spec, Error> {
        let inputs = &self.run.inputs;
        let robot = match self.run.source.robot() {
            RobotChoice::File(path) => RobotSpec::Description(description(path)?),
            named => RobotSpec::Name(named.to_string()),
        };
        let scene = match &inputs.scene {
            None => None,
            Some(SceneChoice::File(path)) => Some(text(path)?),
            Some(named) => Some(named.to_string()),
        };
        let plant = inputs.plant.as_ref().and_then(PlantChoice::simulation);
        let inputs = inputs.inputs(&subject.robot);
        let source = &subject.loaded.source;
        Ok(Spec {
            program: Text {
                name: source.name().to_owned(),
                text: source.text().to_owned(),
            },
            robot,
            scene,
            plant: match plant {
                None => PlantSpec::Scene,
                Some(Simulation::QuasiStatic) => PlantSpec::QuasiStatic,
                Some(Simulation::Dynamic) => PlantSpec::Dynamic,
            },
            vary: self.vary.clone(),
            sampling: match self.sampling {
                SamplingName::Random => Sampling::Random,
                SamplingName::LatinHypercube => Sampling::LatinHypercube,
            },
            repeat: self.repeat,
            seed: self.seed,
            events: inputs.events.to_string(),
            until: self.until,
            cycles: inputs.cycles,
            record: self.record.clone(),
        })
    }

    fn bar(&self, cases: u64, began: u64, lang: Lang) -> ProgressBar {
        let target = match self.quiet {
            true => ProgressDrawTarget::hidden(),
            false => ProgressDrawTarget::stderr_with_hz(RATE),
        };
        // The rate is that of the cases that are run now.
        let bar = ProgressBar::with_draw_target(Some(cases - began), target);
        let hole = |name: &str| name.to_owned().into();
        let progress = Sweeping::Progress {
            at: hole("{at}"),
            all: cases.to_string().into(),
            fell: hole("{msg}"),
            rate: hole("{per_sec}"),
            left: hole("{eta}"),
        };
        let template = format!("{{wide_bar}} {}", progress.in_lang(lang));
        let at = move |state: &ProgressState, out: &mut dyn fmt::Write| {
            // Writing to memory cannot fail.
            let _ = write!(out, "{}", began + state.pos());
        };
        bar.set_style(progress_style(&template).with_key("at", at));
        bar
    }
}

/// Reads a file that has been read before.
fn text(path: &Path) -> Result<String, Error> {
    fs::read_to_string(path).map_err(|error| Error::Failed(format!("{}: {error}", path.display())))
}

/// Reads a description that has been read before, or imports it again.
fn description(path: &Path) -> Result<String, Error> {
    let failed = || Error::Failed(format!("{}: it has changed meanwhile", path.display()));
    let (_, bytes) = input::description_text(path).map_err(|_| failed())?;
    String::from_utf8(bytes).map_err(|_| failed())
}

/// The cases that are left, and the threads that run them.
struct Work {
    /// Number of all cases.
    cases: u64,
    /// The first case that is left.
    first: u64,
    threads: u64,
    /// Number of cases that a thread runs before it hands them over.
    chunk: u64,
    lang: Lang,
    progress: Mutex<Progress>,
    /// Tells threads that a chunk was written, or that they are to end.
    written: Condvar,
}

#[derive(Default)]
struct Progress {
    /// Number of chunks that threads have taken.
    taken: u64,
    /// Number of chunks that are in the table.
    written: u64,
    is_over: bool,
}

/// The results of some cases.
struct Chunk {
    index: u64,
    rows: Vec<Row>,
    /// The end of a sweep that ends early: an interruption, or an error.
    ended: Option<Result<(), Error>>,
}

impl Work {
    /// Divides the cases from `first` on among at most `threads` threads.
    fn new(cases: u64, first: u64, threads: u64, lang: Lang) -> Self {
        let left = cases - first;
        let threads = threads.min(MAX_THREADS).min(left).max(1);
        Work {
            cases,
            first,
            threads,
            chunk: (left / (threads * CHUNKS)).clamp(1, MAX_CHUNK),
            lang,
            progress: Mutex::default(),
            written: Condvar::new(),
        }
    }

    /// Runs all cases and writes them in order; an early end keeps those before it.
    fn run(
        &self,
        sweep: &tip_sweep::Sweep,
        table: &mut Table,
        summary: &mut Summary,
        bar: &ProgressBar,
    ) -> Result<(), Error> {
        let (sender, receiver) = channel();
        thread::scope(|scope| {
            for thread in 0..self.threads {
                let (sender, sweep) = (sender.clone(), sweep.clone());
                let run = move || self.chunks(&sweep, &sender);
                match thread::Builder::new().spawn_scoped(scope, run) {
                    Err(error) if thread == 0 => return Err(Error::Failed(error.to_string())),
                    // Fewer threads give the same table.
                    Err(_) => break,
                    Ok(_) => {}
                }
            }
            drop(sender);
            let mut waiting = BTreeMap::new();
            let mut next = 0;
            let ended = loop {
                let Ok(chunk) = receiver.recv() else {
                    break Ok(());
                };
                waiting.insert(chunk.index, chunk);
                if let Some(ended) = self.write(&mut waiting, &mut next, sweep, table, summary, bar)
                {
                    break ended;
                }
            };
            self.lock().is_over = true;
            self.written.notify_all();
            ended
        })
    }

    /// Writes the chunks whose turn it is.
    fn write(
        &self,
        waiting: &mut BTreeMap<u64, Chunk>,
        next: &mut u64,
        sweep: &tip_sweep::Sweep,
        table: &mut Table,
        summary: &mut Summary,
        bar: &ProgressBar,
    ) -> Option<Result<(), Error>> {
        while let Some(chunk) = waiting.remove(next) {
            match table.add(&chunk.rows, sweep, summary) {
                Err(error) => return Some(Err(error)),
                Ok(false) => return Some(Ok(())),
                Ok(true) => {}
            }
            bar.set_message(summary.fell().to_string());
            bar.set_position(summary.runs - self.first);
            if chunk.ended.is_some() {
                return chunk.ended;
            }
            *next += 1;
            self.lock().written = *next;
            self.written.notify_all();
        }
        None
    }

    /// Runs chunks until none is left.
    fn chunks(&self, sweep: &tip_sweep::Sweep, sender: &Sender<Chunk>) {
        let chunks = (self.cases - self.first).div_ceil(self.chunk);
        while let Some(index) = self.take(chunks) {
            let first = self.first + index * self.chunk;
            let mut chunk = Chunk {
                index,
                rows: Vec::new(),
                ended: None,
            };
            for case in first..(first + self.chunk).min(self.cases) {
                if interrupt::is_requested() {
                    chunk.ended = Some(Ok(()));
                    break;
                }
                match sweep.run_case(case) {
                    Ok(row) => chunk.rows.push(row),
                    Err(error) => {
                        chunk.ended = Some(Err(Error::Failed(error.text(self.lang))));
                        break;
                    }
                }
            }
            if sender.send(chunk).is_err() {
                return;
            }
        }
    }

    /// Takes the next chunk, when those before it are not too far behind.
    fn take(&self, chunks: u64) -> Option<u64> {
        let mut progress = self.lock();
        loop {
            if progress.is_over || progress.taken == chunks {
                return None;
            }
            if progress.taken < progress.written + self.threads * AHEAD {
                progress.taken += 1;
                return Some(progress.taken - 1);
            }
            let waited = self.written.wait(progress);
            progress = waited.unwrap_or_else(PoisonError::into_inner);
        }
    }

    fn lock(&self) -> MutexGuard<'_, Progress> {
        self.progress.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Returns true if a page is wanted of the table of a sweep.
///
/// # Errors
/// An option is given that the table fixes, such as the robot or `own`, one of the command; or the file is the specification.
pub(super) fn is_table_of(run: &RunArguments, own: Option<&'static str>) -> Result<bool, Error> {
    let (file, lang) = (&run.file, run.source.output_options.lang());
    let name = file.to_string_lossy();
    if let Some(table) = name.strip_suffix(".sweep.json") {
        let table = format!("{table}.csv").into();
        return Err(Error::usage(Using::IsSpecification { table }, lang));
    }
    if !is_table(file) {
        return Ok(false);
    }
    match run.fixed_by_table().or(own) {
        Some(option) => {
            let option = option.to_owned();
            Err(Error::usage(Using::TableFixes { option }, lang))
        }
        None => Ok(true),
    }
}

/// Reads the specification of a table, and how its runs are ranked.
fn specified(table: &Path, lang: Lang) -> Result<(tip_sweep::Sweep, Ranking), Error> {
    let usage = |error: SweepError| Error::Usage(error.text(lang));
    let saved = table::saved(table, lang)?;
    let sweep = tip_sweep::Sweep::new(saved.spec).map_err(usage)?;
    let ranking = saved.ranking.of(sweep.columns()).map_err(usage)?;
    Ok((sweep, ranking))
}

/// Returns the page of a table, and the number of its runs. If a server has the page, the runs open from it.
pub(super) fn page(file: &Path, is_served: bool, lang: Lang) -> Result<(String, u64), Error> {
    let (sweep, ranking) = specified(file, lang)?;
    let mut front = Front::new(ranking);
    let (mut runs, mut every) = (0, 1);
    let mut rows: Vec<Row> = Vec::new();
    table::rows(file, &sweep, lang, |row| {
        front.add(&row);
        if runs % every == 0 {
            rows.push(row);
        }
        runs += 1;
        if rows.len() > MAX_RUNS {
            every *= 2;
            rows = std::mem::take(&mut rows).into_iter().step_by(2).collect();
        }
    })?;
    let best = front.rows();
    let is_best = |row: &Row| best.iter().any(|best| best.case() == row.case());
    // The best ones are shown, whichever are left out.
    let left_out = best
        .iter()
        .filter(|best| rows.iter().all(|row| row.case() != best.case()));
    let left_out: Vec<Row> = left_out.map(|best| (*best).clone()).collect();
    rows.extend(left_out);
    rows.sort_by(|one, other| one.outcome().order(&other.outcome()));
    let kinds = rows.iter().map(|row| match row.has_failed() {
        true => 'x',
        false if is_best(row) => 'f',
        false => '.',
    });
    let name = input::name(file);
    let table = SweepTable {
        columns: &**sweep.columns(),
        rows: rows.iter().map(Row::cells).collect::<Vec<_>>(),
        kinds: kinds.collect(),
        ranking: front.ranking(),
        command: format!("tip view {}", quoted(&name)),
        every,
        is_served,
    };
    Ok((tip_view::sweep_page(&name, &table), runs))
}

/// Records a case of a table.
///
/// # Errors
/// There is no such case, or the table belongs to another specification.
pub(super) fn record(file: &Path, number: u64, lang: Lang) -> Result<Recording, Error> {
    interrupt::catch();
    let (sweep, _) = specified(file, lang)?;
    if file.exists() {
        table::rows(file, &sweep, lang, drop)?;
    }
    let spec = sweep.spec();
    let usage = |error: SweepError| Error::Usage(error.text(lang));
    let extent = match spec.cycles {
        Some(cycles) => DurationLimit::cycles(cycles),
        None => DurationLimit::Time {
            most: spec.until * 1000.0,
            wait: f64::INFINITY,
        },
    };
    let (name, program) = (&spec.program.name, spec.program.text.as_bytes());
    let case = sweep.case(number).map_err(usage)?;
    let run = sweep.start(&case).map_err(usage)?;
    let loaded = tip_lint::load(name, program, &case.robot.options());
    let goes_on = || !interrupt::is_requested();
    Recording::of_run(
        run,
        &loaded,
        &case.robot,
        extent,
        FrameRate::Smooth,
        goes_on,
    )
    .map_err(|reason| Error::Usage(reason.to_string()))
}
