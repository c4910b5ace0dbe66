//! What the walking examples share: a program on a simulated robot of `L` legs with `J` joints, run
//! by the compiled program and by the reference interpreter side by side, and what became of it.
#![forbid(unsafe_code)]

pub mod exit;
pub mod gait;
pub mod outcome;
pub mod race;
