//! Facts about a [`Program`](crate::program::Program), found without running it and without changing it.

mod access;
pub mod assignment;
#[cfg(feature = "tools")]
pub mod cycles;
mod flow;
#[cfg(feature = "tools")]
pub mod spots;
