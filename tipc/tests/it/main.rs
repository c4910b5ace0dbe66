//! The tests of the compiler, in one binary.

mod depth;
mod descriptions;
mod messages;
mod reasons;
mod reference;
mod source;
mod symbols;
mod usage;
mod versions;
