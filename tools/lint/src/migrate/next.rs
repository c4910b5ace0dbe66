//! Migration of a program from version 3.1 to edition 3.2: line 1, and names that 3.2 reserves. Questions are mistakes
//! that 3.2 refuses and 3.1 only warns of, and texts of MESSAGE in which 3.2 shows further values.

use super::{Note, NoteKind, changed, free_name, like, load, robots};
use crate::message::Migrating;
use std::collections::HashSet;
use tipc::code::Level;
use tipc::diagnostic::{Diagnostic, Edit};
use tipc::language::Edition;
use tipc::language::reserved::is_reserved;
use tipc::parse::header::version_word;
use tipc::program::{Action, MessagePart, Program};
use tipc::source::{Encoding, Span};
use tipc::symbols::DefinitionKind;
use tipc::{Loaded, Robot};

/// The new text of line 1.
const NEXT: &str = "3.2";

/// Turns a program of version 3.1 into one of 3.2. Returns its bytes, and the changes and questions.
pub(super) fn to_3_2(name: &str, bytes: &[u8], encoding: Encoding) -> (Vec<u8>, Vec<Note>) {
    let before = best(name, bytes, encoding);
    let source = &before.source;
    let version = version_word(source);
    if before.program.is_none() {
        let question =
            |error: &Diagnostic| Note::new(NoteKind::Question, source, error.span, refused(error));
        return (bytes.to_vec(), before.errors().map(question).collect());
    }
    let mut edits = vec![Edit::replace(version, NEXT)];
    let text = Migrating::ToVersion { to: NEXT };
    let mut notes = vec![Note::new(NoteKind::Change, source, version, text)];
    rename(&before, &mut edits, &mut notes);
    let result = changed(source, edits);
    let mut asked: HashSet<(u32, u32)> = HashSet::new();
    for robot in robots(name, bytes, encoding) {
        let after = load(name, &result, encoding, robot);
        // Line 1 and the names have changed, the lines and the statements have not.
        let place = |span: Span| after.source.line_column(span.start);
        let errors = after
            .errors()
            .map(|error| (place(error.span), refused(error)));
        let shown = after.program.iter().flat_map(|program| {
            let before = before.program.iter();
            before.flat_map(|before| shown(before, program))
        });
        for ((line, column), text) in errors.chain(shown) {
            if asked.insert((line, column)) {
                notes.push(Note {
                    kind: NoteKind::Question,
                    line,
                    column,
                    text,
                });
            }
        }
    }
    (result, notes)
}

/// Loads a program for the robot on which it has the fewest errors.
fn best(name: &str, bytes: &[u8], encoding: Encoding) -> Loaded {
    let all = Robot::ALL.iter();
    let all = all.map(|robot| load(name, bytes, encoding, *robot));
    let best = all.min_by_key(|loaded| loaded.errors().count());
    best.unwrap_or_else(|| load(name, bytes, encoding, Robot::default()))
}

/// Renames names that 3.2 reserves, at all their locations.
fn rename(before: &Loaded, edits: &mut Vec<Edit>, notes: &mut Vec<Note>) {
    let symbols = &before.symbols;
    let definitions = symbols.definitions();
    let mut taken: HashSet<String> = definitions.iter().map(|it| it.name.to_string()).collect();
    let renamed: Vec<Option<String>> = definitions
        .iter()
        .map(|definition| {
            let name = definition.name.as_str();
            let clashes = is_reserved(name, Edition::V3_2) && !is_reserved(name, Edition::V3_1);
            clashes.then(|| {
                let new = free_name(name, &taken);
                taken.insert(new.clone());
                new
            })
        })
        .collect();
    for used in symbols
        .all_uses()
        .iter()
        .filter(|it| it.span.start < it.span.end)
    {
        let Some(new) = &renamed[used.definition.index()] else {
            continue;
        };
        let written = before.source.slice(used.span);
        edits.push(Edit::replace(used.span, like(written, new)));
        let definition = symbols.definition(used.definition);
        if definition.span == Some(used.span) {
            let name = definition.name.to_string();
            let new = new.clone();
            let text = match definition.kind {
                DefinitionKind::Variable(_) => Migrating::VariableIn3_2 { name, new },
                _ => Migrating::LabelIn3_2 { name, new },
            };
            notes.push(Note::new(NoteKind::Change, &before.source, used.span, text));
        }
    }
}

/// Returns the locations of MESSAGEs that show another text than before.
fn shown(before: &Program, after: &Program) -> Vec<((u32, u32), Migrating)> {
    let steps = before.steps().iter().zip(after.steps());
    let differing = steps.filter(|(before, after)| match (&before.action, &after.action) {
        (Action::Message { parts: before }, Action::Message { parts: after }) => {
            !before.iter().map(form).eq(after.iter().map(form))
        }
        _ => false,
    });
    differing
        .map(|(_, after)| ((after.line, after.column), Migrating::ShowsMore))
        .collect()
}

/// Returns the text of a part, or the decimals of a value.
fn form(part: &MessagePart) -> (Option<&str>, u8) {
    match part {
        MessagePart::Text(text) => (Some(text), 0),
        MessagePart::Value { decimals, .. } => (None, *decimals),
    }
}

fn refused(diagnostic: &Diagnostic) -> Migrating {
    debug_assert_eq!(diagnostic.level(), Level::Error);
    Migrating::RefusedIn3_2 {
        title: diagnostic.message().into(),
        reason: Box::new(diagnostic.reason.clone()),
    }
}
