//! Runs the program on the servos of `robot.toml`, in real time: `cargo run --bin drive [PORT]`.

use <<crate>>::<<items>>;

use std::env;
use std::error::Error;
use std::process::ExitCode;
use tip_drives::described::{self, Described};
use tip_drives::guard::Step;
use tip_drives::operator;
use tip_runtime::console::Terminal;
use tip_runtime::machine::Machine;

/// RETURN is the emergency stop from the first torque to the last. ESC is the halt request to the program; Ctrl-C and signals are
/// the ordered end. `drives` owns the torque: it leaves the servos as `at_end` or `in_emergency` says, after a panic too.
fn main() -> Result<ExitCode, Box<dyn Error>> {
    let description = described::read("robot.toml", include_bytes!("../../robot.toml"))?;
    let robot = Described::new(&description)?;
    let port = env::args().nth(1).or(robot.bus.port.clone());
    let mut drives = operator::open(&robot, &port.ok_or("which port?")?)?;
    drives.connect()?;
    if drives.approach(&robot.initial, robot.bus.start)? != Step::Arrived {
        operator::leave(&mut drives, &robot)?;
        return Ok(ExitCode::FAILURE);
    }
    drives.host_mut().give_keys();
    let console = Terminal::new().report_interrupts();
    let mut machine = Machine::new(<<Program>>::new(), &<<MODEL>>, drives, console, ())?;
    while machine.cycle().is_running() {
        let drives = machine.hardware_mut();
        drives.wait();
        if drives.host_mut().is_signalled() || machine.console().interrupted() {
            break;
        }
    }
    let drives = machine.hardware_mut();
    operator::leave(drives, &robot)?;
    if let Some(failure) = drives.drives().failure() {
        eprintln!("{failure}");
    }
    println!("{} cycles", machine.cycles());
    Ok(match machine.emergency() {
        None => ExitCode::SUCCESS,
        Some(_) => ExitCode::FAILURE,
    })
}
