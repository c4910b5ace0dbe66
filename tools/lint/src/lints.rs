//! Lints: valid programs that are probably not what their author meant.
//!
//! A lint that fires on honest programs is wrong itself: each says in its file when it stays silent.

mod assignment;
mod commands;
mod conditions;
mod equations;
mod file;
mod labels;
mod message;
mod overridden;
mod routines;
mod threads;
mod unreachable;
mod waits;
mod walk;

use crate::allow::Allows;
use crate::{Loaded, Options};
use tipc::Robot;
use tipc::analysis::flow::Flow;
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::program::{Program, StepId};
use tipc::source::Source;
use tipc::symbols::Symbols;
use tipc::syntax::{Module, Statement};

/// A program, and where its steps come from.
#[derive(Clone, Copy)]
struct LintContext<'a> {
    source: &'a Source,
    module: &'a Module,
    symbols: &'a Symbols,
    program: &'a Program,
    flow: &'a Flow,
    robot: Robot,
}

/// Adds the lints of a file to what was found in it, and leaves out what its comments silence.
pub(crate) fn find(
    loaded: &Loaded,
    mut found: Diagnostics,
    bytes: &[u8],
    options: &Options,
) -> Diagnostics {
    if let Some(program) = &loaded.program {
        let context = LintContext {
            source: &loaded.source,
            module: &loaded.module,
            symbols: &loaded.symbols,
            program,
            flow: &Flow::of(program),
            robot: options.robot,
        };
        context.warn(&mut found);
        let encoding = file::other_encoding(loaded, bytes, options);
        let title = file::title(loaded, options);
        let after_end = file::after_end(&loaded.source, &loaded.module);
        found.extend(encoding.into_iter().chain(title).chain(after_end));
    }
    let mut allows = Allows::of(&loaded.source, &loaded.module);
    allows.silence(&loaded.source, &mut found);
    if loaded.program.is_some() {
        found.extend(allows.warnings(&loaded.source));
    }
    found
}

/// Adds warnings that others found about a program, except those that a comment silences.
pub(crate) fn add(loaded: &mut Loaded, mut found: Vec<Diagnostic>) {
    if !found.is_empty() {
        Allows::of(&loaded.source, &loaded.module).silence(&loaded.source, &mut found);
        loaded.report(found.into());
    }
}

impl LintContext<'_> {
    /// Adds everything that its analysis gives reason to warn of to what was found before.
    fn warn(&self, found: &mut Diagnostics) {
        let warnings = self.warnings();
        let meant = message::placeholder_names(&warnings);
        let is_meant = |name: &String| meant.contains(name.as_str());
        let follows = |diagnostic: &Diagnostic| {
            matches!(diagnostic.code, Code::Unused | Code::NeverRead)
                && diagnostic.subject.as_ref().is_some_and(is_meant)
        };
        let means_any = message::means_any(&warnings);
        let is_unread = |diagnostic: &Diagnostic| means_any && diagnostic.code == Code::NeverRead;
        found.retain(|diagnostic| !follows(diagnostic) && !is_unread(diagnostic));
        found.append(warnings);
    }

    fn warnings(&self) -> Diagnostics {
        let mut found = self.of_statements();
        found.append(self.of_flow());
        found
    }

    /// Returns warnings about statements by themselves, and the values that they read.
    fn of_statements(&self) -> Diagnostics {
        let mut found = Diagnostics::default();
        assignment::warn(self, &mut found);
        commands::warn(self, &mut found);
        equations::warn(self, &mut found);
        message::warn(self, &mut found);
        threads::warn(self, &mut found);
        overridden::warn(self, &mut found);
        found
    }

    /// Returns warnings about conditions and jumps.
    fn of_flow(&self) -> Diagnostics {
        let mut found = Diagnostics::default();
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

    /// Returns the statement that is a step.
    fn statement(&self, step: StepId) -> Option<&Statement> {
        let index = self.module.statement_of(step)?;
        Some(&self.module.statements[index])
    }
}
