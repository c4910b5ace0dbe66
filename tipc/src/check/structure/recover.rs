//! Reports of openers and closers that do not fit, with a guess at what was meant.
//!
//! A missing closer is reported once. If it comes later, after a word that closed an outer block, it is expected and
//! not a second mistake; and an unknown statement may be a misspelt closer. Most guesses are about words of other
//! languages: END for each block, NEXT for a WHILE.

use super::{BlockKind, Matcher, Open};
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Handle, Label, MistakeId};
use crate::language::{Keyword, commands, keywords};
use crate::lex::BLANKS;
use crate::message::{Message, Structuring, Suggestion};
use crate::source::{Source, Span};
use crate::suggest::nearest;
use crate::syntax::{Operand, OperandKind, Shape, StatementKind};

/// Maximum number of statements among which the closer of a block is searched, and of blocks among which the one that a
/// closer names is searched.
const MAX_BLOCK_DISTANCE: usize = 1_000;

/// The closers of one kind that are expected although their construct is reported.
#[derive(Default)]
pub(super) struct AllOwed {
    all: Vec<Owed>,
    /// Number of them whose ELSEIF and ELSE are expected as well.
    branches: usize,
}

/// A closer that may still come for a construct that is reported already. It is not a second mistake.
struct Owed {
    /// The diagnostic of the construct, if it was cut off.
    fault: Option<Handle>,
    /// True if ELSEIF and ELSE are expected as well.
    branches: bool,
}

impl Matcher<'_> {
    /// Reports a word of a block that no open construct takes, unless it is part of a mistake that is reported.
    pub(super) fn nothing_open(&mut self, index: usize, kind: BlockKind, name: Keyword) {
        // The word itself may be broken, which is reported.
        let is_reported = self.is_reported(index);
        let before = self.open.last().map_or(0, |open| open.unknown);
        if self.settle_owed(index, kind, name) || is_reported {
            return;
        }
        if self.takes_unknown(before, false).is_some() {
            if name != kind.closer() {
                self.owes(kind, None, true);
            }
            return;
        }
        let (opener, closer) = (kind.opener(), kind.closer());
        let reason = Structuring::NothingOpen { opener, word: name };
        let help = match (name == closer, kind) {
            (false, _) => {
                // The rest of the IF is no second mistake.
                self.owes(kind, None, name == Keyword::ElseIf);
                Structuring::IfFirst { word: name }
            }
            (_, BlockKind::Subroutine) => Structuring::SubEndCloses,
            (_, BlockKind::Thread) => Structuring::ThreadEndCloses,
            _ => Structuring::Opens { opener, closer },
        };
        let mut fault = Diagnostic::new(Code::Structure, self.location(index), reason).help(help);
        if let Some(open) = self.open.last() {
            let opener = open.kind.opener();
            let text = Structuring::Open { opener };
            fault = fault.label(self.location(open.first), text);
        }
        self.found.push(self.title.opens(opener, fault));
    }

    /// Reads an IF with a statement on its line, as in other languages. An ENDIF may follow, which is expected.
    pub(super) fn one_line_if(&mut self, index: usize) {
        self.result.around[index] = self.current();
        self.owes(BlockKind::If, None, true);
    }

    pub(super) fn owes(&mut self, kind: BlockKind, fault: Option<Handle>, branches: bool) {
        let owed = &mut self.owed[kind as usize];
        owed.branches += usize::from(branches);
        owed.all.push(Owed { fault, branches });
    }

    /// Returns true if the first word of a statement is none of the language.
    pub(super) fn is_unknown(&self, index: usize) -> bool {
        match &self.module.statements[index].kind {
            StatementKind::Command { name, .. } => {
                commands::find_in(&name.node, self.module.edition).is_none()
            }
            _ => false,
        }
    }

    /// Removes unknown statements, the last one first, up to one that may be an opener or closer of a block, and
    /// returns that. The first `before` ones stay. A closer is alone in its statement; neither is near to a command.
    pub(super) fn takes_unknown(&mut self, before: usize, is_closer: bool) -> Option<usize> {
        while self.unknown.len() > before {
            let index = self.unknown.pop()?;
            let StatementKind::Command {
                name, arguments, ..
            } = &self.module.statements[index].kind
            else {
                continue;
            };
            let known = commands::names(self.module.edition);
            if (!is_closer || arguments.is_empty()) && nearest(&name.node, known).is_none() {
                return Some(index);
            }
        }
        None
    }

    /// Reports the SUBROUTINEs and THREADs inside a construct that is closed.
    pub(super) fn refuse_nested(&mut self, open: &Open) {
        let (opener, closer) = (open.kind.opener(), open.kind.closer());
        for index in &open.nested {
            let inside = self.result.around[*index];
            if let Some(outer) = inside.and_then(|block| self.result.blocks[block].parent) {
                self.result.blocks[outer].broken = true;
            }
            let reason = match self.module.statements[*index].kind.shape() {
                Shape::Thread => Structuring::ThreadInside { opener },
                _ => Structuring::SubroutineInside { opener },
            };
            let fault = Diagnostic::new(Code::Structure, self.location(*index), reason)
                .label(self.location(open.first), Structuring::StillOpen { opener })
                .help(Structuring::CloseBefore { opener, closer });
            self.found.push(fault);
        }
    }

    /// Returns true if this word is expected for a construct that is reported already. A closer is then no longer
    /// expected.
    pub(super) fn settle_owed(&mut self, index: usize, kind: BlockKind, name: Keyword) -> bool {
        let owed = &mut self.owed[kind as usize];
        if name != kind.closer() {
            return owed.branches > 0;
        }
        let Some(last) = owed.all.pop() else {
            return false;
        };
        owed.branches -= usize::from(last.branches);
        let text = Structuring::StandsHere { word: name }.into();
        let span = self.location(index);
        // The diagnostic is missing if there are too many.
        if let Some(fault) = last.fault.and_then(|fault| self.found.get_mut(fault)) {
            fault.labels.push(Label { span, text });
        }
        true
    }

    /// Reports the innermost construct, which lacks its closer. `met` is the word that comes before it.
    pub(super) fn leave_open(&mut self, met: Option<(usize, Keyword)>) {
        let Some(open) = self.open.pop() else {
            return;
        };
        let (opener, closer) = (open.kind.opener(), open.kind.closer());
        let block = &mut self.result.blocks[open.block];
        block.broken = true;
        block.end = met.map_or(usize::MAX, |(index, _)| index);
        if self.is_reported(open.first) {
            return self.owes(open.kind, None, true);
        }
        if let Some(word) = self.takes_unknown(open.unknown, true) {
            self.result.closed_by.insert(word, open.block);
            return self.owes(open.kind, None, true);
        }
        // `DO` … `WHILE A < 3`: the WHILE ends a loop that an unknown word began, if the number of unknown words before
        // it is odd: each two of them are an opener and its closer.
        let outer = self.open.last().map_or(0, |outer| outer.unknown);
        let is_begun = (self.unknown.len() - outer.min(self.unknown.len())) % 2 == 1;
        if open.kind == BlockKind::While && is_begun && self.takes_unknown(outer, true).is_some() {
            return self.owes(open.kind, None, true);
        }
        if open.kind == BlockKind::While && met.is_none() && self.closes_repeat(open.first) {
            return;
        }
        let reason = Structuring::NotClosed { opener };
        let mut fault = Diagnostic::new(Code::Structure, self.location(open.first), reason)
            .help(Structuring::CloseWith { closer });
        if let Some(location) = self.return_in(&open) {
            fault = fault
                .label(location, Structuring::ReturnOfGosub)
                .help(Suggestion::SubEnd);
        }
        if let Some(nested) = open.nested.first() {
            let text = Structuring::SubroutineBefore { closer };
            fault = fault.label(self.location(*nested), text);
        }
        fault = match (met, self.module.statements.last()) {
            (Some((index, name)), _) => {
                let text = match name == closer {
                    true => Structuring::ClosesOuter { word: name },
                    false => Structuring::WordBefore { word: name, closer },
                };
                fault.label(self.location(index), text)
            }
            (None, Some(last)) => fault.label(last.span, Structuring::EndsBefore { closer }),
            (None, None) => fault,
        };
        let fault = self.found.push(fault);
        if met.is_some() {
            self.owes(open.kind, fault, true);
        }
    }

    /// Reports a WHILE that nothing closes as the end of the REPEAT around it, as in `REPEAT` … `WHILE A < 3`. Returns
    /// false if there is no such REPEAT.
    pub(super) fn closes_repeat(&mut self, index: usize) -> bool {
        let Some(repeat) = self.open.last().filter(|it| it.kind == BlockKind::Repeat) else {
            return false;
        };
        let (opener, word) = (Keyword::While, Keyword::Repeat);
        let location = self.location(repeat.first);
        let fault = Diagnostic::new(
            Code::Structure,
            self.location(index),
            Structuring::NotClosed { opener },
        );
        let fault = fault.label(location, Structuring::StandsHere { word });
        self.found.push(fault.help(Suggestion::UntilCloses));
        if let Some(repeat) = self.open.pop() {
            self.result.blocks[repeat.block].broken = true;
        }
        true
    }

    /// Returns the location of a RETURN that was probably meant to close a SUBROUTINE.
    pub(super) fn return_in(&self, open: &Open) -> Option<Span> {
        if open.kind != BlockKind::Subroutine {
            return None;
        }
        let inside = self.module.statements[open.first + 1..].iter();
        let mut inside = inside.take_while(|it| it.kind.shape() != Shape::Subroutine);
        let found = inside.find(|it| it.kind == StatementKind::Return)?;
        Some(found.span)
    }

    /// Returns true if a statement is wrong in itself, which is reported.
    pub(super) fn is_reported(&self, index: usize) -> bool {
        let statement = &self.module.statements[index];
        matches!(statement.kind, StatementKind::Broken(_))
    }

    /// Returns the outer FOR whose variable NEXT names, if the inner one has no NEXT of its own: `FOR I`, `FOR J`,
    /// `NEXT I`.
    pub(super) fn named_by_next(&self, index: usize) -> Option<usize> {
        let name = self.named(index)?;
        let fors = self.open.within(BlockKind::For);
        let near = &fors[fors.len().saturating_sub(MAX_BLOCK_DISTANCE)..];
        let mut near = near.iter().rev();
        let location = near.position(|at| self.counter(self.open[*at].first) == Some(name))?;
        let is_innermost = location == 0;
        // If enough NEXTs follow for the FORs around, this one names the wrong variable.
        let is_outer = !is_innermost && self.later(index, BlockKind::For) < fors.len() - 1;
        is_outer.then(|| fors[fors.len() - 1 - location])
    }

    /// Returns the variable of a FOR.
    pub(super) fn counter(&self, index: usize) -> Option<&str> {
        match &self.module.statements[index].kind {
            StatementKind::For { counting, .. } => name_of(&counting.variable),
            _ => None,
        }
    }

    /// Returns the variable that a NEXT names.
    pub(super) fn named(&self, index: usize) -> Option<&str> {
        match &self.module.statements[index].kind {
            StatementKind::Next { variable, .. } => name_of(variable.as_ref()?),
            _ => None,
        }
    }

    /// Checks that NEXT names the variable of its FOR, or none.
    pub(super) fn check_counter(&mut self, opener: usize, closer: usize) {
        let (
            StatementKind::For { counting, .. },
            StatementKind::Next {
                variable: Some(named),
                ..
            },
        ) = (
            &self.module.statements[opener].kind,
            &self.module.statements[closer].kind,
        )
        else {
            return;
        };
        // A variable that is not declared or of another type is reported elsewhere.
        let (Some(name), Some(of)) = (name_of(named), name_of(&counting.variable)) else {
            return;
        };
        if name == of || self.names.find(name).is_none() {
            return;
        }
        // `FOR A`, `FOR B`, `NEXT A`, `NEXT B` is one mistake.
        let start = match self.crossed.remove(&(of, name)) {
            Some(first) => first,
            None => {
                self.crossed.insert((name, of), closer);
                closer
            }
        };
        let reason = Structuring::NextNames { name: name.into() };
        let fault = Diagnostic::new(Code::Structure, named.span, reason)
            .once(MistakeId::CrossedNext(start))
            .label(counting.variable.span, Structuring::VariableOfFor)
            .help(named_by(of));
        self.found.push(fault);
    }

    /// Closes the innermost block by the closer of another kind, as in `WHILE … NEXT`, and reports it, if the block has
    /// no closer of its own. `other_open` is true if a block that the closer fits is open around it. Returns true if it
    /// closed the block.
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

    /// Returns the number of closers after a statement that belong to open blocks of this kind.
    pub(super) fn later(&self, index: usize, kind: BlockKind) -> usize {
        let (mut inside, mut later) = (0, 0);
        for statement in self.module.statements[index + 1..]
            .iter()
            .take(MAX_BLOCK_DISTANCE)
        {
            match statement.kind.shape().keyword() {
                Some(
                    Keyword::Subroutine | Keyword::SubEnd | Keyword::Thread | Keyword::ThreadEnd,
                ) => break,
                Some(word) if word == kind.opener() => inside += 1,
                Some(word) if word == kind.closer() && inside == 0 => later += 1,
                Some(word) if word == kind.closer() => inside -= 1,
                _ => {}
            }
        }
        later
    }

    /// Reports an END inside a block that was probably meant to end the block or to stop the run, since the closer or
    /// another END follows it.
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
        let words: Vec<&str> = words.take(MAX_BLOCK_DISTANCE).collect();
        let has = |word: Keyword| words.iter().any(|one| word.is(one));
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

    /// Reports a closer in two words, such as `END IF`: its END ends the program, and so all open blocks.
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

/// Returns the help for a NEXT that names another variable than its FOR.
pub(in crate::check) fn named_by(variable: &str) -> Suggestion {
    let text = format!("{} {variable}", Keyword::Next).into();
    Suggestion::Write { text }
}

fn name_of(operand: &Operand) -> Option<&str> {
    match &operand.kind {
        OperandKind::Name(name) => Some(name),
        _ => None,
    }
}
