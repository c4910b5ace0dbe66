//! `tip verify`: compares compiled code with the reference interpreter on searched or given inputs, and prints a certificate or the
//! shortest inputs on which they differ.

use crate::Action;
use crate::arguments::{InputArguments, RunArguments};
use crate::choices::Format;
use crate::choices::{positive, quoted};
use crate::error::Error;
use crate::message::Using;
use crate::report::{RATE, progress_style, step_location};
use crate::setup::{ChosenRobot, PlantChoice};
use crate::{Status, interrupt, loader, output, report};
use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget};
use std::env;
use std::fmt::Write as _;
use std::io::{self, IsTerminal};
use std::path::PathBuf;
use std::thread::sleep;
use std::time::Duration;
use tip_lint::coverage_points::CoveragePoint;
use tip_runtime::plant::Simulation;
use tip_runtime::printable::Printable;
use tip_sim::Inputs;
use tip_sim::lockstep::{Answer, Divergence};
use tip_sim::search::{self, Coverage, Diverging, Engines, Failed};
use tip_sim::verify::{Project, Subject, VERSION};
use tipc::program::{Program, Step};
use tipc::source::Source;

#[derive(Debug, Args)]
#[command(
    after_long_help = "The program is compiled by tip and cargo, in release mode, with the tip-runtime of your project. Compiled code and
interpreter run side by side on two simulated robots; every record must be the same, floats by bits. Without inputs
tip makes many runs: it searches for keys, sensor readings and halt requests that lead to new steps and branches,
and always tries the same ones. What no run reached is listed. If the engines differ, the shortest inputs are output_options.

Examples:
  tip verify walk.prg
  tip verify walk.prg --keys 300:F,400:Q    these inputs only
  tip verify march.prg --robot hexapod.toml --cycles 2000 --runs 1000
  tip verify walk.prg --manifest-path controller/Cargo.toml

Exit status: 0 both agree, 1 they differ, or the program does not load or build, 2 wrong usage,
130 interrupted."
)]
pub(super) struct Verify {
    #[command(flatten)]
    pub(super) run: RunArguments,

    /// Number of runs of a search
    #[arg(long, value_name = "N", default_value = "256", value_parser = positive, allow_negative_numbers = true)]
    pub(super) runs: u64,

    /// The Cargo.toml whose tip-runtime is used
    ///
    /// By default that of the project around the current folder
    #[arg(long, value_name = "Cargo.toml")]
    pub(super) manifest_path: Option<PathBuf>,
}

impl Action for Verify {
    fn complete(&mut self) -> Result<(), Error> {
        self.run.complete(&self.run.file.clone()).map(drop)
    }

    fn format(&self) -> Option<Format> {
        Some(self.run.source.output_options.message_format)
    }

    fn execute(&self) -> Result<Status, Error> {
        verify(self)
    }
}

/// Builds the program, runs both engines, and prints a certificate, or the shortest input on which they differ.
fn verify(arguments: &Verify) -> Result<Status, Error> {
    interrupt::catch();
    let run = &arguments.run;
    let output_options = run.source.output_options;
    if let Some(0) = run.inputs.cycles {
        let text = "--cycles 0".to_owned();
        return Err(Error::usage(
            Using::NotPositive { text },
            output_options.lang(),
        ));
    }
    let refusal = Using::ProcessRunsOnce { command: "verify" };
    let loaded = loader::load(&run.file, run, Some(refusal))?;
    let (checked, program) = loader::sound(loaded, output_options, false)?;
    let inputs = run.inputs.inputs(&checked.robot);
    let project = Project::find(arguments.manifest_path.as_deref())?;
    let name = run.file.display().to_string();
    let source = checked.loaded.source.bytes();
    let options = run.source.options(checked.chosen.robot());
    let subject =
        Subject::new(&name, &source, options, &program).with_scene(*checked.robot.scene());
    let subject = match &checked.chosen {
        ChosenRobot::Named(_) => subject,
        ChosenRobot::Described(description) => subject.on(description),
    };
    building();
    let built = project.engines(&subject).map_err(Error::from);
    let built = built.map_err(interrupted_building)?;
    let runs = if inputs.events.is_empty() {
        arguments.runs
    } else {
        1
    };
    let mut engines = CountedEngines::new(built.given_up_if(interrupt::is_requested), runs);
    let compared = search::verify(&mut engines, &program, &inputs, arguments.runs);
    drop(engines);
    let (coverage, diverging) = compared.map_err(|failed| match failed {
        Failed::Refused(reason) => Error::Usage(reason),
        Failed::Engines(error) => error,
    })?;
    let source = &checked.loaded.source;
    match diverging {
        None => {
            output::print(certificate(
                source,
                &program,
                &project,
                &run.inputs,
                &coverage,
            ))?;
            Ok(Status::Success)
        }
        Some(shortest) => {
            output::print(divergence_text(source, &program, &shortest))?;
            Ok(Status::Failure)
        }
    }
}

/// Returns the certificate: what was compared, with what, and what no run reached.
fn certificate(
    source: &Source,
    program: &Program,
    project: &Project,
    inputs: &InputArguments,
    coverage: &Coverage,
) -> String {
    let name = Printable::line(source.name());
    let hash = program.source_hash();
    let robot = program.signature();
    let (robot, legs, joints) = (robot.robot, robot.legs, robot.joints);
    let scene = inputs.scene.as_ref();
    let mut scene = scene.map_or("level floor".to_owned(), |scene| {
        format!("scene {}", Printable::line(scene))
    });
    let plant = inputs.plant.as_ref().and_then(PlantChoice::simulation);
    let is_it = |(_, simulation): &&(&str, Simulation)| Some(*simulation) == plant;
    if let Some((name, _)) = Simulation::NAMES.iter().find(is_it) {
        scene = format!("{scene}, {name} plant");
    }
    let (rustc, cargo) = (
        project.version_of("RUSTC", "rustc"),
        project.version_of("CARGO", "cargo"),
    );
    let (runs, cycles) = (coverage.runs(), coverage.cycles);
    let (finished, limited, stopped) = (coverage.finished, coverage.limited, coverage.stopped);
    let all = coverage.reach.points().all();
    let missed: Vec<&CoveragePoint> = (0..)
        .zip(all)
        .filter(|(point, _)| !coverage.reach.has(*point))
        .map(|(_, point)| point)
        .collect();
    let covered = |is_kind: fn(&CoveragePoint) -> bool| {
        let of = all.iter().filter(|point| is_kind(point)).count();
        let missed = missed.iter().filter(|point| is_kind(point)).count();
        format!("{} of {of}", of - missed)
    };
    let steps = covered(|point| point.way.is_none());
    let edges = covered(|point| point.way.is_some());
    let mut text = format!(
        "{name}: compiled code and interpreter agree\n\
         source       {hash:016x}\n\
         tools        tip {VERSION}, {rustc}, {cargo}\n\
         robot        {robot}, {legs} x {joints} joints, {scene}\n\
         runs         {runs}: {finished} to END or EXIT, {limited} to the last cycle allowed, {stopped} to an emergency stop\n\
         compared     {cycles} cycles, each record with the state of every joint, floats by bits\n\
         steps        {steps}\n\
         branch edges {edges}\n"
    );
    let lines = missed.iter().filter(|point| !follows(point, &missed));
    let lines = lines.map(|point| {
        (
            point.step,
            point
                .way
                .map_or("not reached".to_owned(), |way| format!("never {way}")),
        )
    });
    let dead = (0..)
        .take(program.steps().len())
        .filter(|step| !coverage.reach.points().can_reach(*step));
    let dead = dead.map(|step| (step, "no way leads here".to_owned()));
    let mut lines: Vec<_> = lines.chain(dead).collect();
    lines.sort();
    for (step, what) in lines {
        if let Some(Step {
            line, text: own, ..
        }) = program.steps().get(step as usize)
        {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "  {name}:{line}: {what}: {}", Printable::line(own));
        }
    }
    text
}

/// Returns true for an edge of a step that was not reached: the step is listed already.
fn follows(point: &CoveragePoint, missed: &[&CoveragePoint]) -> bool {
    point.way.is_some()
        && missed
            .iter()
            .any(|other| other.way.is_none() && other.step == point.step)
}

/// The options that are replaced by the shortest inputs.
const INPUTS: [&str; 6] = [
    "--keys", "--sensor", "--halt", "--events", "--cycles", "--runs",
];

/// Returns the report of a divergence: location, the two records, and a command that repeats it.
fn divergence_text(source: &Source, program: &Program, diverging: &Diverging) -> String {
    let Diverging { inputs, divergence } = diverging;
    let Divergence {
        cycle,
        step,
        interpreted,
        compiled,
    } = divergence;
    let name = Printable::line(source.name());
    let location = step_location(source, program, *step);
    let command = Printable::line(without_inputs(env::args().skip(1)));
    format!(
        "{name}: compiled code and interpreter DIFFER in cycle {cycle}, step {step}\n\
         {location}interpreter  {interpreted}\ncompiled     {compiled}\n\
         again        tip {command} {inputs}\n"
    )
}

/// Returns a command line without the options of inputs.
fn without_inputs(arguments: impl Iterator<Item = String>) -> String {
    let mut words = Vec::new();
    let mut skips_value = false;
    for argument in arguments {
        let is_input = INPUTS.iter().any(|option| {
            let value = argument.strip_prefix(option);
            value.is_some_and(|value| value.is_empty() || value.starts_with('='))
        });
        if is_input {
            skips_value = !argument.contains('=');
        } else if !std::mem::take(&mut skips_value) {
            words.push(quoted(&argument));
        }
    }
    words.join(" ")
}

const COMPARES: &str = "comparing {wide_bar} {pos} of {len} runs, {msg} cycles, {eta} left";
const SHRINKS: &str = "they differ: looking for the shortest inputs, {pos} runs so far";
/// Time until the signal that ended cargo arrives here.
const MOMENT: Duration = Duration::from_millis(100);

/// Reports the build on a terminal; cargo shows its own progress.
fn building() {
    if io::stderr().is_terminal() {
        report::complain("building compiled code and interpreter with cargo (Ctrl-C ends it)\n");
    }
}

/// Returns the error of a build, which Ctrl-C may have ended.
fn interrupted_building(error: Error) -> Error {
    sleep(MOMENT);
    match interrupt::is_requested() {
        true => Error::Interrupted("while cargo built: nothing was compared".to_owned()),
        false => error,
    }
}

/// Engines with counts of their runs, for a line of progress and for the report of an interruption.
#[derive(Debug)]
struct CountedEngines<E> {
    engines: E,
    bar: ProgressBar,
    all: u64,
    runs: u64,
    cycles: u64,
    differ: bool,
}

impl<E> CountedEngines<E> {
    /// Returns engines for a search of `all` runs.
    fn new(engines: E, all: u64) -> Self {
        let target = ProgressDrawTarget::stderr_with_hz(RATE);
        let bar = ProgressBar::with_draw_target(Some(all), target);
        bar.set_style(progress_style(COMPARES));
        bar.set_message("0");
        CountedEngines {
            engines,
            bar,
            all,
            runs: 0,
            cycles: 0,
            differ: false,
        }
    }

    fn count(&mut self, answer: &Answer) {
        self.runs += 1;
        match answer {
            Answer::Agreed { cycles, .. } => self.cycles += cycles,
            Answer::Diverged(_) if !self.differ => {
                self.differ = true;
                self.bar.set_style(progress_style(SHRINKS));
            }
            Answer::Diverged(_) | Answer::Refused(_) => {}
        }
        self.bar.set_message(self.cycles.to_string());
        self.bar.set_position(self.runs);
    }

    fn interrupted(&self) -> Error {
        let (runs, all, cycles) = (self.runs, self.all, self.cycles);
        Error::Interrupted(match self.differ {
            true => "while looking for the shortest inputs: compiled code and interpreter DIFFER"
                .to_owned(),
            false => format!("after {runs} of {all} runs, {cycles} cycles: no difference so far"),
        })
    }
}

impl<E: Engines> Engines for CountedEngines<E>
where
    Error: From<E::Error>,
{
    type Error = Error;

    fn ask(&mut self, inputs: &Inputs) -> Result<Answer, Error> {
        let answer = match interrupt::is_requested() {
            true => Err(self.interrupted()),
            false => self.engines.ask(inputs).map_err(Error::from),
        };
        match answer {
            // They were given up.
            Err(_) if interrupt::is_requested() => Err(self.interrupted()),
            Err(error) => Err(error),
            Ok(answer) => {
                self.count(&answer);
                Ok(answer)
            }
        }
    }
}

impl<E> Drop for CountedEngines<E> {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_line_loses_its_inputs_and_keeps_the_rest() {
        let words =
            "verify --keys 3:a --robot six legs.toml --halt=5 p.prg --cycles 9 --sensor VR1=2@3";
        let words = words.replace("six legs", "six\u{1}legs");
        let words = words.split(' ').map(|word| word.replace('\u{1}', " "));
        assert_eq!(
            without_inputs(words),
            "verify --robot 'six legs.toml' p.prg"
        );
    }
}
