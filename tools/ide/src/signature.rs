//! Signature help: the forms of a command or function, and the argument under the cursor.

use crate::Document;
use crate::hover::usage;
use crate::word::{Word, WordKind};
use tipc::language::Bilingual;
use tipc::language::commands::{self, Command, Form};
use tipc::lex::{self, Piece, Pieces, split_comment};
use tipc::source::{Span, Unit};

/// A form of a command or function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// The form, as `PTP [HS] F1 [R] x [R] y [R] z`.
    pub text: String,
    /// The spans of its arguments in that text. An optional one is part of the argument that follows it.
    pub arguments: Vec<Span>,
}

/// The forms of the command or function under the cursor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signatures {
    /// Its forms.
    pub forms: Vec<Signature>,
    /// Its description, in one line.
    pub description: Bilingual,
    /// The index of the form that has the current argument.
    pub form: usize,
    /// The index of the current argument.
    pub argument: usize,
}

impl Document {
    /// Returns the forms of the command or function whose arguments are at a byte of the text.
    pub fn signatures(&self, offset: usize) -> Option<Signatures> {
        let text = self.loaded.source.text();
        let number = self.loaded.source.position(offset, Unit::Utf8).line;
        let line = self.loaded.source.line(number);
        let offset = line.span.start.max(offset.min(line.span.end));
        let before = Span::new(line.span.start, offset);
        let is_text = number < 3 || !text.is_char_boundary(offset);
        if is_text || split_comment(text, before).1.is_some() {
            return None;
        }
        if let Some(found) = self.function_signatures(line, offset) {
            return Some(found);
        }
        let edition = self.edition();
        let Some(Piece::Statement { word, span, .. }) =
            Pieces::new(text, before, false).in_edition(edition).last()
        else {
            return None;
        };
        let is_over = self.slice(Span::new(span.end, offset)).contains(';') || offset <= word.end;
        let command = commands::find_in(self.slice(word), edition).filter(|_| !is_over)?;
        let mut tokens = Vec::new();
        lex::lex(text, span, &mut tokens);
        tokens.retain(|token| token.span.end < offset && token.span.start > word.start);
        let argument = match command.form_in(edition) {
            Form::Words(_) => 0,
            _ => self.argument_count(command, &tokens),
        };
        Some(forms(command, self, argument))
    }

    /// Returns the forms of the function before an offset on the right side of an equation.
    fn function_signatures(&self, line: tipc::source::Line, offset: usize) -> Option<Signatures> {
        let words = self.words(line);
        let before: Vec<&Word> = words
            .iter()
            .take_while(|word| word.span.end < offset)
            .collect();
        let last = before
            .iter()
            .rposition(|word| matches!(word.kind, WordKind::Function(_)))?;
        let WordKind::Function(row) = before[last].kind else {
            return None;
        };
        let after = &before[last + 1..];
        let is_over = self
            .slice(Span::new(before[last].span.end, offset))
            .contains(';');
        if is_over
            || after
                .iter()
                .any(|word| matches!(word.kind, WordKind::Command(_) | WordKind::Keyword(_)))
        {
            return None;
        }
        let is_operand =
            |word: &&&Word| !matches!(word.kind, WordKind::Operator | WordKind::Member(_));
        Some(Signatures {
            forms: vec![signature(usage(row))],
            description: row.description,
            form: 0,
            argument: after.iter().filter(is_operand).count(),
        })
    }
}

fn forms(command: &Command, document: &Document, argument: usize) -> Signatures {
    let edition = document.edition();
    let usage = command.usage(document.robot(), edition);
    let forms: Vec<Signature> = match command.form_in(edition) {
        Form::Words(_) => usage.into_iter().map(statement_signature).collect(),
        _ => usage.into_iter().map(signature).collect(),
    };
    let form = forms
        .iter()
        .position(|form| form.arguments.len() > argument);
    Signatures {
        form: form.unwrap_or(0),
        forms,
        description: command.description,
        argument,
    }
}

/// Returns a form whose arguments are its words.
fn signature(text: String) -> Signature {
    let mut arguments = Vec::new();
    let mut at = 0;
    let mut optional = None;
    for (index, word) in text.split(' ').enumerate() {
        let start = at;
        at += word.len() + 1;
        match (index, word.starts_with('[')) {
            (0, _) => {}
            (_, true) => optional = optional.or(Some(start)),
            (_, false) => {
                let start = optional.take().unwrap_or(start);
                arguments.push(Span::new(start, at - 1));
            }
        }
    }
    if let Some(start) = optional {
        arguments.push(Span::new(start, text.len()));
    }
    Signature { text, arguments }
}

/// Returns a form of a statement: all words after the first are one argument.
fn statement_signature(text: String) -> Signature {
    let rest = text.find(' ').map(|at| Span::new(at + 1, text.len()));
    Signature {
        arguments: rest.into_iter().collect(),
        text,
    }
}
