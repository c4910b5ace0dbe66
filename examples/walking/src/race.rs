//! Two engines side by side, cycle by cycle.

use crate::engine::Engine;
use crate::gait::Gait;
use crate::outcome::Outcome;
use tip_runtime::console::Console;
use tip_runtime::machine::Status;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::Program;
use tip_runtime::record::Ending;

/// Told of a run while it lasts.
pub trait Observer<const L: usize, const J: usize> {
    /// One cycle is over: the time on the robot (s), the robot, and its new records.
    fn cycle(&mut self, time: f64, robot: &SimulatedPlant<L, J>, records: &str);
}

impl<const L: usize, const J: usize> Observer<L, J> for () {
    fn cycle(&mut self, _time: f64, _robot: &SimulatedPlant<L, J>, _records: &str) {}
}

/// Two engines that run the same program.
pub struct Race<A, B, C, const L: usize, const J: usize> {
    leader: Engine<A, C, L, J>,
    rival: Engine<B, C, L, J>,
    gait: Gait<L>,
    margin: f64,
    time: f64,
    records: u64,
    identical: bool,
}

impl<A: Program, B: Program, C: Console, const L: usize, const J: usize> Race<A, B, C, L, J> {
    /// Both engines must be at their start.
    pub fn new(leader: Engine<A, C, L, J>, rival: Engine<B, C, L, J>) -> Self {
        Race {
            leader,
            rival,
            gait: Gait::default(),
            margin: f64::INFINITY,
            time: 0.0,
            records: 0,
            identical: true,
        }
    }

    /// Runs both to their end, or for `limit` cycles.
    pub fn run(mut self, limit: Option<u64>, observer: &mut dyn Observer<L, J>) -> Outcome<L> {
        let ending = loop {
            if limit.is_some_and(|limit| self.leader.machine().cycles() >= limit) {
                break Ending::Limit;
            }
            self.time += self.leader.machine().period() / 1000.0;
            let status = self.leader.cycle();
            let rival_status = self.rival.cycle();
            self.identical &= status == rival_status;
            let robot = self.leader.machine().hardware();
            self.gait.push(robot.contacts());
            self.margin = self.margin.min(robot.margin());
            self.compare(observer);
            if let Some(ending) = self.ending(status) {
                break ending;
            }
        };
        self.leader.end(ending);
        self.rival.end(ending);
        self.compare(observer);
        self.outcome(ending)
    }

    fn compare(&mut self, observer: &mut dyn Observer<L, J>) {
        let records = self.leader.take_records();
        self.identical &= records == self.rival.take_records();
        if self.identical {
            self.records += records.lines().count() as u64;
        }
        observer.cycle(self.time, self.leader.machine().hardware(), &records);
    }

    fn ending(&self, status: Status) -> Option<Ending> {
        match status {
            Status::Running => None,
            Status::Finished(end) => Some(Ending::Program(end)),
            Status::Emergency => self
                .leader
                .machine()
                .emergency()
                .copied()
                .map(Ending::Emergency),
        }
    }

    fn outcome(self, ending: Ending) -> Outcome<L> {
        let machine = self.leader.machine();
        let body = machine.hardware().body();
        Outcome {
            ending,
            cycles: machine.cycles(),
            seconds: self.time,
            travel: body.y,
            drift: body.x,
            falls: machine.hardware().falls(),
            slip: machine.hardware().worst_slip(),
            margin: self.margin,
            gait: self.gait,
            same_records: self.records,
            identical: self.identical,
        }
    }
}
