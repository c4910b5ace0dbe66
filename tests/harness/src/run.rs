//! A run as a case wants it.

use crate::settings::Settings;
use tip_runtime::plant::Scene;
use tip_runtime::program::Program;
use tip_runtime::record::Ending;
use tip_sim::{Inputs, Limit, Robot, Run};

/// No case needs more cycles; one that has not ended by then never will.
const ENDLESS: u64 = 100_000;

/// The trace of a run, with the state in each record.
///
/// # Errors
/// The program is for another robot, what is to happen to it cannot, or it never ends.
pub fn run(program: impl Program + Clone + 'static, settings: &Settings) -> Result<String, String> {
    let inputs: Inputs = settings.inputs.parse().map_err(text)?;
    let run = Run::new(program, robot(settings)?).map_err(text)?;
    let mut run = run
        .with_events(&inputs.events)
        .map_err(text)?
        .with_trace(true);
    let limit = inputs.cycles.unwrap_or(u64::MAX);
    let ending = run.to_end(Limit::cycles(limit.min(ENDLESS)));
    match ending {
        Ending::Limit if limit > ENDLESS => Err(format!("it runs for more than {ENDLESS} cycles")),
        _ => Ok(run.trace()),
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
    match &settings.scene {
        Some(name) => {
            let scene = Scene::by_name(name).ok_or_else(|| format!("no scene is called {name}"))?;
            robot.with_scene(&scene).map_err(text)
        }
        None => Ok(robot),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tip_sim::load;

    #[test]
    fn what_cannot_happen_is_refused() {
        let robot = Robot::named("titan8").unwrap();
        let program = load("p.prg", "3.1\ntest\nEND\n", &robot).unwrap();
        let outcome = |option: &str, value: &str| {
            let mut settings = Settings::default();
            settings.add_input(option, value);
            run(program.clone(), &settings)
        };
        for (option, value) in [("--keys", "3"), ("--sensor", "VR1=8"), ("--cycles", "x")] {
            assert!(outcome(option, value).is_err(), "{option} {value}");
        }
        // An input may read nonsense.
        assert!(outcome("--sensor", "ANTENNA=nan@0").is_ok());
    }
}
