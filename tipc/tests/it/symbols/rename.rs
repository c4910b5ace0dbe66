//! Every program of the tests, with every name replaced by the table: it stays the same program up to names.

use crate::symbols::cases::programs;
use std::collections::HashSet;
use tipc::program::Program;
use tipc::symbols::DefinitionKind;
use tipc::{Loaded, Options, Robot, load};

/// Returns a new name for each definition but those that the language names, `VAR_KEY` and LOOP. They are short, so
/// that no text becomes too long.
fn new_names(loaded: &Loaded) -> Vec<Option<String>> {
    let upper = loaded.source.text().to_ascii_uppercase();
    let is_outside = |char: char| !(char.is_ascii_alphanumeric() || char == '_');
    let taken: HashSet<&str> = upper.split(is_outside).collect();
    let candidates = (0..).map(|number| format!("Z{number}"));
    let mut free = candidates.filter(|name| !taken.contains(name.as_str()));
    let definitions = loaded.symbols.definitions().iter();
    let renamed = definitions.map(|definition| {
        let is_fixed = match definition.kind {
            DefinitionKind::Variable(_) => definition.span.is_none(),
            DefinitionKind::Label => definition.name == "LOOP",
            DefinitionKind::Subroutine | DefinitionKind::Thread | DefinitionKind::Constant => false,
        };
        if is_fixed { None } else { free.next() }
    });
    renamed.collect()
}

/// Returns the text with every use of every name replaced.
fn rename(loaded: &Loaded, names: &[Option<String>]) -> String {
    let text = loaded.source.text();
    let mut renamed = String::new();
    let mut copied = 0;
    for it in loaded.symbols.all_uses() {
        if let Some(name) = names[it.definition.index()]
            .as_ref()
            .filter(|_| it.span.start < it.span.end)
        {
            renamed.push_str(&text[copied..it.span.start]);
            renamed.push_str(name);
            copied = it.span.end;
        }
    }
    renamed + &text[copied..]
}

/// Formats what a program does, without its texts and names.
fn meaning(program: &Program) -> String {
    let actions: Vec<_> = program
        .steps()
        .iter()
        .map(|step| (&step.action, step.line))
        .collect();
    let variables: Vec<_> = program
        .variables()
        .iter()
        .map(|variable| (variable.kind, variable.first))
        .collect();
    let labels: Vec<_> = program
        .labels()
        .iter()
        .map(|label| (label.step, label.kind))
        .collect();
    format!(
        "{actions:?} {variables:?} {labels:?} {:?}",
        program.signature()
    )
}

#[test]
fn renaming_changes_nothing_but_names() {
    let mut compared = 0;
    for (path, bytes) in programs() {
        for robot in Robot::ALL {
            let options = Options {
                robot: *robot,
                ..Options::default()
            };
            let loaded = load("case.prg", &bytes, &options);
            let Some(program) = &loaded.program else {
                continue;
            };
            let names = new_names(&loaded);
            let text = rename(&loaded, &names);
            let again = load("case.prg", text.as_bytes(), &options);
            let found = &again.diagnostics;
            let renamed = again
                .program
                .as_ref()
                .unwrap_or_else(|| panic!("{}: {found:#?}", path.display()));
            assert_eq!(meaning(renamed), meaning(program), "{}", path.display());
            let bears = |old: &str, new: &str, name: &Option<String>| match name {
                Some(name) => name == new,
                None => old == new,
            };
            let old = program
                .variables()
                .iter()
                .map(|it| &it.name)
                .chain(program.labels().iter().map(|it| &it.name));
            let new = renamed
                .variables()
                .iter()
                .map(|it| &it.name)
                .chain(renamed.labels().iter().map(|it| &it.name));
            for ((old, new), name) in old.zip(new).zip(&names) {
                assert!(
                    bears(old, new, name),
                    "{old} {new} {name:?} in {}",
                    path.display()
                );
                compared += 1;
            }
        }
    }
    assert!(
        programs().is_empty() || compared > 2_000,
        "{compared} names"
    );
}
