//! `cargo run -p wave`: see the README beside it.
#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    reason = "an example talks to people"
)]

use std::error::Error;
use std::fmt::Display;
use std::io::{self, Write};
use std::process::ExitCode;
use tip_runtime::console::Console;
use wave::waving;

/// Prints each message on a line of its own.
struct Lines;

impl Console for Lines {
    fn message(&mut self, text: &dyn Display) {
        // A console cannot refuse a text: a closed output loses it.
        let _ = writeln!(io::stdout(), "{text}");
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mut robot = waving(Lines);
    while robot.cycle().is_running() {
        if robot.cycles().is_multiple_of(25) {
            writeln!(
                io::stdout(),
                "{:5.1} s  {}",
                robot.cycles() as f64 * robot.period() / 1000.0,
                pendulum(robot.sensors().angles[1][0])
            )?;
        }
    }
    Ok(match robot.emergency() {
        None => ExitCode::SUCCESS,
        Some(emergency) => {
            eprintln!("{emergency}");
            ExitCode::FAILURE
        }
    })
}

/// The yaw angle of the waving leg as a mark on a line.
fn pendulum(angle: f64) -> String {
    let column = (angle.clamp(-20.0, 60.0) + 20.0) as usize / 2;
    format!("{}o  {angle:5.1} deg", " ".repeat(column))
}
