//! `cargo run --release -p six-legs`: see the README beside it.

use six_legs::{HEXAPOD, Tripod};
use std::error::Error;
use std::io::{self, Write};
use std::process::ExitCode;
use tip_runtime::machine::Machine;
use walking::{exit, run};

fn main() -> ExitCode {
    exit("six-legs", walk())
}

/// Returns true if the robot walked as it should.
fn walk() -> Result<bool, Box<dyn Error>> {
    let mut robot = Machine::simulated_on(Tripod::new(), &HEXAPOD)?;
    let outcome = run(&mut robot, u64::MAX, true, &mut ());
    write!(io::stdout(), "{outcome}")?;
    Ok(outcome.is_good())
}
