//! Programs in the one style of docs/style.md: blanks, capital letters, indentation, comments in columns.
//!
//! Lines are not joined, split or moved. Comments, texts, the first two lines and everything after END keep every byte
//! in any encoding. **The result is the same program**: each call parses it and compares the statements.
//!
//! ```
//! use tip_lint::{Options, format::format};
//!
//! let written = "3.1\nlift a foot\nfor n=1 to 3\nptp f1 r 0,r 0,r 50//mm\nnext\ndef_var n\nend";
//! let formatted = format("lift.prg", written.as_bytes(), &Options::default()).expect("a program");
//! assert_eq!(
//!     String::from_utf8(formatted).expect("UTF-8, as before"),
//!     "3.1\nlift a foot\nFOR N = 1 TO 3\n  PTP F1 R 0 R 0 R 50  //mm\nNEXT\nDEF_VAR N\nEND\n"
//! );
//! ```

use crate::listing::{Constants, write};
use crate::message::Formatting;
use crate::{Loaded, Options, load};
use std::mem::discriminant;
use std::ops::Range;
use tipc::Robot;
use tipc::language::Keyword;
use tipc::lex::{BLANKS, DELIMITERS, split_comment};
use tipc::load::{Parsed, parsed};
use tipc::parse::{LINE_LIMIT, parse};
use tipc::source::{Line, Source, Span, byte_length};
use tipc::syntax::{Edge, Module, Statement, StatementKind, Word};

/// The blanks of each open block.
const INDENT: usize = 2;
/// Separator between statements on one line.
const SEPARATOR: &str = " ; ";
/// Minimum space between code and its comment, columns.
const GAP: usize = 2;

/// Reason why a file is not formatted.
#[derive(Clone, Debug)]
pub enum Refusal {
    /// It does not load. The diagnostics tell why.
    Diagnostics(Box<Loaded>),
    /// It loads, but cannot be written in the style.
    Because(Formatting),
}

/// Formats a program in the style. `name` is the file's name in diagnostics.
///
/// # Errors
///
/// The file does not load; a line would be too long; or, which would be a defect here, the result would not be the same program.
pub fn format(name: &str, bytes: &[u8], options: &Options) -> Result<Vec<u8>, Refusal> {
    format_for(name, bytes, options, &[options.robot])
}

/// Returns the bytes of a program in the style, for the first of some robots that it loads for. `name` and `options` are
/// those of [`format()`].
///
/// # Errors
///
/// The program loads for none of them: the diagnostics are those for the robot with the fewest errors. Else as in [`format()`].
pub fn format_for(
    name: &str,
    bytes: &[u8],
    options: &Options,
    robots: &[Robot],
) -> Result<Vec<u8>, Refusal> {
    let before = parsed(name, bytes, options);
    let mut best = *options;
    let mut fewest = usize::MAX;
    for robot in robots {
        let options = Options {
            robot: *robot,
            ..*options
        };
        let errors = before.errors(&options);
        if errors == 0 {
            return laid_out(&before, bytes, &options).map_err(Refusal::Because);
        }
        if errors < fewest {
            (best, fewest) = (options, errors);
        }
    }
    Err(Refusal::Diagnostics(Box::new(load(name, bytes, &best))))
}

/// Formats a program in the style; checks that the result is the same program.
fn laid_out(before: &Parsed, bytes: &[u8], options: &Options) -> Result<Vec<u8>, Formatting> {
    let rows = rows(&before.source, &before.module);
    let formatted = rows.write(&before.source)?;
    if formatted != bytes {
        check(before, &formatted, options)?;
    }
    Ok(formatted)
}

/// Returns the lines of a program that loads, in the style and without blank ones at its end.
fn rows(source: &Source, module: &Module) -> Rows {
    let mut layout = Layout {
        source,
        rows: Vec::with_capacity(source.line_count() as usize),
        code: Vec::with_capacity(source.text().len()),
        depth: 0,
        ended: false,
    };
    let mut statements = module.statements.as_slice();
    for line in source.lines() {
        let count = statements
            .iter()
            .take_while(|statement| statement.line == line.number)
            .count();
        let (own, others) = statements.split_at(count);
        statements = others;
        layout.line(line, own);
    }
    let Layout { mut rows, code, .. } = layout;
    let is_blank = |byte: &u8| matches!(byte, b' ' | b'\t');
    while let Some(last) = rows.last()
        && !last.has_comment()
        && code[last.code.clone()].iter().all(is_blank)
    {
        rows.pop();
    }
    Rows { rows, code }
}

struct Layout<'a> {
    source: &'a Source,
    rows: Vec<Row>,
    code: Vec<u8>,
    /// Number of blocks that are open at the line.
    depth: usize,
    /// True after END.
    ended: bool,
}

impl Layout<'_> {
    fn line(&mut self, line: Line, statements: &[Statement]) {
        // The version, the title, and what is not part of the program.
        if line.number <= 2 || self.ended {
            return self.verbatim(line);
        }
        let (code, comment) = split_comment(self.source.text(), line.span);
        let start = self.code.len();
        let indent = self.indent(statements);
        let mut length = self.statements(statements, code);
        let mut comment = comment.unwrap_or(Span::new(line.span.end, line.span.end));
        if self.ended && self.says_more(statements, code) {
            // The text after END on its line is not part of the program either.
            let rest = Span::new(
                statements.last().map_or(code.end, |end| end.span.end),
                line.span.end,
            );
            length += self.copy(rest);
            comment = Span::new(line.span.end, line.span.end);
        }
        let kept = self.source.slice(comment).trim_end_matches(BLANKS);
        let row = Row {
            number: line.number,
            indent,
            code: start..self.code.len(),
            length,
            comment: Span::new(comment.start, comment.start + kept.len()),
            end: line.end,
            verbatim: false,
        };
        let follows_blank = line.number > 3 && self.rows.last().is_some_and(Row::is_blank);
        if !(row.is_blank() && follows_blank) {
            self.rows.push(row);
        }
    }

    fn verbatim(&mut self, line: Line) {
        let start = self.code.len();
        let length = self.copy(line.span);
        self.rows.push(Row {
            number: line.number,
            indent: 0,
            code: start..self.code.len(),
            length,
            comment: Span::new(line.span.end, line.span.end),
            end: line.end,
            verbatim: true,
        });
    }

    /// Returns true if END has other text than a comment after it on its line.
    fn says_more(&self, statements: &[Statement], code: Span) -> bool {
        let Some(end) = statements.last() else {
            return false;
        };
        let rest = self.source.slice(Span::new(end.span.end, code.end));
        !rest.trim_matches(DELIMITERS).trim_matches(';').is_empty()
    }

    /// Returns the number of blanks before a line, and counts the blocks that its statements open and close.
    fn indent(&mut self, statements: &[Statement]) -> usize {
        let mut own = self.depth;
        let mut begins = true;
        for statement in statements {
            let edge = statement.kind.shape().edge();
            match edge {
                Edge::Closes(_) => self.depth = self.depth.saturating_sub(1),
                Edge::Opens => self.depth += 1,
                Edge::Parts(_) | Edge::Inside => {}
            }
            match edge {
                Edge::Closes(_) if begins => own = self.depth,
                Edge::Parts(_) if begins => own = self.depth.saturating_sub(1),
                _ => begins = false,
            }
            begins &= matches!(edge, Edge::Closes(_));
        }
        match statements {
            [label, ..] if matches!(label.kind, StatementKind::Label(_)) => 0,
            _ => own * INDENT,
        }
    }

    /// Writes the statements of a line, and returns how many columns they take.
    fn statements(&mut self, statements: &[Statement], code: Span) -> usize {
        let mut length = 0;
        let mut separator = "";
        for statement in statements {
            length += self.put(separator);
            length += self.statement(statement, code);
            separator = match statement.kind {
                StatementKind::Label(_) => " ",
                _ => SEPARATOR,
            };
        }
        length
    }

    fn statement(&mut self, statement: &Statement, code: Span) -> usize {
        match &statement.kind {
            StatementKind::Message { text } | StatementKind::FileMessage { text } => {
                let mut length = self.put(match &statement.kind {
                    StatementKind::FileMessage { .. } => Keyword::FileMessage.word(),
                    _ => Keyword::Message.word(),
                });
                if !text.node.is_empty() {
                    length += self.put(" ") + self.copy(text.span);
                }
                length
            }
            StatementKind::Rem => {
                let word = Keyword::Rem.word();
                let text = self
                    .source
                    .slice(Span::new(statement.span.start + word.len(), code.end));
                let text = text.split(';').next().unwrap_or_default();
                let start = statement.span.start + word.len();
                let end = start + text.trim_end_matches(BLANKS).len();
                self.put(word) + self.copy(Span::new(start, end))
            }
            StatementKind::Define { keyword, names, .. } => {
                let mut length = self.capitals(*keyword);
                for (index, name) in names.iter().enumerate() {
                    length += self.put(if index == 0 { " " } else { ", " });
                    length += self.put(&name.node);
                }
                length
            }
            StatementKind::End => {
                self.ended = true;
                self.put(Keyword::End.word())
            }
            _ => {
                // All of it is ASCII.
                let start = self.code.len();
                let constants = Constants::default();
                write(&mut self.code, self.source, statement, &constants, b' ');
                self.code.len() - start
            }
        }
    }

    /// Writes ASCII.
    fn put(&mut self, text: &str) -> usize {
        self.code.extend_from_slice(text.as_bytes());
        text.len()
    }

    /// Writes a word of the program in capital letters.
    fn capitals(&mut self, word: Span) -> usize {
        let word = self.source.slice(word).to_ascii_uppercase();
        self.put(&word)
    }

    /// Writes the bytes of the file at a span unchanged.
    fn copy(&mut self, span: Span) -> usize {
        self.code.extend_from_slice(self.source.original(span));
        byte_length(self.source.slice(span))
    }
}

/// A line: indentation, code, comment, any of which may be empty.
#[derive(Debug)]
struct Row {
    /// Its number in the file, from 1.
    number: u32,
    /// The blanks that it begins with.
    indent: usize,
    /// Its code among the bytes of all code.
    code: Range<usize>,
    /// Width of the code, columns.
    length: usize,
    comment: Span,
    end: Span,
    /// True for a line that is copied unchanged at any length.
    verbatim: bool,
}

impl Row {
    fn is_blank(&self) -> bool {
        self.code.is_empty() && !self.has_comment()
    }

    fn has_comment(&self) -> bool {
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

/// The lines of a formatted program: the comments of neighbouring lines are aligned.
#[derive(Debug)]
struct Rows {
    rows: Vec<Row>,
    /// The code of all lines, in the encoding of the file.
    code: Vec<u8>,
}

impl Rows {
    /// Returns the bytes of the whole file.
    fn write(&self, source: &Source) -> Result<Vec<u8>, Formatting> {
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
            // A LF after the CR of the line before would make one line end of both.
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

/// Checks that both texts have the same statements, without a mistake, and that comments and texts are read as before.
/// The passes after the parser see only the fields of statements, so equal fields make an equal program.
fn check(before: &Parsed, formatted: &[u8], options: &Options) -> Result<(), Formatting> {
    let name = before.source.name();
    let (after, undecodable) = Source::decode(name, formatted, options.encoding);
    let charset = after.charset();
    if charset != before.source.charset() && !after.text().is_ascii() {
        let encoding = charset.name();
        return Err(Formatting::OtherEncoding { encoding });
    }
    match undecodable.is_none() && is_equal(before, &after, options) {
        true => Ok(()),
        false => Err(Formatting::OtherProgram),
    }
}

/// Returns true if a source is read as the same statements, without an error.
fn is_equal(before: &Parsed, after: &Source, options: &Options) -> bool {
    let (module, found) = parse(after, options.tip_version);
    let mut statements = before.module.statements.iter().zip(&module.statements);
    !found.have_error(module.edition)
        && before.module.edition == module.edition
        && before.module.title == module.title
        && before.module.statements.len() == module.statements.len()
        && statements.all(|(old, new)| is_same((&before.source, old), (after, new)))
}

fn is_same((before, old): (&Source, &Statement), (after, new): (&Source, &Statement)) -> bool {
    old.step == new.step
        && discriminant(&old.kind) == discriminant(&new.kind)
        && match (&old.kind, &new.kind) {
            (
                StatementKind::Define { kind, names, .. },
                StatementKind::Define {
                    kind: new_kind,
                    names: new_names,
                    ..
                },
            ) => kind == new_kind && names.iter().map(name).eq(new_names.iter().map(name)),
            _ => fields(before, old) == fields(after, new),
        }
}

fn name(word: &Word) -> &str {
    &word.node
}

/// Returns the fields of a statement as FORMAL.TMP shows them.
fn fields(source: &Source, statement: &Statement) -> Vec<u8> {
    let mut text = Vec::new();
    write(&mut text, source, statement, &Constants::default(), b'\t');
    text
}

#[cfg(test)]
mod tests {
    use super::check;
    use crate::Options;
    use tipc::load::parsed;

    /// Returns a long program with two lines that a test changes.
    fn program(first: &str, second: &str) -> String {
        let lines = |n: usize| format!("  ptp f1 {n} r 0 r 0 ; a={n}\n").repeat(1000);
        let (begin, end) = (lines(1), lines(2));
        format!(
            "3.1\nlong\ndef_var a\n{begin}{first}\n{end}{second}\n{begin}end\nptp what follows\n"
        )
    }

    #[track_caller]
    fn is_same(before: &str, after: &str) -> bool {
        let options = Options::default();
        let before = parsed("long.prg", before.as_bytes(), &options);
        assert_eq!(*before.diagnostics, []);
        check(&before, after.as_bytes(), &options).is_ok()
    }

    // clauses: 8.1
    #[test]
    fn a_change_in_either_line_is_seen() {
        let before = program("a = 1", "a = 1");
        assert!(is_same(&before, &program("A=1 // as it was", "a   =   1")));
        for other in ["a = 2", "", "a = 1 ; a = 1", "end", "a == 1", "rem"] {
            assert!(!is_same(&before, &program(other, "a = 1")), "{other}");
            assert!(!is_same(&before, &program("a = 1", other)), "{other}");
        }
        // A line that moves from one location to the other.
        assert!(!is_same(&before, &program("", "a = 1\na = 1")));
        let endless = before.replace("end\nptp what follows\n", "");
        assert!(!is_same(&before, &endless));
    }
}
