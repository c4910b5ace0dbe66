//! `tip emit`: a program in another form.

use super::arguments::SourceArguments;
use super::error::Error;
use super::loader::{check, checked};
use super::{Status, output};
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use tip_lint::listing;
use tipc::emit as rust;
use tipc::program::Program;

/// The forms of a program.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Form {
    /// Rust source
    Rust,
    /// FORMAL.TMP
    Formal,
    /// LABEL.TMP
    Label,
    /// TIP.OBJ
    Obj,
    /// WARNING.LOG
    Warning,
}

/// `tip emit`
#[derive(Debug, Args)]
#[command(after_help = "Forms:
  rust     one state for each step, as the macros and build scripts compile it
  formal   FORMAL.TMP: the program step by step, comments and layout gone
  label    LABEL.TMP: every label and the number of its step
  obj      TIP.OBJ: every step as command, target and arguments with their types
  warning  WARNING.LOG: the warnings, one a line

Examples:
  tip emit rust walk.prg -o walk.rs
  tip emit label walk.prg")]
pub(super) struct Emit {
    /// Which form
    #[arg(value_enum)]
    pub(super) form: Form,

    /// The program
    pub(super) file: PathBuf,

    /// Write to a file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    pub(super) out: Option<PathBuf>,

    #[command(flatten)]
    pub(super) source: SourceArguments,
}

/// Writes one form of a program to a file or to standard output.
pub(super) fn emit(arguments: &Emit) -> Result<Status, Error> {
    let source = &arguments.source;
    let Some(checked) = checked(check(&arguments.file, source), source)? else {
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
            let robot = arguments.source.robot().file();
            let inputs: Vec<_> = robot.into_iter().chain([&*arguments.file]).collect();
            output::refuse_inputs(out, &inputs)?;
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
    rust::pretty(program, &options).map_err(|error| {
        Error::Usage(format!(
            "{} cannot be spelt in Rust: {error}",
            program.source_name()
        ))
    })
}
