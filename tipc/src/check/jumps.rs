//! Where jumps lead, and where they may not (T.I.P. 3.1 §4-2 path 4, §7-6, §7-7).

use super::blocks::{BlockKind, Blocks};
use super::labels::Labels;
use super::suggest::nearest;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::reserved::LOOP;
use crate::source::Span;
use crate::syntax::{Jump, JumpKind, Module, StatementKind};

/// Finds the statement that each jump leads to.
pub(crate) fn resolve(
    module: &Module,
    labels: &Labels<'_>,
    blocks: &Blocks,
    found: &mut Vec<Diagnostic>,
) -> Vec<Option<usize>> {
    let mut jumps = Jumps {
        module,
        labels,
        blocks,
        found,
    };
    module
        .statements
        .iter()
        .enumerate()
        .map(|(index, statement)| {
            let (kind, jump) = statement.kind.jump()?;
            let place = jump.label.as_ref().map_or(jump.keyword, |label| label.span);
            let to = jumps.target(index, kind, jump, place)?;
            jumps.check(index, to, kind, jump.keyword);
            Some(to)
        })
        .collect()
}

struct Jumps<'a> {
    module: &'a Module,
    labels: &'a Labels<'a>,
    blocks: &'a Blocks,
    found: &'a mut Vec<Diagnostic>,
}

impl Jumps<'_> {
    fn target(&mut self, index: usize, kind: JumpKind, jump: &Jump, place: Span) -> Option<usize> {
        let name = jump
            .label
            .as_ref()
            .map_or(LOOP, |label| label.node.as_str());
        if name == LOOP {
            return self.loop_target(index, kind, place);
        }
        let Some(to) = self.statement_of(self.labels.find(name)) else {
            let help = match nearest(name, self.labels.names()) {
                Some(near) => format!("did you mean `{near}:`?"),
                None => format!("declare it: `{name}:`"),
            };
            let fault = Diagnostic::new(Code::UnknownLabel, place, "no such label");
            self.found.push(fault.about(name).help(help));
            return None;
        };
        if kind == JumpKind::Call && !self.is_subroutine(to) {
            let reason = format!("`{name}` is a plain label, not a SUBROUTINE");
            let fault = Diagnostic::new(Code::Argument, place, reason)
                .label(self.module.statements[to].span, "declared here")
                .help("GOSUB calls plain labels");
            self.found.push(fault);
            return None;
        }
        Some(to)
    }

    fn loop_target(&mut self, index: usize, kind: JumpKind, place: Span) -> Option<usize> {
        if kind != JumpKind::Goto {
            let fault = Diagnostic::new(Code::Argument, place, "LOOP is a label for GOTO only");
            self.found
                .push(fault.help("give the routine a label of its own"));
            return None;
        }
        let to = self.statement_of(self.labels.loop_above(index));
        if to.is_none() {
            let reason = "no LOOP label stands above this jump";
            let fault = Diagnostic::new(Code::UnknownLabel, place, reason).about(LOOP);
            self.found
                .push(fault.help("put `LOOP:` where the repetition starts"));
        }
        to
    }

    fn statement_of(&self, label: Option<usize>) -> Option<usize> {
        label.map(|label| self.labels.all[label].statement)
    }

    fn is_subroutine(&self, statement: usize) -> bool {
        matches!(
            self.module.statements[statement].kind,
            StatementKind::Subroutine { .. }
        )
    }

    /// A jump may leave blocks, but not enter them; GOTO may not leave a SUBROUTINE.
    fn check(&mut self, from: usize, to: usize, kind: JumpKind, place: Span) {
        let blocks = self.blocks;
        let called = kind != JumpKind::Goto && self.is_subroutine(to);
        let entered = blocks
            .chain(to)
            .take_while(|block| !blocks.blocks[*block].contains(from))
            .filter(|block| {
                let block = &blocks.blocks[*block];
                let is_called = called && block.opener == to;
                !block.broken && !is_called
            });
        let mut entered_for = None;
        let mut refused = None;
        for block in entered {
            match blocks.blocks[block].kind {
                BlockKind::For => entered_for = Some(block),
                _ => refused = Some(block),
            }
        }
        if let Some(block) = refused {
            return self.refuse_entry(block, to, place);
        }
        if kind == JumpKind::Goto
            && let Some(left) = self.left_subroutine(from, to)
        {
            return self.refuse_leaving(left, to, place);
        }
        if let Some(block) = entered_for {
            self.warn_of_for(block, to, place);
        }
    }

    fn left_subroutine(&self, from: usize, to: usize) -> Option<usize> {
        let blocks = &self.blocks.blocks;
        let routine = blocks[self.blocks.around[from]?].routine?;
        let left = !blocks[routine].broken && !blocks[routine].contains(to);
        left.then_some(routine)
    }

    fn refuse_entry(&mut self, block: usize, to: usize, place: Span) {
        let block = self.blocks.blocks[block];
        let opener = &self.module.statements[block.opener];
        let (what, help) = match block.kind {
            BlockKind::If => ("a branch of an IF", "move the label out of the branch"),
            BlockKind::While => ("a WHILE", "jump to a label before the WHILE"),
            BlockKind::Repeat => ("a REPEAT", "jump to a label before the REPEAT"),
            BlockKind::For => ("a FOR", "jump to a label before the FOR"),
            BlockKind::Subroutine => ("a SUBROUTINE", "CALL the SUBROUTINE"),
        };
        let reason = format!("this jump enters {what} from outside");
        let mut fault = Diagnostic::new(Code::Structure, place, reason)
            .label(opener.keyword(), "the block starts here");
        if block.opener != to {
            fault = fault.label(self.module.statements[to].span, "the label");
        }
        self.found.push(fault.help(help));
    }

    fn refuse_leaving(&mut self, block: usize, to: usize, place: Span) {
        let opener = &self.module.statements[self.blocks.blocks[block].opener];
        let fault = Diagnostic::new(Code::Structure, place, "GOTO leaves its SUBROUTINE")
            .label(opener.keyword(), "the SUBROUTINE starts here")
            .label(self.module.statements[to].span, "the label")
            .help("leave a SUBROUTINE with RETURN or SUBEND");
        self.found.push(fault);
    }

    fn warn_of_for(&mut self, block: usize, to: usize, place: Span) {
        let opener = &self.module.statements[self.blocks.blocks[block].opener];
        let reason = "NEXT counts a variable that FOR may not have set";
        let warning = Diagnostic::new(Code::EntersFor, place, reason)
            .label(opener.keyword(), "the FOR")
            .label(self.module.statements[to].span, "the label");
        self.found.push(warning);
    }
}
