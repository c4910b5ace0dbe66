//! Changes of the text, carried over to the bytes of the file.

use tipc::source::{Source, Span};

/// Replacements that do not overlap; what is put in is ASCII, so it is the same in both encodings.
#[derive(Debug, Default)]
pub(super) struct Edits(Vec<(Span, String)>);

impl Edits {
    /// Puts `text` in the place of `span`.
    pub(super) fn replace(&mut self, span: Span, text: impl Into<String>) {
        self.0.push((span, text.into()));
    }

    /// Puts `text` before the byte at `at`.
    pub(super) fn insert(&mut self, at: usize, text: impl Into<String>) {
        self.replace(Span::new(at, at), text);
    }

    /// Returns the bytes of the file with every edit.
    pub(super) fn apply(mut self, source: &Source) -> Vec<u8> {
        self.0.sort_by_key(|(span, _)| *span);
        let changes = self.0.iter().map(|(span, new)| (*span, new.as_str()));
        source.changed(changes)
    }
}
