//! What happens around a program while it runs.

use random_programs::Dice;
use tip_runtime::command::Port;
use tip_runtime::model::Family;
use tip_sim::{Event, Inputs, Plant};
use tipc::Robot;

/// A run's surroundings.
#[derive(Clone, Debug, PartialEq)]
pub struct Script {
    /// How the robot is simulated.
    pub plant: Plant,
    /// What happens, and the most cycles.
    pub inputs: Inputs,
}

const RETURN: u8 = 0x0D;

impl Script {
    /// The surroundings of run `number` of the program of a seed: keys, sensors and touches all the time; in most runs
    /// a halt request towards the end; now and then a failing input, failing hardware or the emergency key.
    pub fn random(robot: Robot, seed: u64, number: u64, limit: u64, plant: Plant) -> Self {
        let mut dice = Dice::new(seed.rotate_left(32) ^ number);
        let mut events = Vec::new();
        let mut cycle = 0;
        let mut touching = false;
        while cycle < limit {
            cycle += 1 + dice.below(40);
            let event = match dice.below(4) {
                0 => {
                    touching = !touching;
                    Event::Touch(touching)
                }
                1 => Event::Sensor(port(&mut dice, robot), dice.below(11) as f64 / 2.0),
                _ => Event::Key(dice.pick(b"abcxyz0189 ")),
            };
            events.push(event.at(cycle));
        }
        if dice.below(4) > 0 {
            let cycle = limit / 2 + dice.below(limit / 2 + 1);
            events.push(Event::Halt.at(cycle));
        }
        if dice.once_in(10) {
            let disaster = dice.pick(&[
                Event::Key(RETURN),
                Event::ReadFails,
                Event::WriteFails,
                Event::Sensor(port(&mut dice.clone(), robot), f64::NAN),
            ]);
            events.push(disaster.at(dice.below(limit)));
        }
        Script {
            plant,
            inputs: Inputs {
                events: events.into(),
                cycles: Some(limit),
            },
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
