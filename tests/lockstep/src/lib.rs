//! Two engines run the same program on two robots of their own, and after each cycle everything that can be told about
//! them must be the same: the step, the next one, every variable, every command, message, lamp and log, what the
//! joints were sent and measured, and how the run ends. Numbers are compared by their bits.
//!
//! Each cycle goes into a running hash on both sides, which is compared at once. Where it differs the run is repeated
//! and both sides write the cycle down.

mod duel;
mod echo;
mod figures;
mod machines;
mod native;
mod notes;
mod rig;
mod script;
mod shrink;
mod typist;

pub use duel::{Difference, Run, Verdict};

use duel::duel;
pub use figures::Figures;
pub use script::{Event, Happening, Scenery, Script};
pub use shrink::shrink;

use tip_runtime::program::Program;
use tip_sim::Interpreter;
use tipc::{Loaded, Options, Robot, listing};

/// Seed, robot and text of a program, and a maker of its compiled form.
pub type Subject = ((u64, &'static str, &'static str), fn() -> Box<dyn Program>);

/// The program of a subject for the reference interpreter.
///
/// # Panics
/// It does not load.
pub fn interpreter(subject: &Subject) -> (Robot, tipc::program::Program) {
    let (robot, loaded) = loaded(subject);
    (robot, loaded.program.expect("what was compiled loads"))
}

fn loaded(subject: &Subject) -> (Robot, Loaded) {
    let ((seed, robot, source), _) = subject;
    let robot = Robot::from_name(robot).expect("a robot of the compiler");
    let options = Options {
        robot,
        ..Options::default()
    };
    let name = format!("{seed}.prg");
    (robot, tipc::load(&name, source.as_bytes(), &options))
}

/// Runs both engines of a subject by a script, and counts what ran.
///
/// # Panics
/// The subject does not load.
pub fn compare(subject: &Subject, script: &Script, figures: &mut Figures) -> Verdict {
    let (robot, loaded) = loaded(subject);
    let program = loaded.program.expect("what was compiled loads");
    let make_interpreter = || Box::new(Interpreter::new(program.clone())) as Box<dyn Program>;
    let verdict = duel(robot, script, &make_interpreter, &subject.1);
    if let Verdict::Same(run) = &verdict {
        let formal = listing::formal(&loaded.source, &loaded.module);
        figures.count_run(robot, &formal, run);
    }
    verdict
}

#[cfg(test)]
mod tests;
