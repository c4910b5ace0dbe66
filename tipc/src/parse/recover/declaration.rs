//! Diagnostics of names and signs in declarations that the language lacks.

use super::characters::narrow;
use crate::code::Code;
use crate::diagnostic::{Diagnostic, MistakeId};
use crate::lex::{Kind, Token, foreign_run};
use crate::message::{Message, Naming, Parsing, Suggestion};
use crate::parse::Parser;
use crate::source::Span;
use crate::syntax::{Arithmetic, VariableKind, upper_case};

impl Parser<'_> {
    /// Reports the first token of a declaration that is no name: `DEF_VAR A = 1`.
    pub(in crate::parse) fn report_odd_token(&mut self, kind: VariableKind, tokens: &[Token]) {
        let Some(at) = tokens.iter().position(|it| it.kind != Kind::Word) else {
            return;
        };
        let (before, odd) = (&tokens[..at], tokens[at]);
        let named = before.last().filter(|_| at > 1);
        let fault = |reason: Message| Diagnostic::new(Code::Argument, odd.span, reason);
        self.report(match (odd.kind, named) {
            (Kind::Assign(_), Some(name)) => {
                let name = upper_case(self.source.slice(name.span));
                let name = match kind {
                    VariableKind::Var => name,
                    VariableKind::Pos => format!("{name}.X").into(),
                    VariableKind::Joint => format!("{name}.J1").into(),
                };
                fault(Suggestion::NoInitial.into()).help(Suggestion::Initial { name })
            }
            _ => fault(Parsing::OnlyNames.into()).help(Parsing::SeparateNames),
        });
    }

    /// Returns the names of a word, which full-width commas may separate: those are reported.
    pub(in crate::parse) fn names_between_commas(&self, word: Span) -> Vec<Span> {
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

    pub(in crate::parse) fn report_hyphen(&mut self, location: Span) {
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
    pub(in crate::parse) fn names_hyphened(&self, tokens: &[Token]) -> bool {
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

/// The commas of full-width text.
const COMMAS: [char; 2] = ['，', '、'];

/// Maximum number of names with a `-` whose uses are not reported again.
const HYPHENED: usize = 8;

/// Returns the names with a `-`: `STEP-LENGTH`.
pub(in crate::parse) fn hyphened(tokens: &[Token]) -> Vec<Span> {
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
