//! Blocks around the cursor: which of their words may begin a statement there, and which labels a jump may lead to.

use crate::Document;
use crate::block::Blocks;
use tipc::language::{Edition, Keyword};
use tipc::syntax::{Shape, Statement};

/// The place of a statement among the blocks of a program.
pub(super) struct Place<'a> {
    statements: &'a [Statement],
    edition: Edition,
    blocks: Blocks,
    innermost: Option<usize>,
    /// True for each block around this place.
    around: Vec<bool>,
}

impl Document {
    /// Returns the place of the statement that begins, or is to begin, at an offset.
    pub(super) fn place_in_blocks(&self, at: usize) -> Place<'_> {
        let statements = self.statements();
        let blocks = self.blocks();
        let first = statements.partition_point(|it| it.span.end <= at);
        let innermost = blocks.before(first);
        let mut around = vec![false; blocks.all.len()];
        for block in blocks.outwards(innermost) {
            around[block] = true;
        }
        Place {
            innermost,
            around,
            statements,
            edition: self.edition(),
            blocks,
        }
    }
}

impl Place<'_> {
    /// Returns the statement that opens the innermost block.
    pub(super) fn opener(&self) -> Option<&Statement> {
        let block = &self.blocks.all[self.innermost?];
        Some(&self.statements[block.opener])
    }

    /// Returns true if a word of blocks may begin a statement here. A word that closes a block may do so only where one is open.
    pub(super) fn fits(&self, keyword: Keyword) -> bool {
        let innermost = self.innermost.map(|id| &self.blocks.all[id]);
        if let Keyword::End | Keyword::Subroutine | Keyword::Thread = keyword {
            return innermost.is_none();
        }
        let closer = Shape::of(keyword).filter(|shape| !shape.closes().is_empty());
        let Some(shape) = closer else {
            return true;
        };
        let closes = shape.closes();
        let Some(innermost) = innermost.filter(|block| closes.contains(&block.shape)) else {
            return false;
        };
        let ending = innermost.closer.map(|id| self.statements[id].kind.shape());
        match shape {
            Shape::Else | Shape::ElseIf if innermost.shape == Shape::Else => false,
            Shape::Else => !matches!(ending, Some(Shape::Else | Shape::ElseIf)),
            Shape::ElseIf => true,
            _ => {
                let mut around = self.blocks.outwards(self.innermost);
                around.any(|id| {
                    let block = &self.blocks.all[id];
                    block.closer.is_none() && closes.contains(&block.shape)
                })
            }
        }
    }

    /// Returns true if a jump from here may lead to the place of a statement: it leaves blocks, but it does not enter one.
    /// GOTO stays in its SUBROUTINE or THREAD, too.
    pub(super) fn reaches(&self, statement: usize, is_goto: bool) -> bool {
        let routine = |id: Option<usize>| id.and_then(|id| self.blocks.all[id].routine);
        let there = self.blocks.before(statement);
        // 3.1 warns of a jump into a FOR.
        let is_closed = |shape| self.edition.is_strict() || shape != Shape::For;
        let entered = self.blocks.outwards(there);
        let mut entered = entered.take_while(|block| !self.around[*block]);
        let enters = entered.any(|block| is_closed(self.blocks.all[block].shape));
        !(enters || is_goto && routine(there) != routine(self.innermost))
    }

    /// Returns the index of the statement at an offset.
    pub(super) fn statement_at(&self, at: usize) -> usize {
        self.statements.partition_point(|it| it.span.end <= at)
    }
}
