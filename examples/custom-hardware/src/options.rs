//! The command line.

use std::path::PathBuf;

/// Output of `--help`.
pub const HELP: &str = "\
Runs a T.I.P. program on a servo bus and records targets against measurements.

Usage: custom-hardware [OPTIONS]

Options:
  --robot FILE  robot description (default: the robot.toml beside this example)
  --csv FILE    where the table goes (default: custom-hardware.csv)
  --fast        as fast as the machine can, instead of in real time
  --help        this text
";

/// The command line, understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// The description file, if not the built-in one.
    pub robot: Option<PathBuf>,
    /// Output file of the table.
    pub csv: PathBuf,
    /// No pacing.
    pub fast: bool,
    /// Only print the help text.
    pub help: bool,
}

impl Options {
    /// Understands the words after the program's name.
    ///
    /// # Errors
    /// Error in the options.
    pub fn parse(words: impl IntoIterator<Item = String>) -> Result<Self, String> {
        let mut options = Options {
            robot: None,
            csv: "custom-hardware.csv".into(),
            fast: false,
            help: false,
        };
        let mut words = words.into_iter();
        while let Some(word) = words.next() {
            let mut file = || words.next().ok_or(format!("{word} needs a file name"));
            match word.as_str() {
                "--robot" => options.robot = Some(file()?.into()),
                "--csv" => options.csv = file()?.into(),
                "--fast" => options.fast = true,
                "--help" | "-h" => options.help = true,
                _ => return Err(format!("unknown option {word}")),
            }
        }
        Ok(options)
    }
}
