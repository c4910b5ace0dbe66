//! One engine on a simulated robot of its own.

use super::inputs::{Due, Inputs};
use super::{Refused, Rig};
use tip_runtime::console::Scripted;
use tip_runtime::machine::{Machine, Status};
use tip_runtime::plant::Plant;
use tip_runtime::program::Program;
use tip_runtime::record::{Ending, JsonLines};
use tip_runtime::special::Special;

pub(super) struct Side<'m, P, H, S, const L: usize, const J: usize> {
    machine: Machine<'m, P, H, Scripted<()>, S, L, J>,
    due: Due,
    /// What the last cycle left behind.
    trace: JsonLines<String>,
}

impl<'m, P, H, S, const L: usize, const J: usize> Side<'m, P, H, S, L, J>
where
    P: Program,
    H: Plant<L, J> + Clone,
    S: Special + Clone,
{
    /// Puts an engine on the robot of a rig.
    pub(super) fn new<C>(
        engine: P,
        rig: &Rig<'m, C, H, S, L, J>,
        inputs: &Inputs,
    ) -> Result<Self, Refused> {
        let (plant, special) = (rig.plant.clone(), rig.special.clone());
        let machine = Machine::new(engine, rig.model, plant, inputs.console(()), special);
        Ok(Side {
            machine: machine.map_err(Refused::Mismatch)?,
            due: Due::new(&inputs.sensors),
            trace: JsonLines::new(String::new(), true),
        })
    }

    /// Runs a cycle, unless `limit` are used up, and says whether that was the end.
    pub(super) fn cycle(&mut self, limit: u64) -> Option<Ending> {
        self.trace.get_mut().clear();
        let cycle = self.machine.cycles();
        let ending = if cycle >= limit {
            Some(Ending::Limit)
        } else {
            while let Some(sensor) = self.due.next(cycle) {
                let plant = self.machine.hardware_mut();
                plant.set_sensor(sensor.port, sensor.volts);
            }
            match self.machine.cycle_traced(&mut self.trace) {
                Status::Running => None,
                Status::Finished(end) => Some(Ending::Program(end)),
                Status::Emergency => self.machine.emergency().copied().map(Ending::Emergency),
            }
        };
        if let Some(ending) = ending {
            self.trace.end(ending, self.machine.cycles());
        }
        ending
    }

    /// What the last cycle left behind: its record, and the last one if that was the end.
    pub(super) fn record(&self) -> &str {
        self.trace.get_ref()
    }

    /// Control cycles whose step ran without a fault.
    pub(super) fn cycles(&self) -> u64 {
        self.machine.cycles()
    }

    /// The engine.
    pub(super) fn program(&self) -> &P {
        self.machine.program()
    }
}
