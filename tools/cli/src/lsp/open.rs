//! The programs that are open in the editor.

use super::places::Places;
use super::surroundings::Chosen;
use gen_lsp_types::TextDocumentContentChangeEvent as Change;
use tip_ide::Document;
use tip_sim::reach;
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
        let mut known = self.document.take();
        for change in changes {
            match change {
                Change::TextDocumentContentChangeWholeDocument(whole) => {
                    known = None;
                    self.text = whole.text;
                }
                Change::TextDocumentContentChangePartial(part) => {
                    let decoded = || Source::decode("", self.text.as_bytes(), Encoding::Utf8).0;
                    let source = known.take();
                    let source = source.map_or_else(decoded, |it| it.source().clone());
                    let source = &source;
                    let span = Places { source, unit }.span(part.range);
                    // A mark before the text is not part of the source.
                    let mark = source.mark().len();
                    let place = span.start + mark..span.end + mark;
                    self.text.replace_range(place, &part.text);
                }
            }
        }
        self.forget();
    }

    /// Its findings may be others now.
    pub(crate) fn forget(&mut self) {
        self.document = None;
        self.is_due = true;
    }

    /// Finds out what will be asked for next.
    pub(crate) fn prepare(&self) {
        if let Some(document) = &self.document {
            document.prepare();
        }
    }

    /// What is known of the text, for a robot.
    pub(crate) fn document(&mut self, name: &str, chosen: &Chosen) -> &Document {
        self.document.get_or_insert_with(|| {
            let mut document = Document::new(name, &self.text, &chosen.options);
            if let Some(robot) = &chosen.robot {
                document.judge(|loaded| reach::warn(loaded, robot));
            }
            document
        })
    }
}
