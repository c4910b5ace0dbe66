//! Runs the program on the simulated robot: `cargo run`.

use <<crate>>::{<<Program>>, SCENE};

use std::process::ExitCode;
use tip_runtime::console::Terminal;
use tip_runtime::machine::Machine;
<<model>>use tip_runtime::plant::SimulatedHand;
use tip_runtime::special::hand::HandSpecials;

fn main() -> ExitCode {
    let plant = SimulatedHand::new(&<<MODEL>>).with_scene(&SCENE);
    let robot = Machine::new(<<Program>>::new(), &<<MODEL>>, plant);
    let robot = robot.expect("the program is compiled for this robot");
    let mut robot = robot.with_console(Terminal::new()).with_special(HandSpecials::new());
    while robot.cycle().is_running() {}
    let seconds = robot.cycles() as f64 * robot.period() / 1000.0;
    println!("{seconds:.1} s on the robot");
    if let [Some(cylinder), ..] = robot.hardware().objects() {
        let height = cylinder.clearance;
        println!("the cylinder is {height:.0} mm above the floor");
    }
    match robot.emergency() {
        None => ExitCode::SUCCESS,
        Some(_) => ExitCode::FAILURE,
    }
}
