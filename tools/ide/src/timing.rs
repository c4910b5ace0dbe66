//! Durations of parts of a program, in control cycles and milliseconds, as hovers and inlay hints show them.

use crate::Document;
use crate::message::Editing;
use tip_lint::cycles::{Count, Part, Span as PartSpan};
use tipc::message::Message;
use tipc::program::{Action, Op, Step, StepId};

impl Document {
    /// Returns cycles, and milliseconds unless the program sets the sampling time.
    pub(crate) fn duration(&self, count: Count) -> Message {
        let cycles = interval(count.min as f64, count.max.map(|max| max as f64));
        let period = self.sampling().standard;
        let ms = |cycles: u64| cycles as f64 * period;
        let duration = match self.sets_sampling() {
            true => Editing::Lasts { cycles },
            false => Editing::LastsTimed {
                cycles,
                ms: interval(ms(count.min), count.max.map(ms)),
            },
        };
        match count.waits {
            true => Editing::AndWaits {
                duration: Box::new(duration.into()),
            }
            .into(),
            false => duration.into(),
        }
    }

    /// Returns the duration of the loop that begins with a step.
    pub(crate) fn turns_of(&self, step: StepId) -> Option<Message> {
        let part = self
            .parts()
            .iter()
            .find(|part| self.opener(part) == Some(step))?;
        Some(self.turns(part))
    }

    /// Returns the step that opens a loop: its FOR, or the target of its jump back.
    pub(crate) fn opener(&self, part: &Part) -> Option<StepId> {
        let PartSpan::Turn { head, .. } = part.span else {
            return None;
        };
        let steps = self.loaded.program.as_ref()?.steps();
        let before = head.checked_sub(1);
        let is_for = |step: &StepId| {
            let step = steps.get(*step as usize);
            step.is_some_and(|step| matches!(step.action, Action::For { .. }))
        };
        Some(before.filter(is_for).unwrap_or(head))
    }

    /// Returns the number of turns of a loop, if it is known, and the duration of one.
    pub(crate) fn turns(&self, part: &Part) -> Message {
        let duration = Box::new(self.duration(part.cycles));
        match part.span {
            PartSpan::Turn {
                turns: Some(turns), ..
            } => Editing::Turns {
                turns: turns.to_string(),
                duration: Box::new(Editing::OneTurn { duration }.into()),
            }
            .into(),
            _ => Editing::OneTurn { duration }.into(),
        }
    }

    fn sets_sampling(&self) -> bool {
        let sets = |step: &Step| {
            matches!(
                step.action,
                Action::Command {
                    op: Op::SetSamplingTime | Op::SetSamplingFreq,
                    ..
                }
            )
        };
        let program = self.loaded.program.as_ref();
        let is_set = || program.is_some_and(|program| program.steps().iter().any(sets));
        *self.sets_sampling.get_or_init(is_set)
    }
}

/// Returns `3`, `3–8`, or `≥ 3`.
fn interval(min: f64, max: Option<f64>) -> String {
    match max {
        Some(max) if max == min => min.to_string(),
        Some(max) => format!("{min}–{max}"),
        None => format!("≥ {min}"),
    }
}
