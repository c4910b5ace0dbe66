//! A run on the simulated robot, written down.

use crate::engine::Boxed;
use crate::events::Events;
use tip_runtime::console::Scripted;
use tip_runtime::machine::{Machine, Status};
use tip_runtime::model::{Model, generic, hand, titan8};
use tip_runtime::plant::{Plant, Scene, SimulatedHand, SimulatedPlant};
use tip_runtime::program::Program;
use tip_runtime::record::{Ending, JsonLines};
use tip_runtime::special::Special;
use tip_runtime::special::hand::HandSpecials;

/// No case needs more cycles; one that has not ended by then never will.
const ENDLESS: u64 = 100_000;

/// The robots that programs run on: those with a name, and described ones of the sizes that the cases have, since each
/// size is compiled for itself.
#[derive(Clone, Debug)]
pub enum Robot {
    /// TITAN VIII.
    Titan8,
    /// The generic robot without a description.
    Generic,
    /// The Hiroshima Hand, and what stands around it.
    Hand(Box<Scene>),
    /// One leg of one joint.
    OneJoint(Box<Model<1, 1>>),
    /// Six legs of three joints.
    Hexapod(Box<Model<6, 3>>),
    /// Nine legs of nine joints.
    Largest(Box<Model<9, 9>>),
}

/// The trace of a run, with the state in each record.
///
/// # Errors
/// The program is for another robot, an input has no such name, or the program never ends.
pub fn run(program: Box<dyn Program>, robot: &Robot, events: &Events) -> Result<String, String> {
    match robot {
        Robot::Titan8 => walk(program, &titan8::MODEL, events),
        Robot::Generic => walk(program, &generic::MODEL, events),
        Robot::Hand(scene) => {
            let plant = SimulatedHand::new(&hand::MODEL).with_scene(scene);
            run_on(program, &hand::MODEL, plant, HandSpecials::new(), events)
        }
        Robot::OneJoint(model) => walk(program, model, events),
        Robot::Hexapod(model) => walk(program, model, events),
        Robot::Largest(model) => walk(program, model, events),
    }
}

fn walk<const L: usize, const J: usize>(
    program: Box<dyn Program>,
    model: &Model<L, J>,
    events: &Events,
) -> Result<String, String> {
    run_on(program, model, SimulatedPlant::new(model), (), events)
}

fn run_on<const L: usize, const J: usize>(
    program: Box<dyn Program>,
    model: &Model<L, J>,
    plant: impl Plant<L, J>,
    special: impl Special,
    events: &Events,
) -> Result<String, String> {
    let keys = Scripted::new(events.keys.clone());
    let console = match events.halt {
        Some(cycle) => keys.halt(cycle),
        None => keys,
    };
    let mut machine = Machine::new(Boxed(program), model, plant, console, special)
        .map_err(|mismatch| mismatch.to_string())?;
    let mut trace = JsonLines::new(String::new(), true);
    let ending = loop {
        let cycle = machine.cycles();
        if events.cycles == Some(cycle) {
            break Ending::Limit;
        }
        if cycle == ENDLESS {
            return Err(format!("it runs for more than {ENDLESS} cycles"));
        }
        for (name, volts, _) in events.sensors.iter().filter(|(_, _, from)| *from == cycle) {
            let port = name
                .parse()
                .map_err(|_| format!("no input is called {name}"))?;
            if !machine.hardware_mut().set_sensor(port, *volts) {
                return Err(format!("the robot has no input {name}"));
            }
        }
        match machine.cycle_traced(&mut trace) {
            Status::Running => {}
            Status::Finished(end) => break Ending::Program(end),
            Status::Emergency => {
                let emergency = machine.emergency().copied();
                break Ending::Emergency(emergency.ok_or("an emergency without a report")?);
            }
        }
    };
    trace.end(ending, machine.cycles());
    trace.result().map_err(|error| error.to_string())?;
    Ok(trace.into_inner())
}
