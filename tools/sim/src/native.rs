//! The native code of SPECIAL under one type.

use std::fmt;
use tip_runtime::command::Poll;
use tip_runtime::fault::Fault;
use tip_runtime::program::Robot;
use tip_runtime::special::{Call, Special};

/// The SPECIAL commands of a robot.
pub(crate) struct Native(Box<dyn AnySpecial>);

trait AnySpecial: Special {
    fn boxed(&self) -> Box<dyn AnySpecial>;
}

impl<S: Special + Clone + 'static> AnySpecial for S {
    fn boxed(&self) -> Box<dyn AnySpecial> {
        Box::new(self.clone())
    }
}

impl Native {
    pub(crate) fn new(special: impl Special + Clone + 'static) -> Self {
        Native(Box::new(special))
    }
}

impl Clone for Native {
    fn clone(&self) -> Self {
        Native(self.0.boxed())
    }
}

impl fmt::Debug for Native {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Native")
    }
}

impl Special for Native {
    fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault> {
        self.0.poll(call, robot)
    }

    fn cycle(&mut self, robot: &mut dyn Robot) -> Result<(), Fault> {
        self.0.cycle(robot)
    }
}
