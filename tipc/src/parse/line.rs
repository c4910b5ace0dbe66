//! One line: labels and statements, separated by `;`, and a comment (T.I.P. 3.1 §4-2).
//!
//! ```text
//! line = {NAME ":"} [statement] {";" {NAME ":"} [statement]} ["//" comment]
//! ```

use super::recover::statement::not_alone;
use super::statement::lone_word;
use super::{Flow, Parser};
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Handle};
use crate::language::names;
use crate::lex::{Piece, Pieces, split_comment};
use crate::message::{Parsing, Suggestion};
use crate::source::Span;
use crate::syntax::{StatementKind, Word, upper_case};

impl Parser<'_> {
    /// Reads the statements of the current line.
    pub(super) fn statements_of_line(&mut self) -> Flow {
        let (code, comment) = split_comment(self.text, self.line.span);
        let first = self.module.statements.len();
        let reported = self.diagnostics.mark();
        let mut flow = Flow::Continue;
        for piece in Pieces::new(self.text, code, false).in_edition(self.module.edition) {
            match piece {
                Piece::Label { name, span } => flow = self.label(name, span),
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

    /// Reads `NAME:`.
    fn label(&mut self, word: Span, span: Span) -> Flow {
        if let Some(flow) = self.no_label(word, span) {
            return flow;
        }
        let name = Word {
            node: upper_case(self.source.slice(word)),
            span: word,
        };
        self.check_name_length(&name);
        self.push(StatementKind::Label(name), span);
        Flow::Continue
    }

    /// Checks that a declared name is not too long.
    pub(super) fn check_name_length(&mut self, name: &Word) {
        if name.node.len() > names::LIMIT {
            let reason = Parsing::NameTooLong {
                limit: names::LIMIT,
                length: name.node.len(),
            };
            let fault = Diagnostic::new(Code::Format, name.span, reason);
            self.report(fault.help(Suggestion::ShorterName));
        }
    }

    /// Checks that ELSE, ENDIF, WEND and REPEAT are alone on their line.
    ///
    /// The line's statements start at `first`, its diagnostics at `reported`.
    fn check_lone_words(&mut self, first: usize, reported: Handle) {
        let statements = &self.module.statements[first..];
        let labels = statements
            .iter()
            .take_while(|statement| matches!(statement.kind, StatementKind::Label(_)))
            .count();
        let statements = &statements[labels..];
        if statements.len() < 2 {
            return;
        }
        let mut known: Vec<usize> = self
            .diagnostics
            .since(reported)
            .iter()
            .map(|diagnostic| diagnostic.span.start)
            .collect();
        known.sort_unstable();
        let is_new = |span: Span| known.binary_search(&span.start).is_err();
        let faults: Vec<Diagnostic> = statements
            .iter()
            .enumerate()
            .filter_map(|(index, statement)| {
                let name = statement.kind.shape().keyword()?;
                if lone_word(name).is_none() || !is_new(statement.span) {
                    return None;
                }
                let other = &statements[usize::from(index == 0)];
                Some(not_alone(name, statement.span, other.span))
            })
            .collect();
        self.diagnostics.extend(faults);
    }
}
