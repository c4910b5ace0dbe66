//! Tests of the drives on a simulated bus.

mod drives;
mod frames;
mod simulated;
mod start;
mod tables;
