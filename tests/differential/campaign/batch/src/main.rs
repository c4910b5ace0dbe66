//! Compares the programs of the file that the environment variable `BATCH` named when this was compiled.

use std::process::ExitCode;

include!(env!("BATCH"));

fn main() -> ExitCode {
    campaign::batch::main(SUBJECTS)
}
