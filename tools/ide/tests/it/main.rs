//! The tests of what editors ask, in one binary.

mod completions;
mod ide;
mod transport;
mod vscode;
