//! `cargo run --release -p walk`: see the README beside it.
#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    reason = "an example talks to people"
)]

use std::env;
use std::error::Error;
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::process::ExitCode;
use tip_runtime::console::Terminal;
use tip_runtime::machine::Machine;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::realtime::run_realtime;
use tip_runtime::record::AtomicFile;
use walk::Walk;
use walk::options::{HELP, Options};
use walking::{Observer, exit, run, whole};

/// Time on the robot between two lines of progress: s.
const REPORT_EVERY: f64 = 5.0;

fn main() -> ExitCode {
    let options = match Options::parse(env::args().skip(1)) {
        Ok(options) => options,
        Err(problem) => {
            eprintln!("walk: {problem}\n\n{HELP}");
            return ExitCode::from(2);
        }
    };
    let good = if options.help {
        help()
    } else if options.realtime {
        walk_in_real_time()
    } else {
        walk(&options)
    };
    exit("walk", good)
}

fn help() -> Result<bool, Box<dyn Error>> {
    io::stdout().write_all(HELP.as_bytes())?;
    Ok(true)
}

fn walk(options: &Options) -> Result<bool, Box<dyn Error>> {
    let mut robot = Machine::simulated(Walk::new());
    let mut progress = Progress {
        due: REPORT_EVERY,
        trace: match &options.trace {
            Some(path) => Some(create(path)?),
            None => None,
        },
        failure: None,
    };
    let limit = options.cycles.unwrap_or(u64::MAX);
    let outcome = run(&mut robot, limit, options.trace_state, &mut progress);
    progress.finish()?;
    write!(io::stdout(), "\n{outcome}")?;
    Ok(outcome.is_good())
}

fn create(path: &Path) -> Result<BufWriter<AtomicFile>, String> {
    let file = AtomicFile::create(path).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(BufWriter::new(file))
}

/// Prints where the body is now and then, and keeps the trace.
struct Progress {
    due: f64,
    trace: Option<BufWriter<AtomicFile>>,
    failure: Option<io::Error>,
}

impl Observer<4, 3> for Progress {
    fn cycle(&mut self, time: f64, robot: &SimulatedPlant<4, 3>, records: &str) {
        if self.failure.is_none() {
            self.failure = self.write(time, robot, records).err();
        }
    }

    fn end(&mut self, record: &str) {
        if let (None, Some(trace)) = (&self.failure, &mut self.trace) {
            self.failure = trace.write_all(record.as_bytes()).err();
        }
    }
}

impl Progress {
    fn write(&mut self, time: f64, robot: &SimulatedPlant<4, 3>, records: &str) -> io::Result<()> {
        if let Some(trace) = &mut self.trace {
            trace.write_all(records.as_bytes())?;
        }
        if time >= self.due {
            self.due += REPORT_EVERY;
            writeln!(io::stdout(), "{time:6.1} s  {}", place(robot))?;
        }
        Ok(())
    }

    fn finish(self) -> io::Result<()> {
        match (self.failure, self.trace) {
            (Some(error), _) => Err(error),
            (None, Some(trace)) => trace.into_inner()?.commit(),
            (None, None) => Ok(()),
        }
    }
}

fn place(robot: &SimulatedPlant<4, 3>) -> String {
    let [right, forward, up] = robot.body().position;
    let feet = robot.contacts().into_iter().zip(["F1", "F2", "F3", "F4"]);
    let standing: Vec<&str> = feet
        .map(|(down, name)| if down { name } else { "--" })
        .collect();
    format!(
        "body {:5} mm forward {:4} mm to the right {:4} mm up   feet {}",
        whole(forward),
        whole(right),
        whole(up),
        standing.join(" ")
    )
}

/// The compiled program alone, with the keyboard.
fn walk_in_real_time() -> Result<bool, Box<dyn Error>> {
    let mut robot = Machine::simulated(Walk::new()).with_console(Terminal::new());
    let (status, pace) = run_realtime(&mut robot, |status| !status.is_running());
    let mut out = io::stdout();
    writeln!(out, "{status:?}; {}", place(robot.hardware()))?;
    writeln!(
        out,
        "{} cycles, {} overruns, the worst {:?} late",
        pace.cycles(),
        pace.overruns(),
        pace.worst()
    )?;
    Ok(robot.hardware().falls() == 0 && robot.emergency().is_none())
}
