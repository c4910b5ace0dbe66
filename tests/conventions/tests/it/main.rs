//! The conventions of the project, each held by a test.

mod circles;
mod messages;
mod packages;
mod runtime;
mod structure;
mod words;
