//! Random motion programs: whole, valid by construction, each of a fixed seed.
//!
//! The arguments of commands are read from the compiler's own table, so that a new row is used immediately;
//! [`rust()`] compiles a batch of programs to one table of Rust for a test to run.

mod command;
mod condition;
mod control;
mod equation;
mod inputs;
mod later;
mod number;
mod operand;
mod rust;
mod text;
mod untidy;
mod writer;

pub use rust::{Tamper, rust};
pub use tipc::language::Edition;
pub use untidy::untidy;

use tip_runtime::random::Random;
use tipc::Robot;
use writer::Writer;

/// The numbers of SPECIAL that the native code of the test answers to, beside those of the hand: 30 is done immediately, 31
/// takes as many cycles as its argument says and then sets SPECIAL_FLAG0 … 9, 32 switches a lamp, 33 fails.
pub const NATIVE: [u8; 4] = [30, 31, 32, 33];

/// A random program.
#[derive(Clone, Debug, PartialEq)]
pub struct Specimen {
    /// Seed and settings that determine it.
    pub seed: u64,
    /// The robot it is for.
    pub robot: Robot,
    /// Its text.
    pub source: String,
}

/// Carefulness of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Temper {
    /// Its equations never feed on themselves and its numbers are in range: it runs for long.
    Calm,
    /// Anything that loads.
    Wild,
}

/// The program of a seed in an edition. Half of them are for TITAN VIII, the others for the hand and the generic robot.
pub fn program(edition: Edition, seed: u64) -> Specimen {
    let mut random = Random::new(seed);
    let robot = pick(
        &mut random,
        &[Robot::Titan8, Robot::Hand, Robot::Titan8, Robot::Generic],
    );
    let temper = pick(&mut random, &[Temper::Calm, Temper::Calm, Temper::Wild]);
    Specimen {
        seed,
        robot,
        source: Writer::new(random, edition, robot, temper).write(seed),
    }
}

/// One of several.
///
/// # Panics
/// There is none.
pub fn pick<T: Clone>(random: &mut Random, from: &[T]) -> T {
    random.pick(from).expect("one of several").clone()
}
