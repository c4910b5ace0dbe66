//! What every command that reads a program takes.

mod inputs;

pub(super) use inputs::InputArguments;

use super::choices::{EncodingName, RobotName};
use super::robot::RobotChoice;
use super::shown::Shown;
use super::usage::Wrong;
use crate::message::Using;
use clap::Args;
use tipc::source::Encoding;
use tipc::{Options, Robot};

/// The robot of a program that nobody says anything of.
static TITAN: RobotChoice = RobotChoice::Named(RobotName::Titan8);

/// How a source file is to be read. Every command takes these.
#[derive(Clone, Debug, Args)]
pub(super) struct SourceArguments {
    /// The robot that the program is for: a name that 'tipc robot list' shows, or a description; else that of tip.toml, or titan8
    #[arg(long, value_name = "NAME|FILE.toml")]
    pub(super) robot: Option<RobotChoice>,

    /// The version of the language that line 1 must name
    #[arg(long, value_name = "NUMBER", default_value = "3.1", value_parser = version_number)]
    tip_version: f64,

    /// How the file spells text; auto, unless tip.toml says otherwise, takes UTF-8 if it is valid, else Shift_JIS
    #[arg(long, value_enum)]
    pub(super) encoding: Option<EncodingName>,

    #[command(flatten)]
    pub(super) shown: Shown,
}

impl SourceArguments {
    /// The robot.
    pub(super) fn robot(&self) -> &RobotChoice {
        self.robot.as_ref().unwrap_or(&TITAN)
    }

    /// The options of the compiler.
    pub(super) fn options(&self, robot: Robot) -> Options {
        Options {
            robot,
            tip_version: self.tip_version,
            encoding: self.encoding.map_or(Encoding::Auto, EncodingName::encoding),
        }
    }
}

/// A version of the language.
pub(super) fn version_number(text: &str) -> Result<f64, Wrong> {
    match text.parse() {
        Ok(number) if f64::is_finite(number) && number > 0.0 => Ok(number),
        _ => Err(Wrong(Using::NotAVersion {
            text: text.to_owned(),
        })),
    }
}
