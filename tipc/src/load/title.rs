//! A statement where the title belongs.

use super::{Loaded, Options, lowered};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::Keyword;
use crate::language::commands::{self, Meaning};
use crate::lex::{Kind, Token, lex};
use crate::message::Habit;
use crate::source::Encoding;

/// Warns if line 2 is a statement that the program would load with, had it a title before.
pub(super) fn warn(loaded: &Loaded, options: &Options) -> Option<Diagnostic> {
    let source = &loaded.source;
    let line = source.line(2).span;
    let mut tokens = Vec::new();
    if lex(source.text(), line, &mut tokens).is_some() || !is_statement(loaded, &tokens) {
        return None;
    }
    let (before, after) = source.text().split_at(line.start);
    let text = format!("{before}A title\n{after}");
    let options = Options {
        encoding: Encoding::Utf8,
        ..*options
    };
    let (titled, found) = lowered(source.name(), text.as_bytes(), &options);
    if found.have_error(titled.module.edition) {
        return None;
    }
    let place = tokens.first()?.span.to(tokens.last()?.span);
    let finding = Diagnostic::new(Code::StatementAsTitle, place, Habit::TitleHere);
    Some(finding.help(Habit::Title))
}

/// Whether these words begin as a statement, and no title of one word.
fn is_statement(loaded: &Loaded, tokens: &[Token]) -> bool {
    let Some(first) = tokens.first() else {
        return false;
    };
    let word = loaded.source.slice(first.span);
    if matches!(tokens.get(1), Some(next) if matches!(next.kind, Kind::Assign(_))) {
        return true;
    }
    // Anything may follow these.
    let is_text = |meaning| {
        let words = [Keyword::Rem, Keyword::Message, Keyword::End];
        words.map(Meaning::Keyword).contains(&meaning)
    };
    let command = commands::find(word).filter(|command| !is_text(command.meaning));
    command.is_some() && (tokens.len() > 1 || word.contains('_'))
}
