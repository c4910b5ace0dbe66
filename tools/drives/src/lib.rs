#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![no_std]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

#[cfg(feature = "std")]
extern crate std;

pub mod bus;
#[cfg(feature = "std")]
pub mod described;
pub mod description;
pub mod drives;
pub mod dynamixel1;
pub mod dynamixel2;
pub mod family;
pub mod feetech;
pub mod frame;
pub mod guard;
pub mod lx;
pub mod model;
pub mod moteus;
#[cfg(feature = "std")]
pub mod operator;
#[cfg(feature = "std")]
pub mod port;
pub mod registers;
#[cfg(feature = "std")]
pub mod serial;
#[cfg(feature = "std")]
pub mod simulated;

pub use bus::{Bus, BusError, Port};
pub use drives::Drives;
pub use family::Family;
pub use guard::TorqueGuard;
pub use model::Model;
