//! What an editor writes beside lines: the turns of loops, and steps that never run.

use crate::Document;
use crate::message::Editing;
use tipc::code::Code;
use tipc::message::Message;
use tipc::source::Span;

/// A remark beside a line.
#[derive(Clone, Debug, PartialEq)]
pub struct Hint {
    /// Where it stands: the end of a statement.
    pub at: usize,
    /// What it says.
    pub text: Message,
}

impl Document {
    /// The remarks in a stretch of the text, in order.
    pub fn hints(&self, span: Span) -> Vec<Hint> {
        let module = &self.loaded.module;
        let is_inside = |at: &usize| span.start <= *at && *at <= span.end;
        let loops = self.parts().iter().filter_map(|part| {
            let index = module.statement_of(self.opener(part)?)?;
            let at = Some(module.statements[index].span.end).filter(is_inside)?;
            let text = self.turns(part);
            Some(Hint { at, text })
        });
        let found = self.loaded.diagnostics.iter();
        let unreachable = found.filter(|it| it.code == Code::Unreachable);
        let unreachable = unreachable.filter_map(|it| {
            let index = module.statement_at(it.span.start)?;
            let at = Some(module.statements[index].span.end).filter(is_inside)?;
            let text = Editing::NeverRuns.into();
            Some(Hint { at, text })
        });
        let mut hints: Vec<Hint> = loops.chain(unreachable).collect();
        hints.sort_by_key(|hint| hint.at);
        hints
    }
}
