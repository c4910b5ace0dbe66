//! A trial of a program that another command is about to write: what goes wrong in simulation.

use crate::choices::OutputOptions;
use crate::message::{Driving, Weight};
use crate::run::emergency::Stopped;
use crate::run::summary::{collision, fall};
use tip_runtime::record::Ending;
use tip_sim::{FallKind, Interpreter, Limit, Robot, Run};
use tipc::Loaded;
use tipc::program::Program;

/// Time of the robot after which a trial is given up, ms.
const TRIAL_TIME: f64 = 3_600_000.0;

/// Runs a program in simulation, and returns reports of its first fall, its first collision, and an end that it has not given itself;
/// they are empty if all went well.
pub(crate) fn trial(
    loaded: &Loaded,
    program: &Program,
    robot: &Robot,
    options: OutputOptions,
) -> String {
    let weight = Weight::Warning;
    let (lang, source) = (options.lang(), &loaded.source);
    let Ok(mut run) = Run::new(Interpreter::new(program.clone()), robot.clone()) else {
        return String::new();
    };
    let ending = run.to_end(Limit::cycles((TRIAL_TIME / run.period()) as u64));
    let mut text = String::new();
    let Some(interpreter) = run.engine::<Interpreter>() else {
        return text;
    };
    if let Some((found, motion)) = run.first_fall().zip(run.motion()) {
        let kind = FallKind::of(&motion, found.is_upright);
        text += &fall(&found, &weight, kind, source, interpreter, lang);
    }
    if let Some(found) = run.first_collision() {
        text += &collision(&found, &weight, source, interpreter, lang);
    }
    match ending {
        Ending::Emergency(emergency) => {
            let stopped = Stopped {
                emergency,
                run: &run,
                program: interpreter,
                loaded,
                options: robot.options(),
                robot,
                description: &robot.description(),
            };
            text += &stopped.report(options);
        }
        Ending::Limit | Ending::Interrupted => {
            let time = format!("{:.0}", run.time() / 1000.0);
            let endless = Driving::RecordEndless { time };
            text += &format!("{}\n", endless.in_lang(lang));
        }
        Ending::Program(_) => {}
    }
    text
}
