//! The help of the command line in Japanese. The English one is what the commands say of themselves.

use super::Arguments;
use clap::builder::{PossibleValue, StyledStr};
use clap::{Arg, Command, CommandFactory};
use std::fmt::Write as _;
use tipc::message::Lang;

/// As clap has it, but for the words that it says in English only.
const TEMPLATE: &str = "{about-with-newline}\n使い方: {usage}\n\n{all-args}{after-help}";

/// The command line with its help in a language.
pub(super) fn command(lang: Lang) -> Command {
    let mut tip = Arguments::command();
    if lang == Lang::Japanese {
        // Adds what every command has: options and a command for help.
        tip.build();
        tip = translated(tip, "");
    }
    tip
}

/// A command and those below it; `above` is what is typed before its name, joined by `_`.
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

/// An option or argument, with what its values and its default are.
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
        // Else they stand in the order of their names.
        Some(place) => ("引数", arg.display_order(place)),
        None => ("オプション", arg),
    };
    arg.help(short)
        .long_help(long)
        .help_heading(heading)
        .hide_default_value(true)
        .hide_possible_values(true)
}

/// A sentence in Japanese; as it is where it has no row.
fn line(english: &StyledStr) -> String {
    let english = english.to_string();
    let row = lines().find(|(row, _)| *row == english);
    row.map_or(english, |(_, japanese)| japanese.to_owned())
}

const LINES: &str = include_str!("../help/lines.txt");
const ENDINGS: &str = include_str!("../help/endings.txt");

/// What a command, an option or a value is said to be in English, and in Japanese.
fn lines() -> impl Iterator<Item = (&'static str, &'static str)> {
    let rows = LINES.split("\n\n").filter(|row| !row.starts_with('#'));
    rows.filter_map(|row| row.trim_end().split_once('\n'))
}

/// A command, its words joined by `_`, and what stands below its options: examples, and what it does and answers.
fn endings() -> impl Iterator<Item = (&'static str, &'static str)> {
    let texts = ENDINGS.trim_start_matches("== ").split("\n== ");
    texts.filter_map(|text| text.split_once('\n'))
}

#[cfg(test)]
mod tests;
