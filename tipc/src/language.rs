//! The language as tables: each word with its edition, its place in the reference and one line that says what it is.
//!
//! Words are spelled here; what a trace prints is spelled in [`tip_runtime::command`], and rows refer to it.

pub mod commands;
mod edition;
pub mod flags;
pub mod functions;
mod index;
pub mod inputs;
pub mod keywords;
pub mod names;
pub mod reserved;

pub use edition::Edition;
pub use keywords::Keyword;
