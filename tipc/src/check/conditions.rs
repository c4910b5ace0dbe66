//! Conditions (T.I.P. 3.1 §6).

use super::resolve::Resolver;
use crate::code::Code;
use crate::program::Condition;
use crate::syntax;

impl Resolver<'_> {
    pub(super) fn condition(&mut self, condition: &syntax::Condition) -> Option<Condition> {
        match condition {
            syntax::Condition::Compare {
                left,
                relation,
                right,
            } => {
                let left = self.number(left, Code::Argument);
                let right = self.number(right, Code::Argument);
                Some(Condition::Compare {
                    left: left?,
                    relation: *relation,
                    right: right?,
                })
            }
            syntax::Condition::Flag { name, negated } => Some(Condition::Flag {
                flag: self.flag(name)?,
                negated: *negated,
            }),
        }
    }
}
