//! Help of the command line: its Japanese texts, `tip completions` and `tip man`. The English texts are in the commands.

use crate::error::Error;
use crate::{Arguments, Status, output};
use clap::builder::{PossibleValue, StyledStr};
use clap::{Arg, Args, Command, CommandFactory};
use clap_complete::Shell;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use tipc::message::Lang;

/// The template of clap with Japanese words.
const TEMPLATE: &str = "{about-with-newline}\n使い方: {usage}\n\n{all-args}{after-help}";

/// Returns the command line with help in a language.
pub(super) fn command(lang: Lang) -> Command {
    let mut tip = Arguments::command();
    if lang == Lang::Japanese {
        // Adds the options and the command for help.
        tip.build();
        tip = translated(tip, "");
    }
    tip
}

/// Translates a command and its subcommands; `above` is the path of its parent, joined by `_`.
fn translated(command: Command, above: &str) -> Command {
    let name = command.get_name().to_owned();
    let about = command.get_about().map(line).unwrap_or_default();
    let path = match above {
        "" | "tip" => name,
        above => format!("{above}_{name}"),
    };
    let ending = endings().find(|(command, _)| *command == path);
    let below: Vec<String> = command.get_subcommands().map(name_of).collect();
    let command = command
        .help_template(TEMPLATE)
        .subcommand_help_heading("コマンド")
        .about(about)
        .after_help(ending.map_or("", |(_, text)| text.trim_end()))
        .mut_args(option);
    below.iter().fold(command, |command, name| {
        command.mut_subcommand(name, |command| translated(command, &path))
    })
}

fn name_of(command: &Command) -> String {
    command.get_name().to_owned()
}

/// Translates an option or argument, with its values and its default.
fn option(arg: Arg) -> Arg {
    let text = arg.get_help().map(line).unwrap_or_default();
    let (mut short, mut long) = (text.clone(), text);
    if arg.get_action().takes_values() {
        let values = arg.get_possible_values();
        let names: Vec<&str> = values.iter().map(PossibleValue::get_name).collect();
        let names = names.join(", ");
        let defaults = arg.get_default_values().iter();
        let default: Vec<_> = defaults.map(|value| value.to_string_lossy()).collect();
        let default = default.join(", ");
        if values.iter().any(|value| value.get_help().is_some()) {
            let _ = write!(long, "\n\n値:");
            for value in &values {
                let help = value.get_help().map(line).unwrap_or_default();
                let _ = write!(long, "\n- {}: {help}", value.get_name());
            }
        } else if !names.is_empty() {
            let _ = write!(long, "\n\n[値: {names}]");
        }
        if !names.is_empty() {
            let _ = write!(short, " [値: {names}]");
        }
        if !default.is_empty() {
            let _ = write!(short, " [既定値: {default}]");
            let _ = write!(long, "\n\n[既定値: {default}]");
        }
    }
    let (heading, arg) = match arg.get_index() {
        // Otherwise clap sorts them by name.
        Some(place) => ("引数", arg.display_order(place)),
        None => ("オプション", arg),
    };
    arg.help(short)
        .long_help(long)
        .help_heading(heading)
        .hide_default_value(true)
        .hide_possible_values(true)
}

/// Translates a sentence; one without a row stays.
fn line(english: &StyledStr) -> String {
    let english = english.to_string();
    let row = lines().find(|(row, _)| *row == english);
    row.map_or(english, |(_, japanese)| japanese.to_owned())
}

const LINES: &str = include_str!("../help/lines.txt");
const ENDINGS: &str = include_str!("../help/endings.txt");

/// Returns the sentences of commands, options and values, in English and Japanese.
fn lines() -> impl Iterator<Item = (&'static str, &'static str)> {
    let rows = LINES.split("\n\n").filter(|row| !row.starts_with('#'));
    rows.filter_map(|row| row.trim_end().split_once('\n'))
}

/// Returns the texts below the options, by command.
fn endings() -> impl Iterator<Item = (&'static str, &'static str)> {
    let texts = ENDINGS.trim_start_matches("== ").split("\n== ");
    texts.filter_map(|text| text.split_once('\n'))
}

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
    /// The folder for the pages, one for each command; it is created if necessary
    #[arg(short, long, value_name = "DIR")]
    out: PathBuf,
}

/// Prints the completion script of a shell.
pub(super) fn completions(arguments: &Completions) -> Result<Status, Error> {
    let mut script = Vec::new();
    let mut command = Arguments::command();
    let name = command.get_name().to_owned();
    clap_complete::generate(arguments.shell, &mut command, name, &mut script);
    output::print(script)?;
    Ok(Status::Success)
}

/// Writes the manual pages.
pub(super) fn man(arguments: &Man) -> Result<Status, Error> {
    let folder = &arguments.out;
    let failed = |error: std::io::Error| Error::cannot_write(folder, error);
    fs::create_dir_all(folder).map_err(failed)?;
    clap_mangen::generate_to(Arguments::command(), folder).map_err(failed)?;
    Ok(Status::Success)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    /// Returns all commands with their paths.
    fn all(lang: Lang) -> Vec<(String, Command)> {
        let mut tip = command(lang);
        tip.build();
        let mut found = Vec::new();
        collect("tip", &tip, &mut found);
        found
    }

    fn collect(path: &str, command: &Command, found: &mut Vec<(String, Command)>) {
        found.push((path.to_owned(), command.clone()));
        for below in command.get_subcommands() {
            let name = below.get_name();
            let path = match path {
                "tip" => name.to_owned(),
                path => format!("{path}_{name}"),
            };
            if name != "help" {
                collect(&path, below, found);
            }
        }
    }

    /// Returns the sentences of commands, options and values.
    fn sentences(commands: &[(String, Command)]) -> BTreeSet<String> {
        let texts = commands.iter().flat_map(|(_, command)| {
            let abouts = command.get_subcommands().chain([command]);
            let abouts: Vec<_> = abouts.filter_map(Command::get_about).cloned().collect();
            let arguments = command.get_arguments().flat_map(|arg| {
                let values = match arg.get_action().takes_values() {
                    true => arg.get_possible_values(),
                    false => Vec::new(),
                };
                let values: Vec<_> = values
                    .iter()
                    .filter_map(|it| it.get_help().cloned())
                    .collect();
                arg.get_help().cloned().into_iter().chain(values)
            });
            abouts.into_iter().chain(arguments).collect::<Vec<_>>()
        });
        texts.map(|text| text.to_string()).collect()
    }

    #[test]
    fn every_sentence_has_a_row_and_every_row_a_sentence() {
        let said = sentences(&all(Lang::English));
        let rows: BTreeSet<String> = lines().map(|(english, _)| english.to_owned()).collect();
        let missing: Vec<_> = said.difference(&rows).collect();
        let unused: Vec<_> = rows.difference(&said).collect();
        assert_eq!((missing, unused), (Vec::new(), Vec::new()));
        assert_eq!(rows.len(), lines().count(), "a row is duplicated");
    }

    /// Returns the command lines of examples, without their explanations.
    fn examples(text: &str) -> Vec<&str> {
        let lines = text.lines().filter(|line| line.starts_with("  tip "));
        lines
            .map(|line| line.trim_start().split("   ").next().unwrap_or_default())
            .map(|line| line.split("  ").next().unwrap_or_default())
            .collect()
    }

    /// Returns the options that a text names.
    fn options(text: &str) -> BTreeSet<&str> {
        let words = text.split(|char: char| !char.is_ascii_alphanumeric() && char != '-');
        words.filter(|word| word.starts_with("--")).collect()
    }

    #[test]
    fn both_languages_show_the_same_examples_and_name_the_same_options() {
        let mut texts = 0;
        for (path, command) in all(Lang::English) {
            let english = command.get_after_help().map(ToString::to_string);
            let row = endings().find(|(name, _)| *name == path);
            assert_eq!(english.is_some(), row.is_some(), "{path}");
            if let (Some(english), Some((_, japanese))) = (english, row) {
                assert_eq!(examples(&english), examples(japanese), "{path}");
                assert_eq!(options(&english), options(japanese), "{path}");
                texts += 1;
            }
        }
        assert_eq!(texts, endings().count());
    }

    #[test]
    fn the_japanese_help_says_nothing_in_english() {
        for (path, mut command) in all(Lang::Japanese) {
            for text in [command.render_help(), command.render_long_help()] {
                let text = text.to_string();
                assert!(text.contains("使い方: tip"), "{path}: {text}");
                for word in [
                    "Usage",
                    "Options:",
                    "Arguments:",
                    "Commands:",
                    "Print",
                    "default",
                    "possible",
                ] {
                    assert!(!text.contains(word), "{path}: {word}: {text}");
                }
            }
        }
    }

    #[test]
    fn arguments_stand_in_their_order() {
        let commands = all(Lang::Japanese);
        let (_, mut emit) = commands
            .into_iter()
            .find(|(path, _)| path == "emit")
            .expect("a command");
        let text = emit.render_help().to_string();
        let places = ["  <FORM>", "  <FILE>"].map(|name| text.find(name));
        assert!(places[0].is_some() && places[0] < places[1], "{text}");
    }
}
