//! From a name to where it is declared, and to every place that names it.

use crate::Document;
use tipc::source::Span;
use tipc::symbols::{Access, Use};

/// A place that names something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mention {
    /// The name alone, without sign, member and colon.
    pub span: Span,
    /// What is done there.
    pub kind: MentionKind,
}

/// What a place does with what it names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MentionKind {
    /// Declares it.
    Declares,
    /// Gives it a value.
    Assigns,
    /// Reads it, or leads there.
    Uses,
}

impl Document {
    /// Where the name at a byte of the text is declared; of a jump without a label, the LOOP that it leads to.
    pub fn definition(&self, offset: usize) -> Option<Span> {
        let named = self.named_or_left_out(offset)?;
        self.definition_of(named).place
    }

    /// Every place of the name at a byte of the text, in order; the declaration only if asked for.
    pub fn references(&self, offset: usize, with_declaration: bool) -> Vec<Mention> {
        let Some(named) = self.named_or_left_out(offset) else {
            return Vec::new();
        };
        let uses = self.loaded.symbols.uses(named.definition);
        let written = uses.filter(|it| it.place.start < it.place.end);
        let mentions = written.map(|it| Mention {
            span: it.place,
            kind: self.kind(it),
        });
        mentions
            .filter(|it| with_declaration || it.kind != MentionKind::Declares)
            .collect()
    }

    fn kind(&self, named: &Use) -> MentionKind {
        if self.definition_of(named).place == Some(named.place) {
            return MentionKind::Declares;
        }
        match named.access {
            Access::Define => MentionKind::Declares,
            Access::Assign | Access::Update | Access::Count => MentionKind::Assigns,
            Access::Read | Access::Jump | Access::Call | Access::Unclear => MentionKind::Uses,
        }
    }

    /// The name there, or the one that a statement leaves out: GOTO, NEXT and KEY_IN alone.
    fn named_or_left_out(&self, offset: usize) -> Option<&Use> {
        if let Some(named) = self.name_at(offset) {
            return Some(named);
        }
        let statement = &self.statements()[self.loaded.module.statement_at(offset)?];
        let mut uses = self.loaded.symbols.within(statement.span).iter();
        uses.find(|it| it.place.start == it.place.end)
    }
}
