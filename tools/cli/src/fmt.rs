//! `tip fmt`: programs in the one style.

use super::arguments::version_number;
use super::choices::EncodingName;
use super::error::Error;
use super::robot::RobotChoice;
use super::shown::Shown;
use super::{Status, input, output, project, report};
use clap::Args;
use similar::TextDiff;
use std::path::{Path, PathBuf};
use tip_lint::format::{Refusal, format_for};
use tip_lint::message::Formatting;
use tip_runtime::printable::Printable;
use tipc::source::{Encoding, Source};
use tipc::{Loaded, Options, Robot};

/// `tip fmt`
#[derive(Debug, Args)]
#[command(
    after_help = "There is one style and no option of it: blocks indented by two blanks, capital letters, one blank between words and
around operators, comments of neighbouring lines in one column. Lines stay apart, and no byte of a comment, of a text, of
the first two lines or of what follows END changes: docs/style.md. What is written loads to the same program, which each
call checks. A file with errors is left as it is.

Examples:
  tip fmt walk.prg turn.prg
  tip fmt --check *.prg      name the files that are not in the style
  tip fmt --diff walk.prg    show what would change
  tip fmt - < walk.prg       from standard input to standard output

Exit status: 0 if every file is in the style now, 1 if one is left as it is, or is not in the style with --check or
--diff."
)]
pub(super) struct Fmt {
    /// The programs; '-' is standard input
    #[arg(value_name = "FILE", required = true)]
    pub(super) files: Vec<PathBuf>,

    /// Write nothing, and print the names of the files that would change
    #[arg(long)]
    pub(super) check: bool,

    /// Write nothing, and print what would change
    #[arg(long, conflicts_with = "check")]
    pub(super) diff: bool,

    /// The robot that the programs are for, if it is none that has a name
    #[arg(long, value_name = "NAME|FILE.toml")]
    pub(super) robot: Option<RobotChoice>,

    /// The version of the language that line 1 must name
    #[arg(long, value_name = "NUMBER", default_value = "3.1", value_parser = version_number)]
    tip_version: f64,

    /// How the files spell text; auto, unless tip.toml says otherwise, takes UTF-8 if it is valid, else Shift_JIS
    #[arg(long, value_enum)]
    encoding: Option<EncodingName>,

    #[command(flatten)]
    pub(super) shown: Shown,
}

/// Lays out each file; one that has to be left as it is makes the whole command fail.
pub(super) fn fmt(arguments: &Fmt) -> Result<Status, Error> {
    let mut status = Status::Success;
    for path in &arguments.files {
        let read = meant(arguments, path).and_then(|meant| Ok((meant, input::bytes(path)?)));
        let done = match read {
            Ok((meant, (name, bytes))) => arguments.file(path, &name, &bytes, &meant)?,
            Err(loaded) => {
                report::findings(&loaded, arguments.shown);
                false
            }
        };
        if !done {
            status = Status::Failure;
        }
    }
    Ok(status)
}

/// What a file is meant for.
struct Meant {
    /// The robots that it may be for.
    robots: Vec<Robot>,
    encoding: Encoding,
}

/// What options and the nearest `tip.toml` say of a file; without them it may be for any robot that has a name.
fn meant(arguments: &Fmt, path: &Path) -> Result<Meant, Box<Loaded>> {
    let given = project::of(path)?;
    let given_robot = given.as_ref().and_then(|given| given.robot.as_ref());
    let robots = match arguments.robot.as_ref().or(given_robot) {
        None => Robot::ALL.to_vec(),
        Some(choice) => vec![choice.load()?.robot()],
    };
    let encoding = arguments.encoding.or_else(|| given.as_ref()?.encoding);
    Ok(Meant {
        robots,
        encoding: encoding.map_or(Encoding::Auto, EncodingName::encoding),
    })
}

impl Fmt {
    /// Whether the file is in the style, or is now.
    fn file(&self, path: &Path, name: &str, bytes: &[u8], meant: &Meant) -> Result<bool, Error> {
        let formatted = match self.formatted(name, bytes, meant) {
            Ok(formatted) => formatted,
            Err(refusal) => {
                self.explain(name, &refusal);
                return Ok(false);
            }
        };
        let changes = formatted != bytes;
        if self.check || self.diff {
            if changes && self.check {
                output::print(format!("{}\n", Printable::line(name)))?;
            } else if changes {
                output::print(difference(name, bytes, &formatted, meant.encoding))?;
            }
            return Ok(!changes);
        }
        if input::is_stream(path) {
            output::print(&formatted)?;
        } else if changes {
            output::update(path, bytes, &formatted, self.shown.lang())?;
        }
        Ok(true)
    }

    /// Formatted for the first robot that it loads for; else what is wrong with it for the one that it suits best.
    fn formatted(&self, name: &str, bytes: &[u8], meant: &Meant) -> Result<Vec<u8>, Refusal> {
        let options = Options {
            tip_version: self.tip_version,
            encoding: meant.encoding,
            ..Options::default()
        };
        format_for(name, bytes, &options, &meant.robots)
    }

    /// Says why a file is left as it is.
    fn explain(&self, name: &str, refusal: &Refusal) {
        let reason = match refusal {
            Refusal::Findings(loaded) => {
                report::findings(loaded, self.shown);
                &Formatting::DoesNotLoad
            }
            Refusal::Because(reason) => reason,
        };
        let reason = reason.in_lang(self.shown.lang());
        report::complain(&format!("{}: {reason}\n", Printable::line(name)));
    }
}

/// Both texts, line by line, as patches show them.
fn difference(name: &str, before: &[u8], after: &[u8], encoding: Encoding) -> String {
    let text = |bytes| {
        let (source, _) = Source::decode(name, bytes, encoding);
        source.text().to_owned()
    };
    let (before, after) = (text(before), text(after));
    let name = Printable::line(name).to_string();
    let diff = TextDiff::from_lines(before.as_str(), after.as_str());
    let mut diff = diff.unified_diff();
    diff.header(&name, &format!("{name} (formatted)"))
        .to_string()
}
