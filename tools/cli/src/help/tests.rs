use super::*;
use std::collections::BTreeSet;

/// A command line with all that every command has, and its commands with their paths.
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

/// The sentences that commands, options and values are said to be.
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
    assert_eq!(rows.len(), lines().count(), "a row stands twice");
}

/// The command lines of a text's examples, without what is said of them.
fn examples(text: &str) -> Vec<&str> {
    let lines = text.lines().filter(|line| line.starts_with("  tip "));
    lines
        .map(|line| line.trim_start().split("   ").next().unwrap_or_default())
        .map(|line| line.split("  ").next().unwrap_or_default())
        .collect()
}

/// The numbers of a text's statuses and options.
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
