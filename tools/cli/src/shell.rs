//! `tip completions` and `tip man`: what shells and man show of the command itself.

use super::error::Error;
use super::{Arguments, Status, output};
use clap::{Args, CommandFactory};
use clap_complete::Shell;
use std::fs;
use std::path::PathBuf;

/// `tip completions`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tip completions bash > ~/.local/share/bash-completion/completions/tip
  tip completions zsh > ~/.zfunc/_tip
  tip completions fish > ~/.config/fish/completions/tip.fish")]
pub(super) struct Completions {
    /// The shell
    shell: Shell,
}

/// `tip man`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tip man -o ~/.local/share/man/man1")]
pub(super) struct Man {
    /// The folder for the pages, one for each command; it is made if need be
    #[arg(short, long, value_name = "DIR")]
    out: PathBuf,
}

/// Prints what a shell completes the command line with.
pub(super) fn completions(arguments: &Completions) -> Result<Status, Error> {
    let mut script = Vec::new();
    let mut command = Arguments::command();
    let name = command.get_name().to_owned();
    clap_complete::generate(arguments.shell, &mut command, name, &mut script);
    output::print(script)?;
    Ok(Status::Success)
}

/// Writes the pages of man.
pub(super) fn man(arguments: &Man) -> Result<Status, Error> {
    let folder = &arguments.out;
    let failed = |error: std::io::Error| Error::cannot_write(folder, error);
    fs::create_dir_all(folder).map_err(failed)?;
    clap_mangen::generate_to(Arguments::command(), folder).map_err(failed)?;
    Ok(Status::Success)
}
