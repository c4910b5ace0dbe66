//! `tip new`: makes a crate with a robot that moves, a test and settings for editors.

mod bus;
mod files;
mod motion;
mod name;
mod origin;
mod template;

use super::choices::OutputOptions;
use super::error::Error;
use super::usage::BadValue;
use super::{Status, output};
use crate::message::{Making, Using};
use clap::Args;
use files::File;
use name::CratePath;
use origin::Origin;
use std::fmt::Write as _;
use std::path::PathBuf;
use template::{Choice, Template};
use tip_runtime::printable::Printable;
use tipc::language::Edition;
use tipc::message::Lang;

/// `tip new`
#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip new demo && cd demo && cargo run
  tip new grasper --robot hand
  tip new six --robot hexapod                 a description of six legs, to be changed
  tip new ours --robot robots/ours.toml       a robot of your own (docs/robots.md)
  tip new demo --edition 3.2                  a program that may have threads (docs/language.md)
  tip new drives --hardware                   with src/hardware.rs, for drives of your own
  tip new hexa --robot phantomx --hardware    with a bus of servos in robot.toml (docs/drives.md)
  tip new demo --workspace ../tip             depend on this checkout of the project

Exit status: 0 if the crate is made, 1 if not: then nothing is written; 2 if NAME cannot be the name of a crate.")]
pub(super) struct New {
    /// The name of the crate, or the path of a new folder with that name
    #[arg(value_name = "NAME")]
    place: CratePath,

    /// The robot: hexapod, a name or a file
    ///
    /// A name that 'tip robot list' shows, or a description in a file
    #[arg(long, value_name = "NAME|FILE.toml", default_value = "titan8")]
    robot: Choice,

    /// The edition, 3.1 or 3.2
    #[arg(long, value_name = "NUMBER", default_value = "3.1", value_parser = edition)]
    edition: Edition,

    /// Add a skeleton for drives of your own
    ///
    /// An implementation of the trait Hardware. A described robot gets a bus of servos too
    #[arg(long)]
    hardware: bool,

    /// The checkout of this project to depend on
    ///
    /// By default the one that tip was built from, or the published crates
    #[arg(long, value_name = "FOLDER")]
    workspace: Option<PathBuf>,

    #[command(flatten)]
    pub(super) output_options: OutputOptions,
}

/// Parses the number of an edition.
fn edition(text: &str) -> Result<Edition, BadValue> {
    let number = text.parse::<f64>();
    let mut all = Edition::ALL.iter().copied();
    let edition = all.find(|edition| number == Ok(edition.number()));
    edition.ok_or_else(|| {
        let text = text.to_owned();
        BadValue(Using::NoSuchEdition { text })
    })
}

/// Makes a crate.
pub(super) fn new(arguments: &New) -> Result<Status, Error> {
    let (place, lang) = (&arguments.place, arguments.output_options.lang());
    let failed = |reason: Making| Error::failed(reason, lang);
    let origin = Origin::find(arguments.workspace.as_deref(), place).map_err(failed)?;
    let refused = Error::refused(arguments.output_options);
    let template = arguments.robot.template().map_err(refused)?;
    let mut template = template.in_edition(arguments.edition);
    if arguments.hardware {
        template.description = template.description.take().map(bus::with_bus);
    }
    let files = files::crate_files(place, &template, &origin, arguments.hardware);
    files::write_crate(place, &files).map_err(failed)?;
    output::print(made(place, &template, &files, lang))?;
    Ok(Status::Success)
}

/// Returns the report: files, results of trying the motion, and the next commands.
fn made(place: &CratePath, template: &Template, files: &[File], lang: Lang) -> String {
    let folder = Printable::line(place.folder().display()).to_string();
    let robot = Printable::line(&template.robot).to_string();
    let made = Making::Made {
        folder: folder.clone().into(),
        robot,
    };
    let mut text = format!("{}\n", made.in_lang(lang));
    for file in files {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {}", file.name);
    }
    for tried in &template.motion.tried {
        let _ = writeln!(text, "{}", tried.in_lang(lang));
    }
    let next = Making::Next.in_lang(lang);
    let _ = writeln!(text, "{next}\n  cd {folder}\n  cargo run");
    text
}

/// Replaces the placeholders of a text.
fn fill(text: &str, placeholders: &[(&str, &str)]) -> String {
    let fill_one =
        |text: String, (name, value): &(&str, &str)| text.replace(&format!("<<{name}>>"), value);
    placeholders.iter().fold(text.to_owned(), fill_one)
}
