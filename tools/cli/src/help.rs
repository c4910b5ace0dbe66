//! Help of the command line: `--help` on one screen, `tip help COMMAND` with examples, and their Japanese texts. The English texts
//! are in the commands.

use crate::commands::{self, Group, grammar};
use crate::output::width;
use clap::builder::PossibleValue;
use clap::{Arg, Command};
use std::fmt::Write as _;
use std::sync::LazyLock;
use tipc::message::Lang;

/// The template of clap with Japanese words.
const TEMPLATE: &str = "{about-with-newline}\n使い方: {usage}\n\n{all-args}{after-help}";

/// Returns the command line with help in a language.
pub(super) fn command(lang: Lang) -> Command {
    let mut tip = grammar();
    // Adds the command for help, and the options to each command.
    tip.build();
    let tip = shaped(tip, "", lang);
    let groups = groups(&tip, lang);
    let more = lang.pick(
        "'tip help COMMAND' tells more of a command, 'tip help' shows a first session.",
        "'tip help コマンド' で各コマンドの詳細を、'tip help' でまず試す手順を表示する。",
    );
    let (usage, options) = (
        lang.pick("Usage", "使い方"),
        lang.pick("Options", "オプション"),
    );
    tip.help_template(format!(
        "{{about-with-newline}}\n{usage}: {{usage}}\n\n{groups}\n{options}:\n{{options}}{{after-help}}"
    ))
    .after_help(more)
}

/// Returns the list of commands, group by group.
fn groups(tip: &Command, lang: Lang) -> String {
    let mut text = String::new();
    for group in Group::ALL {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{}:", group.heading(lang));
        let names = commands::of_group(group);
        for command in names.filter_map(|name| tip.find_subcommand(name)) {
            let about = command.get_about().map(ToString::to_string);
            let (name, about) = (command.get_name(), about.unwrap_or_default());
            let _ = writeln!(text, "  {name:<11}  {about}");
        }
    }
    text
}

/// Puts the help of a command and its subcommands into its form; `above` is the path of its parent, joined by `_`.
fn shaped(command: Command, above: &str, lang: Lang) -> Command {
    let name = command.get_name().to_owned();
    let path = match (above, name.as_str()) {
        // clap makes the command for help at each level.
        ("" | "tip", _) | (_, "help") => name,
        _ => format!("{above}_{name}"),
    };
    let below: Vec<String> = command.get_subcommands().map(name_of).collect();
    let mut command = command.mut_args(|arg| option(arg, &path, lang));
    let english = command.get_after_long_help().map(ToString::to_string);
    if let Some(english) = english {
        let ending = in_lang(english, &path, "ending", lang);
        let words = path.replace('_', " ");
        let more = lang.pick(
            "'tip help COMMAND' tells more: examples, values, exit statuses.",
            "'tip help COMMAND' で例・値・終了コードなどの詳細を表示する。",
        );
        let more = more.replace("COMMAND", &words);
        let examples = first_examples(&ending);
        command = command
            .after_help(format!("{examples}{more}"))
            .after_long_help(ending);
    }
    if lang == Lang::Japanese {
        let about = command.get_about().map(ToString::to_string);
        let about = in_lang(about.unwrap_or_default(), &path, "about", lang);
        command = command
            .help_template(TEMPLATE)
            .subcommand_help_heading("コマンド")
            .about(about);
    }
    below.iter().fold(command, |command, name| {
        command.mut_subcommand(name, |command| shaped(command, &path, lang))
    })
}

/// Number of examples of short help.
const SHORT: usize = 4;

/// Returns the first examples of a text that fit a terminal, below their heading.
fn first_examples(text: &str) -> String {
    let is_heading = |line: &&str| matches!(*line, "Example:" | "Examples:" | "例:");
    let Some(heading) = text.lines().find(is_heading) else {
        return String::new();
    };
    let lines = text.lines().skip_while(|line| *line != heading).skip(1);
    let lines = lines.take_while(|line| line.starts_with("  "));
    let lines = lines.map(fitting).filter(|line| width(line) <= COLUMNS);
    let lines: String = lines.take(SHORT).map(|line| format!("{line}\n")).collect();
    match lines.is_empty() {
        true => String::new(),
        false => format!("{heading}\n{lines}\n"),
    }
}

/// Returns a line of an example, without its explanation if a terminal is too narrow for both.
fn fitting(line: &str) -> &str {
    let indent = line.len() - line.trim_start().len();
    match line[indent..].find("  ") {
        Some(gap) if width(line) > COLUMNS => &line[..indent + gap],
        _ => line,
    }
}

/// Columns of a terminal.
const COLUMNS: usize = 80;

fn name_of(command: &Command) -> String {
    command.get_name().to_owned()
}

/// Puts the help of an option or argument into its form: one line, or all paragraphs with values and default.
fn option(arg: Arg, path: &str, lang: Lang) -> Arg {
    let id = arg.get_id().as_str();
    let english = arg.get_long_help().or(arg.get_help());
    let english = english.map(ToString::to_string).unwrap_or_default();
    let mut long = in_lang(english, path, id, lang);
    let mut short = long.split("\n\n").next().unwrap_or_default().to_owned();
    if arg.get_action().takes_values() {
        let values = arg.get_possible_values();
        let names: Vec<&str> = values.iter().map(PossibleValue::get_name).collect();
        let names = names.join(", ");
        let defaults = arg.get_default_values().iter();
        let default: Vec<_> = defaults.map(|value| value.to_string_lossy()).collect();
        let default = default.join(", ");
        let (all, usual) = (lang.pick("values", "値"), lang.pick("default", "既定値"));
        if values.iter().any(|value| value.get_help().is_some()) {
            let _ = write!(long, "\n\n{all}:");
            for value in &values {
                let name = value.get_name();
                let help = value.get_help().map(ToString::to_string);
                let help = in_lang(help.unwrap_or_default(), path, &value_key(id, name), lang);
                let _ = write!(long, "\n- {name}: {help}");
            }
        } else if !names.is_empty() {
            let _ = write!(long, "\n\n[{all}: {names}]");
        }
        if !default.is_empty() {
            if names.is_empty() {
                let _ = write!(short, " [{usual}: {default}]");
            }
            let _ = write!(long, "\n\n[{usual}: {default}]");
        }
    }
    let arg = match (lang, arg.get_index()) {
        // Otherwise clap sorts them by name.
        (Lang::Japanese, Some(place)) => arg.display_order(place).help_heading("引数"),
        (Lang::Japanese, None) => arg.help_heading("オプション"),
        _ => arg,
    };
    arg.help(short)
        .long_help(long)
        .hide_default_value(true)
        .hide_possible_values(true)
}

/// Returns a text of the help in a language; one without a Japanese text stays.
fn in_lang(english: String, path: &str, key: &str, lang: Lang) -> String {
    match lang {
        Lang::Japanese => japanese(path, key).map_or(english, str::to_owned),
        _ => english,
    }
}

/// Returns the key of the text of an argument's value.
fn value_key(argument: &str, value: &str) -> String {
    format!("{argument}={value}")
}

/// The Japanese help: a table for each command, and one for arguments with the same text in several commands.
static JAPANESE: LazyLock<toml::Table> =
    LazyLock::new(|| include_str!("../help/ja.toml").parse().unwrap_or_default());

/// The table of arguments with the same text in several commands.
const SHARED: &str = "shared";

/// Returns the Japanese text of a command's `about`, `ending`, argument or value.
fn japanese(path: &str, key: &str) -> Option<&'static str> {
    let own = JAPANESE.get(path).and_then(|table| table.get(key));
    let text = own.or_else(|| JAPANESE.get(SHARED)?.get(key));
    text?.as_str().map(str::trim_end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::{BTreeMap, BTreeSet};

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

    /// Returns the English texts of a command by their keys.
    fn texts(command: &Command) -> Vec<(String, String)> {
        let about = command
            .get_about()
            .map(|text| ("about".to_owned(), text.to_string()));
        let ending = command
            .get_after_long_help()
            .map(|text| ("ending".to_owned(), text.to_string()));
        let mut found: Vec<_> = about.into_iter().chain(ending).collect();
        for argument in command.get_arguments() {
            let id = argument.get_id().as_str();
            let text = argument.get_long_help().or(argument.get_help());
            found.extend(text.map(|text| (id.to_owned(), text.to_string())));
            let values = match argument.get_action().takes_values() {
                true => argument.get_possible_values(),
                false => Vec::new(),
            };
            found.extend(values.iter().filter_map(|value| {
                let text = value.get_help()?.to_string();
                Some((value_key(id, value.get_name()), text))
            }));
        }
        found
    }

    #[test]
    fn every_text_is_translated_and_every_translation_is_used() {
        let mut tip = grammar();
        tip.build();
        let mut commands = Vec::new();
        collect("tip", &tip, &mut commands);
        // clap makes the command for help.
        let mut used = BTreeSet::from([("help".to_owned(), "about".to_owned())]);
        let mut shared = BTreeMap::new();
        for (path, command) in &commands {
            for (key, english) in texts(command) {
                let own = JAPANESE.get(path).and_then(|table| table.get(&key));
                let table = if own.is_some() { path } else { SHARED };
                used.insert((table.to_owned(), key.clone()));
                if own.is_none() {
                    let first = shared.entry(key.clone()).or_insert_with(|| english.clone());
                    assert_eq!(*first, english, "{path}: {key} has a text of its own");
                }
                let japanese = japanese(path, &key);
                assert!(japanese.is_some(), "{path}: {key}: {english}");
                // A paragraph that was added in one language is missing in the other.
                let paragraphs = |text: &str| text.split("\n\n").count();
                if key != "ending" {
                    let counts = (
                        paragraphs(japanese.unwrap_or_default()),
                        paragraphs(&english),
                    );
                    assert_eq!(counts.0, counts.1, "{path}: {key}");
                }
            }
        }
        for (path, table) in JAPANESE.iter() {
            for (key, _) in table.as_table().expect("a table for each command") {
                assert!(
                    used.contains(&(path.clone(), key.clone())),
                    "{path}: {key} is not used"
                );
            }
        }
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
        for (path, command) in all(Lang::English) {
            let english = command.get_after_long_help().map(ToString::to_string);
            let japanese = japanese(&path, "ending");
            assert_eq!(english.is_some(), japanese.is_some(), "{path}");
            if let (Some(english), Some(japanese)) = (english, japanese) {
                assert_eq!(examples(&english), examples(japanese), "{path}");
                assert_eq!(options(&english), options(japanese), "{path}");
            }
        }
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
    fn short_help_fits_80_columns_and_one_screen() {
        for lang in [Lang::English, Lang::Japanese] {
            for (path, mut command) in all(lang) {
                let text = command.render_help().to_string();
                for line in text.lines() {
                    assert!(width(line) <= COLUMNS, "{path}: {line}");
                }
                assert!(text.lines().count() <= 40, "{path}:\n{text}");
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
