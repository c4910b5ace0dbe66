//! Fixes of findings, tried before they are offered.

use crate::Document;
use crate::format::by_lines;
use crate::message::Editing;
use tip_lint::repair::{confirm, repair};
use tipc::diagnostic::{Applicability, Edit};
use tipc::message::Message;
use tipc::source::Span;

/// A change that is offered.
#[derive(Clone, Debug, PartialEq)]
pub struct Action {
    /// What it does.
    pub title: Message,
    /// The finding that it puts right, by its place among `Loaded::diagnostics`; none of a change of the whole file.
    pub finding: Option<usize>,
    /// Whether every reader would mean exactly this.
    pub is_certain: bool,
    /// The changes, in order, which belong together and do not overlap.
    pub edits: Vec<Edit>,
}

impl Document {
    /// The fixes of the findings that touch a stretch of the text. Each was tried: it puts its finding right, and brings
    /// none that is new.
    pub fn actions(&self, span: Span) -> Vec<Action> {
        let touches = |place: Span| place.start <= span.end && span.start <= place.end;
        let mut trial = self.loaded.clone();
        for finding in &mut trial.diagnostics {
            if !touches(finding.span) {
                finding.fixes.clear();
            }
        }
        let confirmed = confirm(trial, &self.options);
        let mut actions = Vec::new();
        for (index, finding) in confirmed.diagnostics.into_iter().enumerate() {
            actions.extend(finding.fixes.into_iter().map(|fix| {
                let mut edits = fix.edits;
                edits.sort_by_key(|edit| edit.span);
                Action {
                    title: fix.title,
                    finding: Some(index),
                    is_certain: fix.applicability == Applicability::Certain,
                    edits,
                }
            }));
        }
        actions
    }

    /// All fixes of the file that are certain, as one change; nothing if there is none.
    pub fn fix_all(&self) -> Option<Action> {
        let repaired = repair(self.loaded.clone(), &self.options, Applicability::Certain);
        if repaired.applied.is_empty() {
            return None;
        }
        Some(Action {
            title: Editing::FixAll.into(),
            finding: None,
            is_certain: true,
            edits: by_lines(&self.loaded.source, &repaired.loaded.source),
        })
    }
}
