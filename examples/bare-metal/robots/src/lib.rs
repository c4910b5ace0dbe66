//! The programs of the examples `walk` and `grasp`, one with threads, and the steered tripod of a PhantomX, on simulated robots, and
//! the traces that every machine must leave alike, bit by bit.
#![no_std]
#![forbid(unsafe_code)]

mod trace;

use core::fmt::Write;
use tip_runtime::hardware::Hardware;
use tip_runtime::machine::{Machine, Mismatch, Status};
use tip_runtime::model::{hand, titan8};
use tip_runtime::plant::{DynamicPlant, Object, Scene, Shape, SimulatedHand, SimulatedPlant};
use tip_runtime::program::Program;
use tip_runtime::special::Special;
use tip_runtime::special::hand::HandSpecials;
use trace::Trace;

tip_macros::include_tip!(pub "../../walk/motions/walk.prg");
tip_macros::include_tip!(pub "motions/threads.prg");
tip_macros::include_tip!(pub "../../grasp/motions/grasp.prg", robot = hand);
tip_macros::include_robot!(pub "phantomx");
tip_macros::include_tip!(pub "../../published/tripod.prg", robot = phantomx);

/// TITAN VIII, its controller and its program.
pub type Walker = Machine<Walk, SimulatedPlant<4, 3>, 4, 3>;

/// The walk with mass.
pub type HeavyWalker = Machine<Walk, DynamicPlant<4, 3>, 4, 3>;

/// TITAN VIII, its controller and a program with two threads.
pub type Threaded = Machine<Threads, SimulatedPlant<4, 3>, 4, 3>;

/// The Hiroshima Hand, its controller and its program.
pub type Hand = Machine<Grasp, SimulatedHand<3, 3>, 3, 3, (), HandSpecials>;

/// PhantomX, its controller and a gait that keys steer.
pub type Hexapod = Machine<Tripod, SimulatedPlant<6, 3>, 6, 3>;

// Functions of their own, so that the plant and the program that they move leave the stack before the motion begins.

/// Returns TITAN VIII before its first control cycle.
///
/// # Errors
/// Never: the program was compiled for this robot.
#[inline(never)]
pub fn walker() -> Result<Walker, Mismatch> {
    let plant = SimulatedPlant::new(&titan8::MODEL);
    Machine::new(Walk::new(), &titan8::MODEL, plant)
}

/// Returns TITAN VIII with mass before its first control cycle.
///
/// # Errors
/// Never: the program was compiled for this robot.
#[inline(never)]
pub fn heavy_walker() -> Result<HeavyWalker, Mismatch> {
    let plant = DynamicPlant::new(&titan8::MODEL);
    Machine::new(Walk::new(), &titan8::MODEL, plant)
}

/// Returns TITAN VIII with threads before its first control cycle.
///
/// # Errors
/// Never: the program was compiled for this robot.
#[inline(never)]
pub fn threaded() -> Result<Threaded, Mismatch> {
    let plant = SimulatedPlant::new(&titan8::MODEL);
    Machine::new(Threads::new(), &titan8::MODEL, plant)
}

/// Returns the hand before its first control cycle, above an upright cylinder as that of the example `grasp`.
///
/// # Errors
/// Never: the program was compiled for this robot.
#[inline(never)]
pub fn hand() -> Result<Hand, Mismatch> {
    let (width, height) = (100.0, 60.0);
    let cylinder = Object {
        shape: Shape::Box { width, height },
        mass: 0.2,
        friction: 0.8,
        x: 0.0,
        y: None,
        angle: 0.0,
    };
    let scene = Scene {
        objects: [Some(cylinder), None, None, None],
        ..Scene::EMPTY
    };
    let plant = SimulatedHand::new(&hand::MODEL).with_scene(&scene);
    let machine = Machine::new(Grasp::new(), &hand::MODEL, plant)?;
    Ok(machine.with_special(HandSpecials::new()))
}

/// Returns PhantomX before its first control cycle.
///
/// # Errors
/// Never: the program was compiled for this robot.
#[inline(never)]
pub fn hexapod() -> Result<Hexapod, Mismatch> {
    let plant = SimulatedPlant::new(&PHANTOMX);
    Machine::new(Tripod::new(), &PHANTOMX, plant)
}

/// Cycles of the walk with mass on slow machines: it stands up and swings its first legs.
const SLICE: u64 = 250;

/// Number of traced cycles of a gait, in which it begins to walk. Each cycle has more than seventy steps.
const BEGINNING: u64 = 60;

/// Runs the first cycles of a gait as [`begin`] does, after the key W, which makes it walk ahead.
pub fn steer<P: Program, H: Hardware<L, J>, S: Special, const L: usize, const J: usize>(
    robot: &mut Machine<P, H, L, J, (), S>,
    out: &mut impl Write,
) -> bool {
    robot.key(b'W');
    begin_for(BEGINNING, robot, out)
}

/// Runs the first cycles of a program and writes one line of the trace for each step. Returns true if the program has not ended and all
/// of the trace was written.
pub fn begin<P: Program, H: Hardware<L, J>, S: Special, const L: usize, const J: usize>(
    robot: &mut Machine<P, H, L, J, (), S>,
    out: &mut impl Write,
) -> bool {
    begin_for(SLICE, robot, out)
}

fn begin_for<P: Program, H: Hardware<L, J>, S: Special, const L: usize, const J: usize>(
    cycles: u64,
    robot: &mut Machine<P, H, L, J, (), S>,
    out: &mut impl Write,
) -> bool {
    let mut trace = Trace::new(out);
    let runs = (0..cycles).all(|_| robot.cycle_traced(&mut trace).is_running());
    runs && trace.is_complete()
}

/// Runs a program to its end, with a line in the trace for each control cycle. Whether it ended
/// itself, and all of the trace was written.
pub fn run<P: Program, H: Hardware<L, J>, S: Special, const L: usize, const J: usize>(
    robot: &mut Machine<P, H, L, J, (), S>,
    out: &mut impl Write,
) -> bool {
    let mut trace = Trace::new(out);
    let status = loop {
        let status = robot.cycle_traced(&mut trace);
        if !status.is_running() {
            break status;
        }
    };
    matches!(status, Status::Finished(_)) && trace.is_complete()
}
