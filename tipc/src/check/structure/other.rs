//! Ends of blocks that other languages write: END for each, NEXT for a WHILE.

use super::{FAR, Matcher};
use crate::check::blocks::BlockKind;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::{Keyword, keywords};
use crate::lex::BLANKS;
use crate::message::{Message, Structuring, Suggestion};
use crate::source::Source;
use crate::syntax::{Shape, StatementKind};

impl Matcher<'_> {
    /// `WHILE … NEXT`: the end of another block, where the innermost one never gets its own. `other_open` says whether
    /// a block that it could close is open around that one.
    pub(super) fn closes_other(
        &mut self,
        index: usize,
        kind: BlockKind,
        name: Keyword,
        other_open: bool,
    ) -> bool {
        let Some(open) = self.open.last() else {
            return false;
        };
        let (inner, first, block) = (open.kind, open.first, open.block);
        let may_be = !inner.is_routine()
            && !kind.is_routine()
            && inner != kind
            && name == kind.closer()
            && !self.is_reported(first);
        let is_needed = || other_open && self.later(index, kind) < self.open.within(kind).len();
        if !may_be || self.later(index, inner) > 0 || is_needed() {
            return false;
        }
        self.open.pop();
        self.result.blocks[block].end = index;
        self.result.blocks[block].broken = true;
        let reason = Structuring::NothingOpen {
            opener: kind.opener(),
            word: name,
        };
        let (opener, closer) = (inner.opener(), inner.closer());
        let fault = Diagnostic::new(Code::Structure, self.location(index), reason)
            .label(self.location(first), Structuring::Open { opener })
            .help(Suggestion::Closes { opener, closer });
        if !self.is_reported(index) {
            self.found.push(fault);
        }
        true
    }

    /// Returns the number of ends of blocks of this kind that are open now and come after a statement.
    pub(super) fn later(&self, index: usize, kind: BlockKind) -> usize {
        let (mut inside, mut later) = (0, 0);
        for statement in self.module.statements[index + 1..].iter().take(FAR) {
            match statement.kind.shape() {
                Shape::Subroutine | Shape::SubEnd | Shape::Thread | Shape::ThreadEnd => break,
                shape if shape == opens(kind) => inside += 1,
                shape if shape == closes(kind) && inside == 0 => later += 1,
                shape if shape == closes(kind) => inside -= 1,
                _ => {}
            }
        }
        later
    }

    /// Reports an END inside a block, with statements and another END after it, that was to end the block or to stop
    /// the run.
    pub(super) fn ended_too_early(&mut self, source: &Source) -> Option<()> {
        let innermost = self.open.last()?;
        let last = self.module.statements.last()?;
        if last.kind != StatementKind::End || self.is_reported(innermost.first) {
            return None;
        }
        let (opener, closer) = (innermost.kind.opener(), innermost.kind.closer());
        let (line, _) = source.line_column(last.span.start);
        let after = (line + 1..=source.line_count()).map(|line| source.line_text(line));
        let words = after.map(|text| {
            let text = text.trim_matches(BLANKS);
            text.split([' ', '\t', ';']).next().unwrap_or_default()
        });
        let words: Vec<&str> = words.take(FAR).collect();
        let has = |word: Keyword| {
            let is_it = |one: &&str| one.eq_ignore_ascii_case(word.word());
            words.iter().any(is_it)
        };
        let help: Message = match (has(closer), has(Keyword::End)) {
            (true, _) => Suggestion::Exit.into(),
            (false, true) => Suggestion::Closes { opener, closer }.into(),
            (false, false) => return None,
        };
        let reason = Suggestion::EndInTwo {
            word: opener.into(),
        };
        let fault = Diagnostic::new(Code::Structure, last.span, reason)
            .label(self.location(innermost.first), Structuring::Open { opener })
            .help(help);
        self.found.push(fault);
        while let Some(open) = self.open.pop() {
            self.result.blocks[open.block].broken = true;
        }
        Some(())
    }

    /// `END IF` ends the program, and whatever is open with it.
    pub(super) fn ended_in_two_words(&mut self) -> Option<()> {
        let second = self.module.after_end.as_ref()?;
        let innermost = self.open.last()?;
        let (opener, closer) = (innermost.kind.opener(), innermost.kind.closer());
        // `END SUB`, `END FUNCTION`
        let is_routine = || {
            keywords::find(&second.node, self.module.edition).is_none() && closer == Keyword::SubEnd
        };
        if second.node != opener.word() && !is_routine() {
            return None;
        }
        let end = self.module.statements.last()?.span;
        let reason = Suggestion::EndInTwo {
            word: opener.into(),
        };
        let help = match closer {
            Keyword::Wend => Suggestion::Wend,
            Keyword::Next => Suggestion::Next,
            Keyword::SubEnd => Suggestion::SubEnd,
            _ => Suggestion::InOneWord {
                word: closer.into(),
            },
        };
        let fault = Diagnostic::new(Code::Structure, end.to(second.span), reason)
            .label(self.location(innermost.first), Structuring::Open { opener })
            .help(help);
        // `REPEAT 5` … `END REPEAT` is one mistake.
        let is_one = innermost.kind == BlockKind::Repeat && self.is_reported(innermost.first);
        self.found.extend(Some(fault).filter(|_| !is_one));
        while let Some(open) = self.open.pop() {
            self.result.blocks[open.block].broken = true;
        }
        Some(())
    }
}

fn opens(kind: BlockKind) -> Shape {
    match kind {
        BlockKind::If => Shape::If,
        BlockKind::While => Shape::While,
        BlockKind::Repeat => Shape::Repeat,
        BlockKind::For => Shape::For,
        BlockKind::Subroutine => Shape::Subroutine,
        BlockKind::Thread => Shape::Thread,
    }
}

fn closes(kind: BlockKind) -> Shape {
    match kind {
        BlockKind::If => Shape::EndIf,
        BlockKind::While => Shape::Wend,
        BlockKind::Repeat => Shape::Until,
        BlockKind::For => Shape::Next,
        BlockKind::Subroutine => Shape::SubEnd,
        BlockKind::Thread => Shape::ThreadEnd,
    }
}
