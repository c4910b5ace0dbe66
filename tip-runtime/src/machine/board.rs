//! What a robot has besides legs, and what steps switch: keys, lamps, flags, logs, bar graphs.

use super::graphs::Graphs;
use super::keyboard::Keyboard;
use super::sampling::Sampling;

#[derive(Clone, Debug)]
pub(super) struct Board {
    pub(super) keyboard: Keyboard,
    pub(super) halt_requested: bool,
    pub(super) special_flags: [bool; 10],
    /// Lamps and relays: bit n % 32 of word n / 32 is device n.
    pub(super) lamps: [u32; 8],
    pub(super) sampling: Sampling,
    /// SILENT_ON or SILENT_OFF ran in this cycle.
    pub(super) silence: Option<bool>,
    /// OUTPUT_VARIABLES ran in this cycle.
    pub(super) dump_requested: bool,
    /// Whether OUTPUT_VARIABLES is what holds the robot.
    pub(super) held_for_dump: bool,
    /// Whether a pause is what holds the robot.
    pub(super) held_for_pause: bool,
    pub(super) graphs: Graphs,
}

impl Board {
    pub(super) fn new() -> Self {
        Board {
            keyboard: Keyboard::new(),
            halt_requested: false,
            special_flags: [false; 10],
            lamps: [0; 8],
            sampling: Sampling::default(),
            silence: None,
            dump_requested: false,
            held_for_dump: false,
            held_for_pause: false,
            graphs: Graphs::OFF,
        }
    }
}
