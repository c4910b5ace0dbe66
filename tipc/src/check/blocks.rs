//! The blocks of a program and what ties their ends.

use crate::language::Keyword;

/// What a block is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BlockKind {
    /// One branch of an IF.
    If,
    While,
    Repeat,
    For,
    Subroutine,
}

impl BlockKind {
    pub(super) const fn opener(self) -> Keyword {
        match self {
            BlockKind::If => Keyword::If,
            BlockKind::While => Keyword::While,
            BlockKind::Repeat => Keyword::Repeat,
            BlockKind::For => Keyword::For,
            BlockKind::Subroutine => Keyword::Subroutine,
        }
    }

    pub(super) const fn closer(self) -> Keyword {
        match self {
            BlockKind::If => Keyword::EndIf,
            BlockKind::While => Keyword::Wend,
            BlockKind::Repeat => Keyword::Until,
            BlockKind::For => Keyword::Next,
            BlockKind::Subroutine => Keyword::SubEnd,
        }
    }
}

/// A block, by the index of the statement that opens it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block {
    pub(crate) kind: BlockKind,
    pub(crate) opener: usize,
    pub(crate) parent: Option<usize>,
    /// The innermost SUBROUTINE around it, or it itself.
    pub(crate) routine: Option<usize>,
    /// The statement that closes it.
    pub(super) end: usize,
    /// Its ends do not fit, which is reported: what crosses them is not reported again.
    pub(crate) broken: bool,
}

impl Block {
    /// Whether a statement lies inside. A SUBROUTINE's own step does: only calls reach it from outside.
    pub(crate) fn contains(&self, statement: usize) -> bool {
        let first = self.opener + usize::from(self.kind != BlockKind::Subroutine);
        (first..self.end).contains(&statement)
    }
}

/// How a control word is tied to others, by the indices of statements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Link {
    /// Of IF, ELSEIF: the next ELSEIF, ELSE or ENDIF. Of ELSE: ENDIF. Of WHILE, FOR: the closer.
    /// Of WEND, UNTIL, NEXT: the opener.
    pub(crate) partner: Option<usize>,
}

/// The block structure of a module.
#[derive(Clone, Debug, Default)]
pub(crate) struct Blocks {
    pub(crate) blocks: Vec<Block>,
    /// The innermost block around each statement.
    pub(crate) around: Vec<Option<usize>>,
    /// The ties of each statement.
    pub(crate) links: Vec<Link>,
}

impl Blocks {
    /// The blocks around a statement, innermost first.
    pub(crate) fn chain(&self, statement: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(self.around[statement], |block| self.blocks[*block].parent)
    }
}
