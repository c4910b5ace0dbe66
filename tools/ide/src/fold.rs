//! Folding ranges: blocks, and comments of several lines.

use crate::Document;
use tipc::lex::split_comment;
use tipc::syntax::Shape;

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
