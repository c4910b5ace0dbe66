//! The tests of the example.

mod model;
mod six_legs;
