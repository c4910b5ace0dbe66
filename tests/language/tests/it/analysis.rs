//! What the compiler says about programs without running them, against what their runs do.

mod assignment;
mod cycles;
mod programs;
mod watched;
