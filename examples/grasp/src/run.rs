//! One engine's run on a simulated hand of its own.

use crate::outcome::{LIFT, Outcome};
use std::error::Error;
use tip_runtime::console::Console;
use tip_runtime::plant::{Scene, SimulatedHand};
use tip_runtime::program::Program;
use tip_sim::{Limit, Observer, Robot, Run};

/// No grasp takes longer.
const LIMIT: Limit = Limit::cycles(50_000);

/// Runs a program over a scene and shows the hand after each cycle, with the time on the robot (s).
///
/// # Errors
/// The program was checked for another robot.
pub fn run(
    program: impl Program + Clone + Send + 'static,
    scene: &Scene,
    console: impl Console + Send + 'static,
    show: impl FnMut(f64, &SimulatedHand<3, 3>),
) -> Result<Outcome, Box<dyn Error>> {
    let robot = Robot::named("hand")?.with_scene(scene)?;
    let mut run = Run::new(program, robot)?
        .with_console(console)
        .with_trace(true);
    let mut watch = Watch {
        show,
        lift: 0.0,
        held: 0.0,
        longest: 0.0,
    };
    let ending = run.observed(LIMIT, &mut watch);
    Ok(Outcome {
        ending,
        seconds: run.time() / 1000.0,
        lift: watch.lift,
        held: watch.longest,
        trace: run.trace(),
    })
}

/// Measures how the first object is lifted.
struct Watch<F> {
    show: F,
    /// The highest so far: mm.
    lift: f64,
    /// How long it has been high enough: s.
    held: f64,
    /// The longest of these times: s.
    longest: f64,
}

impl<F: FnMut(f64, &SimulatedHand<3, 3>)> Observer for Watch<F> {
    fn after(&mut self, run: &mut Run) {
        let Some(hand) = run.plant() else {
            return;
        };
        (self.show)(run.time() / 1000.0, hand);
        let height = height(hand);
        let seconds = run.period() / 1000.0;
        self.lift = self.lift.max(height);
        self.held = if height >= LIFT {
            self.held + seconds
        } else {
            0.0
        };
        self.longest = self.longest.max(self.held);
    }
}

/// How high the first object is above the floor: mm.
pub fn height(hand: &SimulatedHand<3, 3>) -> f64 {
    let [object, ..] = hand.objects();
    object.map_or(0.0, |object| object.clearance)
}
