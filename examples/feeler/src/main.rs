//! `cargo run --release -p feeler`: see the README beside it.

use feeler::Feeler;
use std::error::Error;
use std::io::{self, Write};
use std::process::ExitCode;
use tip_runtime::command::Port;
use tip_runtime::console::Transcript;
use tip_runtime::machine::{Machine, Status};
use tip_runtime::plant::Plant;
use tip_runtime::record::Ending;
use walking::{Measured, exit};

/// The cycles in which something is in the way.
const BLOCKED: std::ops::Range<u64> = 500..700;

fn main() -> ExitCode {
    exit("feeler", walk())
}

/// Returns true if the robot walked as it should.
fn walk() -> Result<bool, Box<dyn Error>> {
    let mut robot = Machine::simulated(Feeler::new()).with_console(Transcript::default());
    let mut measured = Measured::new();
    while robot.status().is_running() {
        let volts = if BLOCKED.contains(&robot.cycles()) {
            5.0
        } else {
            0.0
        };
        robot.hardware_mut().set_sensor(Port::Antenna, volts);
        robot.cycle();
        measured.after(robot.time(), robot.hardware());
    }
    let ending = match (robot.status(), robot.emergency()) {
        (Status::Finished(end), _) => Ending::Program(end),
        (_, Some(emergency)) => Ending::Emergency(*emergency),
        _ => Ending::Limit,
    };
    let outcome = measured.outcome(ending, robot.cycles());
    let mut out = io::stdout();
    write!(out, "{outcome}")?;
    write!(out, "FOUT.LOG\n{}", robot.console().appended)?;
    Ok(outcome.is_good())
}
