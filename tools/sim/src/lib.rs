#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

mod body;
mod cycle;
pub mod debug;
mod described;
mod desk;
mod echo;
mod engine;
pub mod event;
pub mod external;
mod figures;
mod findings;
mod interp;
mod load;
pub mod lockstep;
pub mod message;
pub mod mjcf;
mod motion;
mod native;
mod outside;
mod plant;
mod process_group;
pub mod reach;
mod refused;
mod rig;
mod robot;
mod run;
pub mod search;
mod shell;
mod sink;
mod snapshot;
pub mod special;
mod timeline;
mod trace;
mod transcript;
pub mod urdf;
pub mod verify;
mod waits;

pub use body::{Anatomy, Limb};
pub use cycle::{Asked, Cycle};
pub use described::NotDescribed;
pub use engine::Engine;
pub use event::{Event, Events, Inputs, Timed};
pub use external::ExternalPlant;
pub use interp::Interpreter;
pub use load::{NotLoaded, load};
pub use motion::{Fall, Grasp, Limbs};
pub use plant::Plant;
pub use process_group::end_processes;
pub use refused::Refused;
pub use robot::{GraspsNothing, Robot, UnknownRobot};
pub use run::{Limit, Observer, Run};
pub use snapshot::Snapshot;
pub use timeline::Timeline;
pub use tipc;
pub use waits::{Wait, Waits};
