//! `cargo run -p build-script`: see the README beside it.
#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    reason = "an example talks to people"
)]

use build_script::pushing_up;
use std::fmt::Display;
use std::process::ExitCode;
use tip_runtime::console::Console;

/// Prints each message on a line of its own.
struct Lines;

impl Console for Lines {
    fn message(&mut self, text: &dyn Display) {
        println!("{text}");
    }
}

fn main() -> ExitCode {
    let mut robot = match pushing_up(Lines) {
        Ok(robot) => robot,
        Err(mismatch) => {
            eprintln!("build-script: {mismatch}");
            return ExitCode::FAILURE;
        }
    };
    let mut highest = 0.0_f64;
    while robot.cycle().is_running() {
        highest = highest.max(robot.hardware().body().z);
    }
    println!("highest {highest:.0} mm, {} cycles", robot.cycles());
    match robot.emergency() {
        None => ExitCode::SUCCESS,
        Some(emergency) => {
            eprintln!("{emergency}");
            ExitCode::FAILURE
        }
    }
}
