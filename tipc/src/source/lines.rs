//! Lines, and the index of their starts.

use super::{Source, Span};

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
    /// Finds the lines of any text, decoded or not.
    pub(super) fn of(bytes: &'a [u8]) -> Self {
        Lines {
            bytes,
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

/// The first byte of each line of a text; there is at least one line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct LineIndex(Vec<usize>);

impl LineIndex {
    pub(super) fn new(bytes: &[u8]) -> Self {
        let mut starts = Vec::with_capacity(Lines::of(bytes).count());
        starts.extend(Lines::of(bytes).map(|line| line.span.start));
        LineIndex(starts)
    }

    /// Returns the number of lines.
    fn count(&self) -> u32 {
        u32::try_from(self.0.len()).unwrap_or(u32::MAX)
    }

    /// Returns the start of a line, counted from 1; `None` if there is no such line.
    pub(super) fn start(&self, number: u32) -> Option<usize> {
        self.0.get(number.checked_sub(1)? as usize).copied()
    }

    /// Returns the number of the line that holds a byte; after the text it is the last line.
    fn number(&self, offset: usize) -> u32 {
        let number = self.0.partition_point(|start| *start <= offset);
        u32::try_from(number).unwrap_or(u32::MAX)
    }
}

impl Source {
    /// Returns the number of lines; at least one.
    pub fn line_count(&self) -> u32 {
        self.lines.count()
    }

    /// Returns all lines in order. An end after the last line opens no further one.
    pub fn lines(&self) -> Lines<'_> {
        Lines::of(self.text.as_bytes())
    }

    /// Returns the lines from one on, counted from 1.
    pub fn lines_from(&self, number: u32) -> Lines<'_> {
        Lines {
            bytes: self.text.as_bytes(),
            at: self.lines.start(number).unwrap_or(self.text.len()),
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
    pub(crate) fn line_number(&self, offset: usize) -> u32 {
        self.lines.number(offset)
    }

    /// Returns the start of the line of a byte.
    pub(crate) fn start_of_line_at(&self, offset: usize) -> usize {
        self.lines
            .start(self.line_number(offset))
            .unwrap_or_default()
    }
}
