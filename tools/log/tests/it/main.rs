//! The tests of logs and plots, in one binary.

mod csv;
mod mcap;
mod plot;
