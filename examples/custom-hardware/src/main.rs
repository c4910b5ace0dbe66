//! `cargo run --release -p custom-hardware`: see the README beside it.
#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    reason = "an example talks to people"
)]

use custom_hardware::Feet;
use custom_hardware::description::Description;
use custom_hardware::options::{HELP, Options};
use custom_hardware::record::Recorded;
use custom_hardware::workshop::bench;
use std::env;
use std::error::Error;
use std::fmt::Display;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::process::ExitCode;
use tip_runtime::machine::Machine;
use tip_runtime::realtime::run_realtime;

fn main() -> ExitCode {
    let options = match Options::parse(env::args().skip(1)) {
        Ok(options) => options,
        Err(problem) => {
            eprintln!("custom-hardware: {problem}\n\n{HELP}");
            return ExitCode::from(2);
        }
    };
    let done = if options.help { help() } else { run(&options) };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("custom-hardware: {problem}");
            ExitCode::FAILURE
        }
    }
}

fn help() -> Result<(), Box<dyn Error>> {
    io::stdout().write_all(HELP.as_bytes())?;
    Ok(())
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let description = match &options.robot {
        Some(file) => read(file)?,
        None => Description::parse(include_str!("../robot.toml"))?,
    };
    let model = description.model();
    let table = File::create(&options.csv).map_err(|error| about(&options.csv, &error))?;
    let table = BufWriter::new(table);
    let robot = Recorded::new(bench(&description, &model), table)?;
    let mut machine = Machine::new(Feet::new(), &model, robot, (), ())?;

    let mut out = io::stdout();
    let (name, period) = (&description.name, machine.period());
    writeln!(out, "{name}: every {period} ms")?;
    if options.fast {
        while machine.cycle().is_running() {}
    } else {
        let (_, pace) = run_realtime(&mut machine, |status| !status.is_running());
        let worst = pace.worst().as_secs_f64() * 1000.0;
        let overruns = pace.overruns();
        writeln!(out, "{overruns} overruns, the worst {worst:.3} ms late")?;
    }
    let (cycles, csv) = (machine.cycles(), options.csv.display());
    writeln!(out, "{cycles} cycles; {csv}")?;
    machine.hardware_mut().finish()?;
    match machine.emergency() {
        Some(emergency) => Err(emergency.to_string().into()),
        None => Ok(()),
    }
}

fn read(file: &Path) -> Result<Description, String> {
    let text = fs::read_to_string(file).map_err(|error| about(file, &error))?;
    Description::parse(&text).map_err(|error| about(file, &error))
}

fn about(file: &Path, error: &dyn Display) -> String {
    format!("{}: {error}", file.display())
}
