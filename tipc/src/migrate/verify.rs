//! The last look: what is still no statement of version 3.1.

use super::{Note, NoteKind};
use crate::code::{Code, Level};
use crate::diagnostic::Diagnostic;
use crate::language::commands::find;
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
    // Lines are put in behind the title alone, and nothing is wrong with them: only names that fit are declared.
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
            _ if find(&name.node).is_none() => {
                format!("{} is no command of version 3.1: what is meant?", name.node)
            }
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

fn explained(finding: &Diagnostic) -> String {
    if finding.code == Code::NoEnd {
        return "the program has no END: where does it end?".to_owned();
    }
    format!(
        "this is no statement of version 3.1 ({}: {}): what is meant?",
        finding.message(),
        finding.reason
    )
}
