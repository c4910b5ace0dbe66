//! Shared code of the walking examples: a compiled program on a simulated robot of `L` legs with `J` joints, and the
//! result of its run.
#![forbid(unsafe_code)]

use std::error::Error;
use std::fmt;
use std::process::ExitCode;
use tip_runtime::console::Console;
use tip_runtime::machine::{Machine, Status};
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::Program;
use tip_runtime::record::{Ending, JsonLines};
use tip_runtime::special::Special;

/// Width of the diagram's feet, characters.
const COLUMNS: usize = 72;

/// Which feet touched the floor in each control cycle. Shown, it is a picture in text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Gait<const L: usize> {
    cycles: Vec<[bool; L]>,
}

impl<const L: usize> Gait<L> {
    /// Notes which feet touch the floor in one more cycle.
    pub fn push(&mut self, touching: [bool; L]) {
        self.cycles.push(touching);
    }

    /// The cycles noted so far.
    pub fn cycles(&self) -> &[[bool; L]] {
        &self.cycles
    }

    /// Cycles that one column of the diagram stands for.
    pub fn column(&self) -> usize {
        self.cycles.len().div_ceil(COLUMNS).max(1)
    }

    fn mark(&self, chunk: &[[bool; L]], foot: usize) -> char {
        let touching = chunk.iter().filter(|feet| feet[foot]).count();
        if 2 * touching >= chunk.len() {
            '#'
        } else {
            '.'
        }
    }
}

impl<const L: usize> fmt::Display for Gait<L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for foot in 0..L {
            let chunks = self.cycles.chunks(self.column());
            let marks: String = chunks.map(|chunk| self.mark(chunk, foot)).collect();
            writeln!(f, "  F{}  {marks}", foot + 1)?;
        }
        Ok(())
    }
}

/// Distance that the body must travel, mm.
pub const GOAL: f64 = 1000.0;

/// Maximum slip of a foot that carries, mm.
pub const SLIP: f64 = 1.0;

/// The result for a run. Shown, it is a report of a few lines.
#[derive(Clone, Debug)]
pub struct Outcome<const L: usize> {
    /// End of the run.
    pub ending: Ending,
    /// Number of cycles.
    pub cycles: u64,
    /// Duration on the robot, s.
    pub seconds: f64,
    /// Travel of the body forward, mm.
    pub travel: f64,
    /// Travel of the body to the right, mm.
    pub drift: f64,
    /// Number of falls.
    pub falls: u32,
    /// The farthest that a foot slipped while it carried: mm.
    pub slip: f64,
    /// The least that the centre of mass was inside the support polygon: mm; negative outside.
    pub margin: f64,
    /// Which feet touched the floor.
    pub gait: Gait<L>,
}

impl<const L: usize> Outcome<L> {
    /// The program ended itself, and the robot walked.
    pub fn is_good(&self) -> bool {
        matches!(self.ending, Ending::Program(_)) && self.walked()
    }

    /// Far enough, upright, with feet that stayed where they were put.
    fn walked(&self) -> bool {
        self.travel >= GOAL && self.falls == 0 && self.slip <= SLIP
    }
}

impl<const L: usize> fmt::Display for Outcome<L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "gait (# on the floor, . in the air; a column is {:.2} s)\n{}",
            self.seconds / self.cycles.max(1) as f64 * self.gait.column() as f64,
            self.gait
        )?;
        writeln!(
            f,
            "travel {} mm forward, {} mm to the right in {:.1} s; at least {GOAL} mm asked",
            whole(self.travel),
            whole(self.drift),
            self.seconds
        )?;
        writeln!(f, "falls  {}", self.falls)?;
        writeln!(
            f,
            "slip   {:.2} mm at most of a foot that carries",
            self.slip
        )?;
        writeln!(
            f,
            "margin {} mm at least from the centre of mass to the edge of the support polygon",
            whole(self.margin)
        )?;
        match self.ending {
            Ending::Program(_) => writeln!(f, "end    by the program after {} cycles", self.cycles),
            Ending::Emergency(emergency) => {
                writeln!(f, "end    {emergency} in cycle {}", self.cycles)
            }
            Ending::Limit | Ending::Interrupted => {
                writeln!(f, "end    cut off after {} cycles", self.cycles)
            }
        }
    }
}

/// Rounded, without the sign of a negative zero.
pub fn whole(length: f64) -> f64 {
    length.round() + 0.0
}

/// Watches a run while it lasts.
pub trait Observer<const L: usize, const J: usize> {
    /// One cycle is over: the time on the robot (s), the robot, and its new records.
    fn cycle(&mut self, time: f64, robot: &SimulatedPlant<L, J>, records: &str) {
        let _ = (time, robot, records);
    }

    /// The run is over: the last record.
    fn end(&mut self, record: &str) {
        let _ = record;
    }
}

impl<const L: usize, const J: usize> Observer<L, J> for () {}

/// Runs a program to its end, or for `limit` cycles. Records get a hash of the robot's state if `with_state` says so.
pub fn run<P: Program, C: Console, S: Special, const L: usize, const J: usize>(
    machine: &mut Machine<P, SimulatedPlant<L, J>, L, J, C, S>,
    limit: u64,
    with_state: bool,
    observer: &mut dyn Observer<L, J>,
) -> Outcome<L> {
    let mut records = JsonLines::new(String::new(), with_state);
    let mut measured = Measured::new();
    while machine.status().is_running() && machine.cycles() < limit {
        machine.cycle_traced(&mut records);
        measured.after(machine.time(), machine.hardware());
        observer.cycle(measured.seconds, machine.hardware(), records.get_ref());
        records.get_mut().clear();
    }
    let ending = match (machine.status(), machine.emergency()) {
        (Status::Finished(end), _) => Ending::Program(end),
        (_, Some(emergency)) => Ending::Emergency(*emergency),
        _ => Ending::Limit,
    };
    records.end(ending, machine.cycles());
    observer.end(records.get_ref());
    measured.outcome(ending, machine.cycles())
}

/// Measurements of a robot under way.
#[derive(Clone, Debug)]
pub struct Measured<const L: usize> {
    gait: Gait<L>,
    margin: f64,
    seconds: f64,
    travel: f64,
    drift: f64,
    falls: u32,
    slip: f64,
}

impl<const L: usize> Measured<L> {
    /// Measurements before the first cycle.
    pub fn new() -> Self {
        Measured {
            gait: Gait::default(),
            margin: f64::INFINITY,
            seconds: 0.0,
            travel: 0.0,
            drift: 0.0,
            falls: 0,
            slip: 0.0,
        }
    }

    /// Measures the robot after a cycle; `time` is the time on it, ms.
    pub fn after<const J: usize>(&mut self, time: f64, robot: &SimulatedPlant<L, J>) {
        self.seconds = time / 1000.0;
        self.gait.push(robot.contacts());
        self.margin = self.margin.min(robot.margin());
        [self.drift, self.travel, _] = robot.body().position;
        self.falls = robot.falls();
        self.slip = robot.worst_slip();
    }

    /// Returns the result of a run that has ended.
    pub fn outcome(self, ending: Ending, cycles: u64) -> Outcome<L> {
        Outcome {
            ending,
            cycles,
            seconds: self.seconds,
            travel: self.travel,
            drift: self.drift,
            falls: self.falls,
            slip: self.slip,
            margin: self.margin,
            gait: self.gait,
        }
    }
}

impl<const L: usize> Default for Measured<L> {
    fn default() -> Self {
        Self::new()
    }
}

/// The exit status of an example: 0 if all was good, else 1. What kept it from a verdict is reported
/// on standard error.
pub fn exit(example: &str, verdict: Result<bool, Box<dyn Error>>) -> ExitCode {
    match verdict {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(problem) => {
            eprintln!("{example}: {problem}");
            ExitCode::FAILURE
        }
    }
}
