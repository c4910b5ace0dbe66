//! The walker with mass: closed forms, conservation laws, and comparisons with other methods.

mod flight;
mod force;
mod ground;
mod inertial;
mod mass;
mod rig;
