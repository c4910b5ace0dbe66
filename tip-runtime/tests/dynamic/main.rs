//! The walker with mass: closed forms, conservation laws, and what is found by other means.
#![cfg(feature = "control")]

mod flight;
mod force;
mod ground;
mod mass;
mod rig;
mod spread;
