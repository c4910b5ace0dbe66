//! Programs that are lists of commands, on simulated robots.

use crate::list::{self, List};
use tip_runtime::machine::Machine;
use tip_runtime::model::{Model, hand, titan8};
use tip_runtime::plant::{Scene, SimulatedHand, SimulatedPlant};
use tip_runtime::program::Program;
use tip_runtime::special::hand::HandSpecials;

pub(crate) static MODEL: Model<4, 3> = titan8::MODEL;

pub(crate) type Step = list::Step<&'static [f64]>;

pub(crate) type Bench = Machine<List<&'static [f64]>, SimulatedPlant<4, 3>, 4, 3>;

pub(crate) fn bench(steps: &'static [Step]) -> Bench {
    let plant = SimulatedPlant::new(&MODEL);
    let program = List::new(steps.to_vec(), MODEL.signature());
    Machine::new(program, &MODEL, plant).expect("made for this robot")
}

pub(crate) type HandBench =
    Machine<List<&'static [f64]>, SimulatedHand<3, 3>, 3, 3, (), HandSpecials>;

/// Returns the hand with its native commands and an object to grasp.
pub(crate) fn hand_bench(steps: &'static [Step]) -> HandBench {
    let plant = SimulatedHand::new(&hand::MODEL).with_scene(&Scene::CYLINDER);
    let program = List::new(steps.to_vec(), hand::MODEL.signature());
    let machine = Machine::new(program, &hand::MODEL, plant).expect("made for the hand");
    machine.with_special(HandSpecials::new())
}

/// Runs to the end, which must come in time and without an emergency.
pub(crate) fn run(steps: &'static [Step]) -> Bench {
    let mut machine = bench(steps);
    for _ in 0..5000 {
        if !machine.cycle().is_running() {
            assert_eq!(machine.emergency(), None);
            return machine;
        }
    }
    panic!("still at step {}", machine.program().at());
}
