#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

mod cycle;
pub mod debug;
mod description;
mod diagnostics;
mod dyn_machine;
pub mod event;
mod event_console;
pub mod external;
mod ideal_joints;
mod interp;
mod load;
pub mod lockstep;
pub mod message;
pub mod mjcf;
mod model;
mod motion;
mod plant;
mod process_group;
mod program_runner;
pub mod reachability;
mod real_hardware;
mod refused;
mod robot;
mod run;
mod run_motion;
pub mod search;
mod sim_hardware;
mod snapshot;
pub mod special;
mod timeline;
mod trace;
pub mod urdf;
pub mod verify;
mod wait_detector;

pub use cycle::{Cycle, IssuedCommand};
pub use description::DescriptionError;
pub use event::{Event, Events, Inputs, Timed};
pub use external::ExternalPlant;
pub use interp::Interpreter;
pub use load::{LoadError, load};
pub use model::{Anatomy, Limb};
pub use motion::{Fall, Grasp, Limbs};
pub use plant::Plant;
pub use process_group::end_processes;
pub use program_runner::{ProgramRunner, Replacement, StepTaken};
pub use real_hardware::Joints;
pub use refused::Refused;
pub use robot::{GraspsNothing, Robot, UnknownRobot};
pub use run::{Limit, Observer, Run};
pub use snapshot::Snapshot;
pub use timeline::Timeline;
pub use tipc;
pub use wait_detector::{Wait, WaitDetector};
