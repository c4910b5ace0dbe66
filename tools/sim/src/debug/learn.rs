//! Counts how often breakpoints were passed before they were placed.

use super::Debugger;
use super::ask::Now;
use super::progress::Progress;
use crate::run::Run;

/// A run that goes again over cycles in which nobody counted.
#[derive(Debug)]
pub(super) struct Learn {
    scout: Run,
    from: u64,
    at: u64,
    until: u64,
}

impl Learn {
    /// From a position up to where the debugger stands.
    pub(super) fn new(from: u64, debugger: &Debugger) -> Option<Self> {
        let (at, mark) = debugger.marks.before(from)?;
        let mut scout = debugger.run.clone();
        scout.restore(mark);
        scout.happen();
        Some(Learn {
            scout,
            from: *at,
            at: *at,
            until: debugger.now,
        })
    }

    pub(super) fn progress(&self) -> Progress {
        Progress {
            done: self.at - self.from,
            of: Some(self.until - self.from),
        }
    }
}

impl Debugger {
    /// Goes on counting; says whether all is counted.
    pub(super) fn learn(&mut self, learn: &mut Learn, left: &mut u64) -> bool {
        loop {
            let begins = self.history.enters(learn.at);
            let now = Now {
                run: &learn.scout,
                at: learn.at,
                asker: &self.asker,
            };
            let step = learn.scout.program().at();
            self.breakpoints.count(begins.then_some(step), &now);
            if learn.at >= learn.until {
                return true;
            }
            if *left == 0 {
                return false;
            }
            *left -= 1;
            learn.scout.advance(None);
            learn.scout.happen();
            learn.at += 1;
        }
    }
}
