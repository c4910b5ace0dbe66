//! Facts about a [`Program`](crate::program::Program), found without running it and without changing it.

mod access;
pub mod assignment;
#[cfg(any(feature = "build", feature = "tools"))]
pub(crate) mod calls;
#[cfg(feature = "tools")]
pub mod cycles;
#[cfg(any(feature = "build", feature = "tools"))]
pub(crate) mod dead;
mod flow;
#[cfg(feature = "tools")]
pub mod spots;
#[cfg(any(feature = "build", feature = "tools"))]
pub(crate) mod stuck;
#[cfg(any(feature = "build", feature = "tools"))]
mod walk;

pub use access::assigns;

#[cfg(any(feature = "build", feature = "tools"))]
pub(crate) use flow::{Entry, Flow, always, enters};
