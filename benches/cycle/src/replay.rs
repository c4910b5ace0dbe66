//! A robot that measures what another one measured before, so that a run without a simulation takes
//! the same course.

use std::cell::RefCell;
use std::rc::Rc;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, Outputs, Sensors};

/// Measurements, cycle by cycle, and the next one's number.
#[derive(Clone, Debug)]
pub struct Replay<const L: usize, const J: usize> {
    readings: Rc<[Sensors<L, J>]>,
    next: usize,
}

impl<const L: usize, const J: usize> Replay<L, J> {
    /// Records the measurements of `robot` while `run` runs a program on it.
    pub fn of<H: Hardware<L, J>>(robot: H, run: impl FnOnce(Recorder<H, L, J>)) -> Self {
        let readings = Rc::new(RefCell::new(Vec::new()));
        run(Recorder {
            robot,
            readings: Rc::clone(&readings),
        });
        Replay {
            readings: readings.take().into(),
            next: 0,
        }
    }
}

impl<const L: usize, const J: usize> Hardware<L, J> for Replay<L, J> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        *into = *self
            .readings
            .get(self.next)
            .ok_or(HardwareFault::new("replay"))?;
        self.next += 1;
        Ok(())
    }

    fn write(&mut self, _outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        Ok(())
    }

    fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
        Ok(())
    }
}

/// A robot whose measurements are written down.
#[derive(Clone, Debug)]
pub struct Recorder<H, const L: usize, const J: usize> {
    robot: H,
    readings: Rc<RefCell<Vec<Sensors<L, J>>>>,
}

impl<H: Hardware<L, J>, const L: usize, const J: usize> Hardware<L, J> for Recorder<H, L, J> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        self.robot.read(into)?;
        self.readings.borrow_mut().push(*into);
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        self.robot.write(outputs)
    }

    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault> {
        self.robot.stop(why)
    }
}
