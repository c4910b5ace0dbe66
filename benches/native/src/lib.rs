//! Motion programs as machine code: compiled by tipc, written by hand in Rust and in C, as machines of
//! the crate `statig`; and the reference interpreter beside them. All of them ask the same robot for the
//! same commands in the same control cycles.

mod by_hand;
mod compiled;
mod entrant;
mod machines;
pub mod motion;
pub mod robot;
mod switches;
mod walk_by_hand;

pub use entrant::{Entrant, Name, entrant};
