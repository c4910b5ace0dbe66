//! The tests of what is offered for programs, in one binary.

mod bounded;
mod fixes;
mod format;
mod listing;
mod migrate;
mod object;
mod object_joints;
