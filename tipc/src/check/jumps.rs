//! Targets of jumps, and targets that are not allowed (T.I.P. 3.1 §4-2 path 4, §7-6, §7-7).

use super::Known;
use super::labels::Labels;
use super::structure::BlockKind;
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Diagnostics, MistakeId};
use crate::language::Keyword;
use crate::language::reserved::LOOP;
use crate::lex::{Kind, Token, lex, split_comment};
use crate::message::phrase::Entered;
use crate::message::{Message, Naming, Structuring, Suggestion};
use crate::source::{Source, Span};
use crate::suggest::{nearest, nearest_label};
use crate::syntax::{Jump, JumpKind, Module, StatementKind, upper_case};
use std::cell::OnceCell;
use std::collections::HashMap;

/// Targets of jumps.
#[derive(Debug)]
pub(crate) struct Resolved {
    /// The statement that each jump leads to.
    pub(crate) targets: Vec<Option<usize>>,
    /// The jumps to each label without its colon, by the statement of the label.
    pub(crate) bare: HashMap<usize, Vec<Span>>,
}

/// Finds the statement that each jump leads to.
pub(super) fn resolve(known: &Known<'_>, found: &mut Diagnostics) -> Resolved {
    let mut jumps = Jumps {
        known,
        after_end: OnceCell::new(),
        bare: HashMap::new(),
        found,
    };
    let targets = known
        .module
        .statements
        .iter()
        .enumerate()
        .map(|(index, statement)| {
            let (kind, jump) = statement.kind.jump()?;
            let location = jump.label.as_ref().map_or(jump.keyword, |label| label.span);
            let to = jumps.target(index, kind, jump, location)?;
            if kind != JumpKind::Thread {
                jumps.check(index, to, kind, jump.keyword);
            }
            Some(to)
        })
        .collect();
    Resolved {
        targets,
        bare: jumps.bare,
    }
}

struct Jumps<'a> {
    known: &'a Known<'a>,
    /// Labels and SUBROUTINEs that stand after END.
    after_end: OnceCell<HashMap<String, Span>>,
    bare: HashMap<usize, Vec<Span>>,
    found: &'a mut Diagnostics,
}

impl Jumps<'_> {
    fn target(
        &mut self,
        index: usize,
        kind: JumpKind,
        jump: &Jump,
        location: Span,
    ) -> Option<usize> {
        let name = jump
            .label
            .as_ref()
            .map_or(LOOP, |label| label.node.as_str());
        if name == LOOP {
            return self.loop_target(index, kind, jump, location);
        }
        let Some(to) = self.statement_of(self.known.labels.find(name)) else {
            if self.explains_missing_label(name, jump, location) {
                return None;
            }
            let near = match self.found.are_many() {
                true => None,
                false => nearest_label(name, self.known.labels.names()),
            };
            let help = match near {
                Some(near) => Structuring::DidYouMean { near: near.into() },
                None if kind == JumpKind::Thread => Structuring::WriteThread { name: name.into() },
                None => Structuring::DeclareLabel { name: name.into() },
            };
            let reason = Structuring::NoSuchLabel { name: name.into() };
            let fault = Diagnostic::new(Code::UnknownLabel, location, reason);
            let fault = fault.once(MistakeId::Label(name.into()));
            let fault = fault.about(name).help(help);
            self.found.push(self.known.title.labels(name, fault));
            return None;
        };
        if self.refuses_kind(kind, to, name, location) {
            return None;
        }
        if kind == JumpKind::Call && !self.is_subroutine(to) {
            if self.known.labels.is_again(name) {
                return None;
            }
            let reason = Structuring::PlainLabel { name: name.into() };
            let fault = Diagnostic::new(Code::Argument, location, reason)
                .label(self.known.module.statements[to].span, Naming::DeclaredHere)
                .help(Structuring::GosubCalls);
            self.found.push(fault);
            return None;
        }
        Some(to)
    }

    fn loop_target(
        &mut self,
        index: usize,
        kind: JumpKind,
        jump: &Jump,
        location: Span,
    ) -> Option<usize> {
        if kind != JumpKind::Goto {
            if let Some(fault) = self.found.of_mistake(&MistakeId::RoutineLoop) {
                fault.point(location, Naming::AlsoHere);
                return None;
            }
            let fault = Diagnostic::new(Code::Argument, location, Structuring::LoopForGoto);
            self.found.push(fault.help(Structuring::OwnLabel));
            return None;
        }
        let to = self.statement_of(self.known.labels.loop_above(index));
        if to.is_none() && !self.explains_missing_label(LOOP, jump, location) {
            let reason = Structuring::NoLoopAbove;
            let fault = Diagnostic::new(Code::UnknownLabel, location, reason).about(LOOP);
            let fault = fault.once(MistakeId::Label(LOOP.into()));
            let near = match &jump.label {
                Some(_) if !self.found.are_many() => nearest(LOOP, self.known.labels.names()),
                _ => None,
            };
            let help: Message = match (&jump.label, near) {
                (None, _) => Suggestion::GotoLoop.into(),
                (Some(_), Some(near)) => Structuring::DidYouMean { near: near.into() }.into(),
                (Some(_), None) => Structuring::PutLoop.into(),
            };
            self.found
                .push(self.known.title.labels(LOOP, fault.help(help)));
        }
        to
    }

    /// Reports a jump to a missing label as part of another mistake, if there is one: the label lacks its colon or
    /// stands after END, or the jump itself is broken. Returns true if so.
    fn explains_missing_label(&mut self, name: &str, jump: &Jump, location: Span) -> bool {
        if let Some(label) = self.known.labels.bare(name) {
            let jumps = self.bare.entry(label).or_default();
            // A broken jump has its own diagnostic.
            jumps.extend(Some(location).filter(|_| !jump.broken));
            return true;
        }
        if jump.broken || self.known.names.may_declare(name) {
            return true;
        }
        let Some((end, label)) = self.label_after_end(name) else {
            return false;
        };
        let reason = Structuring::NoSuchLabel { name: name.into() };
        let fault = Diagnostic::new(Code::UnknownLabel, location, reason).about(name);
        let fault = fault
            .once(MistakeId::LabelsAfterEnd)
            .label(end, Suggestion::EndsTheText)
            .label(label, Suggestion::StandsAfterEnd);
        self.found.push(fault.help(Suggestion::AfterEnd));
        true
    }

    /// Returns the locations of END and of the label of that name after it.
    fn label_after_end(&self, name: &str) -> Option<(Span, Span)> {
        let end = self.known.module.statements.last()?;
        if end.kind != StatementKind::End {
            return None;
        }
        let after = Span::new(end.span.end, self.known.source.text().len());
        let labels = self
            .after_end
            .get_or_init(|| labels_in(self.known.source, after));
        labels.get(name).map(|label| (end.span, *label))
    }

    fn statement_of(&self, label: Option<usize>) -> Option<usize> {
        label.map(|label| self.known.labels.all[label].statement)
    }

    /// Reports a THREAD that is called, and a label that is no THREAD in the place of one.
    fn refuses_kind(&mut self, kind: JumpKind, to: usize, name: &str, location: Span) -> bool {
        let is_thread = matches!(
            self.known.module.statements[to].kind,
            StatementKind::Thread { .. }
        );
        let name = name.into();
        let (reason, help) = match (kind, is_thread) {
            (JumpKind::Thread, false) => (Structuring::NoThread { name }, Structuring::OnlyThreads),
            (JumpKind::Call | JumpKind::Gosub, true) => {
                (Structuring::CalledThread { name }, Structuring::StartIt)
            }
            _ => return false,
        };
        let fault = Diagnostic::new(Code::Argument, location, reason)
            .label(self.known.module.statements[to].span, Naming::DeclaredHere)
            .help(help);
        self.found.push(fault);
        true
    }

    fn is_subroutine(&self, statement: usize) -> bool {
        matches!(
            self.known.module.statements[statement].kind,
            StatementKind::Subroutine { .. }
        )
    }

    /// Checks that a jump enters no block and a GOTO leaves no SUBROUTINE or THREAD; a jump may leave blocks.
    fn check(&mut self, from: usize, to: usize, kind: JumpKind, location: Span) {
        let mut inner = self.known.blocks.around[to];
        if let Some(routine) = inner
            && kind != JumpKind::Goto
            && self.is_subroutine(to)
        {
            // A call may enter the SUBROUTINE that it names.
            inner = self.known.blocks.blocks[routine].parent;
        }
        let [entered_for, refused] = self.known.blocks.entered(inner, from);
        let is_strict = self.known.module.edition.is_strict();
        if let Some(block) = refused.or(entered_for.filter(|_| is_strict)) {
            return self.refuse_entry(block, to, location);
        }
        if kind == JumpKind::Goto
            && let Some(left) = self.left_subroutine(from, to)
        {
            return self.refuse_leaving(left, to, location);
        }
        if let Some(block) = entered_for {
            self.warn_of_for(block, to, location);
        }
    }

    fn left_subroutine(&self, from: usize, to: usize) -> Option<usize> {
        let blocks = &self.known.blocks.blocks;
        let routine = blocks[self.known.blocks.around[from]?].routine?;
        let left = !blocks[routine].broken && !blocks[routine].contains(to);
        left.then_some(routine)
    }

    fn refuse_entry(&mut self, block: usize, to: usize, location: Span) {
        let block = self.known.blocks.blocks[block];
        let opener = &self.known.module.statements[block.opener];
        let before = Structuring::JumpBefore {
            opener: block.kind.opener(),
        };
        let (block_name, help) = match block.kind {
            BlockKind::If => (Entered::Branch, Structuring::MoveOut),
            BlockKind::While => (Entered::While, before),
            BlockKind::Repeat => (Entered::Repeat, before),
            BlockKind::For => (Entered::For, before),
            BlockKind::Subroutine => (Entered::Subroutine, Structuring::CallIt),
            BlockKind::Thread => (Entered::Thread, Structuring::StartIt),
        };
        let reason = Structuring::Enters { block: block_name };
        let mut fault = Diagnostic::new(Code::Structure, location, reason)
            .label(opener.keyword(), Structuring::BlockStarts);
        if block.opener != to {
            fault = fault.label(self.known.module.statements[to].span, Structuring::Label);
        }
        self.found.push(fault.help(help));
    }

    fn refuse_leaving(&mut self, block: usize, to: usize, location: Span) {
        let opener = &self.known.module.statements[self.known.blocks.blocks[block].opener];
        let is_thread = matches!(opener.kind, StatementKind::Thread { .. });
        let (reason, starts, help) = match is_thread {
            true => (
                Structuring::LeavesThread,
                Structuring::ThreadStarts,
                Structuring::ThreadEndsAt,
            ),
            false => (
                Structuring::LeavesSubroutine,
                Structuring::SubroutineStarts,
                Structuring::LeaveWith,
            ),
        };
        let fault = Diagnostic::new(Code::Structure, location, reason)
            .label(opener.keyword(), starts)
            .label(self.known.module.statements[to].span, Structuring::Label)
            .help(help);
        self.found.push(fault);
    }

    fn warn_of_for(&mut self, block: usize, to: usize, location: Span) {
        let opener = &self.known.module.statements[self.known.blocks.blocks[block].opener];
        let reason = Structuring::NextCounts;
        let warning = Diagnostic::new(Code::EntersFor, location, reason)
            .label(opener.keyword(), Structuring::For)
            .label(self.known.module.statements[to].span, Structuring::Label);
        self.found.push(warning);
    }
}

/// Returns the labels and the names of SUBROUTINEs and THREADs in a part of the text, each at its first location.
fn labels_in(source: &Source, span: Span) -> HashMap<String, Span> {
    let mut all = HashMap::new();
    let mut tokens = Vec::new();
    let lines = source.lines().map(|line| line.span);
    for line in lines.filter(|line| line.start >= span.start) {
        tokens.clear();
        let (code, _) = split_comment(source.text(), line);
        lex(source.text(), code, &mut tokens);
        let word = |token: &Token| upper_case(source.slice(token.span));
        let openers = [Keyword::Subroutine, Keyword::Thread];
        let opens = |token: &Token| openers.iter().any(|it| word(token) == it.word());
        let name = match tokens.as_slice() {
            [name, colon, ..] if colon.kind == Kind::Colon => name,
            [first, name, ..] if opens(first) => name,
            _ => continue,
        };
        all.entry(word(name).to_string()).or_insert(name.span);
    }
    all
}

/// Warns of each SUBROUTINE that a run can enter from the step above it.
pub(crate) fn warn_of_entries(module: &Module, labels: &Labels<'_>, found: &mut Diagnostics) {
    let mut open_above = true;
    for statement in &module.statements {
        if !statement.is_step() {
            continue;
        }
        let is_reported = |location: Span| found.iter().any(|it| it.span == location);
        if let StatementKind::Subroutine { keyword, name } = &statement.kind
            && open_above
            && !labels.is_again(&name.node)
            && !is_reported(*keyword)
        {
            let reason = Structuring::RunsInto;
            let help = Structuring::PutJumpAbove;
            let warning = Diagnostic::new(Code::RunsInto, *keyword, reason);
            found.push(warning.about(name.node.as_str()).help(help));
        }
        open_above = statement.kind.goes_on();
    }
}
