//! DETECT_FLOOR of TITAN VIII (T.I.P. 3.1 §7-11-3): feet move until their soles touch the floor,
//! or leave it.

use super::task::{Course, Search, Task};
use super::trajectory::Goal;
use super::{Controller, targets};
use crate::command::{Command, Poll, Port};
use crate::fault::Fault;
use crate::kinematics::Point;

/// The speed of a searching foot, as a share of the standard V_MAX (SLOW).
const SLOW: f64 = 0.5;

impl Course {
    fn new(operand: f64) -> Result<Self, Fault> {
        match libm::trunc(operand) {
            1.0 => Ok(Course::DownInTurn),
            2.0 => Ok(Course::DownTogether),
            3.0 => Ok(Course::Up),
            _ => Err(Fault::Domain),
        }
    }
}

impl<const L: usize, const J: usize> Controller<'_, L, J> {
    pub(super) fn detect_floor_by_soles(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        let mut search = match self.task {
            Task::Detect(search) => search,
            _ => Self::new_search(command)?,
        };
        for (n, looking) in (1..).zip(&mut search.looking) {
            if !*looking {
                continue;
            }
            if self.touches(n)? != (search.course == Course::Up) {
                // The floor has stopped the foot already: its set point follows at once.
                self.send_foot(n, self.measured_point(n, Point::Tip)?, true)?;
                *looking = false;
            } else {
                self.set_off(n, search.course)?;
                if search.course == Course::DownInTurn {
                    break;
                }
            }
        }
        if search.looking.contains(&true) {
            self.task = Task::Detect(search);
            Ok(Poll::Pending)
        } else {
            self.task = Task::Idle;
            Ok(Poll::Done)
        }
    }

    fn new_search(command: &Command<'_>) -> Result<Search<L>, Fault> {
        let [operand] = command.values else {
            return Err(Fault::Domain);
        };
        let course = Course::new(operand.number())?;
        let mut looking = [false; L];
        for looking in targets::feet(&mut looking, command.target)? {
            *looking = true;
        }
        Ok(Search { course, looking })
    }

    /// Whether the sole of leg `n` feels the floor.
    fn touches(&self, n: u8) -> Result<bool, Fault> {
        let volts = *targets::leg(&self.measured.paws, n)?;
        if volts.is_finite() {
            Ok(volts >= self.model.contact)
        } else {
            Err(Fault::Sensor(Port::Paw(n)))
        }
    }

    fn set_off(&mut self, n: u8, course: Course) -> Result<(), Fault> {
        let slow = SLOW * self.model.standards.v_max;
        let velocity = match course {
            Course::DownInTurn | Course::DownTogether => [0.0, 0.0, -slow],
            Course::Up => [0.0, 0.0, slow],
        };
        let foot = self.foot_track(n)?.towards(Goal::Speed(velocity));
        self.take_point(n, Point::Tip, foot)
    }
}
