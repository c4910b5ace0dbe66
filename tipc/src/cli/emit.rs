//! `tipc emit`: a program in another form.

use super::arguments::{Emit, Form};
use super::error::Error;
use super::{Status, input, output, report};
use tipc::program::Program;
use tipc::{emit as rust, listing};

/// Writes one form of a program to a file or to standard output.
pub(super) fn emit(arguments: &Emit) -> Result<Status, Error> {
    let format = arguments.source.message_format;
    let robot = match arguments.source.robot.load() {
        Ok(robot) => robot.robot(),
        Err(loaded) => {
            report::findings(&loaded, format);
            return Ok(Status::Failure);
        }
    };
    let loaded = input::load(&arguments.file, &arguments.source.options(robot));
    report::findings(&loaded, format);
    let Some(program) = &loaded.program else {
        return Ok(Status::Failure);
    };
    let text = match arguments.form {
        Form::Rust => as_rust(program)?,
        Form::Formal => listing::formal(program),
        Form::Label => listing::label(program),
        Form::Obj => listing::object(program),
        Form::Warning => listing::warnings(&loaded.source, &loaded.diagnostics),
    };
    match &arguments.out {
        Some(out) => {
            output::refuse_source(out, &arguments.file)?;
            output::replace(out, &text)?;
        }
        None => output::print(&text)?,
    }
    Ok(Status::Success)
}

/// A module with one public type.
fn as_rust(program: &Program) -> Result<String, Error> {
    let options = rust::Options {
        visibility: quote::quote!(pub),
        ..rust::Options::default()
    };
    let tokens = rust::emit(program, &options);
    rust::pretty(program, tokens).map_err(|error| {
        Error::Usage(format!(
            "{} cannot be spelt in Rust: {error}",
            program.source_name()
        ))
    })
}
