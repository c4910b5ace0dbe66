//! Compiles and runs a batch.

use crate::batch::Effort;
use random_programs::{Specimen, Tamper, rust};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, io};

/// Build settings of a batch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flavour {
    /// The engines optimised, the programs not: the quickest in all.
    Quick,
    /// The programs optimised as users have them.
    Optimised,
    /// Nothing optimised, and arithmetic overflow checked.
    Debug,
}

impl Flavour {
    /// The arguments of cargo, and the folder of the profile.
    fn profile(self) -> (&'static [&'static str], &'static str) {
        match self {
            Flavour::Quick => (&["--release"], "release"),
            Flavour::Optimised => (&["--profile", "optimised"], "optimised"),
            Flavour::Debug => (&[], "debug"),
        }
    }
}

/// Folders of builds: this package, and a folder for generated files.
#[derive(Clone, Debug)]
pub struct Workshop {
    /// The folder of this package.
    pub package: PathBuf,
    /// Cargo's target folder for batches.
    pub target: PathBuf,
    /// Changes generated code; tests of the campaign plant faults by it.
    pub tamper: Tamper,
}

impl Workshop {
    /// In the target folder of this package, or the one that `CARGO_TARGET_DIR` names.
    pub fn new() -> Self {
        let package = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
        let target =
            std::env::var_os("CARGO_TARGET_DIR").map_or(package.join("target"), PathBuf::from);
        Workshop {
            target,
            package,
            tamper: |code| code,
        }
    }

    /// Folder of generated code and figures.
    pub fn papers(&self) -> PathBuf {
        self.target.join("campaign")
    }

    /// Compiles the programs, runs them, and gives back what was printed.
    ///
    /// # Errors
    /// A program does not load, its code does not compile, or the batch dies.
    pub fn run(
        &self,
        specimens: &[Specimen],
        flavour: Flavour,
        effort: &Effort,
    ) -> io::Result<String> {
        let code = rust(specimens, self.tamper).map_err(io::Error::other)?;
        let file = self.papers().join("batch.rs");
        fs::create_dir_all(self.papers())?;
        fs::write(&file, code)?;
        let (options, folder) = flavour.profile();
        self.build(&file, options)?;
        let program = self.target.join(folder).join("batch");
        printed(Command::new(program).args(effort.arguments()))
    }

    fn build(&self, file: &Path, options: &[&str]) -> io::Result<()> {
        let cargo = std::env::var_os("CARGO").unwrap_or("cargo".into());
        let mut command = Command::new(cargo);
        command
            .args([
                "build",
                "--quiet",
                "--offline",
                "--jobs",
                "1",
                "--package",
                "batch",
            ])
            .args(options);
        command
            .current_dir(&self.package)
            .env("CARGO_TARGET_DIR", &self.target)
            .env("BATCH", file);
        printed(&mut command).map(|_| ())
    }
}

impl Default for Workshop {
    fn default() -> Self {
        Self::new()
    }
}

fn printed(command: &mut Command) -> io::Result<String> {
    let output = command.output()?;
    match output.status.success() {
        true => Ok(String::from_utf8_lossy(&output.stdout).into_owned()),
        false => {
            let errors = String::from_utf8_lossy(&output.stderr);
            Err(io::Error::other(format!(
                "{command:?}: {}\n{errors}",
                output.status
            )))
        }
    }
}
