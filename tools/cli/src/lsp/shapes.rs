//! Answers of several parts in the shapes of the protocol.

use super::client::Client;
use super::places::Places;
use gen_lsp_types::{
    ActiveParameter, CompletionItem, CompletionItemKind, CompletionItemTextEdit, DocumentSymbol,
    Documentation, InsertTextFormat, ParameterInformation, ParameterInformationLabel,
    SignatureHelp, SignatureInformation, SymbolKind, TextEdit,
};
use tip_ide::{Offer, OfferKind, Outline, OutlineKind, Signature, Signatures};
use tipc::message::Lang;

/// What can be written.
pub(crate) fn item(offer: Offer, places: Places, client: &Client) -> CompletionItem {
    let template = offer.template.filter(|_| client.has_snippets);
    let format = match template {
        Some(_) => InsertTextFormat::Snippet,
        None => InsertTextFormat::PlainText,
    };
    let edit = TextEdit {
        range: places.range(offer.span),
        new_text: template.unwrap_or(offer.text),
    };
    let said = |text: String| Some(text).filter(|text| !text.is_empty());
    CompletionItem {
        label: offer.label,
        kind: Some(kind(offer.kind)),
        detail: said(offer.detail),
        documentation: said(offer.description.in_lang(client.lang).to_owned())
            .map(Documentation::String),
        insert_text_format: Some(format),
        text_edit: Some(CompletionItemTextEdit::TextEdit(edit)),
        ..CompletionItem::default()
    }
}

fn kind(kind: OfferKind) -> CompletionItemKind {
    match kind {
        OfferKind::Keyword => CompletionItemKind::Keyword,
        OfferKind::Command => CompletionItemKind::Function,
        OfferKind::Function => CompletionItemKind::Method,
        OfferKind::Flag => CompletionItemKind::Event,
        OfferKind::Target => CompletionItemKind::EnumMember,
        OfferKind::MotionFlag => CompletionItemKind::Operator,
        OfferKind::Constant => CompletionItemKind::Constant,
        OfferKind::Variable => CompletionItemKind::Variable,
        OfferKind::Member => CompletionItemKind::Field,
        OfferKind::Label => CompletionItemKind::Reference,
    }
}

/// The forms of a command, and where in them the cursor is.
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

/// Where the arguments are, in units of UTF-16 whatever the client's columns count.
fn parameters(form: &Signature) -> Vec<ParameterInformation> {
    let units = |end: usize| form.text[..end].encode_utf16().count() as u32;
    let arguments = form.arguments.iter();
    let parameters = arguments.map(|span| ParameterInformation {
        label: ParameterInformationLabel::Tuple((units(span.start), units(span.end))),
        documentation: None,
    });
    parameters.collect()
}

/// Something that is declared, with what is declared inside it.
#[allow(deprecated, reason = "the type has no other constructor")]
pub(crate) fn symbol(one: &Outline, places: Places) -> DocumentSymbol {
    let children = one.children.iter();
    let children: Vec<DocumentSymbol> = children.map(|child| symbol(child, places)).collect();
    DocumentSymbol {
        name: one.name.clone(),
        detail: None,
        kind: match one.kind {
            OutlineKind::Variable(_) => SymbolKind::Variable,
            OutlineKind::Label => SymbolKind::Key,
            OutlineKind::Subroutine => SymbolKind::Function,
        },
        tags: None,
        deprecated: None,
        range: places.range(one.span),
        selection_range: places.range(one.name_span),
        children: Some(children),
    }
}
