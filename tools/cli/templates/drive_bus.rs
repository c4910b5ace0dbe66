//! Runs the program on the servos of `robot.toml`, in real time: `cargo run --bin drive [PORT]`.

use <<crate>>::<<items>>;

use std::env;
use std::error::Error;
use std::process::ExitCode;
use tip_drives::described::{self, Described};
use tip_drives::guard::{Request, Step};
use tip_drives::operator;
use tip_runtime::console::Terminal;
use tip_runtime::machine::Machine;

/// RETURN is the emergency stop from the first torque to the last. ESC is the halt request to the program; Ctrl-C and signals are
/// the ordered end. `drives` owns the torque: it leaves the servos as `at_end` or `in_emergency` says, after a panic too.
/// The exit status is 0 after the program, 128 and the number of a signal that ended it (130 for Ctrl-C), and 1 after an emergency stop.
fn main() -> ExitCode {
    drive().unwrap_or_else(|error| {
        eprintln!("{error}");
        ExitCode::FAILURE
    })
}

fn drive() -> Result<ExitCode, Box<dyn Error>> {
    let description = described::read("robot.toml", include_bytes!("../../robot.toml"))?;
    let robot = Described::new(&description)?;
    let port = env::args().nth(1).or(robot.bus.port.clone());
    let mut drives = operator::open(&robot, &port.ok_or("which port?")?)?;
<<sticks>>    drives.connect()?;
    let step = drives.approach(&robot.initial, robot.bus.start);
    if step != Ok(Step::Arrived) {
        if let Err(left) = operator::leave(&mut drives, &robot) {
            eprintln!("{left}");
        }
        return Ok(match step? {
            Step::Left(Request::End) => ExitCode::from(drives.host_mut().status()),
            _ => ExitCode::FAILURE,
        });
    }
    drives.host_mut().give_keys();
    let console = Terminal::new().report_interrupts();
    let machine = Machine::new(<<Program>>::new(), &<<MODEL>>, drives)?;
    let mut machine = machine.with_console(console);
    let mut is_ended = false;
    while machine.cycle().is_running() && !is_ended {
        let drives = machine.hardware_mut();
        drives.wait();
        is_ended = drives.host_mut().signal().is_some() || machine.console().interrupted();
    }
    let drives = machine.hardware_mut();
    let left = operator::leave(drives, &robot);
    if let Some(failure) = drives.drives().failure() {
        eprintln!("{failure}");
    }
    let (is_stopped, status) = (drives.is_stopped(), drives.host_mut().status());
    println!("{} cycles", machine.cycles());
    left?;
    Ok(match is_ended {
        _ if is_stopped => ExitCode::FAILURE,
        true => ExitCode::from(status),
        false => ExitCode::SUCCESS,
    })
}
