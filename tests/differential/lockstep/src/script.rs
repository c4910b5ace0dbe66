//! Inputs of a program while it runs.

use random_programs::pick;
use tip_runtime::command::Port;
use tip_runtime::model::Family;
use tip_runtime::random::Random;
use tip_sim::{Event, Inputs, Plant};
use tipc::Robot;

/// A run's surroundings.
#[derive(Clone, Debug, PartialEq)]
pub struct Script {
    /// Plant that simulates the robot.
    pub plant: Plant,
    /// Events, and the maximum number of cycles.
    pub inputs: Inputs,
}

const RETURN: u8 = 0x0D;

impl Script {
    /// The surroundings of run `number` of the program of a seed: keys, sensors and touches all the time; in most runs
    /// a halt request towards the end; now and then a failing input, failing hardware or the emergency key.
    pub fn random(robot: Robot, seed: u64, number: u64, limit: u64, plant: Plant) -> Self {
        let mut random = Random::new(seed.rotate_left(32) ^ number);
        let mut events = Vec::new();
        let mut cycle = 0;
        let mut touching = false;
        while cycle < limit {
            cycle += 1 + random.below(40);
            let event = match random.below(4) {
                0 => {
                    touching = !touching;
                    Event::Touch(touching)
                }
                1 => Event::Sensor(port(&mut random, robot), random.below(11) as f64 / 2.0),
                _ => Event::Key(pick(&mut random, b"abcxyz0189 ")),
            };
            events.push(event.at(cycle));
        }
        if random.below(4) > 0 {
            let cycle = limit / 2 + random.below(limit / 2 + 1);
            events.push(Event::Halt.at(cycle));
        }
        if random.once_in(10) {
            let unread = port(&mut random.clone(), robot);
            let disaster = pick(
                &mut random,
                &[
                    Event::Key(RETURN),
                    Event::ReadFails,
                    Event::WriteFails,
                    Event::Sensor(unread, f64::NAN),
                ],
            );
            events.push(disaster.at(random.below(limit)));
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

fn port(random: &mut Random, robot: Robot) -> Port {
    let signature = robot.signature();
    match signature.family {
        Family::Titan if random.once_in(2) => Port::Paw(1 + random.below(4) as u8),
        Family::Titan | Family::Hand if random.once_in(2) => Port::Antenna,
        _ => Port::Knob(1 + random.below(3) as u8),
    }
}
