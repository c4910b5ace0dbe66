//! The option groups that several commands share: the program with its robot, and the inputs of a run.

use super::choices::{EncodingName, LAST, OutputOptions, count};
use super::error::Error;
use super::setup::{ChosenRobot, PlantChoice, RobotChoice, SceneChoice};
use super::sticks;
use crate::message::Using;
use clap::Args;
use std::path::{Path, PathBuf};
use tip_sim::Robot as Simulated;
use tip_sim::event::{Event, Events, Inputs, Keys, SensorAt};
use tipc::source::Encoding;
use tipc::{Options, Robot};

/// The default robot.
static TITAN: RobotChoice = RobotChoice::Named(Robot::Titan8);

/// The options for reading a program.
#[derive(Clone, Debug, Args)]
pub(super) struct SourceArguments {
    /// The robot; else that of tip.toml, or titan8
    ///
    /// A name that 'tip robot list' shows, a description in a file, or a URDF or MJCF file
    #[arg(long, value_name = "NAME|FILE.toml")]
    pub(super) robot: Option<RobotChoice>,

    /// The version in line 1
    ///
    /// The version of the language that line 1 must name; by default that of any edition, 3.1 or 3.2
    #[arg(long, value_name = "NUMBER", value_parser = version_number, display_order = LAST, hide_short_help = true)]
    pub(super) tip_version: Option<f64>,

    /// The encoding: auto, utf-8 or shift_jis
    ///
    /// auto, the default without tip.toml, is UTF-8 if that is valid, else Shift_JIS
    #[arg(long, value_enum, display_order = LAST)]
    pub(super) encoding: Option<EncodingName>,

    #[command(flatten)]
    pub(super) output_options: OutputOptions,

    /// The `tip.toml` that gives the robot, and that robot.
    #[arg(skip)]
    pub(super) given: Option<(PathBuf, RobotChoice)>,
}

impl SourceArguments {
    /// Returns the chosen robot, or the default one.
    pub(super) fn robot(&self) -> &RobotChoice {
        self.robot.as_ref().unwrap_or(&TITAN)
    }

    /// Loads the chosen robot.
    pub(super) fn load_robot(&self) -> Result<ChosenRobot, Error> {
        let refused = Error::refused(self.output_options);
        self.robot().load().map_err(refused)
    }

    /// Returns the options of the compiler for a robot.
    pub(super) fn options(&self, robot: Robot) -> Options {
        Options {
            robot,
            tip_version: self.tip_version,
            encoding: self.encoding.map_or(Encoding::Auto, EncodingName::encoding),
        }
    }
}

/// Parses a version of the language.
pub(super) fn version_number(text: &str) -> Result<f64, Using> {
    match text.parse() {
        Ok(number) if f64::is_finite(number) && number > 0.0 => Ok(number),
        _ => Err(Using::NotAVersion {
            text: text.to_owned(),
        }),
    }
}

/// The inputs and the length of a simulated run.
#[derive(Debug, Default, Args)]
pub(super) struct InputArguments {
    /// Stop after this many control cycles
    #[arg(long, value_name = "N", value_parser = count, allow_negative_numbers = true)]
    pub(super) cycles: Option<u64>,

    /// Keys pressed before the step of a cycle
    ///
    /// One ASCII character each, or 0x1B form
    #[arg(long, value_name = "CYCLE:CHAR,...")]
    pub(super) keys: Option<Keys>,

    /// Request a halt before the step of this cycle
    #[arg(long, value_name = "CYCLE", value_parser = count, allow_negative_numbers = true)]
    pub(super) halt: Option<u64>,

    /// Set an input to a voltage from a time on
    ///
    /// VR1-3, PAW1-4, ANTENNA, J11 and so on: 'VR1=8@300' from cycle 300 on, 'VR1=8@2s..5s' for three seconds. A stick
    /// (VR1-3) springs back to 5 V, where all three rest before; another input to 0 V
    #[arg(long = "sensor", value_name = "NAME=V@TIME")]
    pub(super) sensors: Vec<SensorAt>,

    /// Keys, values, pushes and halts by cycle
    ///
    /// Before the step of the cycle, such as '10:key F, 300:VR1=8, 500:push 80 0 0 for 5, 900:halt'
    #[arg(long, value_name = "CYCLE:EVENT,...")]
    pub(super) events: Option<Events>,

    /// The scene: cylinder, or a file
    ///
    /// cylinder is an object under a hand
    #[arg(long, value_name = "NAME|FILE.toml")]
    pub(super) scene: Option<SceneChoice>,

    /// The simulation: quasi-static or dynamic
    ///
    /// quasi-static: as if at rest at every moment; dynamic: with mass. 'tip run' also takes exec:COMMAND, a process
    /// of yours that simulates any robot
    #[arg(long, value_name = "PLANT")]
    pub(super) plant: Option<PlantChoice>,
}

impl InputArguments {
    /// Returns the events and the number of cycles, for a robot.
    pub(super) fn inputs(&self, robot: &Simulated) -> Inputs {
        let period = robot.description().standards.period;
        let keys = self.keys.clone().unwrap_or_default().0;
        // Sticks that spring back come from the middle.
        let has_sticks = self.sensors.iter().any(|sensor| sensor.stick().is_some());
        let rest = if has_sticks {
            sticks::at_rest()
        } else {
            vec![]
        };
        let sensors = self.sensors.iter().flat_map(|sensor| sensor.events(period));
        let sensors = rest.into_iter().chain(sensors);
        let halt = self.halt.map(|cycle| Event::Halt.at(cycle));
        let events = self.events.clone().unwrap_or_default();
        let all = keys.into_iter().chain(sensors).chain(halt).chain(events);
        Inputs {
            events: all.collect(),
            cycles: self.cycles,
        }
    }
}

/// A program that runs.
#[derive(Debug, Args)]
pub(super) struct RunArguments {
    /// The program
    pub(super) file: PathBuf,

    #[command(flatten)]
    pub(super) source: SourceArguments,

    #[command(flatten)]
    pub(super) inputs: InputArguments,
}

impl RunArguments {
    /// Returns the first option that was given and that the table of a sweep fixes; `tip.toml` must not have completed the options yet.
    pub(super) fn fixed_by_table(&self) -> Option<&'static str> {
        let RunArguments { source, inputs, .. } = self;
        let given = [
            ("--robot", source.robot.is_some()),
            ("--tip-version", source.tip_version.is_some()),
            ("--encoding", source.encoding.is_some()),
            ("--cycles", inputs.cycles.is_some()),
            ("--keys", inputs.keys.is_some()),
            ("--halt", inputs.halt.is_some()),
            ("--sensor", !inputs.sensors.is_empty()),
            ("--events", inputs.events.is_some()),
            ("--scene", inputs.scene.is_some()),
            ("--plant", inputs.plant.is_some()),
        ];
        let mut given = given.into_iter().filter(|(_, is_given)| *is_given);
        given.next().map(|(option, _)| option)
    }

    /// Returns the files that are read.
    pub(super) fn files(&self) -> Vec<&Path> {
        let scene = self.inputs.scene.as_ref().and_then(SceneChoice::file);
        let files = [Some(self.file.as_path()), self.source.robot().file(), scene];
        files.into_iter().flatten().collect()
    }
}
