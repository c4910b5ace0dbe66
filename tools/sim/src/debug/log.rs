//! Log points: breakpoints that say something in place of stopping a run.

use super::breakpoints::{Placed, When};
use super::forward::MESSAGES;
use super::words::Words;
use super::{Debugger, Refused};

impl Debugger {
    /// Places a breakpoint that does not stop a run, but prints a text each time the run passes it going forward. In the text,
    /// braces hold an expression or condition of the program, or the name of a POS or JOINT; its value is printed in their place.
    ///
    /// # Errors
    /// As [`break_at`](Self::break_at); or a text in braces is neither.
    pub fn log_at(
        &mut self,
        line: u32,
        column: u32,
        when: &When<'_>,
        text: &str,
    ) -> Result<Placed, Refused> {
        let words = Words::new(text, &self.program, &self.asker)?;
        let placed = self.break_at(line, column, when)?;
        self.breakpoints.say(placed.id, words);
        Ok(placed)
    }

    /// What log points have said since this was asked last, each with the position. Of very much only the last is kept.
    pub fn logged(&mut self) -> Vec<(u64, String)> {
        std::mem::take(&mut self.logged)
    }

    /// Says what is to be said where a step begins.
    pub(super) fn log_here(&mut self) {
        let step = self.run.program().at();
        let begins = self.now == 0 || self.history.step(self.now - 1) != step;
        if !begins || self.end_at(self.now).is_some() {
            return;
        }
        let said = self.breakpoints.said(step, &self.here());
        if self.logged.len() >= 2 * MESSAGES {
            self.logged.drain(..MESSAGES);
        }
        let at = self.now;
        self.logged.extend(said.into_iter().map(|text| (at, text)));
    }
}
