//! A run as a case wants it.

use case_files::Settings;
use tip_runtime::plant::Scene;
use tip_runtime::program::Program;
use tip_runtime::record::{Ending, JsonLines, Sink};
use tip_sim::lockstep::{Divergence, Lockstep, LockstepObserver};
use tip_sim::{Inputs, Limit, Plant, ProgramRunner, Robot, Run};

/// No case needs more cycles; one that has not ended by then never will.
const ENDLESS: u64 = 100_000;

/// The trace of a run, with the state in each record.
///
/// # Errors
/// The program is for another robot, what is to happen to it cannot, or it never ends.
pub fn run(
    program: impl Program + Clone + Send + 'static,
    settings: &Settings,
) -> Result<String, String> {
    let (inputs, limit) = inputs(settings)?;
    let run = Run::new(program, robot(settings)?).map_err(text)?;
    let mut run = run
        .with_events(&inputs.events)
        .map_err(text)?
        .with_trace(true);
    let ending = run.to_end(Limit::cycles(limit.min(ENDLESS)));
    ends(ending, limit)?;
    Ok(run.trace())
}

/// The trace of the interpreter, while generated code does the same in lock-step.
///
/// # Errors
/// Runs as [`run`] does, in both engines, which must agree.
pub fn both(
    program: tipc::program::Program,
    compiled: ProgramRunner,
    settings: &Settings,
) -> Result<String, String> {
    let (mut inputs, limit) = inputs(settings)?;
    inputs.cycles = Some(limit.min(ENDLESS));
    let lockstep = Lockstep::new(program, compiled, &robot(settings)?).map_err(text)?;
    if let Some(divergence) = lockstep.unlike() {
        return Err(differ(&divergence));
    }
    let mut records = Records(JsonLines::new(String::new(), true));
    let compared = lockstep.run(&inputs, &mut records).map_err(text)?;
    match (compared.divergence, compared.ending) {
        (Some(divergence), _) => Err(differ(&divergence)),
        (None, None) => Err("the engines neither differ nor end".to_owned()),
        (None, Some(ending)) => {
            ends(ending, limit)?;
            records.0.end(ending, compared.cycles);
            Ok(records.0.into_inner())
        }
    }
}

/// Writes down what the interpreter does.
struct Records(JsonLines<String>);

impl LockstepObserver for Records {
    fn sink(&mut self) -> Option<&mut dyn Sink> {
        Some(&mut self.0)
    }
}

fn differ(divergence: &Divergence) -> String {
    let Divergence {
        cycle,
        step,
        interpreted,
        compiled,
    } = divergence;
    format!(
        "in cycle {cycle}, step {step}, interpreter and generated code differ:\n  {interpreted}\n  {compiled}"
    )
}

/// Events of a run, and the maximum number of cycles of its case.
fn inputs(settings: &Settings) -> Result<(Inputs, u64), String> {
    let inputs: Inputs = settings.inputs.parse().map_err(text)?;
    let limit = inputs.cycles.unwrap_or(u64::MAX);
    Ok((inputs, limit))
}

fn ends(ending: Ending, limit: u64) -> Result<(), String> {
    match ending {
        Ending::Limit if limit > ENDLESS => Err(format!("it runs for more than {ENDLESS} cycles")),
        _ => Ok(()),
    }
}

fn text(error: impl std::fmt::Display) -> String {
    error.to_string()
}

fn robot(settings: &Settings) -> Result<Robot, String> {
    let robot = match &settings.description {
        Some(description) => Robot::described(description),
        None => Robot::named(settings.load.robot.name()).map_err(text)?,
    };
    let robot = robot.with_plant(match settings.has_mass {
        true => Plant::Dynamic,
        false => Plant::default(),
    });
    match &settings.scene {
        Some(name) => {
            let scene = Scene::by_name(name).ok_or_else(|| format!("no scene is called {name}"))?;
            robot.with_scene(&scene).map_err(text)
        }
        None => Ok(robot),
    }
}
