//! The tests of the runtime, in one binary.
#![cfg(feature = "control")]

mod arrival;
#[cfg(all(unix, feature = "std"))]
mod atomic_file;
mod cycle;
mod dynamic;
mod generic;
mod hand;
mod hand_plant;
mod kinematics;
mod limits;
mod list;
#[cfg(feature = "std")]
mod log_files;
mod model_check;
mod modes;
mod motion;
mod parameters;
mod plant;
mod rates;
mod rig;
mod robots;
#[cfg(feature = "std")]
mod servo_loop;
mod stops;
mod switches;
mod tasks;
