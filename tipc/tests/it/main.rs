//! The tests of the compiler, in one binary.

mod bounded;
mod codes;
mod descriptions;
mod findings;
mod fixes;
mod format;
mod listing;
mod messages;
mod migrate;
mod misread;
mod object;
mod object_joints;
mod one_mistake;
mod reasons;
mod reference;
mod source;
mod symbols;
mod usage;
mod versions;
mod warnings;
