//! The one module that converts positions: bytes of the text to lines and columns, in every unit, and back.

use super::original::Original;
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
