//! Fixes: for what a diagnostic says, the changes of the text that put it right. It judges no program: what the checker knows
//! is in the diagnostic's messages, the rest in the statement around its location.

mod blocks;
mod characters;
mod declarations;
mod jumps;
mod operators;
mod site;
pub(crate) mod texts;
pub(crate) mod words;

use site::{Shared, Site};
use tipc::diagnostic::{Diagnostic, Edit, Fix};
use tipc::source::Source;
use tipc::syntax::Module;

/// A function that knows the changes for a diagnostic.
pub(crate) type Fixer = fn(&Site<'_>) -> Option<Fix>;

/// Sources of fixes, asked in this order. The first answer counts.
const FIXERS: &[Fixer] = &[
    characters::fix,
    texts::fix,
    words::fix,
    jumps::fix,
    blocks::fix,
    operators::fix,
    declarations::fix,
];

/// Gives each diagnostic the fix that is known for it; `of_word` knows that of a word of another language.
pub(crate) fn attach(
    source: &Source,
    module: &Module,
    diagnostics: &mut [Diagnostic],
    of_word: fn(&Diagnostic, &Source) -> Option<Fixer>,
) {
    let shared = Shared::default();
    for diagnostic in diagnostics {
        let site = Site::new(source, module, &shared, diagnostic);
        let fix = match of_word(diagnostic, source) {
            Some(fixer) => fixer(&site),
            None => FIXERS.iter().find_map(|fixer| fixer(&site)),
        };
        diagnostic.fixes = fix
            .filter(|fix| is_sound(source, fix))
            .into_iter()
            .collect();
    }
}

/// Returns true if its edits change the text, follow each other, and write only what every encoding has alike.
fn is_sound(source: &Source, fix: &Fix) -> bool {
    let is_change = |edit: &Edit| source.slice(edit.span) != edit.text && edit.text.is_ascii();
    let follows = |pair: &[Edit]| pair[0].span.end <= pair[1].span.start;
    !fix.edits.is_empty() && fix.edits.iter().all(is_change) && fix.edits.windows(2).all(follows)
}
