//! Whether a formatted program is the one that it was. The passes after the parser see the fields of statements and not how
//! they are laid out, so equal fields make an equal program.

use crate::code::Level;
use crate::diagnostic::Diagnostic;
use crate::listing::formal;
use crate::load::{Options, Parsed, parsed_by_lines};
use crate::message::Formatting;
use crate::source::Source;
use crate::syntax::{Statement, StatementKind, Word};
use std::mem::discriminant;

/// Both have the same statements, without a mistake, and all text is read as before. The formatted program is read line by
/// line, so that it is never in memory as a whole.
pub(super) fn check(
    before: &Parsed,
    formatted: &[u8],
    options: &Options,
) -> Result<(), Formatting> {
    let mut left = before.module.statements.iter();
    let mut is_equal = true;
    let mut pair = Pair {
        source: &before.source,
        old: Vec::new(),
        new: Vec::new(),
    };
    let after = parsed_by_lines(
        before.source.name(),
        formatted,
        options,
        &mut |source, read| {
            for new in read.drain(..) {
                let old = left.next();
                is_equal = is_equal && old.is_some_and(|old| pair.is_equal(old, source, &new));
            }
        },
    );
    let charset = after.source.charset();
    if charset != before.source.charset() && !after.source.text().is_ascii() {
        let encoding = charset.name();
        return Err(Formatting::OtherEncoding { encoding });
    }
    let is_equal = is_equal
        && left.next().is_none()
        && before.module.edition == after.module.edition
        && before.module.title == after.module.title;
    match reads_without_errors(&after) && is_equal {
        true => Ok(()),
        false => Err(Formatting::OtherProgram),
    }
}

fn reads_without_errors(parsed: &Parsed) -> bool {
    let is_error = |it: &Diagnostic| it.level() == Level::Error;
    parsed.is_program && !parsed.diagnostics.iter().any(is_error)
}

/// The source of the program as it was, and room for the fields of a statement of each.
struct Pair<'a> {
    source: &'a Source,
    old: Vec<u8>,
    new: Vec<u8>,
}

impl Pair<'_> {
    fn is_equal(&mut self, old: &Statement, source: &Source, new: &Statement) -> bool {
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
                _ => fields(&mut self.old, self.source, old) == fields(&mut self.new, source, new),
            }
    }
}

fn name(word: &Word) -> &str {
    &word.node
}

/// The fields of a statement as FORMAL.TMP shows them.
fn fields<'a>(text: &'a mut Vec<u8>, source: &Source, statement: &Statement) -> &'a [u8] {
    text.clear();
    formal::write(text, source, statement, b'\t');
    text
}
