//! `cargo run --release -p six-legs`: see the README beside it.

use six_legs::{SOURCE, Tripod, hexapod};
use std::error::Error;
use std::io::{self, Write};
use std::process::ExitCode;
use tip_sim::lockstep::Lockstep;
use tip_sim::{Inputs, load};
use walking::exit::exit;
use walking::race::race;

fn main() -> ExitCode {
    exit("six-legs", walk())
}

/// Whether the robot walked as it should, alike in both engines.
fn walk() -> Result<bool, Box<dyn Error>> {
    let robot = hexapod();
    let program = load("tripod.prg", SOURCE, &robot)?.program().clone();
    let lockstep = Lockstep::new(program, Tripod::new(), &robot)?;
    let inputs = Inputs {
        cycles: Some(u64::MAX),
        ..Inputs::default()
    };
    let outcome = race::<6, 3>(&lockstep, &inputs, true, &mut ())?;
    write!(io::stdout(), "{outcome}")?;
    Ok(outcome.is_good())
}
