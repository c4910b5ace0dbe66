//! `DEF_VAR`, `DEF_POS`, `DEF_JOINT`: the names, and what else people put there (T.I.P. 3.1 §4-4).

use super::reader::{Fault, Reader};
use super::{Parser, narrow};
use crate::code::Code;
use crate::diagnostic::{Diagnostic, MistakeId};
use crate::language::{Keyword, keywords};
use crate::lex::{Kind, Token, foreign_run};
use crate::message::{Naming, Parsing, Suggestion};
use crate::source::Span;
use crate::syntax::{Arithmetic, StatementKind, VariableKind, Word};

/// The commas of full-width text.
const COMMAS: [char; 2] = ['，', '、'];

/// The most names with a `-` whose uses are not reported again.
const HYPHENED: usize = 8;

impl Parser<'_> {
    /// `DEF_… NAME NAME …`: the names as written; what is not a word is reported.
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
        let reader = Reader::new(self.text, tokens, 0, Code::Argument, self.module.edition);
        let glued = hyphened(tokens);
        for location in &glued {
            self.report_hyphen(*location);
        }
        let is_odd = |token: &Token| token.kind != Kind::Word;
        if glued.is_empty()
            && !reported
            && let Some(odd) = tokens.iter().position(is_odd)
        {
            let fault = odd_in_declaration(&reader, kind, tokens, odd);
            if let Some(fault) = fault {
                self.report(*fault.diagnostic);
            }
        }
        let is_apart = |token: &&Token| {
            let location = token.span;
            let inside = |run: &Span| run.start <= location.start && location.end <= run.end;
            !glued.iter().any(inside)
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

    /// Finds another declaration inside one: `DEF_VAR A, DEF_POS P`.
    fn declares_again(&self, tokens: &[Token]) -> Option<usize> {
        let declares = |token: &Token| {
            let word = self.source.slice(token.span);
            let keyword = keywords::find(word, self.module.edition);
            keyword.is_some_and(|keyword| declared_kind(keyword).is_some())
        };
        let again = tokens.iter().skip(1).position(declares)?;
        Some(again + 1)
    }

    /// Returns the names of a word, which full-width commas may separate: those are reported.
    fn names_between_commas(&self, word: Span) -> Vec<Span> {
        let text = self.source.slice(word);
        if text.bytes().all(|it| it.is_ascii_graphic()) {
            return vec![word];
        }
        let mut start = word.start;
        let names = text.split_inclusive(COMMAS).map(|name| {
            let location = Span::new(start, start + name.trim_end_matches(COMMAS).len());
            start += name.len();
            location
        });
        let is_plain = |location: &Span| {
            let name = || narrow(self.source.slice(*location));
            location.start < location.end
                && foreign_run(&name(), Span::new(0, name().len())).is_none()
        };
        names.filter(is_plain).collect()
    }

    fn report_hyphen(&mut self, location: Span) {
        let written = self.source.slice(location).to_ascii_uppercase();
        let reason = Naming::NoVariableName {
            word: written.as_str().into(),
        };
        let help = Suggestion::NoHyphen {
            name: written.replace('-', "_").into(),
        };
        let fault = Diagnostic::new(Code::Argument, location, reason);
        self.report(
            fault
                .once(MistakeId::Word(written.as_str().into()))
                .help(help),
        );
        if self.hyphened.len() < HYPHENED {
            self.hyphened.push(written);
        }
    }

    /// Returns true if the statement contains a name with a `-`, whose declaration is reported.
    pub(super) fn names_hyphened(&self, tokens: &[Token]) -> bool {
        let (false, [first, .., last]) = (self.hyphened.is_empty(), tokens) else {
            return false;
        };
        let text = self.source.slice(first.span.to(last.span));
        let text = text.to_ascii_uppercase();
        self.hyphened
            .iter()
            .any(|name| text.contains(name.as_str()))
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

/// Returns the names with a `-`: `STEP-LENGTH`.
fn hyphened(tokens: &[Token]) -> Vec<Span> {
    let runs = tokens.chunk_by(|_, next| !next.spaced);
    runs.filter_map(|run| {
        let [first, .., last] = run else { return None };
        let is_part =
            |token: &Token| matches!(token.kind, Kind::Word | Kind::Arithmetic(Arithmetic::Sub));
        let is_name =
            run.iter().all(is_part) && first.kind == Kind::Word && last.kind == Kind::Word;
        is_name.then(|| first.span.to(last.span))
    })
    .collect()
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

/// Reports the token at `odd`, which is not a name.
fn odd_in_declaration(
    reader: &Reader<'_>,
    kind: VariableKind,
    tokens: &[Token],
    odd: usize,
) -> Option<Fault> {
    let location = tokens.get(odd)?;
    let named = tokens[..odd].last().filter(|_| odd > 1);
    Some(match (location.kind, named) {
        (Kind::Assign(_), Some(name)) => {
            let name = reader.word(name.span).node;
            let name = match kind {
                VariableKind::Var => name,
                VariableKind::Pos => format!("{name}.X").into(),
                VariableKind::Joint => format!("{name}.J1").into(),
            };
            reader.fault_with_help(
                location.span,
                Suggestion::NoInitial,
                Suggestion::Initial { name },
            )
        }
        _ => reader.fault_with_help(location.span, Parsing::OnlyNames, Parsing::SeparateNames),
    })
}
