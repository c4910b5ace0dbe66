//! `GOTOL1:`, which is a label and no jump.

use super::LintContext;
use crate::message::Linting;
use std::collections::{HashMap, HashSet};
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::language::Keyword;
use tipc::parse::glued;
use tipc::symbols::{Access, Definition, DefinitionKind, Symbols};

/// Warns of labels like `GOTOL1:`. Silent about a label that something jumps to, and where no label has the rest of
/// its name. That nothing comes to the label that was meant follows from it.
pub(super) fn warn(context: &LintContext<'_>, found: &mut Diagnostics) {
    let suspects = suspects(context.symbols);
    let meant: HashSet<&str> = suspects.iter().map(|it| it.meant).collect();
    let follows = |diagnostic: &Diagnostic| match diagnostic.reason.get() {
        Some(Linting::NothingJumps { name }) => meant.contains(name.as_str()),
        _ => false,
    };
    found.retain(|diagnostic| !follows(diagnostic));
    for Suspect { label, jump, meant } in suspects {
        let help = Linting::JumpInTwoWords {
            written: format!("{jump} {meant}:").into(),
            word: label.name.clone(),
        };
        let reason = Linting::JumpInOneWord { jump };
        let diagnostic = |location| Diagnostic::new(Code::GluedJump, location, reason).help(help);
        found.extend(label.span.map(diagnostic));
    }
}

/// A label that looks like a jump.
struct Suspect<'a> {
    label: &'a Definition,
    jump: Keyword,
    /// The label that it would jump to.
    meant: &'a str,
}

/// Returns the label as a suspect, if it looks like a jump.
fn suspect(label: &Definition) -> Option<Suspect<'_>> {
    let (jump, meant) = glued(&label.name)?;
    (label.kind == DefinitionKind::Label).then_some(Suspect { label, jump, meant })
}

fn suspects(symbols: &Symbols) -> Vec<Suspect<'_>> {
    let definitions = symbols.definitions();
    if !definitions.iter().any(|label| suspect(label).is_some()) {
        return Vec::new();
    }
    let kinds: HashMap<&str, DefinitionKind> = definitions
        .iter()
        .map(|it| (it.name.as_str(), it.kind))
        .collect();
    let leads_on = |jump: Keyword, meant: &str| match kinds.get(meant) {
        None | Some(DefinitionKind::Variable(_) | DefinitionKind::Constant) => false,
        Some(kind) => jump != Keyword::Call || *kind == DefinitionKind::Subroutine,
    };
    let uses = symbols.all_uses().iter();
    let jumps = uses.filter(|it| matches!(it.access, Access::Jump | Access::Call));
    let used: HashSet<usize> = jumps.map(|it| it.definition.index()).collect();
    let is_unused = |(index, _): &(usize, &Definition)| !used.contains(index);
    definitions
        .iter()
        .enumerate()
        .filter(is_unused)
        .filter_map(|(_, label)| suspect(label))
        .filter(|it| leads_on(it.jump, it.meant))
        .collect()
}
