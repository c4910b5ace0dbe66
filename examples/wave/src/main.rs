//! `cargo run -p wave`: see the README beside it.
#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    reason = "an example talks to people"
)]

use std::fmt::Display;
use std::process::ExitCode;
use tip_runtime::console::Console;
use wave::waving;

/// Prints each message on a line of its own.
struct Lines;

impl Console for Lines {
    fn message(&mut self, text: &dyn Display) {
        println!("{text}");
    }
}

fn main() -> ExitCode {
    let mut robot = match waving(Lines) {
        Ok(robot) => robot,
        Err(mismatch) => {
            eprintln!("wave: {mismatch}");
            return ExitCode::FAILURE;
        }
    };
    while robot.cycle().is_running() {
        if robot.cycles() % 25 == 0 {
            println!(
                "{:5.1} s  {}",
                robot.cycles() as f64 * robot.period() / 1000.0,
                pendulum(robot.sensors().angles[1][0])
            );
        }
    }
    match robot.emergency() {
        None => ExitCode::SUCCESS,
        Some(emergency) => {
            eprintln!("{emergency}");
            ExitCode::FAILURE
        }
    }
}

/// The yaw angle of the waving leg as a mark on a line.
fn pendulum(angle: f64) -> String {
    let column = (angle.clamp(-20.0, 60.0) + 20.0) as usize / 2;
    format!("{}o  {angle:5.1} deg", " ".repeat(column))
}
