//! The simulated hand: its fingers, contacts and objects.

mod accuracy;
mod fingers;
mod floors;
mod masses;
mod objects;
mod rig;
mod robustness;
mod statics;
mod thin;
mod vibration;
