//! The runs that are measured: each is a machine that is ready to start.

use crate::replay::Replay;
use grasp::{Grasp, SCENE};
use six_legs::{HEXAPOD, Tripod};
use tip_runtime::console::Console;
use tip_runtime::hardware::Hardware;
use tip_runtime::machine::{Machine, Mismatch};
use tip_runtime::model::{hand, titan8};
use tip_runtime::plant::{DynamicPlant, SimulatedHand, SimulatedPlant};
use tip_runtime::program::Program;
use tip_runtime::special::Special;
use tip_runtime::special::hand::HandSpecials;
use walk::Walk;

/// A machine, whatever robot it has.
pub trait Run {
    /// Runs one control cycle; whether the program goes on.
    fn cycle(&mut self) -> bool;

    /// The sampling time: ms.
    fn period(&self) -> f64;
}

impl<P, H, const L: usize, const J: usize, C, S> Run for Machine<P, H, L, J, C, S>
where
    P: Program,
    H: Hardware<L, J>,
    C: Console,
    S: Special,
{
    fn cycle(&mut self) -> bool {
        Machine::cycle(self).is_running()
    }

    fn period(&self) -> f64 {
        Machine::period(self)
    }
}

/// Runs to the end of the program; how many cycles that took. Callgrind counts what happens in here.
#[inline(never)]
pub fn finish(run: &mut (impl Run + ?Sized)) -> u64 {
    let mut cycles = 1;
    while run.cycle() {
        cycles += 1;
    }
    cycles
}

/// Runs it without counting.
fn record(mut run: impl Run) {
    while run.cycle() {}
}

/// TITAN VIII walks (`examples/walk`).
pub fn walk() -> impl Run + Clone {
    walking(SimulatedPlant::new(&titan8::MODEL))
}

/// Runs it with mass.
pub fn heavy_walk() -> impl Run + Clone {
    walking(DynamicPlant::new(&titan8::MODEL))
}

/// Runs it without the simulated robot: the controller reads recorded measurements.
pub fn walk_replayed() -> impl Run + Clone {
    let plant = SimulatedPlant::new(&titan8::MODEL);
    walking(Replay::of(plant, |recorder| record(walking(recorder))))
}

fn walking<H: Hardware<4, 3>>(hardware: H) -> Machine<Walk, H, 4, 3> {
    checked(Machine::new(Walk::new(), &titan8::MODEL, hardware))
}

/// A hexapod walks (`examples/six-legs`).
pub fn six_legs() -> impl Run + Clone {
    tripod(SimulatedPlant::new(&HEXAPOD))
}

/// Runs it with mass.
pub fn heavy_six_legs() -> impl Run + Clone {
    tripod(DynamicPlant::new(&HEXAPOD))
}

/// Runs it without the simulated robot.
pub fn six_legs_replayed() -> impl Run + Clone {
    let plant = SimulatedPlant::new(&HEXAPOD);
    tripod(Replay::of(plant, |recorder| record(tripod(recorder))))
}

fn tripod<H: Hardware<6, 3>>(hardware: H) -> Machine<Tripod, H, 6, 3> {
    checked(Machine::new(Tripod::new(), &HEXAPOD, hardware))
}

/// Hiroshima Hand grasps (`examples/grasp`).
pub fn grasp() -> impl Run + Clone {
    grasping(SimulatedHand::new(&hand::MODEL).with_scene(&SCENE))
}

/// Runs it without the simulated robot.
pub fn grasp_replayed() -> impl Run + Clone {
    let plant = SimulatedHand::new(&hand::MODEL).with_scene(&SCENE);
    grasping(Replay::of(plant, |recorder| record(grasping(recorder))))
}

fn grasping<H: Hardware<3, 3>>(hardware: H) -> Machine<Grasp, H, 3, 3, (), HandSpecials> {
    checked(Machine::new(Grasp::new(), &hand::MODEL, hardware)).with_special(HandSpecials::new())
}

fn checked<M>(machine: Result<M, Mismatch>) -> M {
    machine.expect("the example's program was compiled for this robot")
}
