//! Whether a formatted program is the one that it was.

use crate::listing::formal;
use crate::load::Loaded;
use crate::message::Formatting;
use crate::program::Program;

/// Both load to the same program and have the same FORMAL.TMP, and all text is read as before.
pub(super) fn check(before: &Loaded, after: &Loaded) -> Result<(), Formatting> {
    let charset = after.source.charset();
    if charset != before.source.charset() && !after.source.text().is_ascii() {
        let encoding = charset.name();
        return Err(Formatting::OtherEncoding { encoding });
    }
    let programs = before.program.as_ref().zip(after.program.as_ref());
    match programs.is_some_and(|(before, after)| is_equal(before, after))
        && is_written_alike(before, after)
    {
        true => Ok(()),
        false => Err(Formatting::OtherProgram),
    }
}

/// Whether two programs of as many steps have the same FORMAL.TMP.
fn is_written_alike(before: &Loaded, after: &Loaded) -> bool {
    let (mut old, mut new) = (String::new(), String::new());
    let mut steps = before.module.steps().zip(after.module.steps());
    steps.all(|(one, other)| {
        old.clear();
        new.clear();
        formal::write(&mut old, &before.source, one, '\t');
        formal::write(&mut new, &after.source, other, '\t');
        old == new
    })
}

/// Whether two programs are equal but for the bytes they were read from, and the places and spelling of their steps.
fn is_equal(before: &Program, after: &Program) -> bool {
    let Program {
        source_name,
        source_hash: _,
        edition,
        title,
        signature,
        variables,
        labels,
        steps,
    } = before;
    *source_name == after.source_name
        && *edition == after.edition
        && *title == after.title
        && *signature == after.signature
        && *variables == after.variables
        && *labels == after.labels
        && steps.len() == after.steps.len()
        && steps
            .iter()
            .zip(&after.steps)
            .all(|(before, after)| before.action == after.action)
}
