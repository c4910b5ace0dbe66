//! The state of a machine in its run.

use super::io_state::IoState;
use super::threads::Threads;
use crate::controller::ControllerView;
use crate::emergency::Emergency;
use crate::fault::Fault;
use crate::program::End;

/// The software emergency stop.
const RETURN_KEY: u8 = 0x0D;
/// The halt request.
const ESCAPE_KEY: u8 = 0x1B;

/// The status of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It runs, or is paused.
    Running,
    /// It ended itself; the servo loop goes on.
    Finished(End),
    /// The robot is in emergency stop.
    Emergency,
}

impl Status {
    /// Returns true if the program has not ended yet.
    pub const fn is_running(self) -> bool {
        matches!(self, Status::Running)
    }
}

#[derive(Clone, Debug)]
pub(super) struct State {
    pub(super) status: Status,
    pub(super) emergency: Option<Emergency>,
    /// A fault after the last step, which the next cycle reports.
    pub(super) pending: Option<Fault>,
    /// Bit n: the last step of thread n waits, so that the next cycle continues it; bit 0 is the main program.
    pub(super) waiting: u8,
    pub(super) threads: Threads,
    /// The thread that has its turn; 0 for the main program, and between turns.
    pub(super) turn: u8,
    pub(super) paused: bool,
    pub(super) stop_requested: bool,
    pub(super) cycles: u64,
    /// Time since the start, ms.
    pub(super) time: f64,
    /// Time at which the sensors were sampled.
    pub(super) sampled_at: f64,
    pub(super) io: IoState,
}

impl State {
    pub(super) fn new() -> Self {
        State {
            status: Status::Running,
            emergency: None,
            pending: None,
            waiting: 0,
            threads: Threads::default(),
            turn: 0,
            paused: false,
            stop_requested: false,
            cycles: 0,
            time: 0.0,
            sampled_at: 0.0,
            io: IoState::new(),
        }
    }

    pub(super) fn key(&mut self, byte: u8) {
        match byte {
            RETURN_KEY => self.stop_requested = true,
            ESCAPE_KEY => self.io.halt_requested = true,
            _ => self.io.keyboard.push(byte),
        }
    }

    pub(super) fn pause<const J: usize>(&mut self, controller: &mut ControllerView<J>) {
        if !self.paused {
            self.paused = true;
            self.io.held_for_pause = controller.take_hold();
        }
    }

    pub(super) fn resume<const J: usize>(&mut self, controller: &mut ControllerView<J>) {
        if self.paused {
            self.paused = false;
            if core::mem::take(&mut self.io.held_for_pause) {
                controller.release();
            }
        }
    }
}
