//! The comparison of both engines of a program.

use crate::native::Native;
use crate::{Figures, Script, Subject, loaded};
use std::convert::Infallible;
use std::panic::{AssertUnwindSafe, catch_unwind};
use tip_lint::listing;
use tip_runtime::record::Ending;
use tip_runtime::special::hand::HandSpecials;
use tip_sim::lockstep::{
    Answer, Compared, Divergence, Evidence, Lockstep, LockstepObserver, RunEnd,
};
use tip_sim::search::{self, Diverging, Engines};
use tip_sim::{Inputs, Plant, Robot, StepTaken};

/// A run that both engines agree about.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Number of cycles that were compared.
    pub cycles: u64,
    /// The command or the error that ended it, or `LIMIT`.
    pub end: String,
    /// Everything that it did.
    pub hash: u64,
    /// Number of times that each step ended.
    pub visits: Vec<u64>,
}

/// The result for a comparison.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Not a bit differs.
    Same(Run),
    /// They part, or one of them panics.
    Different(Divergence),
}

/// Runs both engines of a subject by a script, and counts what ran.
///
/// # Panics
/// The subject does not load.
pub fn compare(subject: &Subject, script: &Script, figures: &mut Figures) -> Verdict {
    let (robot, loaded) = loaded(subject);
    let program = loaded.program.expect("what was compiled loads");
    let (steps, simulated) = (program.steps().len(), simulated(robot, script.plant));
    let compiled = (subject.1)();
    let lockstep = Lockstep::comparing(Evidence::Hashes, program, compiled, &simulated);
    let verdict = judge(&lockstep.expect("both are for this robot"), script, steps);
    if let Verdict::Same(run) = &verdict {
        let formal = listing::formal(&loaded.source, &loaded.module);
        figures.count_run(robot, &formal, run);
    }
    verdict
}

/// A robot with the SPECIAL commands of random programs.
fn simulated(robot: tipc::Robot, plant: Plant) -> Robot {
    let native = Native::default();
    let named = Robot::named(robot.name()).expect("random programs are for robots with names");
    let robot = match robot {
        tipc::Robot::Hand => named.with_special(HandSpecials::with_user(native)),
        _ => named.with_special(native),
    };
    robot.with_plant(plant)
}

fn judge(lockstep: &Lockstep, script: &Script, steps: usize) -> Verdict {
    if let Some(divergence) = lockstep.unlike() {
        return Verdict::Different(divergence);
    }
    let mut visits = Visits(vec![0; steps]);
    let ran = catch_unwind(AssertUnwindSafe(|| {
        lockstep.run(&script.inputs, &mut visits)
    }));
    match ran {
        Err(_) => Verdict::Different(Divergence {
            cycle: 0,
            step: 0,
            interpreted: "no panic".to_owned(),
            compiled: "a panic".to_owned(),
        }),
        Ok(compared) => verdict(
            compared.expect("scripts name inputs that the robot has"),
            visits,
        ),
    }
}

fn verdict(compared: Compared, visits: Visits) -> Verdict {
    if let Some(divergence) = compared.divergence {
        return Verdict::Different(divergence);
    }
    let (end, stopped) = match compared.ending {
        Some(Ending::Emergency(emergency)) => (emergency.fault.to_string(), true),
        Some(Ending::Program(end)) => (format!("{end:?}").to_uppercase(), false),
        Some(Ending::Limit | Ending::Interrupted) | None => ("LIMIT".to_owned(), false),
    };
    Verdict::Same(Run {
        // The cycle that stopped the robot was compared as well.
        cycles: compared.cycles + u64::from(stopped),
        end,
        hash: compared.hash,
        visits: visits.0,
    })
}

/// Number of times that each step ended.
struct Visits(Vec<u64>);

impl LockstepObserver for Visits {
    fn went(&mut self, _cycle: u64, StepTaken { from, to }: StepTaken) {
        // A step that waits is its own next one.
        if to.map(|to| to.step) != Some(from.step)
            && let Some(visits) = self.0.get_mut(from.step as usize)
        {
            *visits += 1;
        }
    }
}

/// The shortest script by which the engines of a subject still differ.
pub fn shrink(subject: &Subject, script: &Script, divergence: Divergence) -> (Script, Divergence) {
    let mut inputs = script.inputs.clone();
    inputs.cycles = Some(divergence.cycle + 1);
    let mut engines = Both {
        subject,
        plant: script.plant,
    };
    let Ok(shortest) = search::shrink(&mut engines, Diverging { inputs, divergence });
    let script = Script {
        inputs: shortest.inputs,
        ..script.clone()
    };
    (script, shortest.divergence)
}

/// The engines of a subject on one kind of robot.
struct Both<'a> {
    subject: &'a Subject,
    plant: Plant,
}

impl Engines for Both<'_> {
    type Error = Infallible;

    fn ask(&mut self, inputs: &Inputs) -> Result<Answer, Infallible> {
        let script = Script {
            plant: self.plant,
            inputs: inputs.clone(),
        };
        let verdict = compare(self.subject, &script, &mut Figures::default());
        Ok(match verdict {
            Verdict::Different(divergence) => Answer::Diverged(divergence),
            Verdict::Same(run) => Answer::Agreed {
                cycles: run.cycles,
                end: RunEnd::Limit,
                new: Vec::new(),
                chances: Vec::new(),
            },
        })
    }
}
