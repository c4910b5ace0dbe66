//! Facts about a [`Program`](crate::program::Program), found without running it and without changing it.

pub mod access;
pub mod assignment;
#[cfg(feature = "build")]
pub(crate) mod calls;
#[cfg(feature = "build")]
pub(crate) mod dead;
pub mod flow;
#[cfg(feature = "build")]
pub(crate) mod stuck;
#[cfg(feature = "build")]
mod walk;

pub use access::assigns;

#[cfg(feature = "build")]
pub(crate) use flow::{Entry, Flow, always, enters};
