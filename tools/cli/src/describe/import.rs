//! `tip robot import`: a description of a URDF file.

use super::foot::{Feet, feet};
use super::{Status, input, output, report};
use crate::choices::LangName;
use crate::error::Error;
use crate::message::{Using, Weight};
use crate::shown;
use crate::usage::Wrong;
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};
use tip_runtime::printable::Printable;
use tip_sim::urdf;
use tipc::embed::LIMIT;
use tipc::message::Lang;

/// `tip robot import`
#[derive(Debug, Args)]
#[command(
    after_help = "Each chain of revolute or continuous joints from the base to a last link becomes a leg; fixed joints are merged. The
foot is the link at the end, on a fixed joint, or what --foot says. A report on standard error lists what was assumed and what was dropped.
A CHAIN is named by one of its joints or links, or by what only its first joint's name has: FL for FL_hip_joint.

Examples:
  tip robot import quadruped.urdf -o quadruped.toml
  tip robot import dog.urdf --order FL,FR,RL,RR --skip head_pan_joint --stand 280 -o dog.toml
  tip robot import arm.urdf --foot hand=0.05,0,0.12 -o arm.toml

Exit status: 0 if the description is written, 1 otherwise."
)]
pub(crate) struct Import {
    /// The URDF file; xacro has to be expanded first
    #[arg(value_name = "FILE.urdf")]
    file: PathBuf,

    /// A link that is a chain's foot, where that is not the last one; with '=X,Y,Z' a place in its frame, in m; several with commas
    /// between them
    #[arg(long, value_name = "LINK[=X,Y,Z]", value_parser = feet)]
    foot: Vec<Feet>,

    /// Leave a chain out, such as an arm or a head; several with commas between them
    #[arg(long, value_name = "CHAIN", value_delimiter = ',')]
    skip: Vec<String>,

    /// The chains that become F1, F2, …, with commas between them; else by place, from front to rear and left before
    /// right
    #[arg(long, value_name = "CHAIN", value_delimiter = ',')]
    order: Vec<String>,

    /// The axis of the file that points up, if that is not z; forward is x, or -z where x points up
    #[arg(long, value_enum, value_name = "x|y|z")]
    up: Option<Up>,

    /// Begin with all feet so many mm below the robot frame, the body level; else in the middle of the limits
    #[arg(long, value_name = "HEIGHT", value_parser = height)]
    stand: Option<f64>,

    /// Write to a file instead of standard output
    #[arg(short, long, value_name = "OUT.toml")]
    out: Option<PathBuf>,

    /// The language of the report and of errors, if not that of the locale
    #[arg(long, value_enum, value_name = "en|ja")]
    lang: Option<LangName>,
}

/// An axis of the file.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Up {
    X,
    Y,
    Z,
}

impl Up {
    fn axis(self) -> urdf::Up {
        match self {
            Up::X => urdf::Up::X,
            Up::Y => urdf::Up::Y,
            Up::Z => urdf::Up::Z,
        }
    }
}

/// A height in mm.
fn height(text: &str) -> Result<f64, Wrong> {
    let number = text.trim().parse().ok();
    let height = number.filter(|height: &f64| height.is_finite() && *height > 0.0);
    height.ok_or_else(|| {
        Wrong(Using::NotAHeight {
            text: text.to_owned(),
        })
    })
}

/// Whether the name of a file says that it holds URDF.
pub(super) fn is_urdf(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending == "urdf")
}

/// The description that a URDF file makes; why there is none goes to standard error.
pub(super) fn read(path: &Path, options: &urdf::ImportOptions, lang: Lang) -> Option<urdf::Import> {
    let read = input::read(path, LIMIT).map_err(|reason| reason.in_lang(lang).to_string());
    let imported = read.and_then(|bytes| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let text = urdf::decode(&bytes);
        let imported = text.and_then(|text| urdf::import_with(&name, &text, options));
        imported.map_err(|refused| refused.message().in_lang(lang).to_string())
    });
    let complain = |reason: &String| {
        let error = Weight::Error.in_lang(lang);
        let (name, reason) = (Printable::line(path.display()), Printable::line(reason));
        report::complain(&format!("{error}: {name}: {reason}\n"));
    };
    imported.inspect_err(complain).ok()
}

/// Writes the description; the report goes to standard error.
pub(super) fn import(arguments: &Import) -> Result<Status, Error> {
    let path = &arguments.file;
    let options = urdf::ImportOptions {
        feet: arguments
            .foot
            .iter()
            .flat_map(|feet| feet.0.clone())
            .collect(),
        skip: arguments.skip.clone(),
        order: arguments.order.clone(),
        up: arguments.up.map(Up::axis),
        stand: arguments.stand,
    };
    let lang = shown::lang(arguments.lang);
    let Some(imported) = read(path, &options, lang) else {
        return Ok(Status::Failure);
    };
    match &arguments.out {
        Some(out) => {
            output::refuse_inputs(out, &[path])?;
            output::replace(out, &imported.toml)?;
        }
        None => output::print(&imported.toml)?,
    }
    let name = Printable::line(path.display());
    for line in &imported.report {
        let line = line.in_lang(lang);
        report::complain(&format!("{name}: {}\n", Printable::line(line)));
    }
    Ok(Status::Success)
}
