//! One line: its comment, its statements, their labels, and the words that need a line of their own.

use super::{Flow, LINE_LIMIT, Parser};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::foreign;
use crate::language::{Keyword, keywords, names};
use crate::lex::{Piece, Pieces, foreign_run, split_comment};
use crate::message::{Habit, Naming, Parsing};
use crate::source::Span;
use crate::syntax::{Shape, StatementKind, Word, upper_case};

impl Parser<'_> {
    /// Reads the statements of the current line.
    pub(super) fn statements_of_line(&mut self) -> Flow {
        let (code, comment) = split_comment(self.text, self.line.span);
        let first = self.module.statements.len();
        let reported = self.diagnostics.len();
        let mut flow = Flow::Continue;
        for piece in Pieces::new(self.text, code, false) {
            match piece {
                Piece::Label { name, span } => flow = self.label_or_word(name, span),
                Piece::Statement {
                    word,
                    span,
                    text_end,
                } => {
                    let cut_by = comment.filter(|_| text_end == code.end);
                    flow = self.statement(word, span, text_end, cut_by);
                }
            }
            if flow != Flow::Continue {
                break;
            }
        }
        self.check_lone_words(first, reported);
        flow
    }

    /// A label, or a word with a colon that it does not take.
    fn label_or_word(&mut self, word: Span, span: Span) -> Flow {
        let keyword = keywords::find(self.source.slice(word), self.module.edition);
        let (shape, flow) = match keyword {
            Some(Keyword::Else) => (Shape::Else, Flow::Continue),
            Some(Keyword::EndIf) => (Shape::EndIf, Flow::Continue),
            Some(Keyword::Wend) => (Shape::Wend, Flow::Continue),
            // The rest of the line is a text.
            Some(Keyword::Rem | Keyword::Message) => (Shape::Plain, Flow::NextLine),
            _ => {
                self.label(word, span);
                return Flow::Continue;
            }
        };
        let word_of = upper_case(self.source.slice(word));
        let reason = Naming::WordOfLanguage {
            word: word_of.clone(),
        };
        let help = Habit::WithoutColon { word: word_of };
        self.report(Diagnostic::new(Code::Argument, word, reason).help(help));
        self.push(StatementKind::Broken(shape), span);
        flow
    }

    fn label(&mut self, word: Span, span: Span) {
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
        if name.node.len() > names::LIMIT {
            let reason = Parsing::NameTooLong {
                limit: names::LIMIT,
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
        let before = &self.text[self.line.span.start..place.start];
        if let Some(plain) = text.chars().next().and_then(foreign::plain) {
            diagnostic = diagnostic.help(Habit::Plain { plain });
        } else if text.chars().all(char::is_whitespace) {
            diagnostic = diagnostic.help(Habit::PlainBlank);
        } else if foreign::ends_in_comment_mark(before) {
            diagnostic = diagnostic.help(Habit::Comment);
        } else if let Some(narrow) = half_width(text) {
            diagnostic = diagnostic.help(Parsing::WriteHalfWidth { narrow });
        } else if self.is_in_foreign_comment(place) {
            diagnostic = diagnostic.help(Habit::Comment);
        } else if text.chars().all(char::is_alphabetic) {
            diagnostic = diagnostic.help(Parsing::PlainNames);
        } else {
            diagnostic = diagnostic.help(Parsing::TakeOut);
        }
        self.report(diagnostic);
    }

    /// Whether a comment of another language begins before a place on its line.
    fn is_in_foreign_comment(&self, place: Span) -> bool {
        let line = self.line.span;
        let before = self.source.slice(Span::new(line.start, place.start));
        // Of a line that is too long it does not matter.
        let is_after = || before.len() <= LINE_LIMIT && foreign::comment_after(before).is_some();
        foreign::is_comment(self.source.slice(line).trim()) || is_after()
    }

    /// ELSE, ENDIF, WEND and REPEAT allow no other statement on their line.
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
                let name = lone_word(statement.kind.shape()).filter(|_| is_new(statement.span))?;
                let other = &statements[usize::from(index == 0)];
                Some(not_alone(name, statement.span, other.span))
            })
            .collect();
        self.diagnostics.extend(faults);
    }
}

/// ELSE, ENDIF, WEND or REPEAT on one line with something else.
pub(super) fn not_alone(name: Keyword, place: Span, other: Span) -> Diagnostic {
    let reason = Parsing::NotAlone { word: name.into() };
    Diagnostic::new(Code::Format, place, reason)
        .label(other, Parsing::WantsOwnLine)
        .help(Parsing::LabelBeforeCommentBehind)
}

fn lone_word(shape: Shape) -> Option<Keyword> {
    match shape {
        Shape::Else => Some(Keyword::Else),
        Shape::EndIf => Some(Keyword::EndIf),
        Shape::Wend => Some(Keyword::Wend),
        Shape::Repeat => Some(Keyword::Repeat),
        Shape::Plain
        | Shape::If
        | Shape::OneLineIf
        | Shape::ElseIf
        | Shape::While
        | Shape::Until
        | Shape::For
        | Shape::Next
        | Shape::Subroutine
        | Shape::SubEnd
        | Shape::Close => None,
    }
}

/// The text with half-width letters, digits and signs for full-width ones.
pub(crate) fn narrow(text: &str) -> String {
    text.chars()
        .map(|char| narrow_char(char).unwrap_or(char))
        .collect()
}

/// The same characters half-width, if they are full-width letters, digits or signs.
fn half_width(text: &str) -> Option<String> {
    text.chars().map(narrow_char).collect()
}

/// The half-width form of a full-width letter, digit or sign.
fn narrow_char(char: char) -> Option<char> {
    match char {
        '\u{FF01}'..='\u{FF5E}' => char::from_u32(char as u32 - 0xFEE0),
        _ => None,
    }
}
