//! Warnings about a program that loads: it means something, but hardly what its author meant.
//!
//! A warning that fires on honest programs is wrong itself: each says in its file when it stays silent.

mod assignment;
mod commands;
mod conditions;
mod equations;
mod labels;
mod message;
mod routines;
mod unreachable;
mod waits;

use crate::analysis::Flow;
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Findings};
use crate::program::{Program, StepId};
use crate::robot::Robot;
use crate::source::Source;
use crate::symbols::Symbols;
use crate::syntax::{Module, Statement};

/// A program, and where its steps come from.
#[derive(Clone, Copy)]
pub(crate) struct Judged<'a> {
    pub(crate) source: &'a Source,
    pub(crate) module: &'a Module,
    pub(crate) symbols: &'a Symbols,
    pub(crate) program: &'a Program,
    pub(crate) flow: &'a Flow,
    pub(crate) robot: Robot,
}

impl Judged<'_> {
    /// Adds everything that its analysis gives reason to warn of to what was found before.
    pub(crate) fn warn(&self, found: &mut Findings) {
        let warnings = self.warnings();
        let meant = message::meant(&warnings);
        let is_meant = |name: &String| meant.contains(name.as_str());
        let follows = |finding: &Diagnostic| {
            matches!(finding.code, Code::Unused | Code::NeverRead)
                && finding.subject.as_ref().is_some_and(is_meant)
        };
        let means_any = message::means_any(&warnings);
        let is_unread = |finding: &Diagnostic| means_any && finding.code == Code::NeverRead;
        found.retain(|finding| !follows(finding) && !is_unread(finding));
        found.append(warnings);
    }

    fn warnings(&self) -> Findings {
        let mut found = self.of_statements();
        found.append(self.of_flow());
        found
    }

    /// What statements by themselves, and the values that they read, give reason for.
    fn of_statements(&self) -> Findings {
        let mut found = Findings::default();
        assignment::warn(self, &mut found);
        commands::warn(self, &mut found);
        equations::warn(self, &mut found);
        message::warn(self, &mut found);
        found
    }

    /// What conditions and jumps give reason for.
    fn of_flow(&self) -> Findings {
        let mut found = Findings::default();
        let constant = conditions::constant(self);
        let open: Vec<StepId> = constant.iter().map(|one| one.step).collect();
        let unreachable = unreachable::Unreachable::of(self, &open);
        conditions::warn(self, &constant, &unreachable, &mut found);
        routines::warn(self, &unreachable, &mut found);
        waits::warn(self, &unreachable, &mut found);
        unreachable.warn(self, &mut found);
        // It takes back what follows from it.
        labels::warn(self, &mut found);
        found
    }

    /// The statement that is a step.
    fn statement(&self, step: StepId) -> Option<&Statement> {
        let index = self.module.statement_of(step)?;
        Some(&self.module.statements[index])
    }
}
