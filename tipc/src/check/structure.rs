//! Openers and closers (T.I.P. 3.1 §7-6, §4-2 path 4).
//!
//! Each closer takes the innermost open construct of its kind. `recover` reports openers and closers that do not fit.

mod recover;

pub(super) use recover::named_by;

use super::labels::Title;
use super::names::Names;
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::language::Keyword;
use crate::message::Structuring;
use crate::source::{Source, Span};
use crate::syntax::{Module, Shape};
use recover::AllOwed;
use std::collections::HashMap;
use std::iter;
use std::ops::Deref;

/// Maximum number of blocks around a label that are searched for the outermost one that a jump enters. If there are
/// more, the outermost of those searched is reported.
const MAX_DEPTH: usize = 1_000;

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
    /// True if opener and closer do not fit, which is reported. A jump across them is not reported again.
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

/// The statement that belongs to a control word, by its index.
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
    /// The link of each statement.
    pub(crate) links: Vec<Link>,
    /// The block that each unknown statement was probably meant to close, by the index of that statement.
    pub(super) closed_by: HashMap<usize, usize>,
}

impl Blocks {
    /// Returns the outermost sound FOR, and the outermost other sound block, that are around a statement or the block
    /// `inner` itself, but not around the statement `from`.
    pub(super) fn entered(&self, inner: Option<usize>, from: usize) -> [Option<usize>; 2] {
        let mut entered = [None; 2];
        let around = iter::successors(inner, |id| self.blocks[*id].parent);
        for id in around.take(MAX_DEPTH) {
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

/// Links every control word to its partner and reports those without one.
pub(super) fn blocks(
    source: &Source,
    module: &Module,
    names: &Names,
    title: &Title,
    found: &mut Diagnostics,
) -> Blocks {
    let count = module.statements.len();
    let mut matcher = Matcher {
        module,
        names,
        title,
        result: Blocks {
            blocks: Vec::new(),
            around: vec![None; count],
            links: vec![Link::default(); count],
            closed_by: HashMap::new(),
        },
        open: Stack::default(),
        owed: Default::default(),
        unknown: Vec::new(),
        crossed: HashMap::new(),
        found,
    };
    for index in 0..count {
        matcher.statement(index);
    }
    matcher.close_rest(source);
    matcher.result
}

struct Open {
    kind: BlockKind,
    /// The statement that opened the whole construct.
    first: usize,
    /// The latest branch of an IF, whose link is still to be set.
    branch: usize,
    /// True if its ELSE was read.
    has_else: bool,
    /// The block of the current branch.
    block: usize,
    /// The SUBROUTINEs and THREADs directly inside, which are not allowed.
    nested: Vec<usize>,
    /// Number of entries of [`Matcher::unknown`] before it.
    unknown: usize,
}

/// The open constructs, outermost first, and the indices of those of each kind.
#[derive(Default)]
struct Stack {
    all: Vec<Open>,
    of_kind: [Vec<usize>; BlockKind::COUNT],
}

impl Stack {
    fn push(&mut self, open: Open) {
        self.of_kind[open.kind as usize].push(self.all.len());
        self.all.push(open);
    }

    fn pop(&mut self) -> Option<Open> {
        let open = self.all.pop()?;
        self.of_kind[open.kind as usize].pop();
        Some(open)
    }

    /// Returns the open blocks of a kind in the innermost SUBROUTINE or THREAD, or that one itself.
    fn within(&self, kind: BlockKind) -> &[usize] {
        let of_kind = &self.of_kind[kind as usize];
        let routines = [BlockKind::Subroutine, BlockKind::Thread];
        let routine = routines.map(|routine| self.of_kind[routine as usize].last());
        let routine = routine.into_iter().max().flatten();
        let outside = routine.map_or(0, |routine| of_kind.partition_point(|at| at < routine));
        &of_kind[outside..]
    }
}

impl Deref for Stack {
    type Target = [Open];

    fn deref(&self) -> &[Open] {
        &self.all
    }
}

struct Matcher<'a> {
    module: &'a Module,
    names: &'a Names,
    title: &'a Title,
    result: Blocks,
    open: Stack,
    /// The closers that may still come, by the kind of their construct.
    owed: [AllOwed; BlockKind::COUNT],
    /// Statements whose first word is unknown. Each of them may be the opener or closer that is missing.
    unknown: Vec<usize>,
    /// Statements of the NEXTs that name another variable than their FOR, by the two variables: that of NEXT, then that
    /// of FOR.
    crossed: HashMap<(&'a str, &'a str), usize>,
    found: &'a mut Diagnostics,
}

impl Matcher<'_> {
    fn statement(&mut self, index: usize) {
        match self.module.statements[index].kind.shape() {
            Shape::Plain => {
                self.result.around[index] = self.current();
                self.unknown
                    .extend(Some(index).filter(|_| self.is_unknown(index)));
            }
            Shape::If => self.open(BlockKind::If, index),
            Shape::OneLineIf => self.one_line_if(index),
            Shape::ElseIf => self.branch(index, Keyword::ElseIf),
            Shape::Else => self.branch(index, Keyword::Else),
            Shape::EndIf => self.close(index, BlockKind::If, Keyword::EndIf),
            Shape::While => self.open(BlockKind::While, index),
            Shape::Wend => self.close(index, BlockKind::While, Keyword::Wend),
            Shape::Repeat => self.open(BlockKind::Repeat, index),
            Shape::Until => self.close(index, BlockKind::Repeat, Keyword::Until),
            Shape::For => self.open(BlockKind::For, index),
            Shape::Next => self.close(index, BlockKind::For, Keyword::Next),
            Shape::Subroutine => self.open(BlockKind::Subroutine, index),
            Shape::SubEnd => self.close(index, BlockKind::Subroutine, Keyword::SubEnd),
            Shape::Thread => self.open(BlockKind::Thread, index),
            Shape::ThreadEnd => self.close(index, BlockKind::Thread, Keyword::ThreadEnd),
            Shape::Close => self.close_innermost(index),
        }
    }

    fn current(&self) -> Option<usize> {
        self.open.last().map(|open| open.block)
    }

    fn new_block(&mut self, kind: BlockKind, opener: usize, parent: Option<usize>) -> usize {
        let blocks = &mut self.result.blocks;
        let block = blocks.len();
        let routine = match kind {
            kind if kind.is_routine() => Some(block),
            _ => parent.and_then(|parent| blocks[parent].routine),
        };
        blocks.push(Block {
            kind,
            opener,
            parent,
            routine,
            end: usize::MAX,
            broken: false,
        });
        block
    }

    fn open(&mut self, kind: BlockKind, index: usize) {
        let is_routine = kind.is_routine();
        if is_routine {
            self.owed = Default::default();
            if let Some(outer) = self.open.all.last_mut() {
                outer.nested.push(index);
            }
        }
        let parent = self.current();
        let block = self.new_block(kind, index, parent);
        self.result.around[index] = if is_routine { Some(block) } else { parent };
        self.open.push(Open {
            kind,
            first: index,
            branch: index,
            has_else: false,
            block,
            nested: Vec::new(),
            unknown: self.unknown.len(),
        });
    }

    fn branch(&mut self, index: usize, name: Keyword) {
        let Some(mut open) = self.unwind(index, BlockKind::If, name) else {
            return;
        };
        if open.has_else {
            let reason = Structuring::BehindElse { word: name };
            let fault = Diagnostic::new(Code::Structure, self.location(index), reason)
                .label(self.location(open.branch), Structuring::Else)
                .help(Structuring::ElseIsLast);
            self.found.push(fault);
        }
        self.result.links[open.branch].partner = Some(index);
        self.result.blocks[open.block].end = index;
        open.block = self.new_block(BlockKind::If, index, self.current());
        open.branch = index;
        open.has_else |= name == Keyword::Else;
        self.open.push(open);
    }

    fn close(&mut self, index: usize, kind: BlockKind, name: Keyword) {
        let Some(open) = self.unwind(index, kind, name) else {
            return;
        };
        self.result.blocks[open.block].end = index;
        self.refuse_nested(&open);
        self.result.links[open.branch].partner = Some(index);
        self.result.links[index].partner = Some(open.first);
        if kind == BlockKind::For {
            self.check_counter(open.first, index);
        }
    }

    fn close_innermost(&mut self, index: usize) {
        match self.open.last().map(|open| open.kind) {
            Some(kind) => self.close(index, kind, kind.closer()),
            None => self.result.around[index] = None,
        }
    }

    /// Removes and returns the construct that a word belongs to: the innermost of its kind. Reports the constructs that
    /// stay open inside of it. If none is open, reports that and returns `None`.
    fn unwind(&mut self, index: usize, kind: BlockKind, name: Keyword) -> Option<Open> {
        // A closer does not reach out of its SUBROUTINE: else one missing closer there would cause errors in all of the
        // rest.
        let reachable = self.open.within(kind).last().copied();
        let reachable = reachable.map(|depth| self.named_by_next(index).unwrap_or(depth));
        let closes_other = self.closes_other(index, kind, name, reachable.is_some());
        let open = match reachable.filter(|_| !closes_other) {
            Some(depth) => {
                while self.open.len() > depth + 1 {
                    self.leave_open(Some((index, name)));
                }
                self.open.pop()
            }
            None => {
                if !closes_other {
                    self.nothing_open(index, kind, name);
                }
                None
            }
        };
        self.result.around[index] = self.current();
        open
    }

    fn close_rest(&mut self, source: &Source) {
        self.ended_in_two_words();
        self.ended_too_early(source);
        while !self.open.is_empty() {
            self.leave_open(None);
        }
    }

    fn location(&self, index: usize) -> Span {
        self.module.statements[index].keyword()
    }
}
