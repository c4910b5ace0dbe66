//! Settings of a case: the options of the command line, in a case's header.
#![expect(
    clippy::disallowed_methods,
    reason = "a case may stand beside the description of its robot"
)]

use std::fmt::{Display, Write as _};
use std::fs;
use std::path::Path;
use tipc::description::{self, Description};
use tipc::message::Lang;
use tipc::render;
use tipc::source::Encoding;
use tipc::{Options, Robot};

/// Settings for loading and running a program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Settings {
    /// Options of the loader.
    pub load: Options,
    /// The robot, if a file beside the case describes it.
    pub description: Option<Description>,
    /// Inputs during the run, as `tip_sim::Inputs` reads them.
    pub inputs: String,
    /// Name of the scene.
    pub scene: Option<String>,
    /// True if the robot is simulated with mass.
    pub has_mass: bool,
}

impl Settings {
    /// The options in the header of an expectation, once for each robot that `# robots:` names; files that they name
    /// stand in `folder`.
    ///
    /// # Errors
    /// An option that does not exist, or a value that is none.
    pub fn of_header(expectation: &str, folder: &Path) -> Result<Vec<Self>, String> {
        let mut settings = Settings::default();
        let mut robots = Vec::new();
        for line in expectation.lines().take_while(|line| line.starts_with('#')) {
            if let Some(args) = line.strip_prefix("# args:") {
                settings.read(args, folder)?;
            }
            if let Some(names) = line.strip_prefix("# robots:") {
                for name in names.split_whitespace() {
                    robots.push(Robot::from_name(name).ok_or(format!("no robot {name}"))?);
                }
            }
        }
        if robots.is_empty() {
            robots.push(settings.load.robot);
        }
        let on = |robot| {
            let mut settings = settings.clone();
            settings.load.robot = robot;
            settings
        };
        Ok(robots.into_iter().map(on).collect())
    }

    /// Key of the generated code of a case for this robot.
    pub fn key(&self, case: &str) -> String {
        format!("{case} on {}", self.load.robot.name())
    }

    /// Lets one more thing happen: an option of `tip run`.
    pub fn add_input(&mut self, option: &str, value: impl Display) {
        if !self.inputs.is_empty() {
            self.inputs.push(' ');
        }
        // Writing to a String cannot fail.
        let _ = write!(self.inputs, "{option} {value}");
    }

    fn read(&mut self, args: &str, folder: &Path) -> Result<(), String> {
        let mut words = args.split_whitespace();
        while let Some(option) = words.next() {
            let value = words.next().map(|word| word.trim_matches('\''));
            let value = value.ok_or_else(|| format!("{option} lacks its value"))?;
            let known = match option {
                "--robot" if value.ends_with(".toml") => Some(self.describe(&folder.join(value))?),
                "--robot" => Robot::from_name(value).map(|robot| self.load.robot = robot),
                "--tip-version" => value.parse().ok().map(|n| self.load.tip_version = Some(n)),
                "--encoding" => encoding(value).map(|encoding| self.load.encoding = encoding),
                "--scene" => {
                    self.scene = Some(value.to_owned());
                    Some(())
                }
                "--plant" => (value == "dynamic").then(|| self.has_mass = true),
                "--cycles" | "--keys" | "--halt" | "--sensor" | "--events" => {
                    self.add_input(option, value);
                    Some(())
                }
                _ => return Err(format!("unknown option {option}")),
            };
            known.ok_or_else(|| format!("{option} cannot be {value}"))?;
        }
        Ok(())
    }

    /// The robot is the one that the file describes.
    fn describe(&mut self, path: &Path) -> Result<(), String> {
        let name = path.display().to_string();
        let bytes = fs::read(path).map_err(|error| format!("{name}: {error}"))?;
        let description = description::parse(&name, &bytes).map_err(|loaded| {
            let told = loaded.diagnostics.iter();
            let told: Vec<String> = told
                .map(|fault| render::short(&loaded.source, fault, Lang::English))
                .collect();
            told.join("\n")
        })?;
        self.load.robot = description.robot();
        self.description = Some(description);
        Ok(())
    }
}

fn encoding(name: &str) -> Option<Encoding> {
    match name {
        "auto" => Some(Encoding::Auto),
        "utf-8" => Some(Encoding::Utf8),
        "shift_jis" => Some(Encoding::ShiftJis),
        _ => None,
    }
}
