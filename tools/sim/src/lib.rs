#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

mod cycle;
pub mod debug;
mod dyn_machine;
pub mod event;
mod event_console;
pub mod external;
mod ideal_joints;
pub mod import;
mod interp;
mod lints;
mod load;
pub mod lockstep;
pub mod message;
pub mod mjcf;
mod model;
mod motion;
mod process_group;
mod program_runner;
mod real_hardware;
mod robot;
mod run;
pub mod search;
mod sim_hardware;
mod summary;
mod timeline;
mod trace;
pub mod urdf;
pub mod verify;
mod wait_detector;

pub use cycle::{Cycle, IssuedCommand};
pub use event::{Event, Events, Inputs, Refused, Timed};
pub use external::ExternalPlant;
pub use interp::Interpreter;
pub use load::{LoadError, load};
pub use model::{Limb, RobotDescription};
pub use motion::{Approach, Fall, FallKind, Grasp, Limbs};
pub use process_group::end_processes;
pub use program_runner::{ProgramRunner, Replacement, StepTaken};
pub use real_hardware::Joints;
pub use robot::{GraspsNothing, Plant, Robot, UnknownRobot};
pub use run::{Limit, Observer, Run, Snapshot};
pub use summary::{
    Energy, FallFigures, Moment, Peak, Sample, Summary, SummaryBuilder, TravelFigures, WaitFigure,
};
pub use timeline::Timeline;
pub use tipc;
pub use wait_detector::{Wait, WaitDetector};
