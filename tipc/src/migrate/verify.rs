//! The last look: what is still no statement of version 3.1.

use super::{Note, NoteKind};
use crate::code::{Code, Level};
use crate::diagnostic::Diagnostic;
use crate::language::commands::find;
use crate::message::Migrating;
use crate::parse::parse;
use crate::source::{Encoding, Source};
use crate::syntax::StatementKind;
use std::collections::HashSet;

/// Questions about what the rules left, on lines that nothing is asked about yet.
pub(super) fn questions(
    old: &Source,
    result: &[u8],
    encoding: Encoding,
    notes: &[Note],
) -> Vec<Note> {
    let asked = notes.iter().filter(|note| note.kind == NoteKind::Question);
    let asked: HashSet<u32> = asked.map(|note| note.line).collect();
    let (source, _) = Source::decode(old.name(), result, encoding);
    // Lines are put in after the title alone, and nothing is wrong with them: only names that fit are declared.
    let added = source.line_count() - old.line_count();
    let (module, found) = parse(&source, 3.1);
    let broken = found
        .iter()
        .filter(|finding| finding.level() == Level::Error)
        .map(|finding| (finding.span.start, explained(finding)));
    let unknown = module.statements.iter().filter_map(|statement| {
        let StatementKind::Command {
            name, malformed, ..
        } = &statement.kind
        else {
            return None;
        };
        let text = match malformed {
            _ if find(&name.node).is_none() => Migrating::NoCommand {
                word: name.node.to_string(),
            },
            Some(fault) => explained(fault),
            None => return None,
        };
        Some((name.span.start, text))
    });
    let questions = broken.chain(unknown).map(|(start, text)| {
        let (line, column) = source.line_column(start);
        Note {
            kind: NoteKind::Question,
            line: if line > 2 { line - added } else { line },
            column,
            text,
        }
    });
    questions
        .filter(|note| !asked.contains(&note.line))
        .collect()
}

fn explained(finding: &Diagnostic) -> Migrating {
    if finding.code == Code::NoEnd {
        return Migrating::NoEnd;
    }
    Migrating::NoStatement {
        title: finding.message(),
        reason: Box::new(finding.reason.clone()),
    }
}
