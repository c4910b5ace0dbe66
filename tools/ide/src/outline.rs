//! The structure of a program: the outline, a tree of variables, constants, labels, subroutines and threads; and folding ranges, of
//! blocks and of comments of several lines.

use crate::Document;
use tipc::lex::split_comment;
use tipc::source::Span;
use tipc::symbols::DefinitionKind;
use tipc::syntax::Shape;

/// A declaration of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outline {
    /// Its name as written.
    pub name: String,
    /// Its kind.
    pub kind: DefinitionKind,
    /// Its extent: a subroutine up to its end, a label up to the next one.
    pub span: Span,
    /// The span of its name.
    pub name_span: Span,
    /// The declarations inside it.
    pub children: Vec<Outline>,
}

/// Returns true for a label of its own, a SUBROUTINE and a THREAD.
const fn is_label(kind: DefinitionKind) -> bool {
    matches!(
        kind,
        DefinitionKind::Label | DefinitionKind::Subroutine | DefinitionKind::Thread
    )
}

impl Document {
    /// Returns variables, constants, labels, subroutines and threads in the order of the text. A label inside a subroutine
    /// or thread is its child.
    pub fn outline(&self) -> Vec<Outline> {
        let mut found: Vec<Outline> = Vec::new();
        let definitions = self.loaded.symbols.definitions().iter();
        let mut names: Vec<(Span, DefinitionKind)> = definitions
            .filter_map(|it| Some((it.span?, it.kind)))
            .collect();
        names.sort_unstable_by_key(|(name, _)| *name);
        let mut labels = names
            .iter()
            .filter(|(_, kind)| is_label(*kind))
            .map(|(name, _)| name.start)
            .skip(1)
            .collect::<Vec<_>>()
            .into_iter();
        for (name, kind) in names {
            let end = match kind {
                DefinitionKind::Variable(_) | DefinitionKind::Constant => name.end,
                DefinitionKind::Subroutine | DefinitionKind::Thread => {
                    labels.next();
                    self.end_of_subroutine(name)
                }
                DefinitionKind::Label => self.end_of_label(name, labels.next()),
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
                    if matches!(
                        around.kind,
                        DefinitionKind::Subroutine | DefinitionKind::Thread
                    ) && is_label(kind)
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

/// Lines that can be folded into the first of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fold {
    /// The line that stays visible, from 1.
    pub first: u32,
    /// The last line that is hidden.
    pub last: u32,
    /// Their kind.
    pub kind: FoldKind,
}

/// The kind of a fold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FoldKind {
    /// A block of statements.
    Block,
    /// Lines of comment.
    Comment,
}

impl Document {
    /// Returns all folds in the order of their first lines.
    pub fn folds(&self) -> Vec<Fold> {
        let mut folds = self.blocks();
        folds.extend(self.comments());
        folds.sort_by_key(|fold| (fold.first, fold.last));
        folds
    }

    fn blocks(&self) -> Vec<Fold> {
        let mut open: Vec<(Shape, u32)> = Vec::new();
        let mut folds = Vec::new();
        for statement in self.statements() {
            let shape = statement.kind.shape();
            let closes = opener(shape);
            if let Some(closes) = closes
                && let Some(at) = open.iter().rposition(|(shape, _)| closes.contains(shape))
            {
                let (_, first) = open[at];
                open.truncate(at);
                // The line that closes a branch opens the next one, and stays.
                let last = match shape {
                    Shape::ElseIf | Shape::Else => statement.line - 1,
                    _ => statement.line,
                };
                if last > first {
                    let kind = FoldKind::Block;
                    folds.push(Fold { first, last, kind });
                }
            }
            if opens(shape) {
                open.push((shape, statement.line));
            }
        }
        folds
    }

    fn comments(&self) -> Vec<Fold> {
        let source = &self.loaded.source;
        let mut folds = Vec::new();
        let mut run: Option<(u32, u32)> = None;
        let mut close = |run: Option<(u32, u32)>| {
            if let Some((first, last)) = run.filter(|(first, last)| last > first) {
                let kind = FoldKind::Comment;
                folds.push(Fold { first, last, kind });
            }
        };
        for line in source.lines().filter(|line| line.number != 2) {
            let (code, comment) = split_comment(source.text(), line.span);
            let is_comment = comment.is_some() && source.slice(code).trim().is_empty();
            run = match (run, is_comment) {
                (Some((first, last)), true) if last + 1 == line.number => {
                    Some((first, line.number))
                }
                (before, is_comment) => {
                    close(before);
                    is_comment.then_some((line.number, line.number))
                }
            };
        }
        close(run);
        folds
    }
}

fn opens(shape: Shape) -> bool {
    matches!(
        shape,
        Shape::If
            | Shape::ElseIf
            | Shape::Else
            | Shape::While
            | Shape::Repeat
            | Shape::For
            | Shape::Subroutine
            | Shape::Thread
    )
}

/// Returns the shapes that a statement closes.
fn opener(shape: Shape) -> Option<&'static [Shape]> {
    Some(match shape {
        Shape::ElseIf | Shape::Else | Shape::EndIf => &[Shape::If, Shape::ElseIf, Shape::Else],
        Shape::Wend => &[Shape::While],
        Shape::Until => &[Shape::Repeat],
        Shape::Next => &[Shape::For],
        Shape::SubEnd => &[Shape::Subroutine],
        Shape::ThreadEnd => &[Shape::Thread],
        _ => return None,
    })
}
