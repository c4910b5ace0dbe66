//! The tests of what editors ask, in one binary.

mod ide;
mod transport;
mod vscode;
