//! The blocks of a program: the statements that open and close each, and the block around every statement. A program with errors has
//! blocks too, as far as they match.

use crate::Document;
use tipc::syntax::Shape;

/// A block; of an IF, one of its branches. Statements are named by their indices.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block {
    /// The kind of the statement that opens it.
    pub(crate) shape: Shape,
    pub(crate) opener: usize,
    /// The statement that ends it, which may begin another branch; `None` if it is not closed.
    pub(crate) closer: Option<usize>,
    /// The block around it.
    pub(crate) around: Option<usize>,
    /// The SUBROUTINE or THREAD that it is or that it is in.
    pub(crate) routine: Option<usize>,
}

/// The blocks of a program, in the order of their openers.
#[derive(Debug, Default)]
pub(crate) struct Blocks {
    pub(crate) all: Vec<Block>,
    /// The innermost block that is open after each statement.
    after: Vec<Option<usize>>,
}

impl Document {
    pub(crate) fn blocks(&self) -> Blocks {
        let mut blocks = Blocks::default();
        let mut open: Vec<usize> = Vec::new();
        for (index, statement) in self.statements().iter().enumerate() {
            let shape = statement.kind.shape();
            let is_closed = |block: &usize| shape.closes().contains(&blocks.all[*block].shape);
            if let Some(place) = open.iter().rposition(is_closed) {
                blocks.all[open[place]].closer = Some(index);
                open.truncate(place);
            }
            if shape.opens() {
                let around = open.last().copied();
                let id = blocks.all.len();
                let routine = match shape {
                    Shape::Subroutine | Shape::Thread => Some(id),
                    _ => around.and_then(|around| blocks.all[around].routine),
                };
                blocks.all.push(Block {
                    shape,
                    opener: index,
                    closer: None,
                    around,
                    routine,
                });
                open.push(id);
            }
            blocks.after.push(open.last().copied());
        }
        blocks
    }
}

impl Blocks {
    /// Returns the innermost block around the place before a statement, or behind the last one.
    pub(crate) fn before(&self, statement: usize) -> Option<usize> {
        let before = statement.checked_sub(1)?;
        self.after.get(before).copied().flatten()
    }

    /// Returns a block and those around it, the innermost first.
    pub(crate) fn outwards(&self, from: Option<usize>) -> impl Iterator<Item = usize> {
        std::iter::successors(from, |inner| self.all[*inner].around)
    }
}
