//! The simulated robots that the tests run programs on, whatever made the program.
//!
//! The plants are generic and therefore compiled here: once and optimised, since nothing of the compiler is needed.

mod engine;
mod events;
mod run;

pub use engine::Boxed;
pub use events::Events;
pub use run::{Robot, run};
