//! Bytes to text: decoding, lines, places and byte lengths. It never looks at words.

mod width;

pub(crate) use width::first_beyond;

use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::syntax::Span;
use encoding_rs::{DecoderResult, SHIFT_JIS};

/// How the bytes of a source file spell text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// UTF-8 if the bytes are valid UTF-8, else Shift_JIS.
    #[default]
    Auto,
    /// UTF-8, with or without byte order mark.
    Utf8,
    /// Shift_JIS as Windows knows it (code page 932).
    ShiftJis,
}

/// The byte order mark of UTF-8.
const BOM: &[u8] = b"\xEF\xBB\xBF";
/// What DOS puts behind the last line of a text file.
const DOS_END_OF_FILE: u8 = 0x1A;

/// A decoded source file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    name: String,
    hash: u64,
    text: String,
    lines: Vec<Span>,
    /// How many characters stand before each multiple of [`STRIDE`] bytes; empty if all are ASCII.
    characters: Vec<usize>,
}

/// How many bytes a search for a column looks at, at most: a line may be as long as the file.
const STRIDE: usize = 1024;

impl Source {
    /// Decodes a file (T.I.P. 3.1 §3).
    ///
    /// Bytes that the encoding lacks are a `Format error` at the first one; the text then has replacement
    /// characters, good enough to show the place but not to be compiled.
    pub fn decode(
        name: impl Into<String>,
        bytes: &[u8],
        encoding: Encoding,
    ) -> (Source, Option<Diagnostic>) {
        let body = bytes.strip_suffix(&[DOS_END_OF_FILE]).unwrap_or(bytes);
        let decoded = match encoding {
            Encoding::Utf8 => decode_utf8(body),
            Encoding::ShiftJis => decode_shift_jis(body),
            Encoding::Auto => decode_auto(body),
        };
        let source = Source {
            name: name.into(),
            hash: fnv1a(bytes),
            lines: split_lines(&decoded.text),
            characters: count_characters(&decoded.text),
            text: decoded.text,
        };
        (source, decoded.bad.map(Bad::diagnostic))
    }

    /// The file's name as the user gave it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// FNV-1a 64 of the file's bytes.
    pub fn hash(&self) -> u64 {
        self.hash
    }

    /// The whole text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// How many lines there are; at least one.
    pub fn line_count(&self) -> u32 {
        self.lines.len() as u32
    }

    /// The place of a line, counted from 1, without its line end. A line that does not exist is empty, at the end.
    pub fn line_span(&self, line: u32) -> Span {
        let end = Span::new(self.text.len(), self.text.len());
        (line as usize)
            .checked_sub(1)
            .and_then(|index| self.lines.get(index).copied())
            .unwrap_or(end)
    }

    /// The text of a line, counted from 1, without its line end.
    pub fn line_text(&self, line: u32) -> &str {
        self.slice(self.line_span(line))
    }

    /// The text at `span`; empty if the span is not of this source.
    pub fn slice(&self, span: Span) -> &str {
        self.text.get(span.start..span.end).unwrap_or_default()
    }

    /// Line, and column in characters, of a byte of the text; both from 1.
    pub fn line_column(&self, offset: usize) -> (u32, u32) {
        let index = self
            .lines
            .partition_point(|line| line.start <= offset)
            .saturating_sub(1);
        let line = index as u32 + 1;
        (line, self.column(line, offset))
    }

    /// Column in characters, from 1, of a byte in or behind that line.
    pub(crate) fn column(&self, line: u32, offset: usize) -> u32 {
        let start = self.line_span(line).start;
        let offset = offset.min(self.text.len());
        let before = match offset - start {
            0..STRIDE => character_starts(&self.text.as_bytes()[start..offset]),
            _ => self.characters_before(offset) - self.characters_before(start),
        };
        before as u32 + 1
    }

    fn characters_before(&self, offset: usize) -> usize {
        match self.characters.get(offset / STRIDE) {
            Some(known) => {
                let start = offset / STRIDE * STRIDE;
                known + character_starts(&self.text.as_bytes()[start..offset])
            }
            None => offset,
        }
    }
}

/// Text, and the first thing that could not be decoded.
struct Decoded {
    text: String,
    bad: Option<Bad>,
}

/// Bytes that are no text.
struct Bad {
    /// The encoding that was tried.
    encoding: &'static str,
    /// Where in the file.
    byte: usize,
    /// Where in the decoded text.
    offset: usize,
    /// What the other encoding says in automatic mode.
    other: Option<(&'static str, usize)>,
}

impl Bad {
    fn diagnostic(self) -> Diagnostic {
        let span = Span::new(
            self.offset,
            self.offset + char::REPLACEMENT_CHARACTER.len_utf8(),
        );
        let reason = format!(
            "byte {} of the file is not valid {}",
            self.byte, self.encoding
        );
        let help = match self.other {
            Some((encoding, byte)) => format!(
                "the file is no {encoding} either (byte {byte}); save it in one of the two encodings"
            ),
            None => "save the file in that encoding, or name the right one".to_owned(),
        };
        Diagnostic::new(Code::Format, span, reason).help(help)
    }
}

fn decode_auto(bytes: &[u8]) -> Decoded {
    let utf8 = decode_utf8(bytes);
    let Some(first) = &utf8.bad else { return utf8 };
    if bytes.starts_with(BOM) {
        return utf8;
    }
    let mut shift_jis = decode_shift_jis(bytes);
    let Some(second) = &mut shift_jis.bad else {
        return shift_jis;
    };
    // The encoding that reads further is the likelier one.
    if second.byte >= first.byte {
        second.other = Some((first.encoding, first.byte));
        return shift_jis;
    }
    let other = Some((second.encoding, second.byte));
    Decoded {
        text: utf8.text,
        bad: utf8.bad.map(|bad| Bad { other, ..bad }),
    }
}

fn decode_utf8(bytes: &[u8]) -> Decoded {
    let body = bytes.strip_prefix(BOM).unwrap_or(bytes);
    match std::str::from_utf8(body) {
        Ok(text) => Decoded {
            text: text.to_owned(),
            bad: None,
        },
        Err(error) => Decoded {
            text: String::from_utf8_lossy(body).into_owned(),
            bad: Some(Bad {
                encoding: "UTF-8",
                byte: bytes.len() - body.len() + error.valid_up_to(),
                offset: error.valid_up_to(),
                other: None,
            }),
        },
    }
}

fn decode_shift_jis(bytes: &[u8]) -> Decoded {
    let mut decoder = SHIFT_JIS.new_decoder_without_bom_handling();
    let room = decoder.max_utf8_buffer_length(bytes.len());
    let mut text = String::with_capacity(room.unwrap_or(bytes.len()));
    let (result, read) = decoder.decode_to_string_without_replacement(bytes, &mut text, true);
    let DecoderResult::Malformed(length, behind) = result else {
        return Decoded { text, bad: None };
    };
    let byte = read - usize::from(length) - usize::from(behind);
    let offset = text.len();
    let (rest, _) = SHIFT_JIS.decode_without_bom_handling(&bytes[byte..]);
    text.push_str(&rest);
    let bad = Bad {
        encoding: "Shift_JIS",
        byte,
        offset,
        other: None,
    };
    Decoded {
        text,
        bad: Some(bad),
    }
}

/// The lines without their ends (LF, CRLF, CR). An end behind the last line opens no further one.
fn split_lines(text: &str) -> Vec<Span> {
    let bytes = text.as_bytes();
    let mut lines = Vec::new();
    let mut start = 0;
    let mut at = 0;
    while at < bytes.len() {
        let end = at;
        at += 1;
        match bytes[end] {
            b'\n' => {}
            b'\r' => at += usize::from(bytes.get(at) == Some(&b'\n')),
            _ => continue,
        }
        lines.push(Span::new(start, end));
        start = at;
    }
    if start < bytes.len() || lines.is_empty() {
        lines.push(Span::new(start, bytes.len()));
    }
    lines
}

fn count_characters(text: &str) -> Vec<usize> {
    if text.is_ascii() {
        return Vec::new();
    }
    let mut before = 0;
    let counts = text.as_bytes().chunks(STRIDE).map(|chunk| {
        let here = before;
        before += character_starts(chunk);
        here
    });
    let mut counts: Vec<usize> = counts.collect();
    counts.push(before);
    counts
}

/// How many characters start in `bytes` of UTF-8.
fn character_starts(bytes: &[u8]) -> usize {
    bytes.iter().filter(|byte| **byte & 0xC0 != 0x80).count()
}

fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xCBF2_9CE4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01B3)
    })
}

#[cfg(test)]
mod tests;
