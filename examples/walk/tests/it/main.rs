//! The tests of the example.

mod gait;
#[cfg(target_os = "linux")]
mod interrupt;
mod options;
mod walk;
