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
pub trait Observer {
    /// One cycle is over: the time on the robot (s), the robot, and its new records.
    fn cycle(&mut self, time: f64, robot: &SimulatedPlant<4, 3>, records: &str);
}

impl Observer for () {
    fn cycle(&mut self, _time: f64, _robot: &SimulatedPlant<4, 3>, _records: &str) {}
}

/// Two engines that run the same program.
pub struct Race<A, B, C> {
    leader: Engine<A, C>,
    rival: Engine<B, C>,
    gait: Gait,
    time: f64,
    records: u64,
    identical: bool,
}

impl<A: Program, B: Program, C: Console> Race<A, B, C> {
    /// Both engines must be at their start.
    pub fn new(leader: Engine<A, C>, rival: Engine<B, C>) -> Self {
        Race {
            leader,
            rival,
            gait: Gait::default(),
            time: 0.0,
            records: 0,
            identical: true,
        }
    }

    /// Runs both to their end, or for `limit` cycles.
    pub fn run(mut self, limit: Option<u64>, observer: &mut dyn Observer) -> Outcome {
        let ending = loop {
            if limit.is_some_and(|limit| self.leader.machine().cycles() >= limit) {
                break Ending::Limit;
            }
            self.time += self.leader.machine().period() / 1000.0;
            let status = self.leader.cycle();
            let rival_status = self.rival.cycle();
            self.identical &= status == rival_status;
            self.gait.push(standing(self.leader.machine().hardware()));
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

    fn compare(&mut self, observer: &mut dyn Observer) {
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

    fn outcome(self, ending: Ending) -> Outcome {
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
            gait: self.gait,
            same_records: self.records,
            identical: self.identical,
        }
    }
}

/// Which feet carry something.
pub fn standing(robot: &SimulatedPlant<4, 3>) -> [bool; 4] {
    robot.feet().map(|foot| foot.touches())
}
