//! The command line.

use std::path::PathBuf;

/// Output of `--help`.
pub const HELP: &str = "\
Walks the simulated TITAN VIII by the compiled program and prints a gait diagram.

Usage: walk [OPTIONS]

Options:
  --cycles N     stop after N control cycles (default: when the program ends)
  --trace FILE   write the trace, one JSON object a line
  --trace-state  add a hash of joint commands and angles to each record
  --realtime     walk in real time: F faster, S slower, Q stop, ESC halt request, RETURN emergency stop
  --help         this text

Exit status: 0 if the body came 1 m forward without a fall, 1 if not, 2 for a wrong command line.
";

/// The command line, understood.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// The most cycles to run.
    pub cycles: Option<u64>,
    /// Output file of the trace.
    pub trace: Option<PathBuf>,
    /// Records end with a hash of the robot's state.
    pub trace_state: bool,
    /// Paced, with the keyboard.
    pub realtime: bool,
    /// Only print the help text.
    pub help: bool,
}

impl Options {
    /// Understands the words after the program's name.
    ///
    /// # Errors
    /// Error in the options.
    pub fn parse(words: impl IntoIterator<Item = String>) -> Result<Self, String> {
        let mut options = Options::default();
        let mut words = words.into_iter();
        while let Some(word) = words.next() {
            let mut value = || words.next().ok_or(format!("{word} needs a value"));
            match word.as_str() {
                "--cycles" => options.cycles = Some(number(&value()?)?),
                "--trace" => options.trace = Some(value()?.into()),
                "--trace-state" => options.trace_state = true,
                "--realtime" => options.realtime = true,
                "--help" | "-h" => options.help = true,
                _ => return Err(format!("unknown option {word}")),
            }
        }
        if options.realtime && (options.trace.is_some() || options.cycles.is_some()) {
            return Err("--realtime goes with neither --trace nor --cycles".into());
        }
        Ok(options)
    }
}

fn number(word: &str) -> Result<u64, String> {
    word.parse()
        .map_err(|_| format!("{word} is not a number of cycles"))
}
