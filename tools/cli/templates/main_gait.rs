//! Walks the simulated robot as keys say: `cargo run`.

use <<crate>>::<<items>>;

use std::process::ExitCode;
use tip_runtime::console::Scripted;
use tip_runtime::machine::Machine;
<<model>>use tip_runtime::plant::{DynamicPlant, Plant};

/// Keys and the seconds at which they are pressed. W: ahead, D: turn to the right, E: to the right, a blank: stop.
const KEYS: [(f64, u8); 4] = [(4.0, b'W'), (8.0, b'D'), (12.0, b'E'), (16.0, b' ')];
/// Time of the halt request, s: the robot sits down.
const HALT: f64 = 18.0;

fn main() -> ExitCode {
    let cycle = |seconds: f64| (1000.0 * seconds / <<MODEL>>.standards.period) as u64;
    let keys = KEYS.map(|(seconds, key)| (cycle(seconds), key));
    let console = Scripted::new(keys.to_vec()).halt(cycle(HALT));
    let plant = DynamicPlant::new(&<<MODEL>>);
    let robot = Machine::new(<<Program>>::new(), &<<MODEL>>, plant);
    let robot = robot.expect("the program is compiled for this robot");
    let mut robot = robot.with_console(console);
    while robot.cycle().is_running() {}
    let seconds = robot.cycles() as f64 * robot.period() / 1000.0;
    println!("{seconds:.1} s on the robot");
    if let Some(motion) = robot.hardware().motion() {
        let travel = motion.travel;
        println!("{:.0} mm forward, {:.0} mm to the right", travel.y, travel.x);
        println!("{:.0} deg to the right, {} falls", -travel.turn, motion.falls);
    }
    match robot.emergency() {
        None => ExitCode::SUCCESS,
        Some(_) => ExitCode::FAILURE,
    }
}
