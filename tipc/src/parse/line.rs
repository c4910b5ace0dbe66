//! One line: its comment, its statements, their labels, and the words that want a line of their own.

use super::{Flow, NAME_LIMIT, Parser};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::{Keyword, keywords};
use crate::lex::{DELIMITERS, foreign_run, skip_delimiters, word_end};
use crate::message::Parsing;
use crate::syntax::{Shape, Span, StatementKind, Word, upper_case};

impl Parser<'_> {
    /// Reads the statements of the current line.
    pub(super) fn statements_of_line(&mut self) -> Flow {
        let (code, comment) = split_comment(self.text, self.line.span);
        let first = self.module.statements.len();
        let reported = self.diagnostics.len();
        let mut start = code.start;
        let mut flow = Flow::Continue;
        while flow == Flow::Continue && start <= code.end {
            let length = self.text.as_bytes()[start..code.end]
                .iter()
                .position(|byte| *byte == b';');
            let end = length.map_or(code.end, |length| start + length);
            let cut_by = comment.filter(|_| end == code.end);
            flow = self.piece(Span::new(start, end), cut_by);
            start = end + 1;
        }
        self.check_lone_words(first, reported);
        flow
    }

    /// Reads what stands between two `;`: labels, and at most one statement.
    fn piece(&mut self, piece: Span, comment: Option<Span>) -> Flow {
        let end = piece.start + self.source.slice(piece).trim_end_matches(DELIMITERS).len();
        let bytes = &self.text.as_bytes()[..end];
        let mut start = skip_delimiters(bytes, piece.start);
        while start < end {
            let word = Span::new(start, word_end(bytes, start));
            let Some(behind) = self.label_end(word, end) else {
                return self.statement(word, Span::new(start, end), piece.end, comment);
            };
            self.label(word, behind);
            start = skip_delimiters(bytes, behind);
        }
        Flow::Continue
    }

    /// The place behind the colon if `word` is a label. MESSAGE and REM may go on with a text that starts with one.
    fn label_end(&self, word: Span, end: usize) -> Option<usize> {
        let bytes = &self.text.as_bytes()[..end];
        let colon = skip_delimiters(bytes, word.end);
        let keyword = || keywords::find(self.source.slice(word), self.module.edition);
        let is_label = bytes.get(colon) == Some(&b':')
            && (colon == word.end || !matches!(keyword(), Some(Keyword::Message | Keyword::Rem)));
        is_label.then_some(colon + 1)
    }

    fn label(&mut self, word: Span, end: usize) {
        let span = Span::new(word.start, end);
        if let Some(foreign) = foreign_run(self.text, word) {
            self.report_foreign(foreign);
            return self.push(StatementKind::Broken(Shape::Plain), span);
        }
        if word.start == word.end {
            let reason = Parsing::LabelNameMissing;
            self.report(Diagnostic::new(Code::Argument, span, reason));
            return self.push(StatementKind::Broken(Shape::Plain), span);
        }
        let name = Word {
            node: upper_case(self.source.slice(word)),
            span: word,
        };
        self.check_name_length(&name);
        self.push(StatementKind::Label(name), span);
    }

    /// A declared name may not be too long.
    pub(super) fn check_name_length(&mut self, name: &Word) {
        if name.node.len() > NAME_LIMIT {
            let reason = Parsing::NameTooLong {
                limit: NAME_LIMIT,
                length: name.node.len(),
            };
            self.report(Diagnostic::new(Code::Format, name.span, reason));
        }
    }

    /// Characters that only comments and texts may hold.
    pub(super) fn report_foreign(&mut self, place: Span) {
        let text = self.source.slice(place);
        let reason = match text.chars().next() {
            Some(first) if first.is_ascii_control() => Parsing::ControlCharacter,
            _ => Parsing::ForeignCharacters,
        };
        let mut diagnostic = Diagnostic::new(Code::Format, place, reason);
        if let Some(narrow) = half_width(text) {
            diagnostic = diagnostic.help(Parsing::WriteHalfWidth { narrow });
        }
        self.report(diagnostic);
    }

    /// ELSE, ENDIF, WEND and REPEAT among the line's statements want no other beside them.
    ///
    /// The line's statements start at `first`, its diagnostics at `reported`.
    fn check_lone_words(&mut self, first: usize, reported: usize) {
        let statements = &self.module.statements[first..];
        let labels = statements
            .iter()
            .take_while(|statement| matches!(statement.kind, StatementKind::Label(_)))
            .count();
        let statements = &statements[labels..];
        if statements.len() < 2 {
            return;
        }
        let mut known: Vec<usize> = self.diagnostics[reported..]
            .iter()
            .map(|diagnostic| diagnostic.span.start)
            .collect();
        known.sort_unstable();
        let is_new = |span: Span| known.binary_search(&span.start).is_err();
        let faults: Vec<Diagnostic> = statements
            .iter()
            .enumerate()
            .filter_map(|(index, statement)| {
                let name = lone_word(&statement.kind).filter(|_| is_new(statement.span))?;
                let other = &statements[usize::from(index == 0)];
                Some(not_alone(name, statement.span, other.span))
            })
            .collect();
        self.diagnostics.extend(faults);
    }
}

/// ELSE, ENDIF, WEND or REPEAT beside something else.
pub(super) fn not_alone(name: Keyword, place: Span, other: Span) -> Diagnostic {
    let reason = Parsing::NotAlone { word: name.into() };
    Diagnostic::new(Code::Format, place, reason)
        .label(other, Parsing::WantsOwnLine)
        .help(Parsing::LabelBeforeCommentBehind)
}

fn lone_word(kind: &StatementKind) -> Option<Keyword> {
    match kind {
        StatementKind::Else => Some(Keyword::Else),
        StatementKind::EndIf => Some(Keyword::EndIf),
        StatementKind::Wend => Some(Keyword::Wend),
        StatementKind::Repeat => Some(Keyword::Repeat),
        _ => None,
    }
}

fn split_comment(text: &str, line: Span) -> (Span, Option<Span>) {
    let bytes = &text.as_bytes()[line.start..line.end];
    match bytes.windows(2).position(|pair| pair == b"//") {
        Some(at) => {
            let at = line.start + at;
            (Span::new(line.start, at), Some(Span::new(at, line.end)))
        }
        None => (line, None),
    }
}

/// The same characters half-width, if they are full-width letters, digits or signs.
fn half_width(text: &str) -> Option<String> {
    text.chars()
        .map(|char| match char {
            '\u{FF01}'..='\u{FF5E}' => char::from_u32(char as u32 - 0xFEE0),
            _ => None,
        })
        .collect()
}
