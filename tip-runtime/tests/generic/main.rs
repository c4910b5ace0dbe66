//! Robots of 1 to 9 legs with 1 to 9 joints each.
#![cfg(feature = "control")]

mod inverse;
#[path = "../list/mod.rs"]
mod list;
mod machine;
mod program;
mod reachable;
mod shapes;
mod statics;
mod walking;
