//! The last look: what is still no statement of version 3.1.

use super::{Note, NoteKind};
use crate::message::Migrating;
use std::collections::HashSet;
use tipc::Robot;
use tipc::code::{Code, Level};
use tipc::diagnostic::Diagnostic;
use tipc::language::commands::find;
use tipc::load::check_module;
use tipc::parse::parse;
use tipc::source::{Encoding, Source};
use tipc::syntax::{Module, Statement, StatementKind};

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
    let (module, found) = parse(&source, Some(3.1));
    let broken = found
        .iter()
        .filter(|diagnostic| diagnostic.level() == Level::Error)
        .map(|diagnostic| (diagnostic.span.start, explained(diagnostic)));
    let refused = refused_by_all(&source, &module);
    let unknown = module.statements.iter().zip(&refused);
    let unknown = unknown.filter_map(|(statement, refused)| {
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
            None => explained(refused.as_ref()?),
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

/// Returns for each statement why no robot takes its arguments, if none does.
fn refused_by_all(source: &Source, module: &Module) -> Vec<Option<Diagnostic>> {
    let mut refused: Vec<Option<Diagnostic>> = vec![None; module.statements.len()];
    let mut robots = vec![0; module.statements.len()];
    for robot in Robot::ALL {
        let mut found = check_module(source, module, *robot);
        found.retain(|one| matches!(one.code, Code::Argument | Code::UnknownCommand));
        let mut seen = vec![false; module.statements.len()];
        for fault in found {
            let location = fault.span.start;
            let before = |statement: &Statement| statement.span.start <= location;
            let behind = module.statements.partition_point(before);
            let Some(at) = behind.checked_sub(1) else {
                continue;
            };
            robots[at] += usize::from(!seen[at]);
            seen[at] = true;
            // That a robot lacks the command says less than what is wrong with it on another.
            if refused[at].is_none() || fault.code == Code::Argument {
                refused[at] = Some(fault);
            }
        }
    }
    for (refused, robots) in refused.iter_mut().zip(robots) {
        *refused = refused.take().filter(|_| robots == Robot::ALL.len());
    }
    refused
}

fn explained(diagnostic: &Diagnostic) -> Migrating {
    if diagnostic.code == Code::NoEnd {
        return Migrating::NoEnd;
    }
    Migrating::NoStatement {
        title: diagnostic.message().into(),
        reason: Box::new(diagnostic.reason.clone()),
    }
}
