//! Warnings of a program that loads, and the comments that silence them.

use super::{Loaded, judge, place};
use crate::allow::Allows;
use crate::diagnostic::Diagnostic;
use crate::robot::Robot;
use crate::warn::Judged;

/// Adds what an analysis of the program warns of, and leaves out what its comments silence.
pub(super) fn find(loaded: &mut Loaded, robot: Robot) {
    if let Some(program) = &loaded.program {
        let judged = Judged {
            source: &loaded.source,
            module: &loaded.module,
            symbols: &loaded.symbols,
            program,
            robot,
        };
        judged.warn(&mut loaded.diagnostics);
    }
    let mut allows = Allows::of(&loaded.source, &loaded.module);
    allows.silence(&loaded.source, &mut loaded.diagnostics);
    if loaded.program.is_some() {
        loaded.diagnostics.extend(allows.warnings(&loaded.source));
    }
}

impl Loaded {
    /// Adds warnings that others found, but those that a comment silences.
    pub fn add(&mut self, mut found: Vec<Diagnostic>) {
        if found.is_empty() {
            return;
        }
        Allows::of(&self.source, &self.module).silence(&self.source, &mut found);
        judge(&mut found, self.module.edition);
        self.diagnostics.append(&mut found);
        self.diagnostics.sort_by_key(place);
    }
}
