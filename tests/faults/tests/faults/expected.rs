//! Required reaction to a fault, by the language reference (2.22, 2.23, 2.24, 7.40, 8.1).

use crate::defect::{Defect, Reading};
use crate::place::Place;
use crate::trial::Outcome;
use tip_runtime::command::Port;
use tip_runtime::fault::{Fault, HardwareFault};
use tip_runtime::model::{Family, Model};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Expected {
    /// An emergency stop in the cycle of the fault, before the step runs.
    StopsAtOnce(Fault),
    /// One in the cycle after: phase 3 failed.
    StopsInNextCycle(Fault),
    /// One as soon as the 256 keys of each cycle let the byte through.
    StopsAfterKeys(Fault),
    /// One in a step that reads the input; the program goes on where none does.
    StopsWhereRead(Fault),
    /// END where the program asks next; a script asks in every cycle.
    EndsWhereAsked,
    /// Nothing of it is to be seen in any command.
    GoesOn,
    /// A sensor gives numbers that it could give, or time is not what it seems: the program goes on
    /// with them, to its end, to a wait for what it does not see, or to a fault of its own.
    GoesOnWithIt,
}

impl Expected {
    pub(crate) fn of<const L: usize, const J: usize>(defect: Defect, model: &Model<L, J>) -> Self {
        match defect {
            Defect::Sensor(place, reading) => Self::of_sensor(place, reading, model),
            Defect::ReadError => Expected::StopsAtOnce(Fault::Hardware(HardwareFault::new("bus"))),
            Defect::WriteError => {
                Expected::StopsInNextCycle(Fault::Hardware(HardwareFault::new("bus")))
            }
            Defect::LostCommand | Defect::LateCycles | Defect::Jitter => Expected::GoesOnWithIt,
            Defect::KeyFlood | Defect::LogFull => Expected::GoesOn,
            Defect::ReturnAfterKeys => Expected::StopsAfterKeys(Fault::EmergencyKey),
            Defect::Halt => Expected::EndsWhereAsked,
            Defect::ReturnKey | Defect::HostStop => Expected::StopsAtOnce(Fault::EmergencyKey),
        }
    }

    fn of_sensor<const L: usize, const J: usize>(
        place: Place,
        reading: Reading,
        model: &Model<L, J>,
    ) -> Self {
        let is_number = !matches!(reading, Reading::NotANumber | Reading::Infinite(_));
        let number = |n: usize| u8::try_from(n + 1).expect("nine at most");
        match place {
            Place::Angle(n, m) => match reading {
                Reading::NotANumber | Reading::Infinite(_) => {
                    Expected::StopsAtOnce(Fault::JointSensor(number(n), number(m)))
                }
                Reading::Absurd(_) | Reading::JustBeyond(_) => {
                    Expected::StopsAtOnce(Fault::JointLimit(number(n), number(m)))
                }
                Reading::Stuck => Expected::GoesOnWithIt,
            },
            Place::Torque(..) if model.forces.is_none() => Expected::GoesOn,
            Place::Torque(n, m) if !is_number => {
                Expected::StopsAtOnce(Fault::JointSensor(number(n), number(m)))
            }
            Place::Slider(_) if model.slider.is_none() => Expected::GoesOn,
            Place::Slider(_) if !is_number => Expected::StopsAtOnce(Fault::SliderSensor),
            Place::Input(Port::Paw(_)) if matches!(model.family, Family::Hand) => Expected::GoesOn,
            Place::Input(port) if !is_number => Expected::StopsWhereRead(Fault::Sensor(port)),
            Place::Torque(..) | Place::Slider(_) | Place::Input(_) => Expected::GoesOnWithIt,
        }
    }

    /// `to_be_read`: the fault broke in before the program read its inputs.
    pub(crate) fn allows(self, outcome: Outcome, to_be_read: bool) -> bool {
        use Outcome::{Ends, Stops};
        match (self, outcome) {
            (Expected::StopsAtOnce(wanted), Stops { after, fault }) => {
                (after, fault) == (0, wanted)
            }
            (Expected::StopsInNextCycle(wanted), Stops { after, fault }) => {
                (after, fault) == (1, wanted)
            }
            // The last cycle of a program writes as any other; what fails there stops the robot at rest.
            (Expected::StopsInNextCycle(_), Ends { after, same }) => (after, same) == (0, true),
            (Expected::StopsAfterKeys(wanted), Stops { after, fault }) => {
                (after, fault) == (3, wanted)
            }
            (Expected::StopsAfterKeys(_), Ends { after, same }) => after < 3 && same,
            (Expected::StopsWhereRead(wanted), Stops { fault, .. }) => fault == wanted,
            (Expected::StopsWhereRead(_), Ends { same, .. }) => same && !to_be_read,
            (Expected::GoesOn, Ends { same, .. }) => same,
            (Expected::EndsWhereAsked, Ends { .. }) => true,
            (Expected::GoesOnWithIt, Stops { fault, .. }) => !matches!(
                fault,
                Fault::Hardware(_)
                    | Fault::EmergencyKey
                    | Fault::Sensor(_)
                    | Fault::SliderSensor
                    | Fault::JointSensor(..)
            ),
            (Expected::GoesOnWithIt, _) => true,
            _ => false,
        }
    }

    /// Returns the table's text for an allowed outcome. An END before the fault could show is left out.
    pub(crate) fn tell(self, outcome: Outcome) -> Option<String> {
        let fault = match outcome {
            Outcome::Stops { fault, .. } => format!("`{}`", any_number(&fault.to_string())),
            Outcome::Ends { .. } | Outcome::Waits => String::new(),
        };
        match (self, outcome) {
            (Expected::StopsAtOnce(_), _) => Some(format!("stops at once: {fault}")),
            (Expected::StopsInNextCycle(_), Outcome::Stops { .. }) => {
                Some(format!("stops in the next cycle: {fault}"))
            }
            (Expected::StopsAfterKeys(_), Outcome::Stops { .. }) => {
                Some(format!("stops 3 cycles later, 256 keys a cycle: {fault}"))
            }
            (Expected::StopsInNextCycle(_) | Expected::StopsAfterKeys(_), _) => None,
            (Expected::StopsWhereRead(_), Outcome::Stops { .. }) => {
                Some(format!("stops in a step that reads it: {fault}"))
            }
            (Expected::EndsWhereAsked, Outcome::Ends { after: 0, .. }) => {
                Some("ends at once if the program asks for it".into())
            }
            (Expected::EndsWhereAsked, _) => Some("ends where the program asks for it".into()),
            (_, Outcome::Ends { same: true, .. }) => Some("unaffected".into()),
            (_, Outcome::Ends { same: false, .. }) => Some("ends differently".into()),
            (_, Outcome::Waits) => Some("waits until it is stopped".into()),
            (_, Outcome::Stops { .. }) => Some(format!("stops: {fault}")),
        }
    }
}

/// `J23` as `Jnm`, `PAW1` as `PAWn`.
fn any_number(text: &str) -> String {
    let mut any = String::new();
    for letter in text.chars() {
        any.push(match (letter.is_ascii_digit(), any.ends_with('n')) {
            (true, true) => 'm',
            (true, false) => 'n',
            (false, _) => letter,
        });
    }
    any
}
