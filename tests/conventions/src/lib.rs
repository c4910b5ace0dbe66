//! The project's own rules about its structure, as ARCHITECTURE.md draws it, read from the sources themselves.

mod circles;
mod imports;
mod manifests;
mod modules;
mod tree;

pub use circles::{Circle, circles};
pub use imports::{Import, imports};
pub use manifests::{Package, packages};
pub use modules::{Module, modules};
pub use tree::{root, rust_files};
