//! Line 2, where the title was forgotten: what is missing stands there.

use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::keywords::{self, Keyword};
use crate::lex::{Kind, Token, lex};
use crate::message::{ForeignWord, Message, Structuring};
use crate::source::{Source, Span};
use crate::syntax::{Module, upper_case};
use std::collections::HashMap;

/// Returns the words of the title; none if it holds what no statement may hold.
fn tokens(source: &Source, module: &Module) -> Vec<Token> {
    let mut tokens = Vec::new();
    match module.title.is_empty() {
        false if lex(source.text(), source.line(2).span, &mut tokens).is_none() => tokens,
        _ => Vec::new(),
    }
}

/// Lets a missing label, opener or END be what it is, if line 2 holds it.
pub(super) fn blame(source: &Source, module: &Module, found: &mut [Diagnostic]) {
    let tokens = tokens(source, module);
    let [first, ..] = tokens.as_slice() else {
        return;
    };
    let word = upper_case(source.slice(first.span));
    let is_label = tokens.get(1).is_some_and(|next| next.kind == Kind::Colon);
    let keyword = keywords::find(&word, module.edition);
    for diagnostic in found {
        let is_missing = match (&diagnostic.reason, diagnostic.code) {
            (_, Code::UnknownLabel) => is_label && diagnostic.subject.as_deref() == Some(&*word),
            (_, Code::NoEnd) => keyword == Some(Keyword::End) && tokens.len() == 1,
            (Message::Structuring(Structuring::NothingOpen { opener, .. }), _) => {
                keyword == Some(*opener)
            }
            _ => false,
        };
        if is_missing {
            let blamed = diagnostic.clone().label(first.span, ForeignWord::TitleHere);
            *diagnostic = blamed.help(ForeignWord::Title);
        }
    }
}

/// Returns the names that line 2 would declare, if it were not the title.
pub(super) fn declared(source: &Source, module: &Module) -> HashMap<String, Span> {
    let tokens = tokens(source, module);
    let word = |span: Span| upper_case(source.slice(span));
    let declares = |keyword: Keyword| {
        matches!(
            keyword,
            Keyword::DefVar | Keyword::DefPos | Keyword::DefJoint
        )
    };
    let first = tokens
        .first()
        .and_then(|token| keywords::find(&word(token.span), module.edition));
    match first.is_some_and(declares) {
        true => tokens[1..]
            .iter()
            .filter(|token| token.kind == Kind::Word)
            .map(|token| (word(token.span).to_string(), token.span))
            .collect(),
        false => HashMap::new(),
    }
}
