//! Exit status of the examples.

use std::error::Error;
use std::process::ExitCode;

/// The exit status of an example: 0 if all was good, else 1. What kept it from a verdict is reported
/// on standard error.
pub fn exit(example: &str, verdict: Result<bool, Box<dyn Error>>) -> ExitCode {
    match verdict {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(problem) => {
            eprintln!("{example}: {problem}");
            ExitCode::FAILURE
        }
    }
}
