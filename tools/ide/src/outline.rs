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
        let mut folds: Vec<Fold> = self.block_folds().collect();
        folds.extend(self.comments());
        folds.sort_by_key(|fold| (fold.first, fold.last));
        folds
    }

    fn block_folds(&self) -> impl Iterator<Item = Fold> {
        let statements = self.statements();
        self.blocks().all.into_iter().filter_map(|block| {
            let closer = &statements[block.closer?];
            let first = statements[block.opener].line;
            // The line that closes a branch opens the next one, and stays.
            let last = match closer.kind.shape() {
                Shape::ElseIf | Shape::Else => closer.line - 1,
                _ => closer.line,
            };
            let kind = FoldKind::Block;
            (last > first).then_some(Fold { first, last, kind })
        })
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
