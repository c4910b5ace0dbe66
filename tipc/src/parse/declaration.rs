//! `DEF_VAR NAME …`, `DEF_POS NAME …`, `DEF_JOINT NAME …` (T.I.P. 3.1 §4-4).
//!
//! [`recover::declaration`](super::recover::declaration) words the diagnostic of anything else.

use super::Parser;
use super::recover::declaration::hyphened;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::{Keyword, keywords};
use crate::lex::{Kind, Token};
use crate::message::{Naming, Parsing, Suggestion};
use crate::source::Span;
use crate::syntax::{StatementKind, VariableKind, Word};

impl Parser<'_> {
    /// Reads `DEF_… NAME NAME …` with the names as written, and reports tokens that are not words.
    ///
    /// Another declaration inside it, `DEF_VAR A, DEF_POS P`, is reported and read as a statement of its own.
    pub(super) fn define(
        &mut self,
        mut kind: VariableKind,
        mut keyword: Span,
        mut tokens: &[Token],
        mut reported: bool,
    ) -> StatementKind {
        while let Some(at) = self.declares_again(tokens) {
            let (first, rest) = tokens.split_at(at);
            let first = self.declaration(kind, keyword, first, reported);
            self.push(first, keyword);
            let second = rest[0].span;
            let fault = Diagnostic::new(Code::Argument, second, Parsing::OnlyNames);
            self.report(fault.help(Suggestion::NextStatement));
            kind = keywords::find(self.source.slice(second), self.module.edition)
                .and_then(declared_kind)
                .unwrap_or(kind);
            (keyword, tokens, reported) = (second, rest, true);
        }
        self.declaration(kind, keyword, tokens, reported)
    }

    /// Reads the names of one declaration.
    fn declaration(
        &mut self,
        kind: VariableKind,
        keyword: Span,
        tokens: &[Token],
        reported: bool,
    ) -> StatementKind {
        if tokens.len() < 2 {
            let missing = Diagnostic::new(Code::Argument, keyword, Naming::NoNames);
            self.report(missing.help(Naming::WriteNames));
        }
        let glued = hyphened(tokens);
        for location in &glued {
            self.report_hyphen(*location);
        }
        if glued.is_empty() && !reported {
            self.report_odd_token(kind, tokens);
        }
        let is_apart = |token: &&Token| {
            let before = glued.partition_point(|run| run.end <= token.span.start);
            let run = glued.get(before);
            run.is_none_or(|run| token.span.start < run.start)
        };
        let names: Vec<Word> = names_in(self.text, tokens, reported)
            .filter(is_apart)
            .flat_map(|token| self.names_between_commas(token.span))
            .map(|location| self.narrow_word(location))
            .collect();
        for name in &names {
            self.check_name_length(name);
        }
        StatementKind::Define {
            kind,
            keyword,
            names,
        }
    }

    /// Returns the index of another declaration inside of one: `DEF_VAR A, DEF_POS P`.
    fn declares_again(&self, tokens: &[Token]) -> Option<usize> {
        let declares = |token: &Token| {
            let word = self.source.slice(token.span);
            let keyword = keywords::find(word, self.module.edition);
            keyword.is_some_and(|keyword| declared_kind(keyword).is_some())
        };
        let again = tokens.iter().skip(1).position(declares)?;
        Some(again + 1)
    }
}

/// Returns the type of variables that a keyword declares.
pub(super) fn declared_kind(keyword: Keyword) -> Option<VariableKind> {
    match keyword {
        Keyword::DefVar => Some(VariableKind::Var),
        Keyword::DefPos => Some(VariableKind::Pos),
        Keyword::DefJoint => Some(VariableKind::Joint),
        _ => None,
    }
}

/// Returns the possible names: a value is not one, nor is a number in the declaration of another language.
fn names_in<'t>(text: &str, tokens: &'t [Token], foreign: bool) -> impl Iterator<Item = &'t Token> {
    let is_assignment = |token: &Token| matches!(token.kind, Kind::Assign(_));
    let no_digit = foreign || tokens.iter().any(is_assignment);
    let is_value = move |at: usize| {
        let first = text.as_bytes()[tokens[at].span.start];
        let starts_value = first.is_ascii_digit() || matches!(first, b'[' | b'(' | b'{');
        is_assignment(&tokens[at - 1]) || no_digit && starts_value
    };
    (1..tokens.len())
        .filter(move |at| tokens[*at].kind == Kind::Word && !is_value(*at))
        .map(|at| &tokens[at])
}
