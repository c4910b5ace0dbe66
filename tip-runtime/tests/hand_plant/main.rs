//! The simulated hand: its fingers, contacts and objects.

#![cfg(feature = "control")]

mod fingers;
mod floors;
mod objects;
mod rig;
mod robustness;
mod statics;
mod vibration;
