//! Help of the command line: `--help` on one screen, `tip help COMMAND` with examples, their Japanese texts, `tip completions`
//! and `tip man`. The English texts are in the commands.

use crate::choices::{LangName, robot_names};
use crate::error::Error;
use crate::output::width;
use crate::{Arguments, Status, output};
use clap::builder::{EnumValueParser, PossibleValue, StyledStr};
use clap::{Arg, ArgAction, Args, Command, CommandFactory};
use clap_complete::Shell;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use tipc::message::Lang;

/// The template of clap with Japanese words.
const TEMPLATE: &str = "{about-with-newline}\n使い方: {usage}\n\n{all-args}{after-help}";

/// The commands by what people do with them: English and Japanese headings, and names.
const GROUPS: &[(&str, &str, &[&str])] = &[
    (
        "Write",
        "書く",
        &["new", "check", "fmt", "explain", "migrate"],
    ),
    (
        "Run",
        "実行する",
        &["run", "debug", "verify", "cycles", "sweep"],
    ),
    ("See", "見る", &["view", "serve", "plot", "log"]),
    ("Embed", "組み込む", &["emit"]),
    ("Robots", "ロボット", &["robot", "drives", "jitter"]),
    (
        "Editors and shells",
        "エディタとシェル",
        &["lsp", "dap", "completions", "man", "help"],
    ),
];

/// Returns the grammar of the command line, with the options that may stand anywhere.
pub(super) fn grammar() -> Command {
    let help = Arg::new("help")
        .short('h')
        .long("help")
        .action(ArgAction::HelpShort)
        .help("Print help");
    let lang = Arg::new("lang")
        .long("lang")
        .value_name("en|ja")
        .value_parser(EnumValueParser::<LangName>::new())
        .help("The language of messages; else the locale's");
    Arguments::command()
        .disable_help_flag(true)
        .args([lang.global(true), help.global(true)])
}

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
    for (english, japanese, names) in GROUPS {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{}:", lang.pick(english, japanese));
        for command in names.iter().filter_map(|name| tip.find_subcommand(name)) {
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
    let path = match above {
        "" | "tip" => name,
        above => format!("{above}_{name}"),
    };
    let below: Vec<String> = command.get_subcommands().map(name_of).collect();
    let mut command = command.mut_args(|arg| option(arg, lang));
    let english = command.get_after_long_help().map(ToString::to_string);
    if let Some(english) = english {
        let japanese = endings().find(|(command, _)| *command == path);
        let ending = match lang {
            Lang::Japanese => japanese.map_or("", |(_, text)| text.trim_end()).to_owned(),
            _ => english,
        };
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
        let about = command
            .get_about()
            .map(|text| line(&text.to_string()))
            .unwrap_or_default();
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
fn option(arg: Arg, lang: Lang) -> Arg {
    let said = |text: Option<&StyledStr>| -> Vec<String> {
        let paragraphs = text.map(paragraphs).unwrap_or_default();
        let in_lang = |text: String| match lang {
            Lang::Japanese => line(&text),
            _ => text,
        };
        paragraphs.into_iter().map(in_lang).collect()
    };
    let mut short = said(arg.get_help()).into_iter().next().unwrap_or_default();
    let mut long = said(arg.get_long_help().or(arg.get_help())).join("\n\n");
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
                let help = said(value.get_help()).concat();
                let _ = write!(long, "\n- {}: {help}", value.get_name());
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

/// Returns the paragraphs of a help text.
fn paragraphs(text: &StyledStr) -> Vec<String> {
    let text = text.to_string();
    text.split("\n\n").map(str::to_owned).collect()
}

/// Translates a sentence; one without a row stays.
fn line(english: &str) -> String {
    let row = lines().find(|(row, _)| *row == english);
    row.map_or(english.to_owned(), |(_, japanese)| japanese.to_owned())
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

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip completions bash > ~/.local/share/bash-completion/completions/tip
  tip completions zsh > ~/.zfunc/_tip
  tip completions fish > ~/.config/fish/completions/tip.fish")]
pub(super) struct Completions {
    /// The shell: bash, elvish, fish, powershell or zsh
    shell: Shell,
}

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip man -o ~/.local/share/man/man1")]
pub(super) struct Man {
    /// The folder for the pages, one for each command
    ///
    /// It is created if necessary
    #[arg(short, long, value_name = "DIR")]
    out: PathBuf,
}

/// Prints the completion script of a shell.
pub(super) fn completions(arguments: &Completions) -> Result<Status, Error> {
    let mut script = Vec::new();
    let mut command = grammar();
    let name = command.get_name().to_owned();
    clap_complete::generate(arguments.shell, &mut command, name, &mut script);
    let script = String::from_utf8_lossy(&script);
    output::print(with_files(&script, arguments.shell))?;
    Ok(Status::Success)
}

/// Completes files wherever the name of a robot is completed, as a description may be there.
fn with_files(script: &str, shell: Shell) -> String {
    let lines = script.lines().map(|line| {
        let names = [robot_names(&[]), robot_names(&["hexapod"])].map(|names| names.join(" "));
        let names = names.iter().find(|names| line.contains(names.as_str()));
        match (shell, names) {
            (Shell::Bash, Some(_)) => line.replace("compgen -W", "compgen -f -W"),
            (Shell::Zsh, Some(names)) => line.replace(
                &format!("({names})"),
                &format!("{{compadd {names}; _files}}"),
            ),
            (Shell::Fish, _) if line.contains("-l robot ") => line.replace(" -r -f ", " -r -F "),
            _ => line.to_owned(),
        }
    });
    lines.map(|line| line + "\n").collect()
}

/// Writes the manual pages.
pub(super) fn man(arguments: &Man) -> Result<Status, Error> {
    let folder = &arguments.out;
    let failed = |error: std::io::Error| Error::cannot_write(folder, error);
    fs::create_dir_all(folder).map_err(failed)?;
    clap_mangen::generate_to(grammar(), folder).map_err(failed)?;
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
                let text = arg.get_long_help().or(arg.get_help()).cloned();
                text.into_iter().chain(values)
            });
            abouts.into_iter().chain(arguments).collect::<Vec<_>>()
        });
        texts.flat_map(|text| paragraphs(&text)).collect()
    }

    #[test]
    fn every_sentence_has_a_row_and_every_row_a_sentence() {
        let mut tip = grammar();
        tip.build();
        let mut commands = Vec::new();
        collect("tip", &tip, &mut commands);
        let said = sentences(&commands);
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
            let english = command.get_after_long_help().map(ToString::to_string);
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
    fn each_command_is_in_one_group() {
        let tip = command(Lang::English);
        let mut commands: Vec<&str> = tip.get_subcommands().map(Command::get_name).collect();
        let mut grouped: Vec<&str> = GROUPS
            .iter()
            .flat_map(|(.., names)| *names)
            .copied()
            .collect();
        commands.sort_unstable();
        grouped.sort_unstable();
        assert_eq!(commands, grouped);
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
