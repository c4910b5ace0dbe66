//! Line 2, where the title was forgotten: what is missing stands there.

use crate::diagnostic::Diagnostic;
use crate::language::keywords::{self, Keyword};
use crate::lex::{Kind, Token, lex};
use crate::message::Suggestion;
use crate::source::{Source, Span};
use crate::syntax::{Module, upper_case};
use smol_str::SmolStr;

/// The statement that the title would be.
#[derive(Debug, Default)]
pub(super) struct Title {
    /// Its first word.
    first: Option<Span>,
    keyword: Option<Keyword>,
    label: Option<SmolStr>,
    names: Vec<(SmolStr, Span)>,
}

impl Title {
    /// Reads the title as a statement. One that holds what no statement may hold is none.
    pub(super) fn of(source: &Source, module: &Module) -> Self {
        let mut tokens = Vec::new();
        if module.title.is_empty() || lex(source.text(), source.line(2).span, &mut tokens).is_some()
        {
            return Title::default();
        }
        let word = |token: &Token| upper_case(source.slice(token.span));
        let keyword = tokens.first().map(word);
        let keyword = keyword.and_then(|word| keywords::find(&word, module.edition));
        let declares = matches!(
            keyword,
            Some(Keyword::DefVar | Keyword::DefPos | Keyword::DefJoint)
        );
        let names = tokens.iter().skip(1).filter(|it| it.kind == Kind::Word);
        Title {
            first: tokens.first().map(|first| first.span),
            keyword,
            label: match tokens.as_slice() {
                [name, colon, ..] if colon.kind == Kind::Colon => Some(word(name)),
                _ => None,
            },
            names: match declares {
                true => names.map(|name| (word(name), name.span)).collect(),
                false => Vec::new(),
            },
        }
    }

    /// Blames the title for a name that is not declared, if it would declare it.
    pub(super) fn declares(&self, name: &str, fault: Diagnostic) -> Diagnostic {
        let declared = self.names.iter().find(|(one, _)| one == name);
        blame(fault, declared.map(|(_, location)| *location))
    }

    /// Blames the title for a missing label, if it would be that label.
    pub(super) fn labels(&self, name: &str, fault: Diagnostic) -> Diagnostic {
        blame(
            fault,
            self.first.filter(|_| self.label.as_deref() == Some(name)),
        )
    }

    /// Blames the title for a block that nothing opens, if it would open it.
    pub(super) fn opens(&self, opener: Keyword, fault: Diagnostic) -> Diagnostic {
        blame(fault, self.first.filter(|_| self.keyword == Some(opener)))
    }
}

/// Says of a fault that it follows from a title that was forgotten. All such faults are one mistake.
fn blame(fault: Diagnostic, location: Option<Span>) -> Diagnostic {
    match location {
        Some(location) => fault
            .once("title")
            .label(location, Suggestion::TitleHere)
            .help(Suggestion::Title),
        None => fault,
    }
}
