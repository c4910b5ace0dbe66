//! The tests of the compiler, in one binary.

mod descriptions;
mod messages;
mod reasons;
mod reference;
mod source;
mod symbols;
mod usage;
mod versions;
