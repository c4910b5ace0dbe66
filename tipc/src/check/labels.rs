//! Labels and subroutine names (T.I.P. 3.1 §4-3).

use super::names::{is_label_name, is_reserved};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::syntax::{Module, StatementKind, Word};
use std::collections::HashMap;

/// The label that may stand more than once.
pub(crate) const LOOP: &str = "LOOP";

/// Every label, by the index of its statement.
#[derive(Clone, Debug, Default)]
pub(crate) struct Labels<'m> {
    /// In order of the text: name, statement, declared by SUBROUTINE.
    pub(crate) all: Vec<(&'m str, usize, bool)>,
    by_name: HashMap<&'m str, usize>,
    loops: Vec<usize>,
}

impl<'m> Labels<'m> {
    /// Reads every label and SUBROUTINE.
    pub(crate) fn collect(module: &'m Module, found: &mut Vec<Diagnostic>) -> Self {
        let mut labels = Labels::default();
        for (index, statement) in module.statements.iter().enumerate() {
            match &statement.kind {
                StatementKind::Label(name) => labels.declare(module, index, name, false, found),
                StatementKind::Subroutine { name, .. } => {
                    labels.declare(module, index, name, true, found);
                }
                _ => {}
            }
        }
        labels
    }

    fn declare(
        &mut self,
        module: &'m Module,
        index: usize,
        name: &'m Word,
        subroutine: bool,
        found: &mut Vec<Diagnostic>,
    ) {
        self.all.push((&name.node, index, subroutine));
        if let Some(fault) = refusal(name, subroutine) {
            found.push(fault);
        }
        if name.node == LOOP && !subroutine {
            self.loops.push(index);
            return;
        }
        if let Some(first) = self.by_name.get(name.node.as_str()) {
            let reason = format!("`{}` is declared again", name.node);
            let first = label_word(&module.statements[*first].kind);
            let mut fault = Diagnostic::new(Code::DuplicateLabel, name.span, reason)
                .help("give each label a name of its own; only LOOP may stand more than once");
            if let Some(first) = first {
                fault = fault.label(first.span, "first declared here");
            }
            found.push(fault);
            return;
        }
        self.by_name.insert(&name.node, index);
    }

    /// The statement of a label other than LOOP.
    pub(crate) fn find(&self, name: &str) -> Option<usize> {
        self.by_name.get(name).copied()
    }

    /// The nearest LOOP above a statement.
    pub(crate) fn loop_above(&self, statement: usize) -> Option<usize> {
        let above = self.loops.partition_point(|index| *index < statement);
        above.checked_sub(1).map(|last| self.loops[last])
    }

    /// The names that a jump may have meant.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.all.iter().map(|(name, ..)| *name)
    }
}

fn refusal(name: &Word, subroutine: bool) -> Option<Diagnostic> {
    let word = name.node.as_str();
    let fault = |reason: String| Diagnostic::new(Code::Argument, name.span, reason);
    if !is_label_name(word) {
        let help = "a label is made of letters, digits and `_`";
        return Some(fault(format!("`{word}` is no name for a label")).help(help));
    }
    if is_reserved(word) {
        let help = "choose another name";
        return Some(fault(format!("`{word}` is a word of the language")).help(help));
    }
    (subroutine && word == LOOP).then(|| fault("a SUBROUTINE cannot be named LOOP".to_owned()))
}

fn label_word(kind: &StatementKind) -> Option<&Word> {
    match kind {
        StatementKind::Label(name) | StatementKind::Subroutine { name, .. } => Some(name),
        _ => None,
    }
}
