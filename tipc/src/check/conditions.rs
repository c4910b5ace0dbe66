//! Conditions (T.I.P. 3.1 §6).

use super::resolve::Resolver;
use super::targets::word;
use crate::code::Code;
use crate::language::flags;
use crate::message::Suggestion;
use crate::program::Condition;
use crate::syntax;
use tip_runtime::command::CONSTANT;

impl Resolver<'_> {
    pub(super) fn condition(&mut self, condition: &syntax::Condition) -> Option<Condition> {
        match condition {
            syntax::Condition::Compare {
                left,
                relation,
                right,
            } => {
                let is_flag = word(left).is_some_and(|name| self.is_flag(name));
                let told = self.found.len();
                let left = self.number(left, Code::Argument);
                if left.is_none() && is_flag {
                    // What it is compared with is not wrong for itself.
                    self.suggest_reading(right, told);
                    return None;
                }
                let told = self.found.len();
                let right = self.number(right, Code::Argument);
                self.suggest_key(told);
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

    fn is_flag(&self, name: &str) -> bool {
        !self.names.has(name) && flags::find(name, self.names.edition).is_some()
    }

    /// Suggests reading the key for a flag that is compared with one.
    fn suggest_reading(&mut self, right: &syntax::Operand, told: usize) {
        let key = word(right).filter(|word| word.starts_with(CONSTANT));
        if let (Some(fault), Some(key)) = (self.found.get_mut(told), key) {
            fault.help = Some(Suggestion::KeyFirst { key: key.into() }.into());
        }
    }

    /// Suggests a key's constant for a letter that is compared with and not declared.
    fn suggest_key(&mut self, told: usize) {
        for fault in &mut self.found[told..] {
            let name = fault.subject.as_deref().unwrap_or_default();
            let is_key = name.len() == 1 && name.starts_with(|c: char| c.is_ascii_uppercase());
            if fault.code == Code::UnknownVariable && is_key {
                let character = name.into();
                fault.help = Some(Suggestion::CharacterOrVariable { character }.into());
            }
        }
    }
}
