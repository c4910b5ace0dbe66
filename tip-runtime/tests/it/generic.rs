//! Robots of 1 to 9 legs with 1 to 9 joints each.

mod inverse;
mod machine;
mod program;
mod reachable;
mod shapes;
mod statics;
mod walking;
