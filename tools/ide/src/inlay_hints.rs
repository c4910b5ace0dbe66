//! Inlay hints: durations of loops, and steps that never run.

use crate::Document;
use crate::message::Editing;
use tipc::code::Code;
use tipc::message::Message;
use tipc::source::Span;

/// A text that an editor shows after a statement.
#[derive(Clone, Debug, PartialEq)]
pub struct InlayHint {
    /// The end of the statement, as an offset.
    pub at: usize,
    /// The text.
    pub text: Message,
}

impl Document {
    /// Returns the hints inside a span, in the order of the text.
    pub fn inlay_hints(&self, span: Span) -> Vec<InlayHint> {
        let module = &self.loaded.module;
        let is_inside = |at: &usize| span.start <= *at && *at <= span.end;
        let loops = self.parts().iter().filter_map(|part| {
            let index = module.statement_of(self.opener(part)?)?;
            let at = Some(module.statements[index].span.end).filter(is_inside)?;
            let text = self.turns(part);
            Some(InlayHint { at, text })
        });
        let found = self.loaded.diagnostics.iter();
        let unreachable = found.filter(|it| it.code == Code::Unreachable);
        let unreachable = unreachable.filter_map(|it| {
            let index = module.statement_at(it.span.start)?;
            let at = Some(module.statements[index].span.end).filter(is_inside)?;
            let text = Editing::NeverRuns.into();
            Some(InlayHint { at, text })
        });
        let mut hints: Vec<InlayHint> = loops.chain(unreachable).collect();
        hints.sort_by_key(|hint| hint.at);
        hints
    }
}
