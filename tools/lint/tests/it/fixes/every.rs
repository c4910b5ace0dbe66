//! Every wrong program that there is: after every certain fix its diagnostic is gone, and none is new.

use super::{Certain, Likely, loaded, repaired};
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use tip_lint::load;
use tip_lint::repair::confirm;
use tipc::code::Level;
use tipc::diagnostic::{Applicability, Diagnostic, Fix};
use tipc::{Loaded, Options};

/// Programs whose fix shows what stood after the end of what could be read.
const UNREAD: &[&str] = &["end_if_in_two_words.prg"];

/// Programs whose mistakes are one: a jump and its label without their colons.
const TOGETHER: &[&str] = &["loop_without_colon.prg"];

/// Returns the programs of the diagnostics, and of all cases.
fn programs() -> Vec<PathBuf> {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found = Vec::new();
    collect(&package.join("tests/diagnostics"), &mut found);
    collect(&package.join("../../tests/language/cases"), &mut found);
    found.sort();
    found
}

fn collect(folder: &Path, found: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else {
        return; // The package alone has no cases.
    };
    for entry in entries {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            collect(&path, found);
        } else if path.extension().is_some_and(|end| end == "prg") {
            found.push(path);
        }
    }
}

/// Counts each error.
fn errors(loaded: &Loaded) -> HashMap<String, usize> {
    let mut errors = HashMap::new();
    for diagnostic in &loaded.diagnostics {
        if diagnostic.level() == Level::Error {
            *errors.entry(said(diagnostic)).or_default() += 1;
        }
    }
    errors
}

fn said(diagnostic: &Diagnostic) -> String {
    format!("{} {}", diagnostic.code.id(), diagnostic.reason)
}

/// Returns the file with one fix.
fn with(loaded: &Loaded, fix: &Fix) -> Loaded {
    let source = &loaded.source;
    let mut text = source.text().to_owned();
    for edit in fix.edits.iter().rev() {
        text.replace_range(edit.span.start..edit.span.end, &edit.text);
    }
    load(source.name(), text.as_bytes(), &Options::default())
}

#[test]
fn after_every_certain_fix_the_diagnostic_is_gone_and_none_is_new() {
    let mut fixes = 0;
    let mut wrong = Vec::new();
    for program in programs() {
        let bytes = fs::read(&program).expect("a program");
        let name = program.file_name().expect("a name").to_string_lossy();
        let before = confirm(loaded(&bytes), &Options::default());
        for diagnostic in &before.diagnostics {
            let certain = |fix: &&Fix| fix.applicability == Applicability::Certain;
            let Some(fix) = diagnostic.fixes.iter().find(certain) else {
                continue;
            };
            fixes += 1;
            let mut allowed = errors(&before);
            if let Some(count) = allowed.get_mut(&said(diagnostic)) {
                *count -= 1;
            }
            let after = errors(&with(&before, fix));
            let mut new = after.iter().filter(|(error, count)| {
                **count > allowed.get(*error).copied().unwrap_or_default()
            });
            let is_known = UNREAD.iter().chain(TOGETHER).any(|known| *known == name);
            if let Some((error, _)) = new.next().filter(|_| !is_known) {
                wrong.push(format!("{}: {}: {error}", program.display(), fix.title));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(fixes >= 60, "{fixes} fixes");
}

#[test]
fn repairs_come_to_an_end_and_keep_what_is_right() {
    for program in programs() {
        let bytes = fs::read(&program).expect("a program");
        let before = loaded(&bytes);
        let is_known = before.diagnostics.iter().any(|it| !it.fixes.is_empty());
        // Of the long ones, each combination of arguments is another statement.
        if !is_known || bytes.len() > 4000 {
            continue;
        }
        for least in [Certain, Likely] {
            let repaired = repaired(&bytes, least);
            let after = &repaired.loaded;
            let name = program.display();
            assert_eq!(
                after.source.bytes() == bytes,
                repaired.applied.is_empty(),
                "{name}"
            );
            assert!(
                before.program.is_none() || after.program.is_some(),
                "{name}"
            );
            assert_eq!(after.source.charset(), before.source.charset(), "{name}");
            let again = super::repaired(&after.source.bytes(), least);
            assert!(again.applied.is_empty(), "{name}: {:#?}", again.applied);
        }
    }
}
