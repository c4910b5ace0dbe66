//! The tests of the compiler, in one binary.

mod codes;
mod descriptions;
mod findings;
mod messages;
mod misread;
mod one_mistake;
mod reasons;
mod reference;
mod source;
mod symbols;
mod usage;
mod versions;
mod warnings;
