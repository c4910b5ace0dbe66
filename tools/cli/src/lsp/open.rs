//! The programs that are open in the editor.

use super::places::Places;
use super::surroundings::Chosen;
use gen_lsp_types::TextDocumentContentChangeEvent as Change;
use std::ops::Range;
use std::thread;
use tip_ide::Document;
use tipc::diagnostic::Diagnostic;
use tipc::source::{Encoding, Source, Unit};

/// A text that is open, and what is known of it once somebody asks.
pub(crate) struct Open {
    pub(crate) version: Option<i32>,
    text: String,
    document: Option<Document>,
    /// Its findings are not sent yet.
    pub(crate) is_due: bool,
}

impl Open {
    pub(crate) fn new(version: Option<i32>, text: String) -> Self {
        Open {
            version,
            text,
            document: None,
            is_due: true,
        }
    }

    /// Changes the text.
    pub(crate) fn change(&mut self, version: Option<i32>, changes: Vec<Change>, unit: Unit) {
        self.version = version;
        self.is_due = true;
        for change in changes {
            match change {
                Change::TextDocumentContentChangeWholeDocument(whole) => self.text = whole.text,
                Change::TextDocumentContentChangePartial(part) => {
                    let decoded = || Source::decode("", self.text.as_bytes(), Encoding::Utf8).0;
                    let bytes = match &self.document {
                        Some(document) => place(document.source(), part.range, unit),
                        None => place(&decoded(), part.range, unit),
                    };
                    self.text.replace_range(bytes, &part.text);
                }
            }
            self.forget();
        }
    }

    /// Its findings may be others now.
    pub(crate) fn forget(&mut self) {
        self.is_due = true;
        if let Some(past) = self.document.take() {
            // To let go of it takes a while, and nobody should wait for that.
            let _ = thread::Builder::new().spawn(|| drop(past));
        }
    }

    /// Finds out what will be asked for next.
    pub(crate) fn prepare(&self) {
        if let Some(document) = &self.document {
            document.prepare();
        }
    }

    /// What is known of the text, for a robot; `other` says whether the crate around the file is for another one.
    pub(crate) fn document(
        &mut self,
        name: &str,
        chosen: &Chosen,
        other: impl FnOnce() -> Option<Diagnostic>,
    ) -> &Document {
        self.document.get_or_insert_with(|| {
            let mut document = Document::new(name, &self.text, &chosen.options);
            document.judge(|loaded| {
                if let Some(robot) = &chosen.robot {
                    robot.warn(loaded);
                }
                tip_lint::add(loaded, other().into_iter().collect());
            });
            document
        })
    }
}

/// The bytes of a text in a range. A mark before the text is not part of its source.
fn place(source: &Source, range: gen_lsp_types::Range, unit: Unit) -> Range<usize> {
    let span = Places { source, unit }.span(range);
    let mark = source.mark().len();
    span.start + mark..span.end + mark
}
