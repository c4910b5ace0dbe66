//! Whether a formatted program is the one that it was. The passes after the parser see the fields of statements and not how
//! they are laid out, so equal fields make an equal program.

use crate::code::Level;
use crate::diagnostic::Diagnostic;
use crate::listing::formal;
use crate::load::Parsed;
use crate::message::Formatting;
use crate::source::Source;
use crate::syntax::{Statement, StatementKind, Word};
use std::mem::discriminant;

/// Both have the same statements, without a mistake, and all text is read as before.
pub(super) fn check(before: &Parsed, after: &Parsed) -> Result<(), Formatting> {
    let charset = after.source.charset();
    if charset != before.source.charset() && !after.source.text().is_ascii() {
        let encoding = charset.name();
        return Err(Formatting::OtherEncoding { encoding });
    }
    match reads_without_errors(after) && is_equal(before, after) {
        true => Ok(()),
        false => Err(Formatting::OtherProgram),
    }
}

fn reads_without_errors(parsed: &Parsed) -> bool {
    let is_error = |it: &Diagnostic| it.level() == Level::Error;
    parsed.is_program && !parsed.diagnostics.iter().any(is_error)
}

/// Whether the same edition, title and statements were read.
fn is_equal(before: &Parsed, after: &Parsed) -> bool {
    let (old, new) = (&before.module, &after.module);
    let mut pair = Pair {
        old: (&before.source, String::new()),
        new: (&after.source, String::new()),
    };
    old.edition == new.edition
        && old.title == new.title
        && old.statements.len() == new.statements.len()
        && old
            .statements
            .iter()
            .zip(&new.statements)
            .all(|(old, new)| pair.is_equal(old, new))
}

/// Two sources, and room for the fields of a statement of each.
struct Pair<'a> {
    old: (&'a Source, String),
    new: (&'a Source, String),
}

impl Pair<'_> {
    fn is_equal(&mut self, old: &Statement, new: &Statement) -> bool {
        old.step == new.step
            && discriminant(&old.kind) == discriminant(&new.kind)
            && match (&old.kind, &new.kind) {
                (
                    StatementKind::Define { kind, names, .. },
                    StatementKind::Define {
                        kind: new_kind,
                        names: new_names,
                        ..
                    },
                ) => kind == new_kind && names.iter().map(name).eq(new_names.iter().map(name)),
                _ => fields(&mut self.old, old) == fields(&mut self.new, new),
            }
    }
}

fn name(word: &Word) -> &str {
    &word.node
}

/// The fields of a statement as FORMAL.TMP shows them.
fn fields<'a>((source, text): &'a mut (&Source, String), statement: &Statement) -> &'a str {
    text.clear();
    formal::write(text, source, statement, '\t');
    text
}
