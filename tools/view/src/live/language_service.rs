//! Language features of the page's editor: diagnostics, hovers and completions.

use serde::Serialize;
use tip_ide::Document;
use tipc::Loaded;
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;
use tipc::source::{Position, Source, Span, Unit};

/// Maximum number of completions in one answer.
const MAX_COMPLETIONS: usize = 2000;

/// A line and a column from 1, the column in units of UTF-16.
pub(super) type Place = [u32; 2];

/// An answer about the text, under the name of the question.
#[derive(Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum LanguageAnswer {
    /// Documentation of a word, if there is one.
    Hover(Option<Hover>),
    /// Completions.
    Offers(Vec<CompletionItem>),
}

#[derive(Debug, Serialize)]
pub(super) struct Hover {
    from: Place,
    to: Place,
    /// Markdown, in English and Japanese.
    text: [String; 2],
}

#[derive(Debug, Serialize)]
pub(super) struct CompletionItem {
    label: String,
    detail: String,
    /// Description in English and Japanese.
    description: [&'static str; 2],
    /// Start of the text that is replaced.
    from: Place,
    to: Place,
    /// Replacement, as a snippet of the Language Server Protocol if it has places to fill.
    text: String,
    fills: bool,
}

/// Returns the documentation of the word at a place.
pub(super) fn hover(document: &Document, place: Place) -> LanguageAnswer {
    let at = offset(document.source(), place);
    let [english, japanese] = [Lang::English, Lang::Japanese].map(|lang| document.hover(at, lang));
    LanguageAnswer::Hover(english.zip(japanese).map(|(english, japanese)| {
        let [from, to] = ends(document.source(), english.span);
        Hover {
            from,
            to,
            text: [english.text, japanese.text],
        }
    }))
}

/// Returns the completions at a place.
pub(super) fn completions(document: &Document, place: Place) -> LanguageAnswer {
    let source = document.source();
    let completions = document.complete(offset(source, place)).into_iter();
    let shown = completions.take(MAX_COMPLETIONS).map(|offer| {
        let [from, to] = ends(source, offer.span);
        CompletionItem {
            label: offer.label,
            detail: offer.detail,
            description: [offer.description.english, offer.description.japanese],
            from,
            to,
            fills: offer.snippet.is_some(),
            text: offer.snippet.unwrap_or(offer.text),
        }
    });
    LanguageAnswer::Offers(shown.collect())
}

fn offset(source: &Source, [line, column]: Place) -> usize {
    source.offset(Position { line, column }, Unit::Utf16)
}

fn ends(source: &Source, span: Span) -> [Place; 2] {
    [span.start, span.end].map(|offset| {
        let Position { line, column } = source.position(offset, Unit::Utf16);
        [line, column]
    })
}

/// Maximum number of diagnostics.
const MAX_DIAGNOSTICS: usize = 200;

/// One diagnostic. Places are lines and columns from 1, columns in units of UTF-16. Texts are in English and Japanese.
#[derive(Clone, Debug, Serialize)]
pub(super) struct PageDiagnostic {
    level: &'static str,
    code: &'static str,
    from: Place,
    to: Place,
    text: [String; 2],
    help: Option<[String; 2]>,
    classical: String,
}

/// Returns all diagnostics of a program, but for the last of very many.
pub(super) fn findings(loaded: &Loaded) -> Vec<PageDiagnostic> {
    let found = loaded.diagnostics.iter().take(MAX_DIAGNOSTICS);
    found
        .map(|one| PageDiagnostic::of(one, &loaded.source))
        .collect()
}

impl PageDiagnostic {
    fn of(diagnostic: &Diagnostic, source: &Source) -> Self {
        let [from, to] = ends(source, diagnostic.span);
        let both = |text: &dyn Fn(Lang) -> String| [Lang::English, Lang::Japanese].map(text);
        PageDiagnostic {
            level: diagnostic.level().name(),
            code: diagnostic.id(),
            from,
            to,
            text: both(&|lang| diagnostic.headline(lang)),
            help: diagnostic
                .help
                .as_ref()
                .map(|help| both(&|lang| help.in_lang(lang).to_string())),
            classical: diagnostic.message(),
        }
    }
}
