//! A compiled program on a simulated robot, measured cycle by cycle.

use crate::gait::Gait;
use crate::outcome::Outcome;
use tip_runtime::console::Console;
use tip_runtime::machine::{Machine, Status};
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::Program;
use tip_runtime::record::{Ending, JsonLines};
use tip_runtime::special::Special;

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
    machine: &mut Machine<P, SimulatedPlant<L, J>, C, S, L, J>,
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
