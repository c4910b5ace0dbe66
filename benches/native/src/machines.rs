//! The motions as hierarchical state machines of the crate `statig`, all states on one level.

use tip_runtime::fault::Fault;
use tip_runtime::program::Context;

/// Inputs and outputs of a machine in one control cycle.
pub(crate) struct Cycle<'a> {
    pub(crate) robot: &'a mut dyn Context,
    pub(crate) fault: Option<Fault>,
}

macro_rules! machines {
    ($($name:ident)*) => { $(
        #[expect(
            dead_code,
            unused_variables,
            reason = "handlers look alike, whether they ask the robot or not; nothing leads to END"
        )]
        pub(crate) mod $name {
            use super::Cycle;
            use crate::by_hand::ask;
            use statig::Outcome::{self, Handled, Transition};
            use statig::blocking;
            use tip_runtime::command::{Op, Poll, Target};
            use tip_runtime::fault::Fault;
            use tip_runtime::ops::finite;

            include!(concat!(env!("OUT_DIR"), "/", stringify!($name), "_statig.rs"));
        }
    )* };
}

machines!(walk_loop steps100 steps1000 steps10000);
