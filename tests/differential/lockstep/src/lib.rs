//! Random programs in both forms, compared by `tip-sim` cycle by cycle: the step, the next one, every variable, every
//! command, message, lamp and log, what the joints were sent and measured, and how the run ends. Numbers are compared by
//! their bits, all of them by a hash that goes on and on.

mod compare;
mod figures;
mod native;
mod script;

pub use compare::{Run, Verdict, compare, shrink};
pub use figures::Figures;
pub use script::Script;

use tip_sim::ProgramRunner;
use tipc::{Loaded, Options, Robot};

/// Seed, robot and text of a program, and a maker of its compiled form.
pub type Subject = ((u64, &'static str, &'static str), fn() -> ProgramRunner);

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
