//! Shared code of the walking examples: a compiled program on a simulated robot of `L` legs with `J` joints, and the
//! result of its run.
#![forbid(unsafe_code)]

pub mod exit;
pub mod gait;
pub mod outcome;
pub mod run;
