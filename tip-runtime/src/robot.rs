//! The named robots that a program can be compiled for, as types.
//!
//! ```
//! use tip_runtime::robot::{For, Hand, Titan8};
//!
//! /// Takes what was compiled for TITAN VIII; with a program for another robot it does not compile.
//! fn name_of(program: &impl For<Titan8>) -> &str {
//!     program.name()
//! }
//! # #[cfg(feature = "control")] {
//! use tip_runtime::machine::Simulated;
//!
//! assert_eq!(<Titan8 as Simulated<4, 3>>::MODEL.name, "titan8");
//! assert_eq!(<Hand as Simulated<3, 3>>::MODEL.name, "hand");
//! # }
//! ```

use crate::program::Program;

/// TITAN VIII.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Titan8 {}

/// The Hiroshima Hand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Hand {}

/// The generic robot, for programs without a description.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Generic {}

/// A program that was checked for the robot `R`. Generated code implements it, unless the robot is
/// described in a file.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was not compiled for a robot with a name",
    note = "for a described robot there is `Machine::simulated_on`, which takes its model"
)]
pub trait For<R>: Program {}
