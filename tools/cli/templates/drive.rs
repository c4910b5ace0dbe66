//! Runs the program on our own robot, in real time: `cargo run --bin drive`.

use <<crate>>::hardware::Drives;

use <<crate>>::<<items>>;

use std::process::ExitCode;
use tip_runtime::console::Terminal;
use tip_runtime::machine::Machine;
<<model>>use tip_runtime::realtime::run_realtime;

/// RETURN is the emergency stop, ESC the halt request. A robot that would sink has to be held after the program's end: then
/// stay in the loop, and let a key end it.
fn main() -> ExitCode {
    let robot = Machine::new(<<Program>>::new(), &<<MODEL>>, Drives::new());
    let robot = robot.expect("the program is compiled for this robot");
    let mut robot = robot.with_console(Terminal::new());
    let (_, pace) = run_realtime(&mut robot, |status| !status.is_running());
    println!("{} cycles, {} of them late", pace.cycles(), pace.overruns());
    match robot.emergency() {
        None => ExitCode::SUCCESS,
        Some(_) => ExitCode::FAILURE,
    }
}
