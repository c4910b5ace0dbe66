//! The formatter: a result in the style that is the same program, with every comment and all that follows it; or a reason.

use tip_lint::format::{Refusal, format};
use tip_lint::message::Formatting;
use tipc::source::{Encoding, Source};
use tipc::{Options, Robot};

/// Formats the bytes for each robot and in each encoding.
///
/// # Panics
/// The result is not in the style, or has lost something; or there is no reason for there being none.
pub fn examine(bytes: &[u8]) {
    for encoding in [Encoding::Auto, Encoding::Utf8, Encoding::ShiftJis] {
        for_some_robot(bytes, encoding);
    }
}

/// The formatted bytes of a program, for the first robot that it is for.
///
/// # Panics
/// Examines as [`examine`] does.
pub fn for_some_robot(bytes: &[u8], encoding: Encoding) -> Option<Vec<u8>> {
    Robot::ALL.iter().find_map(|robot| {
        let options = Options {
            robot: *robot,
            encoding,
            ..Options::default()
        };
        formatted(bytes, &options)
    })
}

/// The formatted bytes of a program that can be formatted.
///
/// # Panics
/// Examines as [`examine`] does.
pub fn formatted(bytes: &[u8], options: &Options) -> Option<Vec<u8>> {
    let seen = String::from_utf8_lossy(bytes);
    match format("random.prg", bytes, options) {
        Ok(once) => {
            let twice = format("random.prg", &once, options);
            assert!(twice.is_ok_and(|twice| twice == once), "{seen}");
            assert_eq!(comments(bytes, options), comments(&once, options), "{seen}");
            Some(once)
        }
        Err(Refusal::Diagnostics(loaded)) => {
            assert!(loaded.program.is_none(), "{seen}");
            None
        }
        Err(Refusal::Because(Formatting::OtherProgram)) => panic!("another program: {seen}"),
        Err(Refusal::Because(_)) => None,
    }
}

/// The comments of a file, without the blanks at their ends, and the rest of the lines that begin with them.
fn comments(bytes: &[u8], options: &Options) -> Vec<String> {
    let (source, _) = Source::decode("random.prg", bytes, options.encoding);
    let lines = source.lines().map(|line| source.slice(line.span));
    let comments = lines.filter_map(|line| line.find("//").map(|at| &line[at..]));
    comments
        .map(|comment| comment.trim_end_matches([' ', '\t', '\u{3000}']).to_owned())
        .collect()
}
