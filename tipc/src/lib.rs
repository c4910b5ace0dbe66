#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

pub mod analysis;
mod check;
pub mod code;
#[cfg(feature = "robot-files")]
pub mod description;
pub mod diagnostic;
pub mod embed;
pub mod emit;
#[cfg(test)]
pub(crate) mod fixture;
#[doc(hidden)]
#[cfg(feature = "build")]
pub mod generate;
pub mod language;
pub mod lex;
pub mod load;
pub mod message;
pub mod parse;
pub mod program;
pub mod published;
pub mod render;
mod robot;
pub mod source;
pub mod suggest;
pub mod symbols;
pub mod syntax;

#[cfg(feature = "build")]
pub use generate::{BuildError, Config, compile};
pub use load::{Loaded, MAX_DIAGNOSTICS, Options, load};
pub use robot::{Facts, Robot};
