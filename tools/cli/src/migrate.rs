//! `tip migrate`: a program of an older version as one of version 3.1.

use super::choices::{EncodingName, Format};
use super::error::Error;
use super::shown::Shown;
use super::{Status, input, output, report};
use clap::Args;
use std::path::PathBuf;
use tip_lint::migrate::{self, Migration};

/// `tip migrate`
#[derive(Debug, Args)]
#[command(
    after_help = "Programs of versions 1.0 to 3.0, and those that say 4.0, become programs of version 3.1: declarations,
renamed commands, changed forms. Comments, layout, encoding and the order of the steps are kept.
Every change is reported with its line. If the text leaves a choice open, the report asks a question and nothing is written.

Examples:
  tip migrate old.prg -o new.prg
  tip migrate old.prg > new.prg                        the new program on standard output
  tip migrate --message-format short old.prg -o new.prg   FILE:LINE:COLUMN: change: ...

Exit status: 0 if the new program is written, 1 if there is a question or a file cannot be read or written."
)]
pub(super) struct Migrate {
    /// The older program
    #[arg(value_name = "OLD")]
    pub(super) file: PathBuf,

    /// Write to a file instead of standard output
    #[arg(short, long, value_name = "NEW")]
    pub(super) out: Option<PathBuf>,

    /// How the file spells text; auto takes UTF-8 if it is valid, else Shift_JIS
    #[arg(long, value_enum, default_value = "auto")]
    pub(super) encoding: EncodingName,

    #[command(flatten)]
    pub(super) shown: Shown,
}

/// Writes the new program, or nothing if a question is open; the report goes to standard error.
pub(super) fn migrate(arguments: &Migrate) -> Result<Status, Error> {
    let shown = arguments.shown;
    let migration = match input::migrate(&arguments.file, arguments.encoding.encoding()) {
        Ok(migration) => migration,
        Err(loaded) => {
            report::findings(&loaded, shown);
            return Ok(Status::Failure);
        }
    };
    let Some(bytes) = migration.bytes() else {
        report::complain(&told(&migration, shown));
        return Ok(Status::Failure);
    };
    match &arguments.out {
        Some(out) => {
            output::refuse_inputs(out, &[&arguments.file])?;
            output::replace(out, bytes)?;
        }
        None => output::print(bytes)?,
    }
    report::complain(&told(&migration, shown));
    Ok(Status::Success)
}

fn told(migration: &Migration, shown: Shown) -> String {
    let lang = shown.lang();
    match shown.message_format {
        Format::Human | Format::Sarif => migrate::render_human(migration, lang),
        Format::Short => migrate::render_short(migration, lang),
        Format::Json => migrate::render_json(migration, lang),
    }
}
