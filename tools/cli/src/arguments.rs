//! What every command that reads a program takes.

mod inputs;

pub(super) use inputs::InputArguments;

use super::choices::EncodingName;
use super::robot::RobotChoice;
use super::shown::Shown;
use super::usage::Wrong;
use clap::Args;
use tipc::message::Using;
use tipc::{Options, Robot};

/// How a source file is to be read. Every command takes these.
#[derive(Debug, Args)]
pub(super) struct SourceArguments {
    /// The robot that the program is for: titan8, hand, generic, or a description
    #[arg(long, value_name = "NAME|FILE.toml", default_value = "titan8")]
    pub(super) robot: RobotChoice,

    /// The version of the language that line 1 must name
    #[arg(long, value_name = "NUMBER", default_value = "3.1", value_parser = version_number)]
    tip_version: f64,

    /// How the file spells text; auto takes UTF-8 if it is valid, else Shift_JIS
    #[arg(long, value_enum, default_value = "auto")]
    encoding: EncodingName,

    #[command(flatten)]
    pub(super) shown: Shown,
}

impl SourceArguments {
    /// The options of the compiler.
    pub(super) fn options(&self, robot: Robot) -> Options {
        Options {
            robot,
            tip_version: self.tip_version,
            encoding: self.encoding.encoding(),
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
