//! `cargo run --release -p grasp`: see the README beside it.
#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    reason = "an example talks to people"
)]

use grasp::run::{height, run};
use grasp::{Grasp, SCENE, SOURCE};
use std::error::Error;
use std::fmt::Display;
use std::io::{self, Write};
use std::process::ExitCode;
use tip_runtime::console::Console;
use tip_runtime::plant::SimulatedHand;
use tip_sim::{Robot, load};
use walking::exit;

/// Time on the robot between two lines of progress: s. No whole number of the vibration's periods, so
/// that they show it.
const REPORT_EVERY: f64 = 0.45;

fn main() -> ExitCode {
    exit("grasp", grasp_and_compare())
}

fn grasp_and_compare() -> Result<bool, Box<dyn Error>> {
    let mut out = io::stdout();
    writeln!(out, "  time     height  contact forces on the cylinder, N")?;
    let mut due = REPORT_EVERY;
    let mut failure = None;
    let compiled = run(Grasp::new(), &SCENE, Messages, |time, hand| {
        if time >= due && failure.is_none() {
            due += REPORT_EVERY;
            failure = progress(time, hand).err();
        }
    })?;
    if let Some(failure) = failure {
        return Err(failure.into());
    }
    let program = load("grasp.prg", SOURCE, &Robot::named("hand")?)?;
    let interpreted = run(program, &SCENE, (), |_, _| {})?;
    let identical = compiled.trace == interpreted.trace;
    write!(out, "\n{compiled}")?;
    let records = compiled.trace.lines().count();
    if identical {
        writeln!(
            out,
            "traces identical: {records} records, compiled and interpreted"
        )?;
    } else {
        writeln!(out, "traces DIFFER")?;
    }
    Ok(compiled.is_good() && identical)
}

/// One line: where the cylinder is, and how the fingers push it.
fn progress(time: f64, hand: &SimulatedHand<3, 3>) -> io::Result<()> {
    let mut out = io::stdout();
    write!(out, "{time:6.2} s {:5.1} mm", height(hand) + 0.0)?;
    for (tip, name) in hand.fingertips().iter().zip(["F1", "F2", "F3"]) {
        let [x, y, _] = tip.on_objects;
        write!(out, "  {name} ({:5.2}, {:5.2})", x + 0.0, y + 0.0)?;
    }
    writeln!(out)
}

/// Prints what the program says.
struct Messages;

impl Console for Messages {
    fn message(&mut self, text: &dyn Display) {
        // A closed output is reported by the next line of progress.
        let _ = writeln!(io::stdout(), "         {text}");
    }
}
