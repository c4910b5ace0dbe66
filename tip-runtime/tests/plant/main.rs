//! The simulated plant against closed forms and invariants.
#![cfg(feature = "control")]

mod falls;
mod gait;
mod pose;
mod random;
mod rig;
mod sensors;
mod servos;
mod unmodelled;
