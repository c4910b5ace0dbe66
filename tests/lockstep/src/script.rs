//! What happens around a program while it runs.

use random_programs::Dice;
use tip_runtime::command::Port;
use tip_runtime::model::Family;
use tipc::Robot;

/// The hardware of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scenery {
    /// Joints that are at once where they are told to be.
    Echo,
    /// The simulated robot.
    Simulated,
}

/// What happens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Happening {
    /// A byte is typed.
    Key(u8),
    /// An input reads so many volts from now on.
    Sensor(Port, f64),
    /// Every foot or finger begins to feel something, or ceases to.
    Touch(bool),
    /// The hardware fails to read.
    ReadFails,
    /// The hardware fails to write.
    WriteFails,
}

/// Something happens before the step of a cycle.
pub type Event = (u64, Happening);

/// A run's surroundings.
#[derive(Clone, Debug, PartialEq)]
pub struct Script {
    /// The most cycles.
    pub limit: u64,
    /// The hardware.
    pub scenery: Scenery,
    /// In order of their cycles.
    pub events: Vec<Event>,
}

const ESCAPE: u8 = 0x1B;
const RETURN: u8 = 0x0D;

impl Script {
    /// The surroundings of run `number` of the program of a seed: keys, sensors and touches all the time; in most runs
    /// a halt request towards the end; now and then a failing input, failing hardware or the emergency key.
    pub fn random(robot: Robot, seed: u64, number: u64, limit: u64, scenery: Scenery) -> Self {
        let mut dice = Dice::new(seed.rotate_left(32) ^ number);
        let mut events = Vec::new();
        let mut cycle = 0;
        let mut touching = false;
        while cycle < limit {
            cycle += 1 + dice.below(40);
            let happening = match dice.below(4) {
                0 => {
                    touching = !touching;
                    Happening::Touch(touching)
                }
                1 => Happening::Sensor(port(&mut dice, robot), dice.below(11) as f64 / 2.0),
                _ => Happening::Key(dice.pick(b"abcxyz0189 ")),
            };
            events.push((cycle, happening));
        }
        if dice.below(4) > 0 {
            events.push((
                limit / 2 + dice.below(limit / 2 + 1),
                Happening::Key(ESCAPE),
            ));
        }
        if dice.once_in(10) {
            let disaster = dice.pick(&[
                Happening::Key(RETURN),
                Happening::ReadFails,
                Happening::WriteFails,
                Happening::Sensor(port(&mut dice.clone(), robot), f64::NAN),
            ]);
            events.push((dice.below(limit), disaster));
        }
        events.sort_by_key(|(cycle, _)| *cycle);
        Script {
            limit,
            scenery,
            events,
        }
    }
}

fn port(dice: &mut Dice, robot: Robot) -> Port {
    let signature = robot.signature();
    match signature.family {
        Family::Titan if dice.once_in(2) => Port::Paw(1 + dice.below(4) as u8),
        Family::Titan | Family::Hand if dice.once_in(2) => Port::Antenna,
        _ => Port::Knob(1 + dice.below(3) as u8),
    }
}
