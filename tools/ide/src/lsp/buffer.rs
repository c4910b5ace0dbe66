//! Programs that are open in the editor: text, version, and the document that is made from them when it is needed.

use super::RobotConfig;
use super::client::Positions;
use crate::Document;
use gen_lsp_types::TextDocumentContentChangeEvent as Change;
use std::ops::Range;
use std::thread;
use tipc::diagnostic::Diagnostic;
use tipc::source::{Encoding, Source, Unit};

/// A program that is open in the editor.
#[derive(Debug)]
pub(crate) struct Buffer {
    pub(crate) version: Option<i32>,
    text: String,
    /// `None` until it is needed.
    document: Option<Document>,
    /// Its diagnostics have not been sent yet.
    pub(crate) is_due: bool,
}

impl Buffer {
    pub(crate) fn new(version: Option<i32>, text: String) -> Self {
        Buffer {
            version,
            text,
            document: None,
            is_due: true,
        }
    }

    /// Applies changes of the text in their order.
    pub(crate) fn change(&mut self, version: Option<i32>, changes: Vec<Change>, unit: Unit) {
        self.version = version;
        self.is_due = true;
        for change in changes {
            match change {
                Change::TextDocumentContentChangeWholeDocument(whole) => self.text = whole.text,
                Change::TextDocumentContentChangePartial(part) => {
                    let decoded = || Source::decode("", self.text.as_bytes(), Encoding::Utf8).0;
                    let bytes = match &self.document {
                        Some(document) => bytes(document.source(), part.range, unit),
                        None => bytes(&decoded(), part.range, unit),
                    };
                    self.text.replace_range(bytes, &part.text);
                }
            }
            self.invalidate();
        }
    }

    /// Drops the document; its diagnostics are due again.
    pub(crate) fn invalidate(&mut self) {
        self.is_due = true;
        if let Some(past) = self.document.take() {
            // Freeing a large document takes a while, and would delay the next answer.
            let _ = thread::Builder::new().spawn(|| drop(past));
        }
    }

    /// Computes what the next requests are likely to need.
    pub(crate) fn prepare(&self) {
        if let Some(document) = &self.document {
            document.prepare();
        }
    }

    /// Returns the document of the text for a robot; `other_robot` returns the warning that the crate around the file is for
    /// another one.
    pub(crate) fn document(
        &mut self,
        name: &str,
        config: &RobotConfig,
        other_robot: impl FnOnce() -> Option<Diagnostic>,
    ) -> &Document {
        self.document.get_or_insert_with(|| {
            let mut document = Document::new(name, &self.text, &config.options);
            document.judge(|loaded| {
                if let Some(robot) = &config.robot {
                    robot.warn(loaded);
                }
                tip_lint::add(loaded, other_robot().into_iter().collect());
            });
            document
        })
    }
}

/// Returns the bytes of a text in a range. A byte order mark is not part of the text's `Source`.
fn bytes(source: &Source, range: gen_lsp_types::Range, unit: Unit) -> Range<usize> {
    let span = Positions { source, unit }.span(range);
    let mark = source.mark().len();
    span.start + mark..span.end + mark
}
