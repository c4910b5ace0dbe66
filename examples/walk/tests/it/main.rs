//! The tests of the example.

#[cfg(target_os = "linux")]
mod interrupt;
mod walk;
