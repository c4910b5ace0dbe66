//! The conventions of the project, each held by a test.

mod packages;
#[cfg(target_os = "linux")]
mod release;
mod runtime;
mod rustdoc;
mod scripts;
mod structure;
mod words;
