//! Comparison of a formatted program with the original. The passes after the parser see the fields of statements and
//! not how they are laid out, so equal fields make an equal program.

use crate::Options;
use crate::listing::{Constants, formal};
use crate::message::Formatting;
use std::mem::discriminant;
use tipc::load::Parsed;
use tipc::parse::parse_taking;
use tipc::source::Source;
use tipc::syntax::{Statement, StatementKind, Word};

/// Checks that both have the same statements, without a mistake, and that all text is read as before. The formatted
/// program is read line by line, so that it is never in memory as a whole.
pub(super) fn check(
    before: &Parsed,
    formatted: &[u8],
    options: &Options,
) -> Result<(), Formatting> {
    let name = before.source.name();
    let (after, undecodable) = Source::decode(name, formatted, options.encoding);
    let charset = after.charset();
    if charset != before.source.charset() && !after.text().is_ascii() {
        let encoding = charset.name();
        return Err(Formatting::OtherEncoding { encoding });
    }
    match undecodable.is_none() && is_equal(before, &after, options) {
        true => Ok(()),
        false => Err(Formatting::OtherProgram),
    }
}

/// Returns true if a source is read as the same statements, without an error.
fn is_equal(before: &Parsed, after: &Source, options: &Options) -> bool {
    let mut left = before.module.statements.iter();
    let mut is_equal = true;
    let mut pair = Pair {
        source: &before.source,
        old: Vec::new(),
        new: Vec::new(),
    };
    let (module, found) = parse_taking(after, options.tip_version, &mut |read| {
        for new in read.drain(..) {
            let old = left.next();
            is_equal = is_equal && old.is_some_and(|old| pair.is_equal(old, after, &new));
        }
    });
    is_equal
        && left.next().is_none()
        && !found.have_error(module.edition)
        && before.module.edition == module.edition
        && before.module.title == module.title
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

/// Returns the fields of a statement as FORMAL.TMP shows them.
fn fields<'a>(text: &'a mut Vec<u8>, source: &Source, statement: &Statement) -> &'a [u8] {
    text.clear();
    formal::write(text, source, statement, &Constants::default(), b'\t');
    text
}

#[cfg(test)]
mod tests {
    use super::check;
    use crate::Options;
    use tipc::load::parsed;

    /// Returns a long program with two lines that a test changes.
    fn program(first: &str, second: &str) -> String {
        let lines = |n: usize| format!("  ptp f1 {n} r 0 r 0 ; a={n}\n").repeat(1000);
        let (begin, end) = (lines(1), lines(2));
        format!(
            "3.1\nlong\ndef_var a\n{begin}{first}\n{end}{second}\n{begin}end\nptp what follows\n"
        )
    }

    #[track_caller]
    fn is_same(before: &str, after: &str) -> bool {
        let options = Options::default();
        let before = parsed("long.prg", before.as_bytes(), &options);
        assert_eq!(*before.diagnostics, []);
        check(&before, after.as_bytes(), &options).is_ok()
    }

    // clauses: 8.1
    #[test]
    fn a_change_in_either_line_is_seen() {
        let before = program("a = 1", "a = 1");
        assert!(is_same(&before, &program("A=1 // as it was", "a   =   1")));
        for other in ["a = 2", "", "a = 1 ; a = 1", "end", "a == 1", "rem"] {
            assert!(!is_same(&before, &program(other, "a = 1")), "{other}");
            assert!(!is_same(&before, &program("a = 1", other)), "{other}");
        }
        // A line that moves from one location to the other.
        assert!(!is_same(&before, &program("", "a = 1\na = 1")));
        let endless = before.replace("end\nptp what follows\n", "");
        assert!(!is_same(&before, &endless));
    }
}
