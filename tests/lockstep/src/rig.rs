//! The hardware of a run, to which things happen.

use crate::echo::Echo;
use crate::script::{Event, Happening, Scenery};
use tip_runtime::command::Port;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, Outputs, Sensors};
use tip_runtime::model::{Family, Model};
use tip_runtime::plant::{Plant, SimulatedHand, SimulatedPlant};

/// What a sole's sensor reads on the ground, and in the air: V.
const PRESSED: f64 = 2.0;

pub(crate) struct Rig<'m, const L: usize, const J: usize> {
    plant: Which<'m, L, J>,
    events: &'m [Event],
    cycle: u64,
    write_fails: bool,
}

enum Which<'m, const L: usize, const J: usize> {
    Echo(Echo<'m, L, J>),
    Simulated(Box<dyn Plant<L, J> + 'm>),
}

impl<'m, const L: usize, const J: usize> Rig<'m, L, J> {
    pub(crate) fn new(model: &'m Model<L, J>, scenery: Scenery, events: &'m [Event]) -> Self {
        let plant = match (scenery, model.family) {
            (Scenery::Echo, _) => Which::Echo(Echo::new(model)),
            (Scenery::Simulated, Family::Hand) => {
                Which::Simulated(Box::new(SimulatedHand::new(model)))
            }
            (Scenery::Simulated, _) => Which::Simulated(Box::new(SimulatedPlant::new(model))),
        };
        Rig {
            plant,
            events,
            cycle: 0,
            write_fails: false,
        }
    }

    fn happen(&mut self, happening: Happening) -> Result<(), HardwareFault> {
        match happening {
            Happening::Key(_) => {}
            Happening::Sensor(port, volts) => {
                self.plant().set_sensor(port, volts);
            }
            Happening::Touch(on) => self.touch(on),
            Happening::ReadFails => return Err(HardwareFault("read")),
            Happening::WriteFails => self.write_fails = true,
        }
        Ok(())
    }

    /// Simulated joints feel what is there; only soles can be told.
    fn touch(&mut self, on: bool) {
        let volts = if on { PRESSED } else { 0.0 };
        for leg in (1..).take(L) {
            self.plant().set_sensor(Port::Paw(leg), volts);
        }
        if let Which::Echo(echo) = &mut self.plant {
            echo.touch(on);
        }
    }

    fn plant(&mut self) -> &mut dyn Plant<L, J> {
        match &mut self.plant {
            Which::Echo(echo) => echo,
            Which::Simulated(plant) => plant.as_mut(),
        }
    }
}

impl<const L: usize, const J: usize> Hardware<L, J> for Rig<'_, L, J> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        let mut outcome = Ok(());
        while let Some(((_, happening), later)) = self
            .events
            .split_first()
            .filter(|((cycle, _), _)| *cycle <= self.cycle)
        {
            self.events = later;
            outcome = outcome.and(self.happen(*happening));
        }
        self.cycle += 1;
        outcome?;
        match &mut self.plant {
            Which::Echo(echo) => echo.read(into),
            Which::Simulated(plant) => plant.read(into),
        }
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        if self.write_fails {
            return Err(HardwareFault("write"));
        }
        match &mut self.plant {
            Which::Echo(echo) => echo.write(outputs),
            Which::Simulated(plant) => plant.write(outputs),
        }
    }

    fn stop(&mut self, why: &Fault) {
        self.plant().stop(why);
    }
}
