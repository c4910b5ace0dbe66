//! The records of a run: the trace, TITAN.LOG, the dump of variables.
//!
//! ```
//! use tip_runtime::hardware::JointCommand;
//! use tip_runtime::record::{Ending, state_hash};
//!
//! // It shows the last bit of every joint.
//! let commands = [JointCommand::at(90.0)];
//! let hash = state_hash(&commands, &[90.0]);
//! assert_eq!(hash, state_hash(&commands, &[90.0]));
//! assert_ne!(hash, state_hash(&commands, &[90.0_f64.next_up()]));
//! # #[cfg(feature = "std")] {
//! use tip_runtime::record::JsonLines;
//!
//! let mut trace = JsonLines::new(String::new(), true);
//! trace.end(Ending::Limit, 250);
//! assert_eq!(trace.into_inner(), "{\"end\":\"LIMIT\",\"cycles\":250}\n");
//! # }
//! # let _ = Ending::Limit;
//! ```

mod dump;
mod ending;
#[cfg(feature = "std")]
mod json_lines;
#[cfg(feature = "std")]
mod moved;
mod sample;
mod state_hash;
#[cfg(feature = "std")]
mod stream;
#[cfg(feature = "std")]
mod titan_log;
#[cfg(feature = "std")]
mod whole_file;

pub use dump::Dump;
pub use ending::Ending;
#[cfg(feature = "std")]
pub use json_lines::JsonLines;
#[cfg(feature = "std")]
pub use moved::Moved;
pub use sample::Sample;
pub use state_hash::state_hash;
#[cfg(feature = "std")]
pub use stream::Stream;
#[cfg(feature = "std")]
pub use titan_log::TitanLog;
#[cfg(feature = "std")]
pub use whole_file::WholeFile;

use crate::command::Command;
use crate::program::Program;
use core::fmt::Display;

/// One control cycle whose step ran to its end without a fault.
#[derive(Clone, Copy)]
#[non_exhaustive]
pub struct Cycle<'a> {
    /// The step that ran.
    pub step: u32,
    /// The step of the next cycle; `None` after END and EXIT.
    pub next: Option<u32>,
    /// The program after the step, for its variables.
    pub program: &'a dyn Program,
    /// The cycle's number and time, with its measurements and commands.
    pub sample: Sample<'a>,
}

/// A recorder of a run, cycle by cycle. In each cycle [`begin`](Self::begin) comes before the step
/// and [`cycle`](Self::cycle) after it, with the other calls in between; the failing cycle of an
/// emergency has no [`cycle`](Self::cycle).
pub trait Sink {
    /// Records that a step is about to run.
    fn begin(&mut self, program: &dyn Program) {
        let _ = program;
    }

    /// Records an accepted robot command: called in the first cycle of the command only.
    fn command(&mut self, command: &Command<'_>) {
        let _ = command;
    }

    /// Records a message; an empty one cleared the line.
    fn say(&mut self, text: &dyn Display) {
        let _ = text;
    }

    /// Records the switching of a lamp.
    fn lamp(&mut self, device: u8, on: bool) {
        let _ = (device, on);
    }

    /// Records the end of a cycle.
    fn cycle(&mut self, cycle: &Cycle<'_>) {
        let _ = cycle;
    }
}
