#![doc = include_str!("../README.md")]
#![no_std]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

#[cfg(feature = "std")]
extern crate std;

pub mod bus;
pub mod drives;
pub mod frame;
pub mod guard;
pub mod model;
pub mod moteus;
#[cfg(feature = "std")]
pub mod serial;
#[cfg(feature = "std")]
pub mod simulated;

pub use bus::{Bus, BusError, Port};
pub use drives::Drives;
pub use guard::TorqueGuard;
pub use model::{Family, Model};
