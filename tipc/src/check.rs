//! Judges what the parser read: names, types, arguments, structure, jumps, use of variables.
//!
//! Every pass reports all that it finds; none stops another.

mod arguments;
mod blocks;
mod conditions;
mod entries;
mod equations;
mod inputs;
mod jumps;
mod labels;
mod message;
mod names;
mod ranges;
mod resolve;
mod structure;
mod suggest;
mod targets;
mod usage;
mod uses;

use crate::diagnostic::Diagnostic;
use crate::program::Variable;
use crate::robot::Robot;
use crate::source::Source;
use crate::symbols::Symbols;
use crate::syntax::Module;
pub(crate) use blocks::Blocks;
pub(crate) use labels::Labels;
pub(crate) use resolve::Resolved;
#[cfg(feature = "robot-files")]
pub(crate) use suggest::nearest;

/// What the passes found out about a module, statement by statement.
#[derive(Debug)]
pub(crate) struct Checked<'m> {
    /// The variables, `VAR_KEY` first.
    pub(crate) variables: Vec<Variable>,
    /// The labels and subroutines.
    pub(crate) labels: Labels<'m>,
    /// The block structure.
    pub(crate) blocks: Blocks,
    /// Where each jump leads: the index of a statement.
    pub(crate) jumps: Vec<Option<usize>>,
    /// What the operands of each statement stand for.
    pub(crate) resolved: Vec<Resolved>,
    /// What the program names.
    pub(crate) symbols: Symbols,
}

/// Runs every pass over a module.
pub(crate) fn check<'m>(
    source: &Source,
    module: &'m Module,
    robot: Robot,
) -> (Checked<'m>, Vec<Diagnostic>) {
    let mut found = Vec::new();
    let names = names::Names::collect(module, robot, &mut found);
    let labels = Labels::collect(module, &mut found);
    let blocks = structure::blocks(module, &mut found);
    let jumps = jumps::resolve(module, &labels, &blocks, &mut found);
    let known = resolve::Known {
        source,
        module,
        robot,
        names: &names,
        labels: &labels,
        blocks: &blocks,
    };
    let (resolved, named) = resolve::statements(&known, &mut found);
    usage::report(source, &names, &named, &mut found);
    entries::warn_of_entries(module, &mut found);
    let checked = Checked {
        variables: names.variables,
        labels,
        blocks,
        jumps,
        resolved,
        symbols: named.symbols,
    };
    (checked, found)
}
