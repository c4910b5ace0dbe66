//! Native code behind the command SPECIAL (T.I.P. 3.1 §7-10-11).

use crate::command::Poll;
use crate::fault::Fault;
use crate::program::Robot;

/// One evaluation of a SPECIAL command. The step is evaluated once a cycle until it is done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Call {
    /// Which command: 0…255.
    pub number: u8,
    /// Its two arguments, `None` where omitted.
    pub arguments: [Option<f64>; 2],
    /// This is the first evaluation of the step.
    pub first: bool,
}

/// The SPECIAL commands of a robot.
///
/// Any `FnMut(Call, &mut dyn Robot) -> Result<Poll, Fault>` is one; `()` knows none.
pub trait Special {
    /// Carries out `call`: [`Poll::Pending`] to be called again in the next cycle with `first`
    /// false, [`Poll::Done`] when the step is over.
    ///
    /// # Errors
    /// `Domain` for a number that is not known, or any other fault. A handler that fails must not
    /// have commanded the robot in the same cycle.
    fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault>;
}

impl Special for () {
    fn poll(&mut self, _call: Call, _robot: &mut dyn Robot) -> Result<Poll, Fault> {
        Err(Fault::Domain)
    }
}

impl<F: FnMut(Call, &mut dyn Robot) -> Result<Poll, Fault>> Special for F {
    fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault> {
        self(call, robot)
    }
}
