//! Findings as the protocol has them.

use super::client::Client;
use super::places::Places;
use super::surroundings::Surroundings;
use gen_lsp_types::{
    Code as Id, CodeDescription, Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity,
    DiagnosticTag, Location, Uri,
};
use tip_lint::message::More;
use tipc::Loaded;
use tipc::code::{Code, Level};
use tipc::diagnostic;

/// Who found it.
const SOURCE: &str = "tip";

/// The findings about a text, and how many others are omitted.
pub(crate) fn findings(
    loaded: &Loaded,
    uri: &str,
    client: &Client,
    around: &mut impl Surroundings,
) -> Vec<Diagnostic> {
    let found = loaded.diagnostics.iter();
    let mut found: Vec<Diagnostic> = found
        .map(|one| finding(loaded, one, uri, client, around))
        .collect();
    let omitted = loaded.omitted.count();
    if let Some(last) = found.last().filter(|_| omitted > 0) {
        let more = Diagnostic {
            severity: Some(DiagnosticSeverity::Information),
            code: None,
            code_description: None,
            message: More::from(omitted).in_lang(client.lang).to_string().into(),
            tags: None,
            related_information: None,
            ..last.clone()
        };
        found.push(more);
    }
    found
}

/// One of them.
pub(crate) fn finding(
    loaded: &Loaded,
    one: &diagnostic::Diagnostic,
    uri: &str,
    client: &Client,
    around: &mut impl Surroundings,
) -> Diagnostic {
    let places = Places {
        source: &loaded.source,
        unit: client.unit,
    };
    let related = one.labels.iter().map(|label| DiagnosticRelatedInformation {
        location: Location {
            uri: Uri(uri.to_owned()),
            range: places.range(label.span),
        },
        message: label.text.in_lang(client.lang).to_string(),
    });
    let page = client
        .has_pages
        .then(|| around.page(one.id(), client.lang))
        .flatten();
    Diagnostic {
        range: places.range(one.span),
        severity: Some(match one.level() {
            Level::Error => DiagnosticSeverity::Error,
            _ => DiagnosticSeverity::Warning,
        }),
        code: Some(Id::String(one.id().to_owned())),
        code_description: page.map(|href| CodeDescription { href: Uri(href) }),
        source: Some(SOURCE.to_owned()),
        message: text(one, client).into(),
        tags: is_needless(one.code).then(|| vec![DiagnosticTag::Unnecessary]),
        related_information: client.has_related.then(|| related.collect()),
        data: None,
    }
}

/// The headline; of a warning with its reason; then the help on a line of its own.
fn text(one: &diagnostic::Diagnostic, client: &Client) -> String {
    let mut text = one.headline(client.lang);
    let mut add = |line: String| {
        text += "\n";
        text += &line;
    };
    if one.level() == Level::Warning {
        add(one.reason.in_lang(client.lang).to_string());
    }
    if let Some(help) = &one.help {
        add(help.in_lang(client.lang).to_string());
    }
    text
}

/// What could be left out of the program.
fn is_needless(code: Code) -> bool {
    matches!(code, Code::Unused | Code::Unreachable)
}
