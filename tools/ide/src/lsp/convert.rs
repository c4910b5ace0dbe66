//! Values of the protocol: diagnostics, semantic tokens, completion items, signatures and symbols from those of this crate.

use super::Workspace;
use super::client::{Client, Positions};
use crate::{
    CompletionKind, Outline, OutlineKind, SemanticToken, Signature, Signatures, TokenClass,
};
use gen_lsp_types::{
    ActiveParameter, Code as Id, CodeDescription, CompletionItem, CompletionItemKind,
    CompletionItemTextEdit, Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity,
    DiagnosticTag, DocumentSymbol, Documentation, InsertTextFormat, Location, ParameterInformation,
    ParameterInformationLabel, SignatureHelp, SignatureInformation, SymbolKind, TextEdit, Uri,
};
use tip_lint::message::More;
use tipc::Loaded;
use tipc::code::{Code, Level};
use tipc::diagnostic;
use tipc::message::Lang;

/// Converts the diagnostics of a text, with a last one that counts those that are omitted.
pub(crate) fn diagnostics(
    loaded: &Loaded,
    uri: &str,
    client: &Client,
    workspace: &mut impl Workspace,
) -> Vec<Diagnostic> {
    let all = loaded.diagnostics.iter();
    let mut all: Vec<Diagnostic> = all
        .map(|one| diagnostic(loaded, one, uri, client, workspace))
        .collect();
    let omitted = loaded.omitted.count();
    if let Some(last) = all.last().filter(|_| omitted > 0) {
        let more = Diagnostic {
            severity: Some(DiagnosticSeverity::Information),
            code: None,
            code_description: None,
            message: More::from(omitted).in_lang(client.lang).to_string().into(),
            tags: None,
            related_information: None,
            ..last.clone()
        };
        all.push(more);
    }
    all
}

/// Converts a diagnostic.
pub(crate) fn diagnostic(
    loaded: &Loaded,
    one: &diagnostic::Diagnostic,
    uri: &str,
    client: &Client,
    workspace: &mut impl Workspace,
) -> Diagnostic {
    let positions = Positions {
        source: &loaded.source,
        unit: client.unit,
    };
    let related = one.labels.iter().map(|label| DiagnosticRelatedInformation {
        location: Location {
            uri: Uri(uri.to_owned()),
            range: positions.range(label.span),
        },
        message: label.text.in_lang(client.lang).to_string(),
    });
    let page = client
        .has_pages
        .then(|| workspace.page(one.id(), client.lang))
        .flatten();
    let is_unnecessary = matches!(one.code, Code::Unused | Code::Unreachable);
    Diagnostic {
        range: positions.range(one.span),
        severity: Some(match one.level() {
            Level::Error => DiagnosticSeverity::Error,
            _ => DiagnosticSeverity::Warning,
        }),
        code: Some(Id::String(one.id().to_owned())),
        code_description: page.map(|href| CodeDescription { href: Uri(href) }),
        source: Some("tip".to_owned()),
        message: diagnostic_text(one, client).into(),
        tags: is_unnecessary.then(|| vec![DiagnosticTag::Unnecessary]),
        related_information: client.has_related.then(|| related.collect()),
        data: None,
    }
}

/// Returns the headline, for a warning also the reason, and the help, one line each.
fn diagnostic_text(one: &diagnostic::Diagnostic, client: &Client) -> String {
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

/// Returns the names of the token classes, in the order of their numbers.
pub(crate) fn token_types() -> Vec<&'static str> {
    TokenClass::ALL.map(token_type).to_vec()
}

/// The names of the token modifiers, in the order of their bits.
pub(crate) const TOKEN_MODIFIERS: [&str; 2] = ["declaration", "modification"];

const fn token_type(class: TokenClass) -> &'static str {
    match class {
        TokenClass::Keyword => "keyword",
        TokenClass::Command => "function",
        TokenClass::Function => "method",
        TokenClass::Flag => "event",
        TokenClass::Constant => "enumMember",
        TokenClass::Modifier => "modifier",
        TokenClass::Variable => "variable",
        TokenClass::Member => "property",
        TokenClass::Label => "label",
        TokenClass::Number => "number",
        TokenClass::Text => "string",
        TokenClass::Comment => "comment",
        TokenClass::Operator => "operator",
    }
}

/// Encodes semantic tokens, each relative to the one before.
pub(crate) fn semantic_tokens(
    tokens: &[SemanticToken],
    positions: Positions,
) -> Vec<gen_lsp_types::SemanticToken> {
    let mut line = 0;
    let mut start = 0;
    let tokens = tokens.iter().map(|token| {
        let range = positions.range(token.span);
        let delta_line = range.start.line - line;
        let before = if delta_line == 0 { start } else { 0 };
        (line, start) = (range.start.line, range.start.character);
        gen_lsp_types::SemanticToken {
            delta_line,
            delta_start: start - before,
            length: range.end.character - range.start.character,
            token_type: token.class as u32,
            token_modifiers_bitset: u32::from(token.declares) | u32::from(token.assigns) << 1,
        }
    });
    tokens.collect()
}

/// Converts a completion item.
pub(crate) fn completion_item(
    item: crate::CompletionItem,
    positions: Positions,
    client: &Client,
) -> CompletionItem {
    let snippet = item.snippet.filter(|_| client.has_snippets);
    let format = match snippet {
        Some(_) => InsertTextFormat::Snippet,
        None => InsertTextFormat::PlainText,
    };
    let edit = TextEdit {
        range: positions.range(item.span),
        new_text: snippet.unwrap_or(item.text),
    };
    let non_empty = |text: String| Some(text).filter(|text| !text.is_empty());
    CompletionItem {
        label: item.label,
        kind: Some(completion_kind(item.kind)),
        detail: non_empty(item.detail),
        documentation: non_empty(item.description.in_lang(client.lang).to_owned())
            .map(Documentation::String),
        insert_text_format: Some(format),
        text_edit: Some(CompletionItemTextEdit::TextEdit(edit)),
        ..CompletionItem::default()
    }
}

fn completion_kind(kind: CompletionKind) -> CompletionItemKind {
    match kind {
        CompletionKind::Keyword => CompletionItemKind::Keyword,
        CompletionKind::Command => CompletionItemKind::Function,
        CompletionKind::Function => CompletionItemKind::Method,
        CompletionKind::Flag => CompletionItemKind::Event,
        CompletionKind::Target => CompletionItemKind::EnumMember,
        CompletionKind::MotionFlag => CompletionItemKind::Operator,
        CompletionKind::Constant => CompletionItemKind::Constant,
        CompletionKind::Variable => CompletionItemKind::Variable,
        CompletionKind::Member => CompletionItemKind::Field,
        CompletionKind::Label => CompletionItemKind::Reference,
    }
}

/// Converts the forms of a command, with the argument at the cursor.
pub(crate) fn signatures(found: Signatures, lang: Lang) -> SignatureHelp {
    let description = found.description.in_lang(lang);
    let forms = found.forms.into_iter().map(|form| SignatureInformation {
        documentation: Some(Documentation::String(description.to_owned())),
        parameters: Some(parameters(&form)),
        label: form.text,
        active_parameter: None,
    });
    SignatureHelp {
        signatures: forms.collect(),
        active_signature: Some(found.form as u32),
        active_parameter: Some(ActiveParameter::Int(found.argument as u32)),
    }
}

/// Converts the spans of arguments. The protocol counts UTF-16 code units here, whichever encoding was agreed.
fn parameters(form: &Signature) -> Vec<ParameterInformation> {
    let units = |end: usize| form.text[..end].encode_utf16().count() as u32;
    let arguments = form.arguments.iter();
    let parameters = arguments.map(|span| ParameterInformation {
        label: ParameterInformationLabel::Tuple((units(span.start), units(span.end))),
        documentation: None,
    });
    parameters.collect()
}

/// Converts a symbol of the outline with its children.
#[allow(deprecated, reason = "the type has no other constructor")]
pub(crate) fn symbol(one: &Outline, positions: Positions) -> DocumentSymbol {
    let children = one.children.iter();
    let children: Vec<DocumentSymbol> = children.map(|child| symbol(child, positions)).collect();
    DocumentSymbol {
        name: one.name.clone(),
        detail: None,
        kind: match one.kind {
            OutlineKind::Variable(_) => SymbolKind::Variable,
            OutlineKind::Label => SymbolKind::Key,
            OutlineKind::Subroutine | OutlineKind::Thread => SymbolKind::Function,
            OutlineKind::Constant => SymbolKind::Constant,
        },
        tags: None,
        deprecated: None,
        range: positions.range(one.span),
        selection_range: positions.range(one.name_span),
        children: Some(children),
    }
}
