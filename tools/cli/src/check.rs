//! `tipc check`: reports everything that is wrong with programs.

use super::arguments::Check;
use super::error::Error;
use super::{Status, input, report};

/// Checks each file; one that does not load makes the whole command fail.
pub(super) fn check(arguments: &Check) -> Result<Status, Error> {
    let format = arguments.source.message_format;
    let robot = match arguments.source.robot.load() {
        Ok(robot) => robot.robot(),
        Err(loaded) => {
            report::check(&loaded, format)?;
            return Ok(Status::Failure);
        }
    };
    let options = arguments.source.options(robot);
    let mut status = Status::Success;
    for file in &arguments.files {
        let loaded = input::load(file, &options);
        report::check(&loaded, format)?;
        if loaded.program.is_none() {
            status = Status::Failure;
        }
    }
    Ok(status)
}
