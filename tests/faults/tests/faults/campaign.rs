//! Every fault in every place, at cycles throughout one robot's program.

use crate::defect::{Defect, Reading};
use crate::expected::Expected;
use crate::faulty::{Desk, Faulty};
use crate::place::Place;
use crate::trial::{Bench, PATIENCE, trial};
use std::collections::{BTreeMap, BTreeSet};
use tip_runtime::hardware::{Hardware, Outputs};
use tip_runtime::machine::{Machine, Status};
use tip_runtime::model::Model;
use tip_runtime::program::Program;
use tip_runtime::special::Special;

/// Moments between two at which a fault that does not stop the robot at once breaks in: a prime, so that they
/// fall on other steps for each place.
const STRIDE: usize = 5;

/// Place and fault, as the table names them.
pub(crate) type Name = (&'static str, &'static str);

/// Outcomes of the trials of one fault at one place.
#[derive(Default)]
pub(crate) struct Cell {
    pub(crate) trials: usize,
    /// In words, each once.
    pub(crate) outcomes: BTreeSet<String>,
}

/// Observations of one robot.
pub(crate) type Seen = BTreeMap<Name, Cell>;

/// A robot and a healthy run of its program.
pub(crate) struct Campaign<P, H, S, const L: usize, const J: usize> {
    model: &'static Model<L, J>,
    /// At the moments at which faults break in: the number of a cycle, and what was there at its start.
    before: Vec<(usize, Bench<P, H, S, L, J>)>,
    sent: Vec<Outputs<L, J>>,
}

impl<P, H, S, const L: usize, const J: usize> Campaign<P, H, S, L, J>
where
    P: Program + Clone,
    H: Hardware<L, J> + Clone,
    S: Special + Clone,
{
    /// Faults break in at every `pace`-th cycle.
    pub(crate) fn new(
        model: &'static Model<L, J>,
        program: P,
        plant: H,
        special: S,
        pace: usize,
    ) -> Self {
        let robot = Faulty::new(model, plant);
        let machine = Machine::new(program, model, robot).expect("made for this robot");
        let mut machine = machine.with_console(Desk::new()).with_special(special);
        let (mut before, mut sent) = (Vec::new(), Vec::new());
        while machine.status().is_running() && sent.len() < 10 * PATIENCE {
            if sent.len() % pace == 0 {
                before.push((sent.len(), machine.clone()));
            }
            machine.cycle();
            sent.push(*machine.outputs());
        }
        let ended = matches!(machine.status(), Status::Finished(_));
        let at = machine.program().at();
        assert!(
            ended,
            "{} at step {at}: {:?}",
            model.name,
            machine.emergency()
        );
        assert!(!machine.console().log.is_empty(), "rows to fill the buffer");
        Campaign {
            model,
            before,
            sent,
        }
    }

    pub(crate) fn run(self) -> Seen {
        let mut seen = Seen::new();
        for (n, defect) in defects::<L, J>().into_iter().enumerate() {
            let expected = Expected::of(defect, self.model);
            let stride = match expected {
                Expected::GoesOn | Expected::GoesOnWithIt | Expected::StopsWhereRead(_) => STRIDE,
                _ => 1,
            };
            // After the first cycle, so that a sensor has something to be stuck at.
            for (cycle, before) in self.before.iter().skip(1 + n % stride).step_by(stride) {
                let to_be_read = !before.console().inputs_read;
                let outcome = trial(before.clone(), defect, &self.sent[*cycle..]);
                let name = self.model.name;
                assert!(
                    expected.allows(outcome, to_be_read),
                    "{name}, {defect:?} in cycle {cycle}: {outcome:?}, not {expected:?}"
                );
                let cell: &mut Cell = seen.entry(defect.name()).or_default();
                cell.trials += 1;
                cell.outcomes.extend(expected.tell(outcome));
            }
        }
        seen
    }
}

fn defects<const L: usize, const J: usize>() -> Vec<Defect> {
    let mut all = Vec::new();
    for reading in Reading::ALL {
        let beyond = matches!(reading, Reading::JustBeyond(_));
        let places = Place::all::<L, J>().into_iter();
        let places = places.filter(|place| !beyond || matches!(place, Place::Angle(..)));
        all.extend(places.map(|place| Defect::Sensor(place, reading)));
    }
    all.extend(Defect::OTHERS);
    all
}
