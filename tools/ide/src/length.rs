//! How many control cycles something takes, in words.

use crate::Document;
use crate::message::Editing;
use tip_lint::cycles::Count;
use tipc::message::Message;
use tipc::program::{Action, Op, Step};

impl Document {
    /// Cycles, and milliseconds unless the program sets a sampling time of its own.
    pub(crate) fn length(&self, count: Count) -> Message {
        let cycles = interval(count.min as f64, count.max.map(|max| max as f64));
        let period = self.sampling().standard;
        let ms = |cycles: u64| cycles as f64 * period;
        let length = match self.sets_sampling() {
            true => Editing::Lasts { cycles },
            false => Editing::LastsTimed {
                cycles,
                ms: interval(ms(count.min), count.max.map(ms)),
            },
        };
        match count.waits {
            true => Editing::AndWaits {
                length: Box::new(length.into()),
            }
            .into(),
            false => length.into(),
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

/// `3`, `3–8`, or `≥ 3`.
fn interval(min: f64, max: Option<f64>) -> String {
    match max {
        Some(max) if max == min => min.to_string(),
        Some(max) => format!("{min}–{max}"),
        None => format!("≥ {min}"),
    }
}
