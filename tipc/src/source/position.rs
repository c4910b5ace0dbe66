//! The one module that converts positions: bytes of the text to bytes of the file, to lines and columns, in every unit,
//! and back.

use super::decode::Charset;
use super::{STRETCH, Source, boundary, next_boundary};
use encoding_rs::SHIFT_JIS;
use std::sync::LazyLock;

/// Unit of columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unit {
    /// Bytes of the file, as it is encoded.
    Byte,
    /// Bytes of the text in UTF-8.
    Utf8,
    /// Code units of the text in UTF-16: a character beyond U+FFFF counts two.
    Utf16,
    /// Characters.
    Character,
}

/// A location as people and editors name it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Position {
    /// The line, from 1.
    pub line: u32,
    /// The column, from 1, in some [`Unit`]; a tab counts as one character, a byte order mark as none.
    pub column: u32,
}

/// Numbers of units before each multiple of [`STRETCH`] bytes; empty if the text is ASCII, where all units are one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ColumnIndex(Vec<Counts>);

/// Numbers of units before some byte of the text, other than bytes of UTF-8.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Counts {
    bytes: usize,
    utf16: usize,
    characters: usize,
}

impl ColumnIndex {
    pub(super) fn new(text: &str, original: &Original) -> Self {
        if text.is_ascii() {
            return ColumnIndex(Vec::new());
        }
        let mut before = Counts::default();
        let stretches = (0..=text.len()).step_by(STRETCH).map(|start| {
            let here = before;
            let end = text.len().min(start + STRETCH);
            before.bytes += original.count(text, here.bytes, start, end);
            before.utf16 += utf16_units(text, start, end);
            before.characters += characters(text, start, end);
            here
        });
        ColumnIndex(stretches.collect())
    }

    /// Returns the last stretch that starts with at most `wanted` units before it; none if units are bytes of the
    /// text.
    fn known_before(&self, wanted: usize, unit: Unit) -> Option<usize> {
        let fits = |counts: &Counts| match unit {
            Unit::Byte => counts.bytes <= wanted,
            Unit::Utf8 => false,
            Unit::Utf16 => counts.utf16 <= wanted,
            Unit::Character => counts.characters <= wanted,
        };
        let stretch = self.0.partition_point(fits).checked_sub(1)?;
        Some(stretch * STRETCH)
    }
}

impl Source {
    /// Returns the position of a byte of the text. Inside a character it is the character's, inside a line end the end
    /// of the line; after the last line end it is the first column of one more line, after the text it is the text's
    /// end.
    pub fn position(&self, offset: usize, unit: Unit) -> Position {
        let offset = boundary(&self.text, offset);
        let number = self.line_number(offset);
        let bytes = self.text.as_bytes();
        if offset == bytes.len() && matches!(bytes.last(), Some(b'\n' | b'\r')) {
            return Position {
                line: number.saturating_add(1),
                column: 1,
            };
        }
        let is_in_end = offset > 0 && bytes.get(offset - 1..=offset) == Some(b"\r\n");
        let start = self.start_of_line_at(offset);
        Position {
            line: number,
            column: self.column_from(start, offset - usize::from(is_in_end), unit),
        }
    }

    /// Returns the byte of the text at a position. Inside a character it is where that starts; a position after its
    /// line is the line's end, a line after the last one the text's end; lines and columns before the first are the
    /// first.
    pub fn offset(&self, position: Position, unit: Unit) -> usize {
        let unit = self.unit(unit);
        let line = self.line(position.line.max(1)).span;
        let ahead = position.column.saturating_sub(1) as usize;
        let wanted = self.units_before(line.start, unit).saturating_add(ahead);
        let Some(known) = self.columns.known_before(wanted, unit) else {
            return boundary(&self.text, wanted.min(line.end));
        };
        let mut at = next_boundary(&self.text, known).clamp(line.start, line.end);
        let mut units = self.units_before(at, unit);
        for char in self.text[at..line.end].chars() {
            units += match unit {
                Unit::Byte => self.original.length(char, units),
                Unit::Utf8 => char.len_utf8(),
                Unit::Utf16 => char.len_utf16(),
                Unit::Character => 1,
            };
            if units > wanted {
                break;
            }
            at += char.len_utf8();
        }
        at
    }

    /// Returns line, and column in characters, of a byte of the text; both from 1. What comes after the last line, or
    /// in its end, is reported on that line.
    pub fn line_column(&self, offset: usize) -> (u32, u32) {
        (self.line_number(offset), self.column(offset))
    }

    /// Returns the column in characters, from 1, of a byte in or after its line.
    pub(crate) fn column(&self, offset: usize) -> u32 {
        self.column_from(self.start_of_line_at(offset), offset, Unit::Character)
    }

    fn column_from(&self, start: usize, offset: usize, unit: Unit) -> u32 {
        let offset = offset.min(self.text.len());
        // Nearly every line is shorter than what an index counts together.
        let is_short = !self.columns.0.is_empty() && (start..start + STRETCH).contains(&offset);
        let units = match unit {
            Unit::Utf16 if is_short => utf16_units(&self.text, start, offset),
            Unit::Character if is_short => characters(&self.text, start, offset),
            _ => self.units_before(offset, unit) - self.units_before(start, unit),
        };
        u32::try_from(units).map_or(u32::MAX, |units| units.saturating_add(1))
    }

    /// Simplifies a unit: in a file of UTF-8 the bytes are those of the text.
    fn unit(&self, unit: Unit) -> Unit {
        match (unit, &self.original) {
            (Unit::Byte, Original::Text) => Unit::Utf8,
            _ => unit,
        }
    }

    /// Returns the number of units before a byte of the text.
    pub(super) fn units_before(&self, offset: usize, unit: Unit) -> usize {
        let offset = offset.min(self.text.len());
        let unit = self.unit(unit);
        let Some(known) = self.columns.0.get(offset / STRETCH) else {
            return offset;
        };
        let start = offset / STRETCH * STRETCH;
        match unit {
            Unit::Utf8 => offset,
            Unit::Byte => known.bytes + self.original.count(&self.text, known.bytes, start, offset),
            Unit::Utf16 => known.utf16 + utf16_units(&self.text, start, offset),
            Unit::Character => known.characters + characters(&self.text, start, offset),
        }
    }
}

/// Counts the characters that start in a stretch of text.
fn characters(text: &str, start: usize, end: usize) -> usize {
    let (start, end) = (next_boundary(text, start), next_boundary(text, end));
    text[start..end].chars().count()
}

/// Counts the units of UTF-16 of the characters that start in a stretch of text: four bytes are two units.
fn utf16_units(text: &str, start: usize, end: usize) -> usize {
    let bytes = &text.as_bytes()[start..end];
    characters(text, start, end) + bytes.iter().filter(|byte| **byte >= 0xF0).count()
}

/// One bit for each character of the basic plane: set if code page 932 has two bytes for it.
type DoubleByte = Box<[u64; 1024]>;

static DOUBLE_BYTE: LazyLock<DoubleByte> = LazyLock::new(|| {
    let mut set: DoubleByte = Box::new([0; 1024]);
    for lead in (0x81..=0x9F).chain(0xE0..=0xFC) {
        for trail in 0x40..=0xFC {
            let pair = [lead, trail];
            let (text, bad) = SHIFT_JIS.decode_without_bom_handling(&pair);
            if let (false, Some(char)) = (bad, text.chars().next()) {
                let code = char as usize & 0xFFFF;
                set[code / 64] |= 1 << (code % 64);
            }
        }
    }
    set
});

/// Finds the first character in `text` that does not fit into `limit` bytes of code page 932: half-width 1,
/// full-width 2; a character outside it counts its UTF-8 bytes.
pub(crate) fn first_beyond(text: &str, limit: usize) -> Option<usize> {
    // No character is longer in code page 932 than in UTF-8.
    if text.len() <= limit {
        return None;
    }
    let mut length = 0;
    for (at, char) in text.char_indices() {
        length += char_length(char);
        if length > limit {
            return Some(at);
        }
    }
    None
}

/// Returns the number of bytes of `text` in code page 932; on a terminal, the number of columns.
pub fn byte_length(text: &str) -> usize {
    match text.is_ascii() {
        true => text.len(),
        false => text.chars().map(char_length).sum(),
    }
}

fn char_length(char: char) -> usize {
    match char {
        '\0'..='\u{80}' | '\u{A5}' | '\u{FF61}'..='\u{FF9F}' => 1,
        _ if is_double_byte(char) => 2,
        _ => char.len_utf8(),
    }
}

fn is_double_byte(char: char) -> bool {
    let code = char as usize;
    code <= 0xFFFF && DOUBLE_BYTE[code / 64] >> (code % 64) & 1 == 1
}

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
