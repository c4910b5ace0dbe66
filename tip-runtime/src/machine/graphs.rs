//! Bar graphs on the console (SPECIAL 20 of the Hiroshima Hand, T.I.P. 3.1 §8-2-3).

use crate::command::{MAX, Target, Teach};
use crate::console::{Bars, Console};
use crate::controller::ControllerView;
use crate::fault::Fault;
use crate::model::Forces;

/// Time between two drawings of the bars, ms.
const EVERY: f64 = 100.0;

/// One bar for each joint that the language can name.
const MOST: usize = MAX * MAX;

/// A bar graph.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Graph {
    /// It is not shown.
    Off,
    /// It is to be taken away.
    Leaving,
    /// Time at which a shown graph is redrawn, ms.
    On(f64),
}

/// Graph 0 shows the joint torques, graph 1 the forces of the fingertips.
#[derive(Clone, Copy, Debug)]
pub(super) struct Graphs([Graph; 2]);

impl Graphs {
    pub(super) const OFF: Self = Graphs([Graph::Off; 2]);

    pub(super) fn switch(&mut self, graph: u8, on: bool) -> Result<(), Fault> {
        let graph = self.0.get_mut(usize::from(graph)).ok_or(Fault::Domain)?;
        *graph = if on { Graph::On(0.0) } else { Graph::Leaving };
        Ok(())
    }
    /// Hands the graphs that are due at `time` (ms) to the console: of these torques, and of the forces
    /// that the controller senses.
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
                    let mut bars = [0.0; MOST];
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
fn torque_bars<'a>(torques: &[f64], forces: &Forces, bars: &'a mut [f64; MOST]) -> &'a [f64] {
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
    bars: &'a mut [f64; MOST],
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
