//! Changes of the text, carried over to the bytes that spell it.

use crate::syntax::Span;

/// The byte order mark of UTF-8.
const BOM: &[u8] = b"\xEF\xBB\xBF";

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

    /// The original bytes with every edit; `text` is what they decode to.
    pub(super) fn apply(mut self, text: &str, original: &[u8]) -> Vec<u8> {
        self.0.sort_by_key(|(span, _)| *span);
        let cursor = Cursor::new(text, original);
        let mut out = Vec::with_capacity(original.len() + 64);
        let (mut at, mut place) = (0, cursor.start);
        out.extend_from_slice(&original[..place]);
        for (span, new) in &self.0 {
            let begin = cursor.advance(place, &text[at..span.start]);
            out.extend_from_slice(&original[place..begin]);
            out.extend_from_slice(new.as_bytes());
            place = cursor.advance(begin, &text[span.start..span.end]);
            at = span.end;
        }
        out.extend_from_slice(&original[place..]);
        out
    }
}

/// Finds the bytes of characters.
struct Cursor<'a> {
    original: &'a [u8],
    /// Where the text begins.
    start: usize,
    utf8: bool,
}

impl<'a> Cursor<'a> {
    fn new(text: &str, original: &'a [u8]) -> Self {
        let behind_mark = original.strip_prefix(BOM);
        let marked = behind_mark.is_some_and(|body| body.starts_with(text.as_bytes()));
        let start = if marked { BOM.len() } else { 0 };
        Cursor {
            original,
            start,
            utf8: original[start..].starts_with(text.as_bytes()),
        }
    }

    /// Where `text` ends if it begins at `place`.
    fn advance(&self, place: usize, text: &str) -> usize {
        if self.utf8 {
            return place + text.len();
        }
        text.chars().fold(place, |place, _| {
            place + shift_jis_length(self.original[place])
        })
    }
}

/// How many bytes a character of Shift_JIS has, by its first one.
fn shift_jis_length(first: u8) -> usize {
    match first {
        0x81..=0x9F | 0xE0..=0xFC => 2,
        _ => 1,
    }
}
