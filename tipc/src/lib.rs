#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

#[cfg(any(feature = "build", feature = "tools"))]
mod allow;
pub mod analysis;
#[cfg(feature = "tools")]
pub mod ask;
mod beside;
mod check;
pub mod code;
#[cfg(feature = "robot-files")]
pub mod description;
pub mod diagnostic;
pub mod embed;
pub mod emit;
#[cfg(feature = "tools")]
mod fix;
#[cfg(test)]
pub(crate) mod fixture;
mod foreign;
#[cfg(feature = "tools")]
pub mod format;
#[cfg(feature = "build")]
pub mod generate;
pub mod language;
pub mod lex;
#[cfg(feature = "tools")]
pub mod listing;
mod load;
mod lower;
pub mod message;
#[cfg(feature = "tools")]
pub mod migrate;
pub mod parse;
pub mod program;
pub mod published;
pub mod render;
#[cfg(feature = "tools")]
pub mod repair;
mod robot;
pub mod source;
mod suggest;
pub mod symbols;
pub mod syntax;
#[cfg(any(feature = "build", feature = "tools"))]
mod warn;

#[cfg(feature = "build")]
pub use generate::{BuildError, Config, compile};
pub use load::{Loaded, MOST, Options, load};
pub use robot::{Facts, Robot};
