#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

pub mod live;
mod page;
mod recorder;
mod recording;
mod trace;
mod updates;

pub use page::{MAX_RUNS, SweepTable, sweep_page};
pub use recorder::{DurationLimit, RecordError};
pub use recording::{
    Frame, FrameRate, LogEntry, ObjectPose, Occurrence, Outcome, Recording, Script, Skeleton, Stop,
    Tick, robot_frame,
};
pub use tip_sim;
pub use trace::TraceError;
