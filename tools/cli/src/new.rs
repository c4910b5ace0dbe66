//! `tip new`: a crate that moves a robot at once, with a test and an editor's configuration.

mod bend;
mod files;
mod folder;
mod gait;
mod kit;
mod name;
mod origin;

use super::error::Error;
use super::shown::Shown;
use super::{Status, output, report};
use crate::message::Making;
use clap::Args;
use files::File;
use kit::{Choice, Kit};
use name::Place;
use origin::Origin;
use std::fmt::Write as _;
use std::path::PathBuf;
use tip_runtime::printable::Printable;
use tipc::message::Lang;

/// `tip new`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tip new demo && cd demo && cargo run
  tip new grasper --robot hand
  tip new six --robot hexapod                 a description of six legs, to be changed
  tip new ours --robot robots/ours.toml       a robot of your own (docs/robots.md)
  tip new drives --hardware                   with src/hardware.rs, for drives of your own
  tip new demo --workspace ../tip             depend on this checkout of the project

Exit status: 0 if the crate is made, 1 if not: then nothing is written; 2 if NAME cannot be the name of a crate.")]
pub(super) struct New {
    /// The crate's name, or a new folder that ends with it
    #[arg(value_name = "NAME")]
    place: Place,

    /// The robot: hexapod, a name that 'tip robot list' shows, or a description
    #[arg(long, value_name = "NAME|FILE.toml", default_value = "titan8")]
    robot: Choice,

    /// Add a skeleton for drives of your own: the trait Hardware
    #[arg(long)]
    hardware: bool,

    /// The checkout of this project to depend on; else the one that tip was built from, else the published crates
    #[arg(long, value_name = "FOLDER")]
    workspace: Option<PathBuf>,

    #[command(flatten)]
    pub(super) shown: Shown,
}

/// Makes the crate.
pub(super) fn new(arguments: &New) -> Result<Status, Error> {
    let (place, lang) = (&arguments.place, arguments.shown.lang());
    let refused = |reason: Making| Error::Failed(reason.in_lang(lang).to_string());
    let origin = Origin::find(arguments.workspace.as_deref(), place).map_err(refused)?;
    let kit = match arguments.robot.kit() {
        Ok(kit) => kit,
        Err(loaded) => {
            report::findings(&loaded, arguments.shown);
            return Ok(Status::Failure);
        }
    };
    let files = files::of(place, &kit, &origin, arguments.hardware);
    folder::write(place, &files).map_err(refused)?;
    output::print(made(place, &kit, &files, lang))?;
    Ok(Status::Success)
}

/// What was made, and what to do with it.
fn made(place: &Place, kit: &Kit, files: &[File], lang: Lang) -> String {
    let folder = Printable::line(place.folder().display()).to_string();
    let robot = Printable::line(&kit.robot).to_string();
    let made = Making::Made {
        folder: folder.clone().into(),
        robot,
    };
    let mut text = format!("{}\n", made.in_lang(lang));
    for file in files {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {}", file.name);
    }
    for tried in &kit.motion.tried {
        let _ = writeln!(text, "{}", tried.in_lang(lang));
    }
    let next = Making::Next.in_lang(lang);
    let _ = writeln!(text, "{next}\n  cd {folder}\n  cargo run");
    text
}

/// The text with its holes filled.
fn fill(text: &str, holes: &[(&str, &str)]) -> String {
    let fill_one =
        |text: String, (name, value): &(&str, &str)| text.replace(&format!("<<{name}>>"), value);
    holes.iter().fold(text.to_owned(), fill_one)
}
