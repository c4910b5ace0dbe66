//! Two engines side by side, cycle by cycle.

use crate::gait::Gait;
use crate::outcome::Outcome;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::record::{Ending, JsonLines, Sink};
use tip_sim::lockstep::{Lockstep, Scout};
use tip_sim::{Inputs, Refused, Run};

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

/// Runs both engines to their end, or until the inputs say so. Records get a hash of the robot's state if
/// `with_state` says so; both are compared with it.
///
/// # Errors
/// The robot lacks an input.
pub fn race<const L: usize, const J: usize>(
    lockstep: &Lockstep,
    inputs: &Inputs,
    with_state: bool,
    observer: &mut dyn Observer<L, J>,
) -> Result<Outcome<L>, Refused> {
    let mut race = Race {
        records: JsonLines::new(String::new(), with_state),
        gait: Gait::default(),
        margin: f64::INFINITY,
        time: 0.0,
        robot: None,
        observer,
    };
    let compared = lockstep.run(inputs, &mut race)?;
    let identical = compared.divergence.is_none();
    let ending = compared.ending.unwrap_or(Ending::Interrupted);
    if identical {
        race.records.end(ending, compared.cycles);
        race.observer.end(race.records.get_ref());
    }
    let (gait, margin, robot) = (race.gait, race.margin, race.robot);
    let pose = robot.as_ref().map(SimulatedPlant::body);
    let [drift, travel, _] = pose.map_or([0.0; 3], |pose| pose.position);
    Ok(Outcome {
        ending,
        cycles: compared.cycles,
        seconds: race.time,
        travel,
        drift,
        falls: robot.as_ref().map_or(0, SimulatedPlant::falls),
        slip: robot.as_ref().map_or(0.0, SimulatedPlant::worst_slip),
        margin,
        gait,
        same_records: compared.cycles + u64::from(identical),
        identical,
    })
}

/// What is seen of the robot under way.
struct Race<'a, const L: usize, const J: usize> {
    records: JsonLines<String>,
    gait: Gait<L>,
    margin: f64,
    /// s.
    time: f64,
    /// As it is now.
    robot: Option<SimulatedPlant<L, J>>,
    observer: &'a mut dyn Observer<L, J>,
}

impl<const L: usize, const J: usize> Scout for Race<'_, L, J> {
    fn sink(&mut self) -> Option<&mut dyn Sink> {
        Some(&mut self.records)
    }

    fn after(&mut self, run: &Run) {
        let Some(robot) = run.plant::<SimulatedPlant<L, J>>() else {
            return;
        };
        self.time = run.time() / 1000.0;
        self.gait.push(robot.contacts());
        self.margin = self.margin.min(robot.margin());
        self.observer
            .cycle(self.time, robot, self.records.get_ref());
        self.records.get_mut().clear();
        self.robot = Some(robot.clone());
    }
}
