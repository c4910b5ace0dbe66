//! The tests of the example.

mod lockstep;
mod special;
