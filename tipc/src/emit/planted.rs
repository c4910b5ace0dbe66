//! A fault on purpose, so that a test can show that it is found.

use super::{Options, emit};
use crate::program::{Action, Condition, Program, Relation};
use proc_macro2::TokenStream;

/// Spells a program as [`emit`] does, save that an IF that asks for `>` is content with `>=`.
pub fn planted(program: &Program, options: &Options) -> TokenStream {
    let mut wrong = program.clone();
    for step in &mut wrong.steps {
        if let Action::If { condition, .. } = &mut step.action
            && let Condition::Compare { relation, .. } = condition
            && *relation == Relation::Gt
        {
            *relation = Relation::Ge;
        }
    }
    emit(&wrong, options)
}
