//! The tests of the example.

mod description;
mod options;
mod run;
mod wire;
