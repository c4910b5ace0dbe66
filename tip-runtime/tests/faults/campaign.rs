//! Every fault in every place, at cycles throughout one robot's program.

use crate::defect::{Defect, Reading};
use crate::expected::Expected;
use crate::faulty::{Desk, Faulty};
use crate::place::Place;
use crate::script::{Script, Step};
use crate::trial::{Bench, PATIENCE, trial};
use std::collections::{BTreeMap, BTreeSet};
use tip_runtime::hardware::{Hardware, Outputs};
use tip_runtime::machine::{Machine, Status};
use tip_runtime::model::Model;

/// Cycles between two at which a fault that does not stop the robot at once breaks in: a prime, so that the
/// cycles fall on other steps for each place.
const STRIDE: usize = 5;

/// Place and fault, as the table names them.
pub(crate) type Name = (&'static str, &'static str);

/// What became of the trials of one fault at one place.
#[derive(Default)]
pub(crate) struct Cell {
    pub(crate) trials: usize,
    /// In words, each once.
    pub(crate) outcomes: BTreeSet<String>,
}

/// What was seen of one robot.
pub(crate) type Seen = BTreeMap<Name, Cell>;

/// A robot and a healthy run of its program.
pub(crate) struct Campaign<H, const L: usize, const J: usize> {
    model: &'static Model<L, J>,
    /// At the start of each cycle.
    before: Vec<Bench<H, L, J>>,
    sent: Vec<Outputs<L, J>>,
}

impl<H: Hardware<L, J> + Clone, const L: usize, const J: usize> Campaign<H, L, J> {
    pub(crate) fn new(model: &'static Model<L, J>, steps: &'static [Step], plant: H) -> Self {
        let script = Script {
            signature: model.signature(),
            steps,
            at: 0,
        };
        let robot = Faulty::new(model, plant);
        let mut machine =
            Machine::new(script, model, robot, Desk::new(), ()).expect("made for this robot");
        let (mut before, mut sent) = (Vec::new(), Vec::new());
        while machine.status().is_running() && before.len() < 10 * PATIENCE {
            before.push(machine.clone());
            machine.cycle();
            sent.push(*machine.outputs());
        }
        let ended = matches!(machine.status(), Status::Finished(_));
        let at = machine.program().at;
        assert!(
            ended,
            "{} at step {at}: {:?}",
            model.name,
            machine.emergency()
        );
        assert_eq!(machine.console().log.len(), sent.len());
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
            // Behind the first cycle, so that a sensor has something to be stuck at.
            for cycle in (1 + n % stride..self.sent.len()).step_by(stride) {
                let before = self.before[cycle].clone();
                let to_be_read = !before.console().inputs_read;
                let outcome = trial(before, defect, &self.sent[cycle..]);
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
