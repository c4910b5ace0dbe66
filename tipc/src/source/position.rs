//! The one module that converts positions: bytes of the text to bytes of the file, to lines and columns, in every unit,
//! and back.

use super::decode::Charset;
use super::lines::LineIndex;
use super::{Source, Span, boundary, next_boundary};
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
        Position {
            line: number,
            column: self.column_on(number, offset - usize::from(is_in_end), unit),
        }
    }

    /// Returns the byte of the text at a position. Inside a character it is where that starts; a position after its
    /// line is the line's end, a line after the last one the text's end; lines and columns before the first are the
    /// first.
    pub fn offset(&self, position: Position, unit: Unit) -> usize {
        let line = self.line(position.line.max(1));
        let wanted = position.column.saturating_sub(1) as usize;
        let is_before = |it: &Column| it.units(unit) <= wanted;
        let known = self.columns.last(line.span, is_before);
        let characters = self.characters(line.number, line.span, known);
        let places = characters.take_while(|(_, after)| is_before(after));
        places.last().map_or(known, |(_, after)| after).offset
    }

    /// Returns line, and column in characters, of a byte of the text; both from 1. What comes after the last line, or
    /// in its end, is reported on that line.
    pub fn line_column(&self, offset: usize) -> (u32, u32) {
        (self.line_number(offset), self.column(offset))
    }

    /// Returns the column in characters, from 1, of a byte in or after its line.
    pub(crate) fn column(&self, offset: usize) -> u32 {
        self.column_on(self.line_number(offset), offset, Unit::Character)
    }

    /// Returns the column, from 1, of a byte of the line of this number. Characters that begin before it count.
    fn column_on(&self, number: u32, offset: usize, unit: Unit) -> u32 {
        let units = self.column_at(number, offset).units(unit);
        u32::try_from(units).map_or(u32::MAX, |units| units.saturating_add(1))
    }

    /// Returns the byte of the file, without its byte order mark, for the start of a character.
    pub(super) fn byte_of(&self, offset: usize) -> usize {
        let number = self.line_number(offset);
        let start = self
            .original
            .line_start(self.start_of_line_at(offset), number);
        start + self.column_at(number, offset).file
    }

    /// Returns the column of the first character that does not begin before a byte of the line of this number.
    fn column_at(&self, number: u32, offset: usize) -> Column {
        let line = Span::new(self.start_of_line_at(offset), offset.min(self.text.len()));
        let known = self.columns.last(line, |it| it.offset <= offset);
        let characters = self.characters(number, line, known);
        characters.last().map_or(known, |(_, after)| after)
    }

    /// Returns the characters of a line from a column of it on, each with the column after it. A character that begins in the
    /// span belongs to it.
    fn characters(
        &self,
        number: u32,
        line: Span,
        from: Column,
    ) -> impl Iterator<Item = (char, Column)> {
        let rest = Span::new(from.offset, next_boundary(&self.text, line.end));
        let start = self.original.line_start(line.start, number);
        self.slice(rest).chars().scan(from, move |column, char| {
            let bytes = self.original.length(char, start + column.file);
            *column = column.after(char, bytes);
            Some((char, *column))
        })
    }
}

/// Number of bytes of the text between two columns of an index.
const STRIDE: usize = 1024;

/// The column of a character, in every unit. The counts are the units before it on its line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Column {
    /// The byte of the text.
    offset: usize,
    file: usize,
    utf8: usize,
    utf16: usize,
    characters: usize,
}

impl Column {
    /// Returns the first column of the line that starts at a byte of the text.
    fn first(offset: usize) -> Self {
        Column {
            offset,
            file: 0,
            utf8: 0,
            utf16: 0,
            characters: 0,
        }
    }

    /// Returns the column after a character, which has so many bytes in the file.
    fn after(self, char: char, bytes: usize) -> Self {
        Column {
            offset: self.offset + char.len_utf8(),
            file: self.file + bytes,
            utf8: self.utf8 + char.len_utf8(),
            utf16: self.utf16 + char.len_utf16(),
            characters: self.characters + 1,
        }
    }

    fn units(&self, unit: Unit) -> usize {
        match unit {
            Unit::Byte => self.file,
            Unit::Utf8 => self.utf8,
            Unit::Utf16 => self.utf16,
            Unit::Character => self.characters,
        }
    }
}

/// Known columns of long lines, one for each [`STRIDE`] bytes, in the order of the text. A conversion counts characters
/// from the nearest one, since a line may be long and have many positions to convert.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct ColumnIndex(Vec<Column>);

impl ColumnIndex {
    pub(super) fn new(source: &Source) -> Self {
        let mut columns = Vec::new();
        for line in source.lines() {
            let first = Column::first(line.span.start);
            let mut next = STRIDE;
            // Short lines need no known columns.
            if line.span.end - line.span.start < STRIDE {
                continue;
            }
            for (_, column) in source.characters(line.number, line.span, first) {
                if column.utf8 >= next {
                    columns.push(column);
                    next = column.utf8 + STRIDE;
                }
            }
        }
        ColumnIndex(columns)
    }

    /// Returns the last known column of a line for which `fits` is true. `fits` must be true for the columns before
    /// such a column as well.
    fn last(&self, line: Span, fits: impl Fn(&Column) -> bool) -> Column {
        let start = self.0.partition_point(|it| it.offset < line.start);
        let end = self.0.partition_point(|it| it.offset <= line.end);
        let known = &self.0[start..end.max(start)];
        let fitting = known.partition_point(fits);
        let last = fitting.checked_sub(1).map(|last| known[last]);
        last.unwrap_or(Column::first(line.start))
    }
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
    /// Others, with the starts of their lines, which are the lines of the text. They are kept, since encoding the text
    /// again would not always lead back to them.
    Bytes(Charset, Box<[u8]>, LineIndex),
}

impl Original {
    pub(super) fn new(text: &str, charset: Charset, bytes: &[u8]) -> Self {
        if text.as_bytes() == bytes {
            return Original::Text;
        }
        Original::Bytes(charset, bytes.into(), LineIndex::new(bytes))
    }

    /// Returns the byte of the file at which the line of this number starts, whose start in the text is `start`.
    fn line_start(&self, start: usize, number: u32) -> usize {
        match self {
            Original::Text => start,
            Original::Bytes(_, bytes, lines) => lines.start(number).unwrap_or(bytes.len()),
        }
    }

    /// Returns the bytes of the file from `start` up to `end`; `text` is what they encode.
    pub(super) fn get<'a>(&'a self, text: &'a str, start: usize, end: usize) -> &'a [u8] {
        let bytes = match self {
            Original::Text => text.as_bytes(),
            Original::Bytes(_, bytes, _) => bytes,
        };
        bytes.get(start..end).unwrap_or_default()
    }

    /// Returns the number of bytes of the file for `char`, which is at `at`.
    fn length(&self, char: char, at: usize) -> usize {
        let Original::Bytes(charset, bytes, _) = self else {
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
