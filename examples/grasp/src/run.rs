//! One engine's run on a simulated hand of its own.

use crate::outcome::{LIFT, Outcome};
use tip_runtime::console::Console;
use tip_runtime::machine::{Machine, Mismatch, Status};
use tip_runtime::model::hand;
use tip_runtime::plant::{Scene, SimulatedHand};
use tip_runtime::program::Program;
use tip_runtime::record::{Ending, JsonLines};
use tip_runtime::special::hand::HandSpecials;

/// No grasp takes longer: cycles.
const LIMIT: u64 = 50_000;

/// Runs a program over a scene and shows the hand after each cycle, with the time on the robot (s).
///
/// # Errors
/// The program was checked for another robot.
pub fn run<P: Program, C: Console>(
    program: P,
    scene: &Scene,
    console: C,
    mut show: impl FnMut(f64, &SimulatedHand<3, 3>),
) -> Result<Outcome, Mismatch> {
    let plant = SimulatedHand::new(&hand::MODEL).with_scene(scene);
    let special = HandSpecials::new();
    let mut machine = Machine::new(program, &hand::MODEL, plant, console, special)?;
    let mut trace = JsonLines::new(String::new(), true);
    let (mut time, mut lift, mut held, mut longest) = (0.0, 0.0_f64, 0.0, 0.0_f64);
    let ending = loop {
        let seconds = machine.period() / 1000.0;
        let status = machine.cycle_traced(&mut trace);
        time += seconds;
        show(time, machine.hardware());
        let height = height(machine.hardware());
        lift = lift.max(height);
        held = if height >= LIFT { held + seconds } else { 0.0 };
        longest = longest.max(held);
        match (status, machine.emergency()) {
            (Status::Finished(end), _) => break Ending::Program(end),
            (_, Some(emergency)) => break Ending::Emergency(*emergency),
            _ if machine.cycles() >= LIMIT => break Ending::Limit,
            _ => {}
        }
    };
    trace.end(ending, machine.cycles());
    Ok(Outcome {
        ending,
        seconds: time,
        lift,
        held: longest,
        trace: trace.into_inner(),
    })
}

/// How high the first object is above the floor: mm.
pub fn height(hand: &SimulatedHand<3, 3>) -> f64 {
    let [object, ..] = hand.objects();
    object.map_or(0.0, |object| object.clearance)
}
