//! Variables that NEXT names: they say which FOR is meant.

use super::Matcher;
use super::other::FAR;
use crate::check::blocks::BlockKind;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::message::{Parsing, Structuring};
use crate::syntax::{Operand, OperandKind, StatementKind};

impl Matcher<'_> {
    /// `FOR I`, `FOR J`, `NEXT I`: the outer FOR, whose variable NEXT names, if the inner one never gets its own NEXT.
    pub(super) fn named_by_next(&self, index: usize) -> Option<usize> {
        let name = self.named(index)?;
        let fors = self.open.within(BlockKind::For);
        let near = &fors[fors.len().saturating_sub(FAR)..];
        let mut near = near.iter().rev();
        let place = near.position(|at| self.counter(self.open[*at].first) == Some(name))?;
        let is_innermost = place == 0;
        // With enough others for those around it, it names the wrong variable.
        let is_outer = !is_innermost && self.later(index, BlockKind::For) < fors.len() - 1;
        is_outer.then(|| fors[fors.len() - 1 - place])
    }

    /// The variable of a FOR.
    fn counter(&self, index: usize) -> Option<&str> {
        match &self.module.statements[index].kind {
            StatementKind::For { counting, .. } => name_of(&counting.variable),
            _ => None,
        }
    }

    /// The variable that a NEXT names.
    fn named(&self, index: usize) -> Option<&str> {
        match &self.module.statements[index].kind {
            StatementKind::Next { variable, .. } => name_of(variable.as_ref()?),
            _ => None,
        }
    }

    /// NEXT may name the variable of its FOR, and no other.
    pub(super) fn check_counter(&mut self, opener: usize, closer: usize) {
        let (
            StatementKind::For { counting, .. },
            StatementKind::Next {
                variable: Some(named),
                ..
            },
        ) = (
            &self.module.statements[opener].kind,
            &self.module.statements[closer].kind,
        )
        else {
            return;
        };
        let variable = &counting.variable;
        if name_of(variable) != name_of(named) {
            let reason = match name_of(named) {
                Some(name) => Structuring::NextNames { name: name.into() },
                None => Structuring::NextNamesAnother,
            };
            let help = Parsing::NextNamesItsVariable;
            let fault = Diagnostic::new(Code::Structure, named.span, reason)
                .label(variable.span, Structuring::VariableOfFor)
                .help(help);
            self.found.push(fault);
        }
    }
}

fn name_of(operand: &Operand) -> Option<&str> {
    match &operand.kind {
        OperandKind::Name(name) => Some(name),
        _ => None,
    }
}
