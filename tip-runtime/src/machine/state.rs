//! The state of a machine besides its legs: run, keys, lamps, flags, logs, and bar graphs (SPECIAL 20 of the Hiroshima
//! Hand, T.I.P. 3.1 §8-2-3).

use super::threads::{Threads, Timers};
use super::variables::SpecialVariables;
use crate::command::{Flag, MAX, Port, Target, Teach};
use crate::console::{Bars, Console};
use crate::controller::ControllerView;
use crate::emergency::Emergency;
use crate::fault::Fault;
use crate::hardware::Inputs;
use crate::model::Forces;
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
    /// It has ended. The servo loop goes on.
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
            _ => {
                self.io.key.get_or_insert(byte);
            }
        }
    }
}

#[derive(Clone, Debug)]
pub(super) struct IoState {
    /// The oldest key since the last KEY_IN. KEY_IN empties the keyboard buffer, so later keys are not stored.
    pub(super) key: Option<u8>,
    pub(super) halt_requested: bool,
    pub(super) special_flags: [bool; 10],
    /// Lamps and relays: bit n % 32 of word n / 32 is device n.
    pub(super) lamps: [u32; 8],
    /// True if each cycle is sampled (LOG_START).
    pub(super) samples: bool,
    /// True if this cycle is sampled (LOG_ONE_SHOT).
    pub(super) samples_once: bool,
    /// `Some` if SILENT_ON (true) or SILENT_OFF (false) ran in this cycle.
    pub(super) silence: Option<bool>,
    /// True if OUTPUT_VARIABLES ran in this cycle.
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
    /// Returns the state of an event flag.
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
            Flag::KbHit => self.key.is_some(),
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
            key: None,
            halt_requested: false,
            special_flags: [false; 10],
            lamps: [0; 8],
            samples: false,
            samples_once: false,
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

/// Time between two drawings of the bars, ms.
const EVERY: f64 = 100.0;

/// One bar for each joint that the language can name.
const MAX_BARS: usize = MAX * MAX;

/// A bar graph.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Graph {
    /// The graph is not shown.
    Off,
    /// It is removed at the next drawing.
    Leaving,
    /// Time at which a shown graph is redrawn, ms.
    On(f64),
}

/// Graph 0 shows the joint torques, graph 1 the forces of the fingertips.
#[derive(Clone, Copy, Debug)]
pub(super) struct Graphs([Graph; 2]);

impl Graphs {
    const OFF: Self = Graphs([Graph::Off; 2]);

    pub(super) fn switch(&mut self, graph: u8, on: bool) -> Result<(), Fault> {
        let graph = self.0.get_mut(usize::from(graph)).ok_or(Fault::Domain)?;
        *graph = if on { Graph::On(0.0) } else { Graph::Leaving };
        Ok(())
    }
    /// Passes the graphs that are due at `time` (ms) to the console: of these torques, and of the forces that the
    /// controller senses.
    pub(super) fn show<const J: usize>(
        &mut self,
        time: f64,
        torques: &[[f64; J]],
        controller: &ControllerView<J>,
        console: &mut dyn Console,
    ) {
        let Some(forces) = &controller.robot().forces else {
            return;
        };
        for (number, graph) in (0..).zip(&mut self.0) {
            *graph = match *graph {
                Graph::Leaving => {
                    console.bars(number, Bars(&[]));
                    Graph::Off
                }
                Graph::On(due) if time >= due => {
                    let mut bars = [0.0; MAX_BARS];
                    let bars = match number {
                        0 => torque_bars(torques.as_flattened(), forces, &mut bars),
                        _ => force_bars(controller, forces, &mut bars),
                    };
                    console.bars(number, Bars(bars));
                    Graph::On(time + EVERY)
                }
                Graph::Off | Graph::On(_) => continue,
            };
        }
    }
}

/// Fills bars with torques; full height is twice the torque of a search.
fn torque_bars<'a>(torques: &[f64], forces: &Forces, bars: &'a mut [f64; MAX_BARS]) -> &'a [f64] {
    let full = 2.0 * forces.search_torque;
    for (bar, torque) in bars.iter_mut().zip(torques) {
        *bar = torque / full;
    }
    bars.get(..torques.len()).unwrap_or(bars)
}

/// Fills bars with forces; full height is four times the force of a search, and a force that is not
/// available has no height.
fn force_bars<'a, const J: usize>(
    controller: &ControllerView<J>,
    forces: &Forces,
    bars: &'a mut [f64; MAX_BARS],
) -> &'a [f64] {
    let full = 4.0 * forces.search_force;
    let legs = controller.count();
    for (n, bar) in (1..=legs).zip(bars.iter_mut()) {
        if let Ok([x, y, z, ..]) = controller.teach(Teach::Force, Target::Foot(n))
            && z >= 0.0
        {
            *bar = libm::sqrt(x * x + y * y) / full;
        }
    }
    bars.get(..usize::from(legs)).unwrap_or(bars)
}
