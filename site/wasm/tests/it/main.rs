//! The tests of the playground.

mod contents;
mod session;
