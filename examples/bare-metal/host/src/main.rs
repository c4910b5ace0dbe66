//! Prints the traces of this machine, for the others to be compared with.
#![forbid(unsafe_code)]

use std::io::{self, Write};
use std::process::ExitCode;

fn main() -> ExitCode {
    let mut traces = String::new();
    let steered = robots::hexapod().is_ok_and(|mut robot| robots::steer(&mut robot, &mut traces));
    let walked = robots::walker().is_ok_and(|mut robot| robots::run(&mut robot, &mut traces));
    let grasped = robots::hand().is_ok_and(|mut robot| robots::run(&mut robot, &mut traces));
    let threaded = robots::threaded().is_ok_and(|mut robot| robots::run(&mut robot, &mut traces));
    let swung =
        robots::heavy_walker().is_ok_and(|mut robot| robots::begin(&mut robot, &mut traces));
    match io::stdout().write_all(traces.as_bytes()) {
        Ok(()) if walked && grasped && threaded && swung && steered => ExitCode::SUCCESS,
        _ => ExitCode::FAILURE,
    }
}
