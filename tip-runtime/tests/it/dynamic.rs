//! The walker with mass: closed forms, conservation laws, and what is found by other means.

mod flight;
mod force;
mod ground;
mod mass;
mod rig;
mod spread;
