//! Judges what the parser read: names, types, arguments, structure, jumps, use of variables.
//!
//! Every pass reports all that it finds; none stops another.

mod arguments;
mod equations;
mod inputs;
mod jumps;
mod labels;
mod names;
mod ranges;
mod resolve;
mod structure;
mod targets;
mod texts;
mod uses;
mod values;

use crate::code::Code;
use crate::diagnostic::Diagnostics;
use crate::program::{Action, Variable};
use crate::robot::Robot;
use crate::source::Source;
use crate::symbols::Symbols;
use crate::syntax::Module;
pub(crate) use labels::DeclaredLabel;
use labels::{Labels, Title};
use names::{NamedConstant, Names};
use structure::Blocks;

/// Results of the first passes.
struct Known<'a> {
    source: &'a Source,
    module: &'a Module,
    robot: Robot,
    names: &'a Names,
    labels: &'a Labels<'a>,
    blocks: &'a Blocks,
    title: &'a Title,
}

/// Results of the passes over a module.
#[derive(Debug)]
pub(crate) struct Checked<'m> {
    /// Definitions and uses of names.
    pub(crate) symbols: Symbols,
    /// The resolved module; `None` if a statement could not be resolved.
    pub(crate) resolved: Option<ResolvedModule<'m>>,
    /// All diagnostics, including those of the parser.
    pub(crate) found: Diagnostics,
}

/// A module whose statements are all resolved.
#[derive(Debug)]
pub(crate) struct ResolvedModule<'m> {
    /// The variables, `VAR_KEY` first.
    pub(crate) variables: Vec<Variable>,
    /// The constants that DEFINE names.
    pub(crate) constants: Vec<NamedConstant>,
    /// The labels, SUBROUTINEs and THREADs.
    pub(crate) labels: Vec<DeclaredLabel<'m>>,
    /// The action of each statement; none for a declaration, which is not a step.
    pub(crate) actions: Vec<Option<Action>>,
}

/// Runs every pass over a module. `found` has the diagnostics of the parser.
pub(crate) fn check<'m>(
    source: &Source,
    module: &'m Module,
    robot: Robot,
    mut found: Diagnostics,
) -> Checked<'m> {
    let title = Title::of(source, module);
    let names = Names::collect(source, module, robot, &mut found);
    let labels = Labels::collect(module, &mut found);
    let blocks = structure::blocks(source, module, &names, &title, &mut found);
    let known = Known {
        source,
        module,
        robot,
        names: &names,
        labels: &labels,
        blocks: &blocks,
        title: &title,
    };
    let jumps = jumps::resolve(&known, &mut found);
    let (actions, named) = resolve::statements(&known, &jumps, &mut found);
    // The uses of variables are known only if the blocks are whole.
    if found
        .iter()
        .all(|diagnostic| diagnostic.code != Code::Structure)
    {
        uses::report(source, &names, &named, &mut found);
        if !module.edition.is_strict() {
            jumps::warn_of_entries(module, &labels, &mut found);
        }
    }
    let resolved = actions.map(|actions| ResolvedModule {
        variables: names.variables,
        constants: names.constants,
        labels: labels.all,
        actions,
    });
    Checked {
        symbols: named.symbols,
        resolved,
        found,
    }
}
