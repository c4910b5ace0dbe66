//! Compiler, reference interpreter, runtime and plants as a page without a server needs them: the session that `tip serve`
//! serves, and traces.

#[cfg(target_arch = "wasm32")]
mod exports;
mod playground;
mod setup;

pub use playground::{Playground, trace};
pub use setup::{Bench, Text, Wanted};
