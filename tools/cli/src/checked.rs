//! A program that a command is going to use.

use super::arguments::SourceArguments;
use super::robot::ChosenRobot;
use super::{input, report};
use std::path::Path;
use tipc::Loaded;
use tipc::diagnostic::Diagnostic;
use tipc::program::Program;
use tipc::source::Source;
use tipc::syntax::Module;

/// A program that loads.
pub(super) struct Checked {
    /// The robot that it was checked for.
    pub(super) robot: ChosenRobot,
    pub(super) program: Program,
    pub(super) source: Source,
    pub(super) module: Module,
    /// The warnings about it, already reported.
    pub(super) diagnostics: Vec<Diagnostic>,
}

/// Loads the program at `path` for the robot of the command line, and reports the findings about both;
/// `None` if one of them does not load.
pub(super) fn checked(path: &Path, arguments: &SourceArguments) -> Option<Checked> {
    let shown = arguments.shown;
    let robot = match arguments.robot().load() {
        Ok(robot) => robot,
        Err(loaded) => {
            report::findings(&loaded, shown);
            return None;
        }
    };
    let loaded = input::load(path, &arguments.options(robot.robot()));
    report::findings(&loaded, shown);
    let Loaded {
        source,
        module,
        program,
        diagnostics,
        ..
    } = loaded;
    Some(Checked {
        robot,
        program: program?,
        source,
        module,
        diagnostics,
    })
}
