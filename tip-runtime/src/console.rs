//! The interface between a program and its operator: keyboard, message line, logs, emergency
//! report.
//!
//! ```
//! use std::fmt::Display;
//! use tip_runtime::console::Console;
//!
//! /// One key at cycle 3, and the last message.
//! #[derive(Default)]
//! struct Panel {
//!     pressed: bool,
//!     line: String,
//! }
//!
//! impl Console for Panel {
//!     fn key(&mut self, cycle: u64) -> Option<u8> {
//!         let is_new = cycle >= 3 && !std::mem::replace(&mut self.pressed, cycle >= 3);
//!         is_new.then_some(b'F')
//!     }
//!
//!     fn message(&mut self, text: &dyn Display) {
//!         self.line = text.to_string();
//!     }
//! }
//!
//! let mut panel = Panel::default();
//! panel.message(&format_args!("leg {}", 2));
//! assert_eq!(panel.line, "leg 2");
//! let keys = (0..5).map(|cycle| panel.key(cycle));
//! assert_eq!(keys.collect::<Vec<_>>(), [None, None, None, Some(b'F'), None]);
//! ```

#[cfg(feature = "terminal")]
mod key;
#[cfg(feature = "std")]
mod log_files;
#[cfg(feature = "std")]
mod scripted;
#[cfg(feature = "terminal")]
mod terminal;

#[cfg(feature = "terminal")]
pub use key::Key;
#[cfg(feature = "std")]
pub use log_files::{LogError, LogFiles};
#[cfg(feature = "std")]
pub use scripted::{Scripted, Transcript};
#[cfg(feature = "terminal")]
pub use terminal::{Terminal, TerminalState};

use crate::emergency::Report;
use crate::record::{Dump, Sample};
use core::fmt::{self, Display};

/// The operator's console. Every method has a default that does nothing: `()` is a console.
///
/// Texts arrive as [`Display`] so that a console that shows nothing formats nothing.
pub trait Console {
    /// Returns the next byte that was typed and not yet handed over, if any. Called in every cycle
    /// until it returns `None`; `cycle` counts the program's cycles from 0.
    fn key(&mut self, cycle: u64) -> Option<u8> {
        let _ = cycle;
        None
    }

    /// Shows one line in place of the previous one; an empty line clears it (MESSAGE).
    fn message(&mut self, text: &dyn Display) {
        let _ = text;
    }

    /// Appends text to FOUT.LOG, exactly as it is (F_MESSAGE).
    fn append(&mut self, text: &dyn Display) {
        let _ = text;
    }

    /// Reduces the output to a minimum, or restores it (SILENT_ON, SILENT_OFF).
    fn silent(&mut self, on: bool) {
        let _ = on;
    }

    /// Draws a bar graph (from 0) in place of the previous one; without bars the graph is removed.
    /// Called ten times a second of the robot's time while the graph is shown.
    fn bars(&mut self, graph: u8, bars: Bars<'_>) {
        let _ = (graph, bars);
    }

    /// Records one row of TITAN.LOG (LOG_START, LOG_ONE_SHOT).
    fn sample(&mut self, sample: &Sample<'_>) {
        let _ = sample;
    }

    /// Takes the text of OUTPUT_VARIABLES. Only a console that shows it should format it: the
    /// floats of `core::fmt` have panic paths.
    fn variables(&mut self, dump: &Dump<'_>) {
        let _ = dump;
    }

    /// Reports the emergency stop, once.
    fn emergency(&mut self, report: &Report<'_>) {
        let _ = report;
    }

    /// Reports the end of the program by END, EXIT or emergency stop. Collected output is written
    /// here.
    fn ended(&mut self) {}
}

impl Console for () {}

/// The bars of a graph, each as a share of the full height: −1…1. `Display` writes one character
/// for each bar, as high as the bar is long, whatever its sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bars<'a>(pub &'a [f64]);

const HEIGHTS: [char; 8] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];

impl fmt::Display for Bars<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for share in self.0 {
            let steps = libm::round(libm::fabs(*share).min(1.0) * (HEIGHTS.len() - 1) as f64);
            let height = HEIGHTS.get(steps as usize).unwrap_or(&'▁');
            write!(f, "{height}")?;
        }
        Ok(())
    }
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::Bars;
    use std::string::ToString;

    // clauses: 7.48
    #[test]
    fn a_bar_is_as_high_as_its_share() {
        assert_eq!(Bars(&[0.0, 0.5, -0.5, 1.0, -9.0]).to_string(), "▁▅▅██");
        assert_eq!(Bars(&[0.07, 0.08, f64::NAN]).to_string(), "▁▂█");
        assert_eq!(Bars(&[]).to_string(), "");
    }
}
