//! Inlay hints: durations of loops, and steps that never run. Durations of parts of a program, in control cycles and milliseconds, as
//! hovers show them too.

use crate::Document;
use crate::message::Editing;
use tip_lint::cycles::{Count, Part, Span as PartSpan, sampling_set};
use tipc::code::Code;
use tipc::message::Message;
use tipc::program::StepId;
use tipc::source::Span;

/// A text that an editor shows after a statement.
#[derive(Clone, Debug, PartialEq)]
pub struct InlayHint {
    /// The end of the statement, as an offset.
    pub at: usize,
    /// The text.
    pub text: Message,
}

impl Document {
    /// Returns the hints inside a span, in the order of the text.
    pub fn inlay_hints(&self, span: Span) -> Vec<InlayHint> {
        let module = &self.loaded.module;
        let is_inside = |at: &usize| span.start <= *at && *at <= span.end;
        let loops = self.parts().iter().filter_map(|part| {
            let index = module.statement_of(self.opener(part)?)?;
            let at = Some(module.statements[index].span.end).filter(is_inside)?;
            let text = self.turns(part);
            Some(InlayHint { at, text })
        });
        let found = self.loaded.diagnostics.iter();
        let unreachable = found.filter(|it| it.code == Code::Unreachable);
        let unreachable = unreachable.filter_map(|it| {
            let index = module.statement_at(it.span.start)?;
            let at = Some(module.statements[index].span.end).filter(is_inside)?;
            let text = Editing::NeverRuns.into();
            Some(InlayHint { at, text })
        });
        let mut hints: Vec<InlayHint> = loops.chain(unreachable).collect();
        hints.sort_by_key(|hint| hint.at);
        hints
    }
}

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
        let program = self.loaded.program.as_ref()?;
        matches!(part.span, PartSpan::Turn { .. }).then(|| part.first_step(program))
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
        let program = self.loaded.program.as_ref();
        let is_set = || program.is_some_and(|program| sampling_set(program).is_some());
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
