//! Layout of each line: its statements, and their indentation.

use super::rows::{Row, Rows};
use crate::listing::{Constants, formal};
use tipc::language::Keyword;
use tipc::lex::{BLANKS, DELIMITERS, split_comment};
use tipc::source::{Line, Source, Span, byte_length};
use tipc::syntax::{Module, Shape, Statement, StatementKind};

/// The blanks of each open block.
const INDENT: usize = 2;
/// Separator between statements on one line.
const SEPARATOR: &str = " ; ";

/// Returns the lines of a program that loads, in the style and without blank ones at its end.
pub(super) fn rows(source: &Source, module: &Module) -> Rows {
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
    /// Number of open blocks.
    depth: usize,
    /// END is passed.
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
            // So is what follows END on its line.
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

    /// Returns true if more than a comment follows END on its line.
    fn says_more(&self, statements: &[Statement], code: Span) -> bool {
        let Some(end) = statements.last() else {
            return false;
        };
        let rest = self.source.slice(Span::new(end.span.end, code.end));
        !rest.trim_matches(DELIMITERS).trim_matches(';').is_empty()
    }

    /// Returns the blanks before a line; what its statements open and close counts from now on.
    fn indent(&mut self, statements: &[Statement]) -> usize {
        let mut own = self.depth;
        let mut begins = true;
        for statement in statements {
            let edge = Edge::of(statement.kind.shape());
            match edge {
                Edge::Closes => self.depth = self.depth.saturating_sub(1),
                Edge::Opens => self.depth += 1,
                Edge::Parts | Edge::Inside => {}
            }
            match edge {
                Edge::Closes if begins => own = self.depth,
                Edge::Parts if begins => own = self.depth.saturating_sub(1),
                _ => begins = false,
            }
            begins &= edge == Edge::Closes;
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
                formal::write(&mut self.code, self.source, statement, &constants, b' ');
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

    /// Writes what the file has there, to the byte.
    fn copy(&mut self, span: Span) -> usize {
        self.code.extend_from_slice(self.source.original(span));
        byte_length(self.source.slice(span))
    }
}

/// Effect of a statement on the depth of blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Edge {
    Opens,
    /// It closes one branch and opens the next.
    Parts,
    Closes,
    Inside,
}

impl Edge {
    const fn of(shape: Shape) -> Self {
        match shape {
            Shape::If
            | Shape::While
            | Shape::Repeat
            | Shape::For
            | Shape::Subroutine
            | Shape::Thread => Edge::Opens,
            Shape::ElseIf | Shape::Else => Edge::Parts,
            Shape::EndIf
            | Shape::Wend
            | Shape::Until
            | Shape::Next
            | Shape::SubEnd
            | Shape::ThreadEnd
            | Shape::Close => Edge::Closes,
            Shape::Plain | Shape::OneLineIf => Edge::Inside,
        }
    }
}
