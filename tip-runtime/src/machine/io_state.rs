//! What a robot has besides legs, and what steps switch: keys, lamps, flags, logs, bar graphs.

use super::graphs::Graphs;
use super::keyboard::Keyboard;
use super::sampling::Sampling;
use crate::command::{Flag, Port};
use crate::hardware::Inputs;

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

/// Volts from which the antenna counts as touching.
const TOUCH: f64 = 0.5;

impl Board {
    /// Whether a flag is up, unless it is one of the controller.
    pub(super) fn flag(&self, flag: Flag, inputs: &Inputs) -> bool {
        match flag {
            Flag::HaltRequest => self.halt_requested,
            Flag::KbHit => !self.keyboard.is_empty(),
            Flag::Special(n) => {
                let flag = self.special_flags.get(usize::from(n));
                flag.is_some_and(|up| *up)
            }
            Flag::Antenna => inputs
                .get(Port::Antenna)
                .is_some_and(|volts| volts >= TOUCH),
            Flag::Inpos(_) | Flag::Near(_) => false,
        }
    }

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
