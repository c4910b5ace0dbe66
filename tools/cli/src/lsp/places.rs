//! Bytes of a text to positions of the protocol and back, by the one place of `tip` that counts columns.

use gen_lsp_types::{Position, Range, TextEdit};
use tip_ide::Edit;
use tipc::source::{self, Source, Span, Unit};

/// A text, and what its columns count.
#[derive(Clone, Copy)]
pub(crate) struct Places<'a> {
    pub(crate) source: &'a Source,
    pub(crate) unit: Unit,
}

impl Places<'_> {
    pub(crate) fn position(self, offset: usize) -> Position {
        let place = self.source.position(offset, self.unit);
        let line = place.line - 1;
        Position {
            line,
            character: place.column - 1 + self.mark(line),
        }
    }

    pub(crate) fn range(self, span: Span) -> Range {
        Range {
            start: self.position(span.start),
            end: self.position(span.end),
        }
    }

    /// The byte at a position; a column after its line is the line's end.
    pub(crate) fn offset(self, position: Position) -> usize {
        let column = position.character.saturating_sub(self.mark(position.line));
        let place = source::Position {
            line: position.line.saturating_add(1),
            column: column.saturating_add(1),
        };
        self.source.offset(place, self.unit)
    }

    /// The bytes of a range; one that ends before it begins is empty.
    pub(crate) fn span(self, range: Range) -> Span {
        let start = self.offset(range.start);
        Span::new(start, self.offset(range.end).max(start))
    }

    /// How many columns of a line stand before its text: most editors keep a mark of UTF-8 to themselves.
    fn mark(self, line: u32) -> u32 {
        match (line, self.source.mark().len(), self.unit) {
            (1.., ..) | (_, 0, _) => 0,
            (_, bytes, Unit::Byte | Unit::Utf8) => bytes as u32,
            (_, _, Unit::Utf16 | Unit::Character) => 1,
        }
    }

    pub(crate) fn edits(self, edits: &[Edit]) -> Vec<TextEdit> {
        let edits = edits.iter().map(|edit| TextEdit {
            range: self.range(edit.span),
            new_text: edit.text.clone(),
        });
        edits.collect()
    }
}
