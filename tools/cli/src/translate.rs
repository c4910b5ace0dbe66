//! Commands that write a program in another form: `tip fmt`, `tip emit`, `tip migrate` and `tip cycles`.

use crate::Action;
use crate::arguments::{SourceArguments, version_number};
use crate::choices::{EncodingName, Format, OutputOptions};
use crate::error::Error;
use crate::loader::{check, sound};
use crate::setup::RobotChoice;
use crate::{Status, input, loader, output, report};
use clap::{Args, ValueEnum};
use similar::TextDiff;
use std::path::{Path, PathBuf};
use tip_lint::cycles::{self, Sampling};
use tip_lint::format::{Refusal, format_for};
use tip_lint::listing;
use tip_lint::message::Formatting;
use tip_lint::migrate::{self, Migration};
use tip_runtime::printable::Printable;
use tipc::emit as rust;
use tipc::language::Edition;
use tipc::program::Program;
use tipc::source::{Encoding, Source};
use tipc::{Loaded, Options, Robot};

#[derive(Debug, Args)]
#[command(
    after_long_help = "There is one style without options: blocks indented by two blanks, capital letters, one blank between words and
around operators, comments of neighbouring lines in one column. Lines are neither joined nor split, and no byte of a
comment, of a text, of the first two lines or after END changes: docs/style.md. Each call checks that the result loads to
the same program. A file with errors is left as it is.

Examples:
  tip fmt walk.prg turn.prg
  tip fmt --check *.prg      name the files that are not in the style
  tip fmt --diff walk.prg    show what would change
  tip fmt - < walk.prg       from standard input to standard output

Exit status: 0 if every file is in the style now, 1 if one was left as it is or, with --check or --diff, is not in the
style."
)]
pub(super) struct Fmt {
    /// The programs; '-' is standard input
    #[arg(value_name = "FILE", required = true)]
    pub(super) files: Vec<PathBuf>,

    /// Write nothing; name the files that would change
    #[arg(long)]
    pub(super) check: bool,

    /// Write nothing; print what would change
    #[arg(long, conflicts_with = "check")]
    pub(super) diff: bool,

    /// The robot, if it has no name
    ///
    /// A name that 'tip robot list' shows, or a description in a file
    #[arg(long, value_name = "NAME|FILE.toml")]
    pub(super) robot: Option<RobotChoice>,

    /// The version in line 1
    ///
    /// The version of the language that line 1 must name; by default that of any edition, 3.1 or 3.2
    #[arg(long, value_name = "NUMBER", value_parser = version_number)]
    tip_version: Option<f64>,

    /// The encoding: auto, utf-8 or shift_jis
    ///
    /// auto, the default without tip.toml, is UTF-8 if that is valid, else Shift_JIS
    #[arg(long, value_enum)]
    encoding: Option<EncodingName>,

    #[command(flatten)]
    pub(super) output_options: OutputOptions,
}

impl Action for Fmt {
    fn format(&self) -> Option<Format> {
        Some(self.output_options.message_format)
    }

    fn execute(&self) -> Result<Status, Error> {
        fmt(self)
    }
}

/// Formats each file; one that cannot be formatted makes the whole command fail.
fn fmt(arguments: &Fmt) -> Result<Status, Error> {
    let mut status = Status::Success;
    for path in &arguments.files {
        let read = target(arguments, path).and_then(|target| Ok((target, input::bytes(path)?)));
        let done = match read {
            Ok((target, (name, bytes))) => arguments.format_file(path, &name, &bytes, target)?,
            Err(loaded) => {
                report::diagnostics(&loaded, arguments.output_options);
                false
            }
        };
        if !done {
            status = Status::Failure;
        }
    }
    Ok(status)
}

/// The robots that a file may be for, and its encoding.
type Target = (Vec<Robot>, Encoding);

/// Returns robots and encoding from options and the nearest `tip.toml`; without them, all robots that have a name.
fn target(arguments: &Fmt, path: &Path) -> Result<Target, Box<Loaded>> {
    let given = loader::settings(path)?;
    let given_robot = given.as_ref().and_then(|given| given.robot.as_ref());
    let robots = match arguments.robot.as_ref().or(given_robot) {
        None => Robot::ALL.to_vec(),
        Some(choice) => vec![choice.load()?.robot()],
    };
    let encoding = arguments.encoding.or_else(|| given.as_ref()?.encoding);
    let encoding = encoding.map_or(Encoding::Auto, EncodingName::encoding);
    Ok((robots, encoding))
}

impl Fmt {
    /// Formats a file for the first robot that it loads for, or checks its format; returns true if it is formatted now.
    fn format_file(
        &self,
        path: &Path,
        name: &str,
        bytes: &[u8],
        (robots, encoding): Target,
    ) -> Result<bool, Error> {
        let options = Options {
            tip_version: self.tip_version,
            encoding,
            ..Options::default()
        };
        let formatted = match format_for(name, bytes, &options, &robots) {
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
                output::print(difference(name, bytes, &formatted, encoding))?;
            }
            return Ok(!changes);
        }
        if input::is_stream(path) {
            output::print(&formatted)?;
        } else if changes {
            output::update(path, bytes, &formatted, self.output_options.lang())?;
        }
        Ok(true)
    }

    /// Reports the reason why a file is left as it is: errors are those for the robot with the fewest.
    fn explain(&self, name: &str, refusal: &Refusal) {
        let reason = match refusal {
            Refusal::Diagnostics(loaded) => {
                report::diagnostics(loaded, self.output_options);
                &Formatting::DoesNotLoad
            }
            Refusal::Because(reason) => reason,
        };
        let reason = reason.in_lang(self.output_options.lang());
        report::complain(&format!("{}: {reason}\n", Printable::line(name)));
    }
}

/// Returns the unified diff of two texts.
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

#[derive(Debug, Args)]
#[command(after_long_help = "Forms:
  rust     one state for each step, as the macros and build scripts compile it
  formal   FORMAL.TMP: the program step by step, comments and layout gone
  label    LABEL.TMP: every label and the number of its step
  obj      TIP.OBJ: every step as command, target and arguments with their types
  warning  WARNING.LOG: the warnings, one a line

Examples:
  tip emit rust walk.prg -o walk.rs
  tip emit label walk.prg")]
pub(super) struct Emit {
    /// The form: rust, formal, label, obj or warning
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

impl Action for Emit {
    fn complete(&mut self) -> Result<(), Error> {
        self.source.complete(&self.file).map(drop)
    }

    fn format(&self) -> Option<Format> {
        Some(self.source.output_options.message_format)
    }

    fn execute(&self) -> Result<Status, Error> {
        emit(self)
    }
}

/// Writes one form of a program to a file or to standard output.
fn emit(arguments: &Emit) -> Result<Status, Error> {
    let source = &arguments.source;
    let subject = check(&arguments.file, source)?;
    let (subject, program) = sound(subject, source.output_options, false)?;
    let Loaded {
        source: text,
        module,
        diagnostics,
        ..
    } = &subject.loaded;
    let emitted = match arguments.form {
        Form::Rust => as_rust(&program)?,
        Form::Formal => listing::formal(text, module),
        Form::Label => listing::label(&program),
        Form::Obj => listing::object(text, module, &program),
        Form::Warning => listing::warnings(text, diagnostics),
    };
    let robot = source.robot().file();
    let inputs: Vec<_> = robot.into_iter().chain([&*arguments.file]).collect();
    output::write(arguments.out.as_deref(), &inputs, emitted)?;
    Ok(Status::Success)
}

/// Returns a module with one public type.
fn as_rust(program: &Program) -> Result<String, Error> {
    let options = rust::Options {
        visibility: quote::quote!(pub),
        ..rust::Options::default()
    };
    rust::pretty(program, &options).map_err(|error| {
        Error::Usage(format!(
            "{} cannot be written as Rust: {error}",
            program.source_name()
        ))
    })
}

#[derive(Debug, Args)]
#[command(
    after_long_help = "Programs of versions 1.0 to 3.0, and those that say 4.0, become programs of version 3.1: declarations,
renamed commands, changed forms. Comments, layout, encoding and the order of the steps are kept.
With --to 3.2 they go on to edition 3.2, and a program of 3.1 does: names that 3.2 reserves are renamed, and what 3.2 refuses
is a question. Every change is reported with its line. If the text leaves a choice open, the report asks a question and nothing is written.

Examples:
  tip migrate old.prg -o new.prg
  tip migrate --to 3.2 walk.prg -o next.prg
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

    /// The version of the new program
    #[arg(long, value_enum, default_value = "3.1")]
    pub(super) to: EditionName,

    /// The encoding: auto, utf-8 or shift_jis
    ///
    /// auto is UTF-8 if that is valid, else Shift_JIS
    #[arg(long, value_enum, default_value = "auto")]
    pub(super) encoding: EncodingName,

    #[command(flatten)]
    pub(super) output_options: OutputOptions,
}

/// The editions of the language.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum EditionName {
    /// T.I.P. 3.1
    #[value(name = "3.1")]
    V3_1,
    /// T.I.P. 3.2
    #[value(name = "3.2")]
    V3_2,
}

impl EditionName {
    const fn edition(self) -> Edition {
        match self {
            EditionName::V3_1 => Edition::V3_1,
            EditionName::V3_2 => Edition::V3_2,
        }
    }
}

impl Action for Migrate {
    fn format(&self) -> Option<Format> {
        Some(self.output_options.message_format)
    }

    fn execute(&self) -> Result<Status, Error> {
        migrate(self)
    }
}

/// Writes the new program, or nothing if a question is open; the report goes to standard error.
fn migrate(arguments: &Migrate) -> Result<Status, Error> {
    let output_options = arguments.output_options;
    let (encoding, edition) = (arguments.encoding.encoding(), arguments.to.edition());
    let migration = input::migrate(&arguments.file, encoding, edition);
    let migration = migration.map_err(Error::refused(output_options))?;
    let report = migration_report(&migration, output_options);
    let Some(bytes) = migration.bytes() else {
        report::complain(&report);
        return Ok(Status::Failure);
    };
    match &arguments.out {
        Some(out) => {
            output::refuse_same(out, &[&arguments.file])?;
            output::replace(out, bytes)?;
        }
        None => output::print(bytes)?,
    }
    report::complain(&report);
    Ok(Status::Success)
}

fn migration_report(migration: &Migration, output_options: OutputOptions) -> String {
    let lang = output_options.lang();
    match output_options.message_format {
        Format::Human | Format::Sarif => migrate::render_human(migration, lang),
        Format::Short => migrate::render_short(migration, lang),
        Format::Json => migrate::render_json(migration, lang),
    }
}

#[derive(Debug, Args)]
#[command(
    after_long_help = "For each subroutine, each turn of a loop, and each stretch from a label to the next: the least and the
most control cycles, and the time at the robot's standard sampling time. One step is one cycle. A step that
waits counts as the least that it can take, and its part is marked 'waits'. 'or more' marks a part without a bound.

Examples:
  tip cycles walk.prg
  tip cycles --message-format json walk.prg   one object a line, for tools

Exit status: 0 if the program loads, 1 otherwise."
)]
pub(super) struct Cycles {
    /// The program
    pub(super) file: PathBuf,

    #[command(flatten)]
    pub(super) source: SourceArguments,
}

impl Action for Cycles {
    fn complete(&mut self) -> Result<(), Error> {
        self.source.complete(&self.file).map(drop)
    }

    fn format(&self) -> Option<Format> {
        Some(self.source.output_options.message_format)
    }

    fn execute(&self) -> Result<Status, Error> {
        cycles(self)
    }
}

/// Writes the counts of one program to standard output.
fn cycles(arguments: &Cycles) -> Result<Status, Error> {
    let source = &arguments.source;
    let subject = check(&arguments.file, source)?;
    let (subject, program) = sound(subject, source.output_options, false)?;
    let sampling = Sampling::of(subject.chosen.robot());
    let parts = cycles::parts(&program, sampling);
    output::print(match source.output_options.message_format {
        Format::Human | Format::Sarif => cycles::human(&program, &parts, sampling),
        Format::Short => cycles::short(&program, &parts, sampling),
        Format::Json => cycles::json(&program, &parts, sampling),
    })?;
    Ok(Status::Success)
}
