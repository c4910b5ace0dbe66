#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

mod allow;
pub mod coverage_points;
pub mod cycles;
mod fix;
pub mod format;
mod lints;
pub mod listing;
pub mod message;
pub mod migrate;
pub mod query;
pub mod repair;
mod words;

pub use tipc::{Loaded, Options};

use message::RobotChoice;
use tipc::Robot;
use tipc::code::Level;
use tipc::diagnostic::{Diagnostic, Omitted};
use tipc::load::lowered;

/// Reads, checks and lowers a program as [`tipc::load()`] does, and adds lints and fixes. If the program has many
/// errors, but none for another built-in robot, a single error names that robot.
pub fn load(name: &str, bytes: &[u8], options: &Options) -> Loaded {
    let mut loaded = load_all_errors(name, bytes, options);
    if let Some(robot) = other_robot(&loaded, bytes, options) {
        report_robot(&mut loaded, robot, options.robot.name());
    }
    loaded
}

/// Loads a program as [`load`] does, but keeps all errors of a program for another robot.
pub fn load_all_errors(name: &str, bytes: &[u8], options: &Options) -> Loaded {
    let (mut loaded, found) = lowered(name, bytes, options);
    let found = lints::find(&loaded, found, bytes, options);
    loaded.report(found);
    words::advise(&mut loaded);
    fix::attach(
        &loaded.source,
        &loaded.module,
        &mut loaded.diagnostics,
        words::fixer,
    );
    loaded
}

/// Minimum number of errors for which other robots are tried.
const MANY: usize = 4;

fn errors(loaded: &Loaded) -> impl Iterator<Item = &Diagnostic> {
    let all = loaded.diagnostics.iter();
    all.filter(|one| one.level() == Level::Error)
}

/// Returns the robot for which a program with many errors has none.
fn other_robot(loaded: &Loaded, bytes: &[u8], options: &Options) -> Option<&'static str> {
    // A text with more errors than are reported is no program for any robot, and another attempt would need as much
    // memory again.
    if errors(loaded).count() < MANY || loaded.omitted.count() > 0 {
        return None;
    }
    let others = Robot::ALL.iter().copied();
    let mut others = others.filter(|robot| *robot != options.robot);
    let fits = |robot: &Robot| {
        let options = Options {
            robot: *robot,
            ..*options
        };
        let (loaded, _) = lowered(loaded.source.name(), bytes, &options);
        loaded.program.is_some()
    };
    others.find(fits).map(Robot::name)
}

/// Replaces all diagnostics by one at the first error: the choice of the robot is the only mistake.
fn report_robot(loaded: &mut Loaded, robot: &'static str, chosen: &'static str) {
    let Some(mut one) = errors(loaded).next().cloned() else {
        return;
    };
    one.reason = RobotChoice::LooksLike { robot, chosen }.into();
    one.help = Some(RobotChoice::Choose { robot }.into());
    one.labels.clear();
    one.fixes.clear();
    one.is_guess = false;
    loaded.diagnostics = vec![one];
    loaded.omitted = Omitted::default();
}

/// Adds warnings of another crate about a program, except those that a comment silences.
pub fn add(loaded: &mut Loaded, found: Vec<Diagnostic>) {
    lints::add(loaded, found);
}
