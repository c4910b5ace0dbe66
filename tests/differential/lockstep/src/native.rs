//! The native code of SPECIAL that random programs call.

use random_programs::NATIVE;
use tip_runtime::command::{Command, Op, Poll, Target, Value};
use tip_runtime::fault::Fault;
use tip_runtime::program::{Robot, SpecialVariable};
use tip_runtime::special::{Call, Special};

/// Remaining cycles of the present command, and number of all cycles.
#[derive(Clone, Debug, Default)]
pub(crate) struct Native {
    left: f64,
    cycles: f64,
}

impl Special for Native {
    fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault> {
        let [at_once, lasting, lamp, _] = NATIVE;
        let [cycles, flag] = call.arguments.map(Option::unwrap_or_default);
        match call.number {
            n if n == at_once => Ok(Poll::Done),
            n if n == lasting => Ok(self.last(call.first, cycles, flag, robot)),
            n if n == lamp => robot.command(&Command {
                op: Op::LampOn,
                hs: false,
                target: Target::None,
                values: &[Value::Absolute(1.0)],
            }),
            _ => Err(Fault::Domain),
        }
    }

    /// Counts in one variable of the program, and copies another.
    fn cycle(&mut self, robot: &mut dyn Robot) -> Result<(), Fault> {
        self.cycles += 1.0;
        let copied = robot.special_variable(SpecialVariable::Var(0));
        // They are refused before the program's first SPECIAL, and if it names none.
        let _ = robot.set_special_variable(SpecialVariable::Var(1), self.cycles);
        let _ = robot.set_special_variable(SpecialVariable::Joint(2, 0), copied);
        Ok(())
    }
}

impl Native {
    fn last(&mut self, first: bool, cycles: f64, flag: f64, robot: &mut dyn Robot) -> Poll {
        if first {
            self.left = cycles;
        }
        self.left -= 1.0;
        if self.left > 0.0 {
            return Poll::Pending;
        }
        robot.set_special_flag(flag as u8 % 10, robot.period() > cycles);
        Poll::Done
    }
}
