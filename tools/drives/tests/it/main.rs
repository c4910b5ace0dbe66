//! Tests of the drives on a simulated bus.

mod drives;
mod frames;
mod guard;
mod operator;
mod simulated;
mod start;
mod tables;
