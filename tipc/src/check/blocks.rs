//! The blocks of a program and what ties their ends.

use crate::language::Keyword;
use std::collections::HashMap;
use std::iter;

/// The most blocks around a label that are looked at. Of a jump that enters more, one of these is named.
const DEEP: usize = 1_000;

/// Kind of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BlockKind {
    /// One branch of an IF.
    If,
    While,
    Repeat,
    For,
    Subroutine,
    Thread,
}

impl BlockKind {
    /// Number of kinds.
    pub(super) const COUNT: usize = BlockKind::Thread as usize + 1;

    /// Returns true for a SUBROUTINE or THREAD: it stands in no block, and holds none of its kind.
    pub(super) const fn is_routine(self) -> bool {
        matches!(self, BlockKind::Subroutine | BlockKind::Thread)
    }

    pub(super) const fn opener(self) -> Keyword {
        match self {
            BlockKind::If => Keyword::If,
            BlockKind::While => Keyword::While,
            BlockKind::Repeat => Keyword::Repeat,
            BlockKind::For => Keyword::For,
            BlockKind::Subroutine => Keyword::Subroutine,
            BlockKind::Thread => Keyword::Thread,
        }
    }

    pub(super) const fn closer(self) -> Keyword {
        match self {
            BlockKind::If => Keyword::EndIf,
            BlockKind::While => Keyword::Wend,
            BlockKind::Repeat => Keyword::Until,
            BlockKind::For => Keyword::Next,
            BlockKind::Subroutine => Keyword::SubEnd,
            BlockKind::Thread => Keyword::ThreadEnd,
        }
    }
}

/// A block, by the index of the statement that opens it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block {
    pub(crate) kind: BlockKind,
    pub(crate) opener: usize,
    pub(crate) parent: Option<usize>,
    /// The innermost SUBROUTINE or THREAD around it, or it itself.
    pub(crate) routine: Option<usize>,
    /// The statement that closes it.
    pub(super) end: usize,
    /// Its ends do not fit, which is reported: what crosses them is not reported again.
    pub(crate) broken: bool,
}

impl Block {
    /// Returns true if a statement lies inside. The own step of a SUBROUTINE or THREAD does: no GOTO reaches it from
    /// outside.
    pub(crate) fn contains(&self, statement: usize) -> bool {
        let first = self.opener + usize::from(!self.kind.is_routine());
        (first..self.end).contains(&statement)
    }
}

/// Ties of a control word to others, by the indices of statements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Link {
    /// For IF, ELSEIF: the next ELSEIF, ELSE or ENDIF. For ELSE: ENDIF. For WHILE, FOR: the closer.
    /// For WEND, UNTIL, NEXT: the opener.
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
    /// The blocks that unknown words were to close, by the statements of these.
    pub(super) closed_by: HashMap<usize, usize>,
}

impl Blocks {
    /// Returns the outermost sound FOR, and the outermost other sound block, that are around a statement or the block
    /// `inner` itself, but not around the statement `from`.
    pub(super) fn entered(&self, inner: Option<usize>, from: usize) -> [Option<usize>; 2] {
        let mut entered = [None; 2];
        let around = iter::successors(inner, |id| self.blocks[*id].parent);
        for id in around.take(DEEP) {
            let block = &self.blocks[id];
            if block.contains(from) {
                break;
            }
            if !block.broken {
                entered[usize::from(block.kind != BlockKind::For)] = Some(id);
            }
        }
        entered
    }
}
