//! The parts of a robot besides its legs, which steps switch: keys, lamps, flags, logs, bar graphs.

use super::graphs::Graphs;
use super::keyboard::Keyboard;
use super::threads::Timers;
use super::variables::SpecialVariables;
use crate::command::{Flag, Port};
use crate::controller::ControllerView;
use crate::hardware::Inputs;

#[derive(Clone, Debug)]
pub(super) struct IoState {
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
    /// True if OUTPUT_VARIABLES holds the robot.
    pub(super) held_for_dump: bool,
    /// True if a pause holds the robot.
    pub(super) held_for_pause: bool,
    pub(super) graphs: Graphs,
    pub(super) timers: Timers,
    /// Number of steps in a turn, from the next cycle on (TIP_SPEED_UP).
    pub(super) speed: u8,
    pub(super) variables: SpecialVariables,
}

/// Volts from which the antenna counts as touching.
const TOUCH: f64 = 0.5;

impl IoState {
    /// Returns true if a flag of conditions is up.
    pub(super) fn flag<const J: usize>(
        &self,
        flag: Flag,
        controller: &ControllerView<J>,
        inputs: &Inputs,
    ) -> bool {
        match flag {
            Flag::Inpos(target) => controller.inpos(target),
            Flag::Near(target) => controller.near(target),
            Flag::HaltRequest => self.halt_requested,
            Flag::KbHit => !self.keyboard.is_empty(),
            Flag::Special(n) => {
                let flag = self.special_flags.get(usize::from(n));
                flag.is_some_and(|up| *up)
            }
            Flag::Antenna => inputs
                .get(Port::Antenna)
                .is_some_and(|volts| volts >= TOUCH),
        }
    }

    pub(super) fn new() -> Self {
        IoState {
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
            timers: Timers::HALTED,
            speed: 1,
            variables: SpecialVariables::ZERO,
        }
    }
}

/// The state of LOG_START, LOG_STOP and LOG_ONE_SHOT.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sampling {
    running: bool,
    once: bool,
}

impl Sampling {
    pub(super) const fn start(&mut self) {
        self.running = true;
    }

    pub(super) const fn stop(&mut self) {
        self.running = false;
    }

    pub(super) const fn one_shot(&mut self) {
        self.once = true;
    }

    /// Returns true if this cycle is sampled.
    pub(super) const fn take(&mut self) -> bool {
        let once = self.once;
        self.once = false;
        self.running || once
    }
}
