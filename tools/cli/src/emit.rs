//! `tipc emit`: a program in another form.

use super::arguments::Emit;
use super::checked::checked;
use super::choices::Form;
use super::error::Error;
use super::{Status, output};
use tipc::program::Program;
use tipc::{emit as rust, listing};

/// Writes one form of a program to a file or to standard output.
pub(super) fn emit(arguments: &Emit) -> Result<Status, Error> {
    let Some(checked) = checked(&arguments.file, &arguments.source) else {
        return Ok(Status::Failure);
    };
    let program = &checked.program;
    let text = match arguments.form {
        Form::Rust => as_rust(program)?,
        Form::Formal => listing::formal(&checked.source, &checked.module),
        Form::Label => listing::label(program),
        Form::Obj => listing::object(&checked.source, &checked.module, program),
        Form::Warning => listing::warnings(&checked.source, &checked.diagnostics),
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
