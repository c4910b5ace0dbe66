//! The bytes of the text in its file.

use super::decode::Charset;
use super::next_boundary;

/// The bytes of the text in its file, without byte order mark and DOS end of file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Original {
    /// The bytes of the text.
    Text,
    /// Others. They are kept, since encoding the text again would not always lead back to them.
    Bytes(Charset, Box<[u8]>),
}

impl Original {
    pub(super) fn new(text: &str, charset: Charset, bytes: &[u8]) -> Self {
        if text.as_bytes() == bytes {
            return Original::Text;
        }
        Original::Bytes(charset, bytes.into())
    }

    /// Counts the bytes of the file, from `at` on there, of the characters that start from `start` up to `end`. Bytes
    /// of the text itself need not be counted.
    pub(super) fn count(&self, text: &str, at: usize, start: usize, end: usize) -> usize {
        if let Original::Text = self {
            return 0;
        }
        let (start, end) = (next_boundary(text, start), next_boundary(text, end));
        let lengths = |at, char| at + self.length(char, at);
        text[start..end].chars().fold(at, lengths) - at
    }

    /// Returns the bytes of the file from `start` up to `end`; `text` is what they encode.
    pub(super) fn get<'a>(&'a self, text: &'a str, start: usize, end: usize) -> &'a [u8] {
        let bytes = match self {
            Original::Text => text.as_bytes(),
            Original::Bytes(_, bytes) => bytes,
        };
        bytes.get(start..end).unwrap_or_default()
    }

    /// Returns the number of bytes of the file for `char`, which is at `at`.
    pub(super) fn length(&self, char: char, at: usize) -> usize {
        let Original::Bytes(charset, bytes) = self else {
            return char.len_utf8();
        };
        let bytes = bytes.get(at..).unwrap_or_default();
        match charset {
            Charset::Utf8 if char == char::REPLACEMENT_CHARACTER => replaced_utf8(bytes),
            Charset::Utf8 => char.len_utf8(),
            Charset::ShiftJis if char == char::REPLACEMENT_CHARACTER => replaced_shift_jis(bytes),
            Charset::ShiftJis => 1 + usize::from(is_lead(bytes)),
        }
    }
}

/// Returns the number of bytes that one replacement character of UTF-8 stands for; a file may hold the character
/// itself.
fn replaced_utf8(bytes: &[u8]) -> usize {
    // No sequence is longer, so the rest of the file need not be looked at.
    let start = &bytes[..bytes.len().min(4)];
    let chunk = start.utf8_chunks().next();
    match chunk {
        Some(chunk) if chunk.valid().is_empty() => chunk.invalid().len(),
        _ => char::REPLACEMENT_CHARACTER.len_utf8(),
    }
}

/// Returns the number of bytes that one replacement character of Shift_JIS stands for: ASCII after a lead byte is read
/// for itself.
fn replaced_shift_jis(bytes: &[u8]) -> usize {
    let has_trail = bytes.get(1).is_some_and(|trail| !trail.is_ascii());
    1 + usize::from(is_lead(bytes) && has_trail)
}

/// Returns true if the first byte is the first of two.
fn is_lead(bytes: &[u8]) -> bool {
    matches!(bytes.first(), Some(0x81..=0x9F | 0xE0..=0xFC))
}
