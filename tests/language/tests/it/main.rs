//! Generated code beside the interpreter.

mod analysis;
mod cases;
mod clauses;
mod coverage;
mod golden;
mod host;
mod macros;
mod mutants;
mod outside;
mod second_edition;
mod special;
mod variables;
