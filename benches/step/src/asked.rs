//! A command as a script gives it.

use peers::code;
use tip_runtime::command::{Command, Value};
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, Flow};

/// A command in numbers.
#[derive(Clone, Copy)]
pub(crate) struct Asked {
    pub(crate) op: usize,
    pub(crate) target: u8,
    pub(crate) values: [f64; 3],
    pub(crate) count: usize,
}

impl Asked {
    /// Asks the robot.
    pub(crate) fn of(&self, robot: &mut dyn Context) -> Result<Flow, Fault> {
        let values = self.values.map(Value::Absolute);
        robot.command(&Command {
            op: code::op(self.op).ok_or(Fault::Domain)?,
            hs: false,
            target: code::target(self.target),
            values: values.get(..self.count).ok_or(Fault::Domain)?,
        })?;
        Ok(Flow::Next)
    }
}
