//! The lines of a formatted program, and their bytes: the comments of neighbouring lines are aligned.

use crate::message::Formatting;
use std::ops::Range;
use tipc::parse::LINE_LIMIT;
use tipc::source::{Source, Span, byte_length};

/// Minimum space between code and its comment, columns.
const GAP: usize = 2;

/// A line: indentation, code, comment, any of which may be empty.
#[derive(Debug)]
pub(super) struct Row {
    /// Its number in the file, from 1.
    pub(super) number: u32,
    /// The blanks that it begins with.
    pub(super) indent: usize,
    /// Its code among the bytes of all code.
    pub(super) code: Range<usize>,
    /// Width of the code, columns.
    pub(super) length: usize,
    pub(super) comment: Span,
    pub(super) end: Span,
    /// It is copied as it is, however long.
    pub(super) verbatim: bool,
}

impl Row {
    pub(super) fn is_blank(&self) -> bool {
        self.code.is_empty() && !self.has_comment()
    }

    pub(super) fn has_comment(&self) -> bool {
        self.comment.start < self.comment.end
    }

    /// Returns true if a comment follows code here.
    fn is_commented(&self) -> bool {
        !self.code.is_empty() && self.has_comment()
    }

    /// Returns the column after the code, from 0.
    fn code_end(&self) -> usize {
        self.indent + self.length
    }
}

/// All lines.
#[derive(Debug)]
pub(super) struct Rows {
    pub(super) rows: Vec<Row>,
    /// The code of all lines, in the encoding of the file.
    pub(super) code: Vec<u8>,
}

impl Rows {
    /// Returns the bytes of the whole file.
    pub(super) fn write(&self, source: &Source) -> Result<Vec<u8>, Formatting> {
        let mut out = Vec::with_capacity(source.text().len() * 5 / 4);
        out.extend_from_slice(source.mark());
        for section in self
            .rows
            .chunk_by(|a, b| a.is_commented() && b.is_commented())
        {
            let column = section.iter().map(Row::code_end).max().unwrap_or(0) + GAP;
            for row in section {
                self.row(row, column, source, &mut out)?;
            }
        }
        out.extend_from_slice(source.tail());
        Ok(out)
    }

    fn row(
        &self,
        row: &Row,
        column: usize,
        source: &Source,
        out: &mut Vec<u8>,
    ) -> Result<(), Formatting> {
        if !row.is_blank() {
            blanks(out, row.indent);
        }
        out.extend_from_slice(&self.code[row.code.clone()]);
        let mut length = row.code_end();
        if row.is_commented() {
            blanks(out, column - length);
            length = column;
        }
        if row.has_comment() {
            out.extend_from_slice(source.original(row.comment));
            length += byte_length(source.slice(row.comment));
        }
        if length > LINE_LIMIT && !row.verbatim {
            let line = row.number;
            return Err(Formatting::LineTooLong {
                line,
                limit: LINE_LIMIT,
            });
        }
        out.extend_from_slice(self.end(row, source, out));
        Ok(())
    }

    /// Returns the line end of a row, unchanged. The last line ends like the one before it, if it did not end.
    fn end<'a>(&self, row: &Row, source: &'a Source, out: &[u8]) -> &'a [u8] {
        match source.original(row.end) {
            // Together with the end before it, this would be one.
            b"\n" if out.ends_with(b"\r") => b"\r",
            b"" => {
                let before = self.rows.iter().rev().map(|row| source.original(row.end));
                before
                    .into_iter()
                    .find(|end| !end.is_empty())
                    .unwrap_or(b"\n")
            }
            end => end,
        }
    }
}

fn blanks(out: &mut Vec<u8>, count: usize) {
    out.resize(out.len() + count, b' ');
}
