//! Rust as one writes it by hand for a long motion.

use tip_runtime::command::{Command, Op, Poll, Target, Value};
use tip_runtime::fault::Fault;
use tip_runtime::program::Context;

/// Asks the robot for a command.
pub(crate) fn ask<const N: usize>(
    cx: &mut dyn Context,
    op: Op,
    target: Target,
    values: [f64; N],
) -> Result<Poll, Fault> {
    let values = values.map(Value::Absolute);
    cx.command(&Command {
        op,
        hs: false,
        target,
        values: &values,
    })
}

macro_rules! by_hand {
    ($($name:ident)*) => { $(
        pub(crate) mod $name {
            use super::ask;
            use tip_runtime::command::{Op, Poll, Target};
            use tip_runtime::fault::Fault;
            use tip_runtime::ops::finite;
            use tip_runtime::program::{Context, End, Flow};

            include!(concat!(env!("OUT_DIR"), "/", stringify!($name), "_by_hand.rs"));
        }
    )* };
}

by_hand!(steps100 steps1000 steps10000);
