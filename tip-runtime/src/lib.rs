#![cfg_attr(feature = "control", doc = include_str!("../README.md"))]
#![cfg_attr(
    not(feature = "control"),
    doc = "The vocabulary that the compiler and the runtime of T.I.P. programs share."
)]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![no_std]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

#[cfg(feature = "std")]
extern crate std;

#[cfg(feature = "control")]
mod analog;
pub mod command;
#[cfg(feature = "control")]
pub mod console;
#[cfg(feature = "control")]
pub mod controller;
#[cfg(feature = "control")]
mod emergency;
pub mod fault;
pub mod function;
#[doc(hidden)]
pub mod generated;
#[cfg(feature = "control")]
pub mod hardware;
#[cfg(feature = "control")]
pub mod kinematics;
#[cfg(feature = "control")]
pub mod machine;
pub mod model;
#[cfg(feature = "ops")]
pub mod ops;
#[cfg(feature = "control")]
pub mod plant;
pub mod printable;
pub mod program;
pub mod random;
#[cfg(feature = "std")]
pub mod realtime;
#[cfg(feature = "control")]
pub mod record;
pub mod robot;
pub mod scene;
#[cfg(feature = "control")]
pub mod special;
pub mod vibration;

#[doc(hidden)]
pub use generated::version;
