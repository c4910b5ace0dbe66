//! Signs in the wrong order, or twice: `N =+ 5`, `--391`.

use super::reader::{Fault, Reader};
use crate::lex::Kind;
use crate::message::{Habit, Instead};
use crate::source::Span;
use crate::syntax::upper_case;

impl Reader<'_> {
    /// `N =+ 5`, where `N += 5` was meant.
    pub(super) fn turned_update(&self, sign: Span, operand: Span) -> Option<Fault> {
        let equals = self.before()?;
        let is_glued = equals.kind == Kind::Assign(None) && equals.span.end == sign.start;
        let name = self.slice(self.whole()).split('=').next()?.trim();
        let text = format!("{name} {}= {}", self.slice(sign), self.slice(operand));
        let both = equals.span.to(sign);
        let reason = Habit::NoOperator {
            sign: self.slice(both).into(),
        };
        let text = upper_case(&text);
        is_glued.then(|| self.fault_with_help(both, reason, Instead::Write { text }))
    }

    /// `--391`
    pub(super) fn two_signs(&self, first: Span, second: Span) -> Fault {
        let both = first.to(second);
        let third = self.left_tokens().get(2);
        let operand = third.map_or("", |it| self.slice(it.span));
        let text = format!("{}{operand}", self.slice(second)).into();
        let reason = Habit::NoOperator {
            sign: self.slice(both).into(),
        };
        self.fault_with_help(both, reason, Instead::Write { text })
    }
}
