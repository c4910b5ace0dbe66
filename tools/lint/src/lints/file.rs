//! Lints about a file as a whole: its title, its encoding, and what stands after END.

use crate::message::Foreign;
use crate::{Loaded, Options};
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::language::Keyword;
use tipc::language::commands::{self, Meaning};
use tipc::lex::{Kind, Token, lex};
use tipc::load::lowered;
use tipc::message::{Reading, Suggestion};
use tipc::parse;
use tipc::source::{Encoding, Source, Span, looks_like};
use tipc::syntax::Module;

/// Warns of the first statement after END.
pub(super) fn after_end(source: &Source, module: &Module) -> Option<Diagnostic> {
    let location = parse::after_end(source, module)?;
    let diagnostic = Diagnostic::new(Code::AfterEnd, location, Suggestion::StandsAfterEnd);
    let end = module.statements.last()?;
    Some(
        diagnostic
            .label(end.span, Suggestion::EndsTheText)
            .help(Foreign::MoveEndOrComment),
    )
}

/// Warns of a file that can be read, but not as what was written: in EUC-JP, say.
pub(super) fn other_encoding(
    loaded: &Loaded,
    bytes: &[u8],
    options: &Options,
) -> Option<Diagnostic> {
    if options.encoding != Encoding::Auto {
        return None;
    }
    let encoding = looks_like(bytes)?;
    let text = loaded.source.text();
    let at = text.find(|c: char| !c.is_ascii() || c == '\u{1B}')?;
    let length = text[at..].find(['\n', '\r']).unwrap_or(text.len() - at);
    let location = Span::new(at, at + length);
    let diagnostic = Diagnostic::new(Code::OtherEncoding, location, Reading::OtherCharacters);
    Some(diagnostic.help(Suggestion::OtherEncoding { encoding }))
}

/// Warns if line 2 is a statement that the program would load with, had it a title before.
pub(super) fn title(loaded: &Loaded, options: &Options) -> Option<Diagnostic> {
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
    let location = tokens.first()?.span.to(tokens.last()?.span);
    let diagnostic = Diagnostic::new(Code::StatementAsTitle, location, Suggestion::TitleHere);
    Some(diagnostic.help(Suggestion::Title))
}

/// Returns true if these words begin a statement, and no title of one word.
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
