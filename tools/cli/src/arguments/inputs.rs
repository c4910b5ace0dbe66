//! The options of a run, which `tipc run` and `tipc verify` share.

use super::super::plant::PlantChoice;
use super::super::scene::SceneChoice;
use super::super::usage::count;
use clap::Args;
use tip_sim::event::{Event, Events, Inputs, Keys, SensorAt};

/// What happens around a simulated robot, and how long it runs.
#[derive(Debug, Default, Args)]
pub(crate) struct InputArguments {
    /// Stop after this many control cycles
    #[arg(long, value_name = "N", value_parser = count, allow_negative_numbers = true)]
    cycles: Option<u64>,

    /// Keys that are pressed before the step of a cycle: one ASCII character each, or 0x1B form
    #[arg(long, value_name = "CYCLE:CHAR,...")]
    keys: Option<Keys>,

    /// Request a halt before the step of this cycle
    #[arg(long, value_name = "CYCLE", value_parser = count, allow_negative_numbers = true)]
    halt: Option<u64>,

    /// Make an input read this voltage from a cycle on: VR1-3, PAW1-4, ANTENNA, J11 and so on
    #[arg(long = "sensor", value_name = "NAME=VALUE@CYCLE")]
    sensors: Vec<SensorAt>,

    /// Events before the step of a cycle, such as '10:key F, 300:VR1=8, 500:push 80 0 0 for 5, 900:halt'
    #[arg(long, value_name = "CYCLE:EVENT,...")]
    events: Option<Events>,

    /// What surrounds the robot: cylinder, an object under a hand, or a scene of your own
    #[arg(long, value_name = "NAME|FILE.toml")]
    pub(crate) scene: Option<SceneChoice>,

    /// How a walking robot is simulated: quasi-static, at rest wherever it is, or dynamic, with mass; for 'tipc run' also exec:COMMAND,
    /// a process of yours that simulates any robot
    #[arg(long, value_name = "PLANT")]
    pub(crate) plant: Option<PlantChoice>,
}

impl InputArguments {
    /// The arguments of a client that has no command line.
    pub(crate) fn of_client(
        events: Option<Events>,
        scene: Option<SceneChoice>,
        plant: Option<PlantChoice>,
    ) -> Self {
        InputArguments {
            events,
            scene,
            plant,
            ..InputArguments::default()
        }
    }

    /// What happens to the run.
    pub(crate) fn inputs(&self) -> Inputs {
        let keys = self.keys.clone().unwrap_or_default().0;
        let sensors = self.sensors.iter().map(|sensor| sensor.0.clone());
        let halt = self.halt.map(|cycle| Event::Halt.at(cycle));
        let events = self.events.clone().unwrap_or_default();
        let all = keys.into_iter().chain(sensors).chain(halt).chain(events);
        Inputs {
            events: all.collect(),
            cycles: self.cycles,
        }
    }
}
