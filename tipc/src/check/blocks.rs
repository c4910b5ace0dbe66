//! The blocks of a program and what ties their ends.

use crate::language::Keyword;
use std::collections::HashMap;

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

/// The blocks as a tree, in which the way up is searched in steps that grow: a jump may lead out of any number of them.
pub(super) struct Tree<'a> {
    blocks: &'a [Block],
    nodes: Vec<Node>,
}

/// A block in the tree, or, as the first node, the program around all of them.
#[derive(Clone, Copy, Default)]
struct Node {
    parent: usize,
    /// An outer one further up.
    far: usize,
    depth: usize,
    /// Numbers of sound FORs and of other sound blocks from here up.
    sound: [usize; 2],
}

impl<'a> Tree<'a> {
    pub(super) fn of(blocks: &'a [Block]) -> Self {
        let mut nodes = vec![Node::default()];
        for block in blocks {
            let parent = block.parent.map_or(0, |parent| parent + 1);
            let Node {
                far,
                depth,
                mut sound,
                ..
            } = nodes[parent];
            let is_as_far =
                depth - nodes[far].depth == nodes[far].depth - nodes[nodes[far].far].depth;
            sound[usize::from(block.kind != BlockKind::For)] += usize::from(!block.broken);
            nodes.push(Node {
                parent,
                far: if is_as_far { nodes[far].far } else { parent },
                depth: depth + 1,
                sound,
            });
        }
        Tree { blocks, nodes }
    }

    /// Returns the outermost sound FOR, and the outermost other sound block, that are around a statement or the block
    /// `inner` itself, but not around the statement `from`.
    pub(super) fn entered(&self, inner: Option<usize>, from: usize) -> [Option<usize>; 2] {
        let inner = inner.map_or(0, |block| block + 1);
        let holds_from = |at: usize| at == 0 || self.blocks[at - 1].contains(from);
        let common = match holds_from(inner) {
            true => inner,
            false => self.nodes[self.climb(inner, |at| !holds_from(at))].parent,
        };
        [0, 1].map(|of| {
            let outside = self.nodes[common].sound[of];
            let is_inside = |at: usize| self.nodes[at].sound[of] > outside;
            is_inside(inner).then(|| self.climb(inner, is_inside) - 1)
        })
    }

    /// Returns the outermost node from one up of which something holds: of that node it does, and of the program it
    /// does not.
    fn climb(&self, from: usize, holds: impl Fn(usize) -> bool) -> usize {
        let mut at = from;
        loop {
            let Node { parent, far, .. } = self.nodes[at];
            at = match (holds(far), holds(parent)) {
                (true, _) => far,
                (false, true) => parent,
                (false, false) => return at,
            };
        }
    }
}
