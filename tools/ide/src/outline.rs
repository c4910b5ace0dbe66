//! What a program declares, as a tree.

use crate::Document;
use tipc::source::Span;
use tipc::symbols::DefinitionKind;
use tipc::syntax::{Shape, VariableKind};

/// Something that a program declares.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outline {
    /// Its name as it is written.
    pub name: String,
    /// What it is.
    pub kind: OutlineKind,
    /// All of it: of a subroutine up to its end, of a label up to the next one.
    pub span: Span,
    /// Its name where it is declared.
    pub name_span: Span,
    /// What is declared inside it.
    pub children: Vec<Outline>,
}

/// What is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum OutlineKind {
    /// A variable of this type.
    Variable(VariableKind),
    /// A label.
    Label,
    /// A SUBROUTINE.
    Subroutine,
}

impl Document {
    /// Variables, labels and subroutines in the order of the text. A label inside a subroutine is its child.
    pub fn outline(&self) -> Vec<Outline> {
        let mut found: Vec<Outline> = Vec::new();
        let definitions = self.loaded.symbols.definitions().iter();
        let mut places: Vec<(Span, OutlineKind)> = definitions
            .filter_map(|it| Some((it.place?, kind(it.kind))))
            .collect();
        places.sort_unstable_by_key(|(place, _)| *place);
        let mut labels = places
            .iter()
            .filter(|(_, kind)| !matches!(kind, OutlineKind::Variable(_)))
            .map(|(place, _)| place.start)
            .skip(1)
            .collect::<Vec<_>>()
            .into_iter();
        for (place, kind) in places {
            let end = match kind {
                OutlineKind::Variable(_) => place.end,
                OutlineKind::Subroutine => {
                    labels.next();
                    self.end_of_subroutine(place)
                }
                OutlineKind::Label => self.end_of_label(place, labels.next()),
            };
            let one = Outline {
                name: self.slice(place).to_owned(),
                kind,
                span: Span::new(place.start, end.max(place.end)),
                name_span: place,
                children: Vec::new(),
            };
            let is_variable = matches!(kind, OutlineKind::Variable(_));
            match found.last_mut() {
                Some(around)
                    if around.kind == OutlineKind::Subroutine
                        && !is_variable
                        && one.span.end <= around.span.end =>
                {
                    around.children.push(one);
                }
                _ => found.push(one),
            }
        }
        found
    }

    /// What is inside each SUBROUTINE, in order.
    pub(crate) fn subroutines(&self) -> Vec<Span> {
        let mut inside: Vec<Span> = Vec::new();
        let mut start = None;
        for statement in self.statements() {
            match statement.kind.shape() {
                Shape::Subroutine => start = Some(statement.span.end),
                Shape::SubEnd => {
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
        let end = after.find(|it| it.kind.shape() == Shape::SubEnd);
        end.map_or(name.end, |it| it.span.end)
    }

    /// The end of the last statement before the next label or the end of its subroutine.
    fn end_of_label(&self, name: Span, next: Option<usize>) -> usize {
        let statements = self.statements();
        let first = statements.partition_point(|it| it.span.end < name.end);
        let is_inside = |it: &&tipc::syntax::Statement| {
            next.is_none_or(|next| it.span.start < next)
                && !matches!(it.kind.shape(), Shape::SubEnd | Shape::Subroutine)
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
    }
}
