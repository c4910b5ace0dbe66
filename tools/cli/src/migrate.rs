//! `tipc migrate`: a program of an older version as one of version 3.1.

use super::arguments::Migrate;
use super::choices::Format;
use super::error::Error;
use super::{Status, input, output, report};
use tipc::migrate::{self, Migration};

/// Writes the new program, or nothing if a question is open; the report goes to standard error.
pub(super) fn migrate(arguments: &Migrate) -> Result<Status, Error> {
    let format = arguments.message_format;
    let migration = match input::migrate(&arguments.file, arguments.encoding.encoding()) {
        Ok(migration) => migration,
        Err(loaded) => {
            report::findings(&loaded, format);
            return Ok(Status::Failure);
        }
    };
    let Some(bytes) = migration.bytes() else {
        report::complain(&told(&migration, format));
        return Ok(Status::Failure);
    };
    match &arguments.out {
        Some(out) => {
            output::refuse_source(out, &arguments.file)?;
            output::replace(out, bytes)?;
        }
        None => output::print(bytes)?,
    }
    report::complain(&told(&migration, format));
    Ok(Status::Success)
}

fn told(migration: &Migration, format: Format) -> String {
    match format {
        Format::Human => migrate::render_human(migration),
        Format::Short => migrate::render_short(migration),
        Format::Json => migrate::render_json(migration),
    }
}
