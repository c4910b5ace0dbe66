//! The outline: variables, constants, labels, subroutines and threads of a program as a tree.

use crate::Document;
use tipc::source::Span;
use tipc::symbols::DefinitionKind;
use tipc::syntax::{Shape, VariableKind};

/// A declaration of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outline {
    /// Its name as written.
    pub name: String,
    /// Its kind.
    pub kind: OutlineKind,
    /// Its extent: a subroutine up to its end, a label up to the next one.
    pub span: Span,
    /// The span of its name.
    pub name_span: Span,
    /// The declarations inside it.
    pub children: Vec<Outline>,
}

/// The kind of a declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum OutlineKind {
    /// A variable of this type.
    Variable(VariableKind),
    /// A label.
    Label,
    /// A SUBROUTINE.
    Subroutine,
    /// A THREAD.
    Thread,
    /// A constant that DEFINE names.
    Constant,
}

impl OutlineKind {
    /// Returns true for a label of its own, a SUBROUTINE and a THREAD.
    const fn is_label(self) -> bool {
        matches!(
            self,
            OutlineKind::Label | OutlineKind::Subroutine | OutlineKind::Thread
        )
    }
}

impl Document {
    /// Returns variables, constants, labels, subroutines and threads in the order of the text. A label inside a subroutine
    /// or thread is its child.
    pub fn outline(&self) -> Vec<Outline> {
        let mut found: Vec<Outline> = Vec::new();
        let definitions = self.loaded.symbols.definitions().iter();
        let mut names: Vec<(Span, OutlineKind)> = definitions
            .filter_map(|it| Some((it.span?, kind(it.kind))))
            .collect();
        names.sort_unstable_by_key(|(name, _)| *name);
        let mut labels = names
            .iter()
            .filter(|(_, kind)| kind.is_label())
            .map(|(name, _)| name.start)
            .skip(1)
            .collect::<Vec<_>>()
            .into_iter();
        for (name, kind) in names {
            let end = match kind {
                OutlineKind::Variable(_) | OutlineKind::Constant => name.end,
                OutlineKind::Subroutine | OutlineKind::Thread => {
                    labels.next();
                    self.end_of_subroutine(name)
                }
                OutlineKind::Label => self.end_of_label(name, labels.next()),
            };
            let one = Outline {
                name: self.slice(name).to_owned(),
                kind,
                span: Span::new(name.start, end.max(name.end)),
                name_span: name,
                children: Vec::new(),
            };
            match found.last_mut() {
                Some(around)
                    if matches!(around.kind, OutlineKind::Subroutine | OutlineKind::Thread)
                        && kind.is_label()
                        && one.span.end <= around.span.end =>
                {
                    around.children.push(one);
                }
                _ => found.push(one),
            }
        }
        found
    }

    /// Returns the inside of each SUBROUTINE and THREAD, in order.
    pub(crate) fn subroutines(&self) -> Vec<Span> {
        let mut inside: Vec<Span> = Vec::new();
        let mut start = None;
        for statement in self.statements() {
            match statement.kind.shape() {
                Shape::Subroutine | Shape::Thread => start = Some(statement.span.end),
                Shape::SubEnd | Shape::ThreadEnd => {
                    let start = start.take();
                    inside.extend(start.map(|start| Span::new(start, statement.span.start)));
                }
                _ => {}
            }
        }
        let end = self.loaded.source.text().len();
        inside.extend(start.map(|start| Span::new(start, end)));
        inside
    }

    fn end_of_subroutine(&self, name: Span) -> usize {
        let statements = self.statements();
        let first = statements.partition_point(|it| it.span.end < name.end);
        let mut after = statements[first..].iter();
        let end = after.find(|it| matches!(it.kind.shape(), Shape::SubEnd | Shape::ThreadEnd));
        end.map_or(name.end, |it| it.span.end)
    }

    /// Returns the end of the last statement before the next label or the end of its subroutine.
    fn end_of_label(&self, name: Span, next: Option<usize>) -> usize {
        let statements = self.statements();
        let first = statements.partition_point(|it| it.span.end < name.end);
        let is_inside = |it: &&tipc::syntax::Statement| {
            next.is_none_or(|next| it.span.start < next)
                && !matches!(
                    it.kind.shape(),
                    Shape::SubEnd | Shape::Subroutine | Shape::ThreadEnd | Shape::Thread
                )
        };
        let inside = statements[first..].iter().take_while(is_inside);
        inside.last().map_or(name.end, |it| it.span.end)
    }
}

fn kind(kind: DefinitionKind) -> OutlineKind {
    match kind {
        DefinitionKind::Variable(kind) => OutlineKind::Variable(kind),
        DefinitionKind::Label => OutlineKind::Label,
        DefinitionKind::Subroutine => OutlineKind::Subroutine,
        DefinitionKind::Thread => OutlineKind::Thread,
        DefinitionKind::Constant => OutlineKind::Constant,
    }
}
