//! Properties that hold for any input, tested with the corpora and with random bytes.

mod dap;
mod editing;
mod format;
mod fuzz;
mod programs;
mod repetitions;
