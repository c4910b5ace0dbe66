//! A program's compiled code beside the interpreter, where there is only its text: cargo builds both into a process of
//! their own, with the runtime of a project. `tip verify` is this and [`search::verify`].
//!
//! ```no_run
//! use tip_sim::verify::{Project, Subject};
//! use tip_sim::{Inputs, Robot, search, tipc};
//!
//! let source = std::fs::read("walk.prg")?;
//! let options = Robot::named("titan8")?.options();
//! let program = tip_lint::load("walk.prg", &source, &options).program.ok_or("it does not load")?;
//! let subject = Subject::new("walk.prg", &source, options, &program);
//! let mut engines = Project::find(None)?.engines(&subject)?;
//! match search::verify(&mut engines, &program, &Inputs::default(), 256) {
//!     Ok((tally, None)) => println!("{} runs agree", tally.runs()),
//!     Ok((_, Some(shortest))) => println!("they differ: {}", shortest.inputs),
//!     Err(failed) => println!("{failed:?}"),
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`search::verify`]: crate::search::verify
#![allow(clippy::disallowed_methods, reason = "packages are written for cargo")]

mod engines;
mod error;
mod package;
mod project;

pub use engines::Engines;
pub use error::NotBuilt;
pub use project::{Project, VERSION};

use package::Package;
use tip_runtime::plant::Scene;
use tipc::Options;
use tipc::description::Description;
use tipc::program::Program;

/// A program that loads, on a robot in its surroundings.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    pub(crate) name: &'a str,
    pub(crate) source: &'a [u8],
    pub(crate) options: Options,
    pub(crate) program: &'a Program,
    pub(crate) description: Option<&'a Description>,
    pub(crate) scene: Scene,
}

impl<'a> Subject<'a> {
    /// The program of these bytes; `name` and `options` are those that it was loaded with. The robot has a name, or
    /// [a description](Self::on).
    pub fn new(name: &'a str, source: &'a [u8], options: Options, program: &'a Program) -> Self {
        Subject {
            name,
            source,
            options,
            program,
            description: None,
            scene: Scene::EMPTY,
        }
    }

    /// On the robot of a description.
    #[must_use]
    pub fn on(self, description: &'a Description) -> Self {
        Subject {
            description: Some(description),
            ..self
        }
    }

    /// In a scene. One with objects is for a hand.
    #[must_use]
    pub fn with_scene(self, scene: Scene) -> Self {
        Subject { scene, ..self }
    }
}

impl Project {
    /// Builds both engines of a program, and starts them. Cargo talks to the user itself.
    ///
    /// # Errors
    /// The robot cannot use the scene, the package cannot be written or built, or it does not start.
    pub fn engines(&self, subject: &Subject<'_>) -> Result<Engines, NotBuilt> {
        let package = Package::new(subject, self)?;
        let manifest = package.write(self)?;
        Engines::start(&self.build(&manifest)?)
    }
}
