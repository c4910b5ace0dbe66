//! Lines, found by counting: the index knows how many end before each stretch of the text, and nothing of any line.

use super::{STRETCH, Source, Span, boundary};

/// A line of a source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// Its number, from 1.
    pub number: u32,
    /// Its text, without its end.
    pub span: Span,
    /// Its end (LF, CRLF or CR); empty if the text ends without one.
    pub end: Span,
}

/// The lines of a text, one by one.
#[derive(Clone, Debug)]
pub struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    number: u32,
}

impl<'a> Lines<'a> {
    /// Finds the lines of any text.
    pub(super) fn of(text: &'a str) -> Self {
        Lines {
            bytes: text.as_bytes(),
            at: 0,
            number: 0,
        }
    }
}

impl Iterator for Lines<'_> {
    type Item = Line;

    fn next(&mut self) -> Option<Line> {
        let start = self.at;
        if start == self.bytes.len() && self.number > 0 {
            return None;
        }
        let rest = &self.bytes[start..];
        let length = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        let end = start + length.unwrap_or(rest.len());
        self.at = end
            + match &self.bytes[end..] {
                [b'\r', b'\n', ..] => 2,
                [_, ..] => 1,
                [] => 0,
            };
        self.number = self.number.saturating_add(1);
        Some(Line {
            number: self.number,
            span: Span::new(start, end),
            end: Span::new(end, self.at),
        })
    }
}

/// Index of the lines of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct LineIndex {
    /// Number of line ends before each multiple of [`STRETCH`] bytes.
    ends: Vec<u32>,
    /// Number of lines.
    count: u32,
}

impl LineIndex {
    pub(super) fn new(text: &str) -> Self {
        let bytes = text.as_bytes();
        let mut ends = Vec::with_capacity(bytes.len() / STRETCH + 1);
        let mut before: u32 = 0;
        for start in (0..=bytes.len()).step_by(STRETCH) {
            ends.push(before);
            before = before.saturating_add(count_ends(bytes, start, start + STRETCH));
        }
        // An end after the last line opens no further one.
        let is_open = bytes.is_empty() || !ends_line(bytes, bytes.len() - 1);
        LineIndex {
            ends,
            count: before.saturating_add(u32::from(is_open)),
        }
    }
}

impl Source {
    /// Returns the number of lines; at least one.
    pub fn line_count(&self) -> u32 {
        self.lines.count
    }

    /// Returns all lines in order. An end after the last line opens no further one.
    pub fn lines(&self) -> Lines<'_> {
        Lines::of(&self.text)
    }

    /// Returns the lines from one on, counted from 1.
    pub fn lines_from(&self, number: u32) -> Lines<'_> {
        Lines {
            bytes: self.text.as_bytes(),
            at: self.line_start(number),
            number: number.saturating_sub(1),
        }
    }

    /// Returns a line by its number, from 1. A line that does not exist is empty, at the end.
    pub fn line(&self, number: u32) -> Line {
        let end = Span::new(self.text.len(), self.text.len());
        let (span, end) = match self.lines_from(number).next() {
            Some(line) => (line.span, line.end),
            None => (end, end),
        };
        Line { number, span, end }
    }

    /// Returns the text of a line, counted from 1, without its line end.
    pub fn line_text(&self, number: u32) -> &str {
        self.slice(self.line(number).span)
    }

    /// Returns the number of the line that holds a byte of the text, its end included; after the text it is the last
    /// line.
    pub(super) fn line_number(&self, offset: usize) -> u32 {
        let bytes = self.text.as_bytes();
        let offset = offset.min(bytes.len());
        let stretch = offset / STRETCH;
        let ends = self.lines.ends[stretch];
        let ends = ends.saturating_add(count_ends(bytes, stretch * STRETCH, offset));
        ends.saturating_add(1).min(self.lines.count)
    }

    /// Returns the start of a line; for a line that does not exist, the end.
    fn line_start(&self, number: u32) -> usize {
        let bytes = self.text.as_bytes();
        if number == 0 || number > self.lines.count {
            return bytes.len();
        }
        let ends = number - 1;
        let Some(stretch) = self
            .lines
            .ends
            .partition_point(|before| *before < ends)
            .checked_sub(1)
        else {
            return 0;
        };
        let missing = ends - self.lines.ends[stretch];
        (stretch * STRETCH..bytes.len())
            .filter(|at| ends_line(bytes, *at))
            .nth(missing as usize - 1)
            .map_or(bytes.len(), |at| at + 1)
    }

    /// Returns the start of the line of a byte.
    pub(crate) fn start_of_line_at(&self, offset: usize) -> usize {
        let last = boundary(&self.text, offset.min(self.text.len().saturating_sub(1)));
        let from = boundary(&self.text, last.saturating_sub(STRETCH));
        let feed = self.text[from..last].rfind('\n');
        let start = feed.map_or(from, |feed| from + feed + 1);
        let before = &self.text[start..last];
        let before = match self.text.as_bytes().get(last) {
            Some(b'\n') => before.strip_suffix('\r').unwrap_or(before),
            _ => before,
        };
        match before.rfind('\r') {
            Some(alone) => start + alone + 1,
            None if feed.is_some() || start == 0 => start,
            // Few lines are so long.
            None => self.line_start(self.line_number(last)),
        }
    }
}

/// Returns true if a line end ends with the byte at `at`.
fn ends_line(bytes: &[u8], at: usize) -> bool {
    match bytes[at] {
        b'\n' => true,
        b'\r' => bytes.get(at + 1) != Some(&b'\n'),
        _ => false,
    }
}

/// Counts the line ends that end with a byte from `start` up to `end`.
fn count_ends(bytes: &[u8], start: usize, end: usize) -> u32 {
    let end = end.min(bytes.len());
    let count = |wanted: u8| bytes[start..end].iter().filter(|it| **it == wanted).count();
    let (returns, feeds) = (count(b'\r'), count(b'\n'));
    if returns == 0 {
        return feeds as u32;
    }
    let pairs = &bytes[start..bytes.len().min(end + 1)];
    let pairs = pairs.windows(2).filter(|pair| *pair == b"\r\n").count();
    (feeds + returns - pairs) as u32
}
