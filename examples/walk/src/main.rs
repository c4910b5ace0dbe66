//! `cargo run --release -p walk`: see the README beside it.
#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    reason = "an example talks to people"
)]

use std::env;
use std::error::Error;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;
use std::process::ExitCode;
use tip_runtime::console::Terminal;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::realtime::run_realtime;
use tip_runtime::record::Ending;
use walk::engine::{Engine, interpreter, on_simulated_robot};
use walk::options::{HELP, Options};
use walk::outcome::{GOAL, Outcome};
use walk::race::{Observer, Race, standing};
use walk::{SOURCE, Walk};

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
        print!("{HELP}");
        Ok(true)
    } else if options.realtime {
        walk_in_real_time()
    } else {
        walk_and_compare(&options)
    };
    match good {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(problem) => {
            eprintln!("walk: {problem}");
            ExitCode::FAILURE
        }
    }
}

fn walk_and_compare(options: &Options) -> Result<bool, Box<dyn Error>> {
    let compiled = Engine::new(Walk::new(), (), options.trace_state)?;
    let interpreted = interpreter("walk.prg", SOURCE)?;
    let interpreted = Engine::new(interpreted, (), options.trace_state)?;
    let mut progress = Progress {
        due: REPORT_EVERY,
        trace: match &options.trace {
            Some(path) => Some(create(path)?),
            None => None,
        },
        failure: None,
    };
    let outcome = Race::new(compiled, interpreted).run(options.cycles, &mut progress);
    progress.finish()?;
    report(&outcome);
    Ok(outcome.is_good())
}

fn create(path: &Path) -> Result<BufWriter<File>, String> {
    let file = File::create(path).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(BufWriter::new(file))
}

/// Prints where the body is now and then, and keeps the trace.
struct Progress {
    due: f64,
    trace: Option<BufWriter<File>>,
    failure: Option<std::io::Error>,
}

impl Observer for Progress {
    fn cycle(&mut self, time: f64, robot: &SimulatedPlant<4, 3>, records: &str) {
        if let Some(trace) = &mut self.trace
            && self.failure.is_none()
        {
            self.failure = trace.write_all(records.as_bytes()).err();
        }
        if time >= self.due {
            self.due += REPORT_EVERY;
            println!("{time:6.1} s  {}", place(robot));
        }
    }
}

impl Progress {
    fn finish(mut self) -> std::io::Result<()> {
        match (self.failure.take(), &mut self.trace) {
            (Some(error), _) => Err(error),
            (None, Some(trace)) => trace.flush(),
            (None, None) => Ok(()),
        }
    }
}

fn place(robot: &SimulatedPlant<4, 3>) -> String {
    let body = robot.body();
    let feet = standing(robot).into_iter().zip(["F1", "F2", "F3", "F4"]);
    let standing: Vec<&str> = feet
        .map(|(down, name)| if down { name } else { "--" })
        .collect();
    format!(
        "body {:5} mm forward {:4} mm to the right {:4} mm up   feet {}",
        whole(body.y),
        whole(body.x),
        whole(body.z),
        standing.join(" ")
    )
}

/// Rounded, without the sign of a negative zero.
fn whole(length: f64) -> f64 {
    length.round() + 0.0
}

fn report(outcome: &Outcome) {
    println!(
        "\ngait (# on the floor, . in the air; a column is {:.2} s)\n{}",
        outcome.seconds / outcome.cycles.max(1) as f64 * outcome.gait.column() as f64,
        outcome.gait
    );
    println!(
        "travel {} mm forward, {} mm to the right in {:.1} s; at least {GOAL} mm asked",
        whole(outcome.travel),
        whole(outcome.drift),
        outcome.seconds
    );
    println!("falls  {}", outcome.falls);
    println!(
        "slip   {:.2} mm at most of a foot that carries",
        outcome.slip
    );
    match outcome.ending {
        Ending::Program(_) => println!("end    by the program after {} cycles", outcome.cycles),
        Ending::Emergency(emergency) => println!("end    {emergency} in cycle {}", outcome.cycles),
        Ending::Limit | Ending::Interrupted => {
            println!("end    cut off after {} cycles", outcome.cycles)
        }
    }
    if outcome.identical {
        println!(
            "traces identical: {} records, compiled and interpreted",
            outcome.same_records
        );
    } else {
        println!("traces DIFFER behind record {}", outcome.same_records);
    }
}

/// The compiled program alone, with the keyboard.
fn walk_in_real_time() -> Result<bool, Box<dyn Error>> {
    let mut robot = on_simulated_robot(Walk::new(), Terminal::new())?;
    let (status, pace) = run_realtime(&mut robot);
    println!("{status:?}; {}", place(robot.hardware()));
    println!(
        "{} cycles, {} overruns, the worst {:?} late",
        pace.cycles(),
        pace.overruns(),
        pace.worst()
    );
    Ok(robot.hardware().falls() == 0 && robot.emergency().is_none())
}
