//! `cargo run --release -p six-legs`: see the README beside it.

use six_legs::{HEXAPOD, SOURCE, Tripod, interpreter};
use std::error::Error;
use std::io::{self, Write};
use std::process::ExitCode;
use walking::engine::{Engine, on_simulated_robot};
use walking::exit::exit;
use walking::race::Race;

fn main() -> ExitCode {
    exit("six-legs", walk())
}

/// Whether the robot walked as it should, alike in both engines.
fn walk() -> Result<bool, Box<dyn Error>> {
    let compiled = on_simulated_robot(Tripod::new(), &HEXAPOD, ())?;
    let interpreted = on_simulated_robot(interpreter(SOURCE)?, &HEXAPOD, ())?;
    let race = Race::new(Engine::new(compiled, true), Engine::new(interpreted, true));
    let outcome = race.run(None, &mut ());
    write!(io::stdout(), "{outcome}")?;
    Ok(outcome.is_good())
}
