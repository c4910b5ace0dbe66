//! Errors of the command line, with suggestions.

use super::choices::LangName;
use super::report::complain;
use super::{choices, commands};
use crate::message::{Using, Weight};
use clap::ValueEnum;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use std::env;
use std::error::Error as _;
use std::path::Path;
use tip_runtime::printable::is_control;
use tipc::message::Lang;
use tipc::message::list::Each;

/// Commands of other tools, and the commands that they mean here.
const OTHER_TOOLS: &[(&str, &str)] = &[
    ("build", "emit rust"),
    ("compile", "emit rust"),
    ("convert", "migrate"),
    ("create", "new"),
    ("format", "fmt"),
    ("init", "new"),
    ("lint", "check"),
    ("sim", "run"),
    ("simulate", "run"),
    ("upgrade", "migrate"),
];

/// Reports an error of the command line, or prints the help that was asked for.
pub(super) fn report(error: &clap::Error) {
    let lang = lang();
    let in_japanese = || translated(error).filter(|_| lang == Lang::Japanese);
    if let Some(reason) = specific(error).or_else(in_japanese) {
        let option = text(error, ContextKind::InvalidArg);
        let names_it = [ErrorKind::ValueValidation, ErrorKind::InvalidValue];
        let option = option.filter(|_| names_it.contains(&error.kind()));
        let option = option.and_then(|option| Some(option.split_once(' ')?.0.to_owned() + ": "));
        let option = option.unwrap_or_default();
        let (error, reason) = (Weight::Error.in_lang(lang), reason.in_lang(lang));
        complain(&format!("{error}: {option}{reason}\n"));
        if let Some(command) = command() {
            complain(&format!("{}\n", Using::SeeHelp { command }.in_lang(lang)));
        }
    } else if error.use_stderr()
        && env::args_os().any(|word| word.to_string_lossy().chars().any(is_control))
    {
        // It repeats words of the command line, which are made printable; that removes colours, too.
        complain(&error.render().to_string());
    } else {
        // A closed output is not an error.
        let _ = error.print();
    }
}

/// Returns the message of an error that has a specific one.
fn specific(error: &clap::Error) -> Option<Using> {
    match error.kind() {
        ErrorKind::InvalidSubcommand => {
            let word = text(error, ContextKind::InvalidSubcommand)?;
            let near = strings(error, ContextKind::SuggestedSubcommand);
            Some(unknown_command(word, near.first()))
        }
        ErrorKind::MissingRequiredArgument => {
            let missing = strings(error, ContextKind::InvalidArg);
            let is_file = |name: &String| name.starts_with("<FILE>") || name == "<OLD>";
            let command = command().filter(|_| missing.iter().any(is_file))?;
            let command = match command.as_str() {
                "emit" => "emit rust".to_owned(),
                _ => command,
            };
            Some(Using::NoFile { command })
        }
        ErrorKind::UnknownArgument => {
            let option = text(error, ContextKind::InvalidArg)?;
            let near = full_option(&option)?;
            Some(Using::NearOption { option, near })
        }
        ErrorKind::ValueValidation => error.source()?.downcast_ref::<Using>().cloned(),
        // The usage that clap prints has one of both only.
        ErrorKind::ArgumentConflict => Some(Using::NotTogether {
            option: text(error, ContextKind::InvalidArg)?,
            other: text(error, ContextKind::PriorArg)?,
        }),
        _ => None,
    }
}

/// Returns the translated message of an error that clap has in English only.
fn translated(error: &clap::Error) -> Option<Using> {
    let option = text(error, ContextKind::InvalidArg);
    Some(match error.kind() {
        ErrorKind::UnknownArgument => {
            let option = option?;
            match text(error, ContextKind::SuggestedArg) {
                Some(near) => Using::NearOption { option, near },
                None => Using::NoOption { option },
            }
        }
        ErrorKind::InvalidValue => {
            let value = text(error, ContextKind::InvalidValue).unwrap_or_default();
            let values = strings(error, ContextKind::ValidValue);
            match value.is_empty() {
                true => Using::NeedsValue,
                false => Using::NoSuchValue {
                    value,
                    values: Each(values),
                },
            }
        }
        ErrorKind::MissingRequiredArgument => Using::MissingArgument {
            what: strings(error, ContextKind::InvalidArg).join(" "),
        },
        ErrorKind::MissingSubcommand => Using::WhichCommand {
            commands: Each(commands()),
        },
        _ => return None,
    })
}

/// Returns the message about an unknown command.
fn unknown_command(word: String, near: Option<&String>) -> Using {
    let path = Path::new(&word);
    let is_program = path
        .extension()
        .is_some_and(|end| end.eq_ignore_ascii_case("prg"));
    if is_program || path.is_file() {
        return Using::RunThat { file: word.into() };
    }
    let other = OTHER_TOOLS.iter().find(|(other, _)| *other == word);
    let meant = other.map(|(_, command)| (*command).to_owned());
    match meant.or_else(|| near.cloned()) {
        Some(command) => Using::OtherWord { word, command },
        None => Using::NoCommand {
            word,
            commands: Each(commands()),
        },
    }
}

/// Returns the option that ends in these words: `--message-format` for `--format`.
fn full_option(option: &str) -> Option<String> {
    let end = option.strip_prefix('-').filter(|end| end.len() > 2)?;
    let tip = commands::grammar();
    let mut options = tip.find_subcommand(command()?)?.get_arguments();
    let near = options.find_map(|it| it.get_long().filter(|long| long.ends_with(end)))?;
    Some(format!("--{near}"))
}

/// Returns the names of the commands.
fn commands() -> Vec<String> {
    let tip = commands::grammar();
    let commands = tip.get_subcommands();
    commands
        .map(|command| command.get_name().to_owned())
        .collect()
}

/// Returns the command of the command line.
fn command() -> Option<String> {
    let mut words = env::args().skip(1);
    words.find_map(|word| commands().into_iter().find(|command| *command == word))
}

/// Returns the language of the command line, which may be invalid otherwise, or that of the locale.
pub(super) fn lang() -> Lang {
    let words: Vec<String> = env::args_os()
        .map(|word| word.to_string_lossy().into_owned())
        .collect();
    let value = |(word, next): (&String, &String)| match word.strip_prefix("--lang") {
        Some("") => Some(next.clone()),
        Some(value) => value.strip_prefix('=').map(str::to_owned),
        None => None,
    };
    let end = String::new();
    let nexts = words.iter().skip(1).chain([&end]);
    let asked = words.iter().zip(nexts).find_map(value);
    choices::lang(asked.and_then(|name| LangName::from_str(&name, false).ok()))
}

fn text(error: &clap::Error, kind: ContextKind) -> Option<String> {
    match error.get(kind)? {
        ContextValue::String(text) => Some(text.clone()),
        _ => None,
    }
}

fn strings(error: &clap::Error, kind: ContextKind) -> Vec<String> {
    match error.get(kind) {
        Some(ContextValue::String(text)) => vec![text.clone()],
        Some(ContextValue::Strings(texts)) => texts.clone(),
        _ => Vec::new(),
    }
}
