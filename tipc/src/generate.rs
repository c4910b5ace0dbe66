//! Compiling motion programs in a build script.
//!
//! Three steps, as for any code generator. `Cargo.toml` names the runtime and, for the build
//! script, the compiler:
//!
//! ```toml
//! [dependencies]
//! tip-runtime = "0.1"
//!
//! [build-dependencies]
//! tipc = { package = "tip-compiler", version = "0.1" }
//! ```
//!
//! `build.rs` compiles `motions/walk.prg` to `$OUT_DIR/walk.rs`:
//!
//! ```no_run
//! fn main() -> Result<(), tipc::BuildError> {
//!     tipc::compile("motions/walk.prg")
//! }
//! ```
//!
//! `lib.rs` takes it in, as the type `Walk`, by the line `include!(concat!(env!("OUT_DIR"), "/walk.rs"));`
//!
//! A program with errors fails the build, each error shown with its line. The script runs again
//! when a `.prg` file changes, and only then.

#[cfg(feature = "robot-files")]
use crate::description::{self, Description};
#[cfg(feature = "robot-files")]
use crate::published;

use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::load::{self, Loaded, load};
use crate::message::{Building, Lang, Reading};
use crate::program::Program;
use crate::render::Style;
use crate::source::{Encoding, Source, Span};
use crate::{Robot, embed, emit, render};
use proc_macro2::TokenStream;
use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::{env, fmt, fs};

/// Compiles one motion program with the standard settings: TITAN VIII, TIP 3.1, a `pub` type named
/// after the file, in `$OUT_DIR/<file's stem>.rs`.
///
/// # Errors
/// The program's errors, or a file that could not be read or written.
pub fn compile(path: impl AsRef<Path>) -> Result<(), BuildError> {
    Config::new().compile(&[path])
}

/// Settings of a compilation.
///
/// ```no_run
/// # fn main() -> Result<(), tipc::BuildError> {
/// tipc::Config::new()
///     .robot(tipc::Robot::Generic)
///     .visibility("pub(crate)")
///     .compile(&["motions/walk.prg", "motions/wave.prg"])
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Config {
    load: load::Options,
    #[cfg(feature = "robot-files")]
    robot_file: Option<PathBuf>,
    out_dir: Option<PathBuf>,
    runtime_path: String,
    type_name: Option<String>,
    visibility: String,
}

impl Default for Config {
    fn default() -> Self {
        Config {
            load: load::Options::default(),
            #[cfg(feature = "robot-files")]
            robot_file: None,
            out_dir: None,
            runtime_path: "::tip_runtime".to_owned(),
            type_name: None,
            visibility: "pub".to_owned(),
        }
    }
}

impl Config {
    /// Creates the standard settings.
    pub fn new() -> Self {
        Config::default()
    }

    /// Sets the robot that programs are checked for; TITAN VIII if not called.
    pub fn robot(&mut self, robot: Robot) -> &mut Self {
        self.load.robot = robot;
        self
    }

    /// Sets the robot that programs are checked for, as a file describes it, or one of those that are
    /// [`published`], by its name; it takes the place of [`robot`](Self::robot).
    #[cfg(feature = "robot-files")]
    pub fn robot_file(&mut self, path: impl Into<PathBuf>) -> &mut Self {
        self.robot_file = Some(path.into());
        self
    }

    /// Sets the folder for generated files; Cargo's `OUT_DIR` if not called.
    pub fn out_dir(&mut self, folder: impl Into<PathBuf>) -> &mut Self {
        self.out_dir = Some(folder.into());
        self
    }

    /// Sets the version number that programs must have on their first line; 3.1 if not called.
    pub fn tip_version(&mut self, version: f64) -> &mut Self {
        self.load.tip_version = Some(version);
        self
    }

    /// Sets the encoding of sources; detected if not called.
    pub fn encoding(&mut self, encoding: Encoding) -> &mut Self {
        self.load.encoding = encoding;
        self
    }

    /// Sets the path under which generated code finds the crate `tip-runtime`; `::tip_runtime` if not called.
    pub fn runtime_path(&mut self, path: impl Into<String>) -> &mut Self {
        self.runtime_path = path.into();
        self
    }

    /// Sets the name of the generated type; the file's name in UpperCamelCase if not called. For one program only.
    pub fn type_name(&mut self, name: impl Into<String>) -> &mut Self {
        self.type_name = Some(name.into());
        self
    }

    /// Sets the visibility of the generated type, such as `pub(crate)` or nothing; `pub` if not called.
    pub fn visibility(&mut self, visibility: impl Into<String>) -> &mut Self {
        self.visibility = visibility.into();
        self
    }

    /// Compiles each program to a file of its own and reports to Cargo inputs and errors.
    ///
    /// # Errors
    /// The errors of every program that has some; a setting or file that cannot be used.
    pub fn compile(&self, paths: &[impl AsRef<Path>]) -> Result<(), BuildError> {
        let paths: Vec<&Path> = paths.iter().map(AsRef::as_ref).collect();
        let mut report = Report::begin();
        let outcome = self.generate(&paths, &mut report);
        report.tell_cargo();
        outcome
    }

    /// Writes the model of a described robot to a file of its own, `$OUT_DIR/<file's stem>.rs`: a constant
    /// named after the file, in capitals, unless [`type_name`](Self::type_name) names it.
    ///
    /// ```no_run
    /// fn main() -> Result<(), tipc::BuildError> {
    ///     // `HEXAPOD`, a `Model<6, 3>`, and the program `March` that runs on it.
    ///     tipc::Config::new().compile_robot("hexapod.toml")?;
    ///     tipc::Config::new().robot_file("hexapod.toml").compile(&["march.prg"])
    /// }
    /// ```
    ///
    /// # Errors
    /// The errors of the description; a setting or file that cannot be used.
    #[cfg(feature = "robot-files")]
    pub fn compile_robot(&self, path: impl AsRef<Path>) -> Result<(), BuildError> {
        let mut report = Report::begin();
        let outcome = self.generate_robot(path.as_ref(), &mut report);
        report.tell_cargo();
        outcome
    }

    fn generate(&self, paths: &[&Path], report: &mut Report) -> Result<(), BuildError> {
        let emit_options = self.emit_options(paths.len())?;
        let folder = out_dir(self.out_dir.as_deref())?;
        let outputs = outputs(paths, &folder)?;
        let load = self.load(report)?;
        for (output, input) in outputs {
            report.depends_on(input)?;
            claim(&output, input)?;
            let Some(program) = program(input, &load, report) else {
                continue;
            };
            let text = emit::pretty(&program, &emit_options).map_err(|error| no_rust(&error))?;
            write_if_changed(&output, &text)?;
        }
        report.outcome()
    }

    #[cfg(feature = "robot-files")]
    fn generate_robot(&self, path: &Path, report: &mut Report) -> Result<(), BuildError> {
        let emit_options = self.emit_options(1)?;
        let folder = out_dir(self.out_dir.as_deref())?;
        if let Some(description) = describe(path, report)? {
            let outputs = outputs(&[path], &folder)?;
            for output in outputs.keys() {
                claim(output, path)?;
                let text = description
                    .pretty(&emit_options)
                    .map_err(|error| no_rust(&error))?;
                write_if_changed(output, &text)?;
            }
        }
        report.outcome()
    }

    /// Returns the options for loading programs: with the robot that the file describes, if there is one.
    #[cfg(feature = "robot-files")]
    fn load(&self, report: &mut Report) -> Result<load::Options, BuildError> {
        let mut load = self.load;
        if let Some(path) = &self.robot_file {
            match describe(path, report)? {
                Some(description) => load.robot = description.robot(),
                None => report.outcome()?,
            }
        }
        Ok(load)
    }

    #[cfg(not(feature = "robot-files"))]
    fn load(&self, _: &mut Report) -> Result<load::Options, BuildError> {
        Ok(self.load)
    }

    fn emit_options(&self, programs: usize) -> Result<emit::Options, BuildError> {
        if self.type_name.is_some() && programs > 1 {
            return Err(BuildError::setting(Building::OneType));
        }
        let name = self
            .type_name
            .as_deref()
            .map(|name| syn::parse_str(name).map_err(|error| no_such_rust(name, &error)));
        Ok(emit::Options {
            name: name.transpose()?,
            visibility: tokens::<syn::Visibility>(&self.visibility)?,
            runtime: tokens::<syn::Path>(&self.runtime_path)?,
            ..emit::Options::default()
        })
    }
}

fn program(input: &Path, options: &load::Options, report: &mut Report) -> Option<Program> {
    let name = input.display().to_string();
    let loaded = match embed::read_file(input, embed::LIMIT) {
        Ok(bytes) => load(&name, &bytes, options),
        Err(reason) => unreadable(&name, reason),
    };
    report.add_all(&loaded);
    loaded.program
}

#[cfg(feature = "robot-files")]
fn describe(path: &Path, report: &mut Report) -> Result<Option<Description>, BuildError> {
    if let Some(robot) = path.to_str().and_then(published::find) {
        return Ok(robot.read().map_err(|loaded| report.add_all(&loaded)).ok());
    }
    report.depends_on(path)?;
    let name = path.display().to_string();
    let described = match embed::read_file(path, embed::LIMIT) {
        Ok(bytes) => description::parse(&name, &bytes),
        Err(reason) => Err(Box::new(unreadable(&name, reason))),
    };
    Ok(described.map_err(|loaded| report.add_all(&loaded)).ok())
}

/// Report to Cargo.
#[derive(Default)]
struct Report {
    lang: Lang,
    lines: Vec<String>,
    /// Each error, rendered for people.
    errors: Vec<String>,
}

impl Report {
    /// Begins a report in the language that the environment asks for.
    fn begin() -> Self {
        let asked = env::var(embed::LANG).unwrap_or_default();
        Report {
            lang: Lang::of(&asked),
            ..Report::default()
        }
    }

    #[expect(clippy::disallowed_macros, reason = "this is how Cargo is informed")]
    fn tell_cargo(&self) {
        println!("cargo::rerun-if-env-changed={}", embed::LANG);
        for line in &self.lines {
            println!("cargo::{line}");
        }
    }

    /// Has Cargo watch a file. A line break in its path would be another line to Cargo.
    fn depends_on(&mut self, input: &Path) -> Result<(), BuildError> {
        let path = input.display().to_string();
        if path.contains(['\n', '\r']) {
            let path = emit::in_comment(&path).into();
            return Err(BuildError::setting(Building::LineBreak { path }));
        }
        self.lines.push(format!("rerun-if-changed={path}"));
        Ok(())
    }

    fn outcome(&self) -> Result<(), BuildError> {
        match self.errors.is_empty() {
            true => Ok(()),
            false => Err(BuildError::programs(&self.errors)),
        }
    }

    fn add_all(&mut self, loaded: &Loaded) {
        for diagnostic in loaded.errors() {
            self.add(&loaded.source, diagnostic);
        }
    }

    fn add(&mut self, source: &Source, diagnostic: &Diagnostic) {
        let style = Style::default().lang(self.lang);
        self.errors.push(render::human(source, diagnostic, style));
        let line = emit::in_comment(&render::short(source, diagnostic, self.lang));
        self.lines.push(format!("error={line}"));
    }
}

/// Returns each program with the file that it compiles to.
fn outputs<'a>(
    paths: &[&'a Path],
    folder: &Path,
) -> Result<BTreeMap<PathBuf, &'a Path>, BuildError> {
    let mut outputs = BTreeMap::new();
    for path in paths {
        let mut name = path.file_stem().ok_or_else(|| no_file(path))?.to_owned();
        name.push(".rs");
        let output = folder.join(name);
        if let Some(other) = outputs.insert(output, *path) {
            return Err(same_output(other, path));
        }
    }
    Ok(outputs)
}

fn same_output(one: &Path, other: &Path) -> BuildError {
    BuildError::setting(Building::SameOutput {
        one: one.display().to_string().into(),
        other: other.display().to_string().into(),
    })
}

/// Returns the tokens of a setting that must be a `T`.
fn tokens<T: syn::parse::Parse>(text: &str) -> Result<TokenStream, BuildError> {
    syn::parse_str::<T>(text).map_err(|error| no_such_rust(text, &error))?;
    text.parse().map_err(|error| no_such_rust(text, &error))
}

/// Creates the error for a setting that is not Rust.
fn no_such_rust(text: &str, error: &dyn Display) -> BuildError {
    BuildError::setting(Building::NoRust {
        text: text.to_owned(),
        error: error.to_string().into(),
    })
}

/// Settings that make no Rust file.
fn no_rust(error: &dyn Display) -> BuildError {
    let error = error.to_string().into();
    BuildError::setting(Building::Rust { error })
}

fn no_file(path: &Path) -> BuildError {
    let path = path.display().to_string().into();
    BuildError::setting(Building::NoFile { path })
}

fn unreadable(name: &str, reason: Reading) -> Loaded {
    let (source, _) = Source::decode(name, b"", Encoding::Utf8);
    let finding = Diagnostic::new(Code::FileNotFound, Span::default(), reason);
    Loaded::refused(source, vec![finding.about(name)])
}

/// Error of a failed generation. It displays every error with its location in the source.
pub struct BuildError {
    message: String,
}

impl BuildError {
    /// Creates the error for a setting of [`Config`](self::Config) that makes no sense.
    pub(super) fn setting(message: Building) -> Self {
        BuildError {
            message: message.to_string(),
        }
    }

    /// Programs with errors, each one rendered.
    pub(super) fn programs(errors: &[String]) -> Self {
        BuildError {
            message: errors.join("\n"),
        }
    }
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// Formats like `Display`: a build script that returns the error prints its `Debug`.
impl fmt::Debug for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl Error for BuildError {}

/// Files that this build script generated so far, each with its source.
static GENERATED: Mutex<BTreeMap<PathBuf, PathBuf>> = Mutex::new(BTreeMap::new());

/// Returns the folder of generated files.
fn out_dir(chosen: Option<&Path>) -> Result<PathBuf, BuildError> {
    match (chosen, env::var_os("OUT_DIR")) {
        (Some(folder), _) => Ok(folder.to_owned()),
        (None, Some(folder)) => Ok(folder.into()),
        (None, None) => Err(BuildError::setting(Building::NoOutDir)),
    }
}

/// Refuses a file that another input of this build script is generated to already: it would be overwritten.
fn claim(output: &Path, input: &Path) -> Result<(), BuildError> {
    let mut generated = GENERATED.lock().unwrap_or_else(PoisonError::into_inner);
    let first = generated.entry(output.to_owned());
    let first = first.or_insert_with(|| input.to_owned());
    match first == input {
        true => Ok(()),
        false => Err(same_output(first, input)),
    }
}

/// Leaves a file with this very text alone, so that nothing is rebuilt because of it.
#[expect(
    clippy::disallowed_methods,
    reason = "a build script is where files are read and written"
)]
fn write_if_changed(path: &Path, text: &str) -> Result<(), BuildError> {
    if fs::read(path).is_ok_and(|old| old == text.as_bytes()) {
        return Ok(());
    }
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    folder
        .and_then(|()| fs::write(path, text))
        .map_err(|error| {
            BuildError::setting(Building::CannotWrite {
                path: path.display().to_string().into(),
                error: error.to_string().into(),
            })
        })
}

#[cfg(test)]
mod tests;
