//! Known start of each foot, on the first pass through a program.

use super::constants;
use crate::Robot;
use tip_runtime::command::{Op, Target};
use tip_runtime::model::Point;
use tipc::program::{Action, Step};

/// Knowledge of a foot.
#[derive(Clone, Copy, Default)]
struct Foot {
    /// Place of rest.
    rests: Option<Point>,
    /// Place of its target.
    goes: Option<Point>,
}

/// Knowledge of all feet before a step.
pub(super) struct Starts {
    /// None after the first question, or a command that may move anything.
    feet: Option<Vec<Foot>>,
}

impl Starts {
    /// Creates a robot in its initial posture. Of legs without a closed form nothing is known: they
    /// choose postures on their way.
    pub(super) fn of(robot: &Robot) -> Self {
        let anatomy = robot.anatomy();
        if !anatomy.inverse.is_closed() {
            return Starts { feet: None };
        }
        let rests = |at: Point| Foot {
            rests: Some(at),
            goes: None,
        };
        let feet = anatomy.feet.into_iter().map(rests);
        Starts {
            feet: Some(feet.collect()),
        }
    }

    /// Returns the start of the foot that a step moves, if that is known; afterwards the effect of
    /// the step is known.
    pub(super) fn before(&mut self, step: &Step) -> Option<Point> {
        let feet = self.feet.as_mut()?;
        let Action::Command {
            op,
            target,
            arguments,
            ..
        } = &step.action
        else {
            let goes_on = matches!(
                step.action,
                Action::Nothing
                    | Action::SetScalar { .. }
                    | Action::SetStruct { .. }
                    | Action::Message { .. }
            );
            self.feet = self.feet.take().filter(|_| goes_on);
            return None;
        };
        match (op, target) {
            (Op::Ptp, Target::Foot(leg)) => {
                let foot = feet.get_mut(usize::from(*leg).checked_sub(1)?)?;
                let start = foot.rests.take();
                foot.goes = constants(arguments).and_then(|to| to.try_into().ok());
                start
            }
            (Op::WaitInpos, Target::Foot(leg)) => {
                let foot = feet.get_mut(usize::from(*leg).checked_sub(1)?)?;
                foot.arrive();
                None
            }
            (Op::WaitInpos, Target::All) => {
                feet.iter_mut().for_each(Foot::arrive);
                None
            }
            (
                Op::Sleep | Op::WaitNear | Op::LampOn | Op::LampOff | Op::LogStart | Op::LogStop,
                _,
            ) => None,
            (Op::SetVMax | Op::SetAMax | Op::SetVMaxRate | Op::SetAMaxRate, _) => None,
            _ => {
                self.feet = None;
                None
            }
        }
    }
}

impl Foot {
    /// Moves its place of rest to its target.
    fn arrive(&mut self) {
        self.rests = self.rests.or(self.goes.take());
    }
}
