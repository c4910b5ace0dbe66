//! The tests of what is offered for programs, in one binary.

mod bounded;
mod codes;
mod diagnostics;
mod edition_3_2;
mod fixes;
mod format;
mod listing;
mod migrate;
mod misread;
mod object;
mod object_joints;
mod one_mistake;
mod warnings;
