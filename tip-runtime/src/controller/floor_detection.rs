//! DETECT_FLOOR of TITAN VIII (T.I.P. 3.1 §7-11-3): feet move until their soles touch the floor,
//! or leave it.

use super::targets::unlocked;
use super::task::{FloorSearch, Task};
use super::trajectory::Goal;
use super::{ControllerView, targets};
use crate::command::{Command, Poll, Port, Target};
use crate::fault::Fault;
use crate::kinematics::LegPoint;

/// The speed of a searching foot, as a share of the standard V_MAX (SLOW).
const SLOW: f64 = 0.5;

impl FloorSearch {
    fn new(operand: f64) -> Result<Self, Fault> {
        match libm::trunc(operand) {
            1.0 => Ok(FloorSearch::DownInTurn),
            2.0 => Ok(FloorSearch::DownTogether),
            3.0 => Ok(FloorSearch::Up),
            _ => Err(Fault::Domain),
        }
    }
}

impl<const J: usize> ControllerView<J> {
    pub(super) fn detect_floor_by_soles(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        let search = match self.tasks.current() {
            Task::DetectFloor(search) => search,
            _ => self.new_search(command)?,
        };
        for n in 1..=self.count() {
            if self.leg(n)?.search.is_none() {
                continue;
            }
            unlocked(self.leg(n)?.switches.has_locked())?;
            if self.touches(n)? != (search == FloorSearch::Up) {
                // The floor has stopped the foot already: its set point follows immediately.
                self.send_foot(n, self.measured_point(n, LegPoint::Tip)?, true)?;
                targets::leg_mut(&mut self.legs, n)?.search = None;
            } else {
                self.set_off(n, search)?;
                if search == FloorSearch::DownInTurn {
                    break;
                }
            }
        }
        if self.legs.iter().any(|leg| leg.search.is_some()) {
            self.tasks.set(Task::DetectFloor(search));
            Ok(Poll::Pending)
        } else {
            self.tasks.set(Task::Idle);
            Ok(Poll::Done)
        }
    }

    fn new_search(&mut self, command: &Command<'_>) -> Result<FloorSearch, Fault> {
        let [operand] = command.values else {
            return Err(Fault::Domain);
        };
        let search = FloorSearch::new(operand.number())?;
        self.begin_search(command.target)?;
        Ok(search)
    }

    /// Legs that a target names begin to search, no others.
    ///
    /// # Errors
    /// `InvalidMode` for a leg with a locked joint, or while another thread stands in a command of
    /// this kind; `Domain` for a target that is no leg.
    pub(super) fn begin_search(&mut self, target: Target) -> Result<(), Fault> {
        let legs = targets::feet(&mut self.legs, target)?;
        unlocked(legs.iter().any(|leg| leg.switches.has_locked()))?;
        self.tasks.begin()?;
        for leg in &mut self.legs {
            leg.search = None;
        }
        for leg in targets::feet(&mut self.legs, target)? {
            leg.search = Some(0);
        }
        Ok(())
    }

    /// Returns true if the sole of leg `n` senses the floor.
    fn touches(&self, n: u8) -> Result<bool, Fault> {
        let volts = self.leg(n)?.paw;
        if volts.is_finite() {
            Ok(volts >= self.robot.contact)
        } else {
            Err(Fault::Sensor(Port::Paw(n)))
        }
    }

    fn set_off(&mut self, n: u8, search: FloorSearch) -> Result<(), Fault> {
        let slow = SLOW * self.robot.standards.v_max;
        let velocity = match search {
            FloorSearch::DownInTurn | FloorSearch::DownTogether => [0.0, 0.0, -slow],
            FloorSearch::Up => [0.0, 0.0, slow],
        };
        let foot = self.foot_track(n)?.towards(Goal::Speed(velocity));
        self.take_point(n, LegPoint::Tip, foot)
    }
}
