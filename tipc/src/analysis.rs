//! Facts about a [`Program`](crate::program::Program), found without running it and without changing it.

pub mod access;
pub mod assignment;
pub mod flow;

pub use access::assigns;
