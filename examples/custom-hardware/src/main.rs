//! `cargo run --release -p custom-hardware`: see the README beside it.

use custom_hardware::Feet;
use custom_hardware::bus::ServoBus;
use custom_hardware::servos::MemoryLink;
use std::error::Error;
use tip_runtime::machine::Machine;
use tip_runtime::model::titan8;
use tip_runtime::realtime::run_realtime;

fn main() -> Result<(), Box<dyn Error>> {
    let robot = ServoBus(MemoryLink::titan8());
    let mut machine = Machine::new(Feet::new(), &titan8::MODEL, robot)?;
    println!(
        "{} servos, every {} ms",
        machine.hardware().0.servos.len(),
        machine.period()
    );
    let (_, pace) = run_realtime(&mut machine, |status| !status.is_running());
    let worst = pace.worst().as_secs_f64() * 1000.0;
    println!(
        "{} cycles, {} overruns, the worst {worst:.3} ms late",
        machine.cycles(),
        pace.overruns()
    );
    match machine.emergency() {
        Some(emergency) => Err(emergency.to_string().into()),
        None => Ok(()),
    }
}
