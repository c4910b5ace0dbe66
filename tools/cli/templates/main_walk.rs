//! Runs the program on the simulated robot: `cargo run`.

use <<crate>>::<<items>>;

use std::process::ExitCode;
use tip_runtime::console::Terminal;
use tip_runtime::machine::Machine;
<<model>>use tip_runtime::plant::Plant;

fn main() -> ExitCode {
    let robot = Machine::simulated_on(<<Program>>::new(), &<<MODEL>>);
    let robot = robot.expect("the program is compiled for this robot");
    let mut robot = robot.with_console(Terminal::new());
    while robot.cycle().is_running() {}
    let seconds = robot.cycles() as f64 * robot.period() / 1000.0;
    println!("{seconds:.1} s on the robot");
    if let Some(motion) = robot.hardware().motion() {
        println!("{:.0} mm forward, {} falls", motion.travel.y, motion.falls);
    }
    match robot.emergency() {
        None => ExitCode::SUCCESS,
        Some(_) => ExitCode::FAILURE,
    }
}
