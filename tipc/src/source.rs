//! Files as text and lines, losslessly: every byte can be given back. It never looks at words.
//!
//! A file is a mark, lines with their ends, and a tail:
//!
//! ```
//! use tipc::source::{Encoding, Source};
//!
//! let bytes = b"\xEF\xBB\xBF3.1\r\n\xE6\xAD\xA9\xE3\x81\x8F\nEND\x1A";
//! let (source, _) = Source::decode("walk.prg", bytes, Encoding::Auto);
//! let mut again = source.mark().to_vec();
//! for line in source.lines() {
//!     again.extend_from_slice(source.original(line.span));
//!     again.extend_from_slice(source.original(line.end));
//! }
//! again.extend_from_slice(source.tail());
//! assert_eq!(again, bytes);
//! ```

use decode::{Decoded, MARK, decode};
use lines::LineIndex;
use position::{ColumnIndex, Original};

mod decode;
mod lines;
mod position;

pub use decode::{Charset, Encoding, Undecodable, looks_like};
pub use lines::{Line, Lines};
pub(crate) use position::first_beyond;
pub use position::{Position, Unit, byte_length};

/// Byte that DOS puts after the last line of a text file.
const TAIL: &[u8] = b"\x1A";

/// A decoded source file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    name: String,
    charset: Charset,
    mark: &'static [u8],
    tail: &'static [u8],
    text: String,
    original: Original,
    lines: LineIndex,
    columns: ColumnIndex,
}

impl Source {
    /// Decodes a file (T.I.P. 3.1 §3).
    ///
    /// If bytes are not text, the first ones are returned; the text then has replacement characters, good enough
    /// to show the location but not to be compiled.
    pub fn decode(
        name: impl Into<String>,
        bytes: &[u8],
        encoding: Encoding,
    ) -> (Source, Option<Undecodable>) {
        let (body, tail) = match bytes.strip_suffix(TAIL) {
            Some(body) => (body, TAIL),
            None => (bytes, &TAIL[..0]),
        };
        let Decoded {
            text,
            charset,
            marked,
            bad,
        } = decode(body, encoding);
        let mark = if marked { MARK } else { &MARK[..0] };
        let original = Original::new(&text, charset, &body[mark.len()..]);
        let mut source = Source {
            name: name.into(),
            charset,
            mark,
            tail,
            lines: LineIndex::new(text.as_bytes()),
            columns: ColumnIndex::default(),
            original,
            text,
        };
        source.columns = ColumnIndex::new(&source);
        (source, bad)
    }

    /// Returns the file's name as the user gave it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns FNV-1a 64 of the file's bytes.
    pub fn hash(&self) -> u64 {
        let original = self.original(Span::new(0, self.text.len()));
        let pieces = [self.mark, original, self.tail];
        fnv1a(pieces.into_iter().flatten())
    }

    /// Returns the character set of the file.
    pub fn charset(&self) -> Charset {
        self.charset
    }

    /// Returns the whole text: neither byte order mark nor DOS end of file is part of it.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns the text at `span`; empty if the span is not of this source.
    pub fn slice(&self, span: Span) -> &str {
        self.text.get(span.start..span.end).unwrap_or_default()
    }

    /// Returns the byte order mark before the text of the file, if there is one.
    pub fn mark(&self) -> &[u8] {
        self.mark
    }

    /// Returns the bytes of the file for the text at `span`, even if they are invalid. Spans that follow
    /// each other give bytes that follow each other; characters that begin in a span are given back completely.
    pub fn original(&self, span: Span) -> &[u8] {
        let at = |offset| self.byte_of(next_boundary(&self.text, offset));
        self.original.get(&self.text, at(span.start), at(span.end))
    }

    /// Returns the byte of the file for a byte of the text.
    pub fn file_offset(&self, offset: usize) -> usize {
        self.mark.len() + self.byte_of(next_boundary(&self.text, offset))
    }

    /// Returns the bytes of the file.
    pub fn bytes(&self) -> Vec<u8> {
        self.changed(std::iter::empty())
    }

    /// Returns the bytes of the file with other texts in the place of some spans, which follow each other and do not
    /// overlap. The texts are ASCII, so they are the same in every encoding; all other bytes are those of the file.
    pub fn changed<'a>(&self, changes: impl Iterator<Item = (Span, &'a str)>) -> Vec<u8> {
        let mut out = self.mark().to_vec();
        let mut at = 0;
        for (span, new) in changes {
            out.extend_from_slice(self.original(Span::new(at, span.start)));
            out.extend_from_slice(new.as_bytes());
            at = span.end;
        }
        out.extend_from_slice(self.original(Span::new(at, self.text().len())));
        out.extend_from_slice(self.tail());
        out
    }

    /// Returns the DOS end of file that follows the text in the file, if one does.
    pub fn tail(&self) -> &[u8] {
        self.tail
    }
}

/// Returns the start of the character that holds a byte of the text; its end, if there is no such byte.
fn boundary(text: &str, offset: usize) -> usize {
    let mut at = offset.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// Returns the first start of a character from a byte of the text on, or its end.
fn next_boundary(text: &str, offset: usize) -> usize {
    let mut at = offset.min(text.len());
    while !text.is_char_boundary(at) {
        at += 1;
    }
    at
}

fn fnv1a<'a>(bytes: impl Iterator<Item = &'a u8>) -> u64 {
    bytes.fold(0xCBF2_9CE4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01B3)
    })
}

/// A stretch of the decoded source text, in bytes of UTF-8.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// The first byte.
    pub start: usize,
    /// The byte after the last one.
    pub end: usize,
}

impl Span {
    /// Creates a span from `start` up to `end`.
    pub const fn new(start: usize, end: usize) -> Self {
        Span { start, end }
    }

    /// Returns the span from the start of `self` to the end of `other`.
    pub const fn to(self, other: Span) -> Span {
        Span::new(self.start, other.end)
    }
}

#[cfg(test)]
mod tests;
