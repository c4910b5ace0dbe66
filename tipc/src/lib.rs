//! Compiler for T.I.P. 3.1 robot programs.
#![forbid(unsafe_code)]

pub mod check;
pub mod codes;
pub mod commands;
pub mod diagnostic;
pub mod emit;
#[cfg(test)]
pub(crate) mod fixture;
#[cfg(feature = "build")]
pub mod generate;
#[cfg(feature = "interp")]
pub mod interp;
pub mod lex;
pub mod listing;
pub mod lower;
pub mod parse;
pub mod program;
pub mod source;
pub mod syntax;
