//! What must hold of any bytes, tried with the corpora and with random ones.

mod dap;
mod editing;
mod format;
mod fuzz;
mod programs;
mod random;
