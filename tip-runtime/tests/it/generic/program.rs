//! Programs that are lists of commands, on the simulated robot.

use crate::list::{self, List};
use tip_runtime::fault::Fault;
use tip_runtime::machine::Machine;
use tip_runtime::model::Model;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::Program;

pub(crate) type Step = list::Step<Vec<f64>>;

pub(crate) type Bench<const L: usize, const J: usize> =
    Machine<List<Vec<f64>>, SimulatedPlant<L, J>, L, J>;

pub(crate) fn bench<const L: usize, const J: usize>(
    model: &Model<L, J>,
    steps: Vec<Step>,
) -> Bench<L, J> {
    let plant = SimulatedPlant::new(model);
    let program = List::new(steps, model.signature());
    Machine::new(program, model, plant).expect("made for this robot")
}

/// Runs to the end, or to the emergency that is reported.
pub(crate) fn run<const L: usize, const J: usize>(
    model: &Model<L, J>,
    steps: Vec<Step>,
) -> (Bench<L, J>, Option<Fault>) {
    let mut machine = bench(model, steps);
    for _ in 0..3000 {
        if !machine.cycle().is_running() {
            let fault = machine.emergency().map(|emergency| emergency.fault);
            return (machine, fault);
        }
    }
    let at = machine.program().at();
    panic!("{} is still at step {at}", model.name);
}
