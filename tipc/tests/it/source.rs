//! The layer of bytes and lines: nothing is lost, positions are those that counting from the start gives, and an index
//! costs next to nothing.
#![expect(clippy::disallowed_methods, reason = "cases and corpora are files")]

mod hostile;
mod lossless;
mod memory;
mod positions;
