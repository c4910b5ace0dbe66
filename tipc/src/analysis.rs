//! Facts about a [`Program`](crate::program::Program), found without running it and without changing it.

mod access;
pub mod assignment;
pub(crate) mod calls;
#[cfg(feature = "tools")]
pub mod cycles;
pub(crate) mod dead;
mod flow;
#[cfg(feature = "tools")]
pub mod spots;
pub(crate) mod stuck;
mod walk;

pub use access::assigns;

pub(crate) use flow::{Entry, always, enters};
