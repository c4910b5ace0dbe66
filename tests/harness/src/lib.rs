//! How the tests run a motion program: on the simulated robot, with what happens around it, traced record by record.
//!
//! A crate of its own so that it can be optimised: the plants are generic, and therefore compiled here.

mod engine;
mod run;
mod settings;

pub use engine::Boxed;
pub use run::run;
pub use settings::Settings;
