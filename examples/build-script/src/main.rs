//! `cargo run -p build-script`: see the README beside it.
#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    reason = "an example talks to people"
)]

use build_script::pushing_up;
use std::error::Error;
use std::fmt::Display;
use std::io::{self, Write};
use std::process::ExitCode;
use tip_runtime::console::Console;

/// Prints each message on a line of its own.
struct Lines;

impl Console for Lines {
    fn message(&mut self, text: &dyn Display) {
        // A console cannot refuse a text: a closed output loses it.
        let _ = writeln!(io::stdout(), "{text}");
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mut robot = pushing_up(Lines);
    let mut highest = 0.0_f64;
    while robot.cycle().is_running() {
        highest = highest.max(robot.hardware().body().position[2]);
    }
    let cycles = robot.cycles();
    writeln!(io::stdout(), "highest {highest:.0} mm, {cycles} cycles")?;
    Ok(match robot.emergency() {
        None => ExitCode::SUCCESS,
        Some(emergency) => {
            eprintln!("{emergency}");
            ExitCode::FAILURE
        }
    })
}
