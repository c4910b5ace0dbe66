//! The simulated plant, compared with closed forms and invariants.

mod falls;
mod gait;
mod pose;
mod random;
mod rig;
mod sensors;
mod servos;
mod unmodelled;
