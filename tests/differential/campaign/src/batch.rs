//! A compiled batch: runs each of its programs several times, with other events each time.

use crate::found::{self, Failure};
use lockstep::{Figures, Script, Subject, Verdict, compare, shrink};
use std::env;
use std::process::ExitCode;
use tip_sim::Plant;
use tipc::Robot;

/// Number and length of the runs of each program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Runs on joints that echo their commands.
    pub runs: u64,
    /// The most cycles of each.
    pub cycles: u64,
    /// One program in this many runs on the simulated robot too.
    pub simulated_one_in: u64,
    /// The most cycles of that.
    pub simulated_cycles: u64,
    /// The most cycles of a run with mass beside it, of robots that walk.
    pub heavy_cycles: u64,
}

impl Effort {
    /// Returns the arguments of a batch.
    pub fn arguments(&self) -> Vec<String> {
        let Effort {
            runs,
            cycles,
            simulated_one_in,
            simulated_cycles,
            heavy_cycles,
        } = self;
        [
            runs,
            cycles,
            simulated_one_in,
            simulated_cycles,
            heavy_cycles,
        ]
        .map(u64::to_string)
        .to_vec()
    }

    fn parse(arguments: &[String]) -> Option<Self> {
        let numbers: Vec<u64> = arguments
            .iter()
            .map(|text| text.parse().ok())
            .collect::<Option<_>>()?;
        let [
            runs,
            cycles,
            simulated_one_in,
            simulated_cycles,
            heavy_cycles,
        ] = numbers[..]
        else {
            return None;
        };
        Some(Effort {
            runs,
            cycles,
            simulated_one_in,
            simulated_cycles,
            heavy_cycles,
        })
    }

    /// Returns true if programs of a robot run at all.
    pub fn concerns(&self, robot: Robot) -> bool {
        robot != Robot::Hand || self.runs > 0 || self.simulated_cycles > 0
    }

    /// The scripts of a program. Simulated joints take longer to compute, mass longer still.
    fn scripts(&self, robot: Robot, seed: u64) -> Vec<Script> {
        let echo = |run| Script::random(robot, seed, run, self.cycles, Plant::Echo);
        let mut scripts: Vec<Script> = (0..self.runs).map(echo).collect();
        if seed.is_multiple_of(self.simulated_one_in) {
            let simulated = |number, cycles, plant| {
                Script::random(robot, seed, self.runs + number, cycles, plant)
            };
            if self.simulated_cycles > 0 {
                scripts.push(simulated(0, self.simulated_cycles, Plant::Simulated));
            }
            if robot != Robot::Hand {
                scripts.push(simulated(1, self.heavy_cycles, Plant::Dynamic));
            }
        }
        scripts
    }
}

/// Prints the figures of a batch, a fingerprint of each program's runs, and what is different after it.
pub fn main(subjects: &[Subject]) -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let Some(effort) = Effort::parse(&arguments) else {
        eprintln!("usage: batch RUNS CYCLES SIMULATED_ONE_IN SIMULATED_CYCLES HEAVY_CYCLES");
        return ExitCode::FAILURE;
    };
    let mut figures = Figures::default();
    for subject in subjects {
        match program(subject, &effort, &mut figures) {
            Ok(hash) => println!("same {} {hash:016x}", subject.0.0),
            Err(failure) => print!("{}", found::text(&failure)),
        }
    }
    print!("{figures}");
    ExitCode::SUCCESS
}

/// A hash of all runs of a program.
fn program<'a>(
    subject: &'a Subject,
    effort: &Effort,
    figures: &mut Figures,
) -> Result<u64, Box<Failure<'a>>> {
    let ((seed, name, _), _) = *subject;
    let robot = Robot::from_name(name).expect("a robot of the compiler");
    let mut fingerprint = 0_u64;
    figures.add("programs".to_owned(), 1);
    figures.add(format!("programs on {name}"), 1);
    for script in effort.scripts(robot, seed) {
        match compare(subject, &script, figures) {
            Verdict::Same(run) => fingerprint = fingerprint.rotate_left(7) ^ run.hash,
            Verdict::Different(difference) => {
                figures.add("differences".to_owned(), 1);
                let (script, difference) = shrink(subject, &script, difference);
                return Err(Box::new(Failure {
                    subject,
                    script,
                    difference,
                }));
            }
        }
    }
    Ok(fingerprint)
}
