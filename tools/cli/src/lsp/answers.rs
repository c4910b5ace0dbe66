//! The answers to requests, from `tip-ide`.

use super::findings::finding;
use super::places::Places;
use super::server::{Asked, Failure, Server, path};
use super::shapes;
use super::surroundings::Surroundings;
use super::tokens::tokens;
use gen_lsp_types::{
    CompletionItem, CompletionList, DocumentHighlight, DocumentHighlightKind, FoldingRange,
    FoldingRangeKind, FoldingRangeParams, Hover, InlayHint, InlayHintParams, Location,
    MarkupContent, MarkupKind, PrepareRenamePlaceholder, ReferenceParams, RenameParams,
    SemanticTokens, TextDocumentIdentifier, TextDocumentPositionParams, Uri,
};
use lsp_server::ErrorCode;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, from_value, json, to_value};
use tip_ide::{Action, FoldKind, MentionKind};
use tipc::message::Message;
use tipc::source::Span;

/// The parameters that a request needs, or why they are no good.
fn read<P: DeserializeOwned>(params: Value) -> Result<P, Failure> {
    from_value(params).map_err(|error| Failure::new(ErrorCode::InvalidParams, error.to_string()))
}

fn write(answer: impl Serialize) -> Result<Value, Failure> {
    to_value(answer).map_err(|error| Failure::new(ErrorCode::InternalError, error.to_string()))
}

impl<S: Surroundings> Server<S> {
    /// The answer to a request about a program.
    pub(super) fn answer(&mut self, method: &str, params: Value) -> Result<Value, Failure> {
        match method {
            "textDocument/hover" => self.at(params, |it, at| it.hover(at)),
            "textDocument/definition" => self.at(params, |it, at| it.definition(at)),
            "textDocument/documentHighlight" => self.at(params, |it, at| it.highlights(at)),
            "textDocument/completion" => self.at(params, |it, at| it.completion(at)),
            "textDocument/signatureHelp" => self.at(params, |it, at| it.signatures(at)),
            "textDocument/prepareRename" => self.at(params, |it, at| it.nameable(at)),
            "textDocument/references" => {
                let params: ReferenceParams = read(params)?;
                let declares = params.context.include_declaration;
                self.at_place(params.text_document_position_params, |it, at| {
                    it.references(at, declares)
                })
            }
            "textDocument/rename" => {
                let params: RenameParams = read(params)?;
                let name = params.new_name;
                self.at_place(params.text_document_position_params, |it, at| {
                    it.rename(at, &name)
                })
            }
            "textDocument/documentSymbol" => self.whole(params, |it| it.outline()),
            "textDocument/foldingRange" => self.whole(params, |it| it.folds()),
            "textDocument/formatting" => self.whole(params, |it| it.format()),
            "textDocument/semanticTokens/full" => self.whole(params, |it| it.paint(it.all())),
            "textDocument/semanticTokens/range" => self.part(params, |it, span| it.paint(span)),
            "textDocument/inlayHint" => self.part(params, |it, span| it.hints(span)),
            "textDocument/codeAction" => {
                let only = params.pointer("/context/only").and_then(Value::as_array);
                let only: Option<Vec<String>> = only.map(|kinds| {
                    let kinds = kinds.iter().filter_map(Value::as_str);
                    kinds.map(str::to_owned).collect()
                });
                self.part(params, |it, span| it.actions(span, only.as_deref()))
            }
            // Not of the protocol: an editor reads and writes files itself, and asks how.
            "tip/encoding" => {
                let params: TextDocumentIdentifier = read(params)?;
                let file = path(&params.uri.0);
                write(file.and_then(|file| self.around.encoding(&file)))
            }
            _ => {
                let message = format!("`{method}` is not served");
                Err(Failure::new(ErrorCode::MethodNotFound, message))
            }
        }
    }

    fn of<A>(
        &mut self,
        uri: &Uri,
        ask: impl FnOnce(&mut Asked<'_, S>) -> Result<A, Failure>,
    ) -> Result<A, Failure> {
        let Some((mut asked, _)) = self.asked(&uri.0) else {
            let message = format!("`{}` is not open", uri.0);
            return Err(Failure::new(ErrorCode::InvalidParams, message));
        };
        ask(&mut asked)
    }

    /// An answer at a place.
    fn at(
        &mut self,
        params: Value,
        ask: impl FnOnce(&mut Asked<'_, S>, usize) -> Result<Value, Failure>,
    ) -> Result<Value, Failure> {
        let params: TextDocumentPositionParams = read(params)?;
        self.at_place(params, ask)
    }

    fn at_place(
        &mut self,
        params: TextDocumentPositionParams,
        ask: impl FnOnce(&mut Asked<'_, S>, usize) -> Result<Value, Failure>,
    ) -> Result<Value, Failure> {
        self.of(&params.text_document.uri, |asked| {
            let at = asked.places().offset(params.position);
            ask(asked, at)
        })
    }

    /// An answer about a stretch of a program.
    fn part(
        &mut self,
        params: Value,
        ask: impl FnOnce(&mut Asked<'_, S>, Span) -> Result<Value, Failure>,
    ) -> Result<Value, Failure> {
        let params: InlayHintParams = read(params)?;
        self.of(&params.text_document.uri, |asked| {
            let span = asked.places().span(params.range);
            ask(asked, span)
        })
    }

    /// An answer about a whole program.
    fn whole(
        &mut self,
        params: Value,
        ask: impl FnOnce(&mut Asked<'_, S>) -> Result<Value, Failure>,
    ) -> Result<Value, Failure> {
        let params: FoldingRangeParams = read(params)?;
        self.of(&params.text_document.uri, ask)
    }
}

impl<S: Surroundings> Asked<'_, S> {
    pub(super) fn places(&self) -> Places<'_> {
        Places {
            source: self.document.source(),
            unit: self.client.unit,
        }
    }

    fn all(&self) -> Span {
        Span::new(0, self.document.source().text().len())
    }

    fn location(&self, span: Span) -> Location {
        Location {
            uri: Uri(self.uri.to_owned()),
            range: self.places().range(span),
        }
    }

    fn refused(&self, reason: &Message) -> Failure {
        let reason = reason.in_lang(self.client.lang).to_string();
        Failure::new(ErrorCode::RequestFailed, reason)
    }

    fn hover(&self, at: usize) -> Result<Value, Failure> {
        let hover = self.document.hover(at, self.client.lang);
        write(hover.map(|hover| {
            Hover {
                contents: MarkupContent {
                    kind: MarkupKind::Markdown,
                    value: hover.text,
                }
                .into(),
                range: Some(self.places().range(hover.span)),
            }
        }))
    }

    fn definition(&self, at: usize) -> Result<Value, Failure> {
        let place = self.document.definition(at);
        write(place.map(|span| self.location(span)))
    }

    fn references(&self, at: usize, declares: bool) -> Result<Value, Failure> {
        let found = self.document.references(at, declares).into_iter();
        write(found.map(|it| self.location(it.span)).collect::<Vec<_>>())
    }

    fn highlights(&self, at: usize) -> Result<Value, Failure> {
        let found = self.document.references(at, true).into_iter();
        let highlights = found.map(|it| DocumentHighlight {
            range: self.places().range(it.span),
            kind: Some(match it.kind {
                MentionKind::Uses => DocumentHighlightKind::Read,
                MentionKind::Declares | MentionKind::Assigns => DocumentHighlightKind::Write,
            }),
        });
        write(highlights.collect::<Vec<_>>())
    }

    fn completion(&self, at: usize) -> Result<Value, Failure> {
        let (offers, are_all) = self.document.complete_with(at, MOST_OFFERS);
        let places = self.places();
        let items = offers
            .into_iter()
            .map(|it| shapes::item(it, places, self.client));
        let items: Vec<CompletionItem> = items.collect();
        match are_all {
            true => write(items),
            // With the next letter the editor asks again.
            false => write(CompletionList {
                is_incomplete: true,
                items,
                ..CompletionList::default()
            }),
        }
    }

    fn signatures(&self, at: usize) -> Result<Value, Failure> {
        let found = self.document.signatures(at);
        write(found.map(|found| shapes::signatures(found, self.client.lang)))
    }

    fn nameable(&self, at: usize) -> Result<Value, Failure> {
        match self.document.nameable(at) {
            Ok(name) => write(PrepareRenamePlaceholder {
                range: self.places().range(name.span),
                placeholder: name.name,
            }),
            Err(reason) => Err(self.refused(&reason)),
        }
    }

    fn rename(&self, at: usize, name: &str) -> Result<Value, Failure> {
        match self.document.rename(at, name) {
            Ok(edits) => self.change(&edits),
            Err(reason) => Err(self.refused(&reason)),
        }
    }

    /// Changes of this program.
    fn change(&self, edits: &[tip_ide::Edit]) -> Result<Value, Failure> {
        let edits = write(self.places().edits(edits))?;
        Ok(json!({ "changes": { self.uri: edits } }))
    }

    fn outline(&self) -> Result<Value, Failure> {
        let places = self.places();
        let outline = self.document.outline();
        let symbols = outline.iter().map(|one| shapes::symbol(one, places));
        write(symbols.collect::<Vec<_>>())
    }

    fn folds(&self) -> Result<Value, Failure> {
        let folds = self.document.folds().into_iter();
        let folds = folds.map(|fold| FoldingRange {
            start_line: fold.first - 1,
            end_line: fold.last - 1,
            kind: Some(match fold.kind {
                FoldKind::Comment => FoldingRangeKind::Comment,
                FoldKind::Block => FoldingRangeKind::Region,
            }),
            ..FoldingRange::default()
        });
        write(folds.collect::<Vec<_>>())
    }

    fn format(&self) -> Result<Value, Failure> {
        match self.document.format() {
            Ok(edits) => write(self.places().edits(&edits)),
            Err(reason) => Err(self.refused(&reason.into())),
        }
    }

    fn paint(&self, span: Span) -> Result<Value, Failure> {
        let painted = self.document.paint(span);
        write(SemanticTokens {
            result_id: None,
            data: tokens(&painted, self.places()),
        })
    }

    fn hints(&self, span: Span) -> Result<Value, Failure> {
        let hints = self.document.hints(span).into_iter();
        let hints = hints.map(|hint| InlayHint {
            position: self.places().position(hint.at),
            label: hint.text.in_lang(self.client.lang).to_string().into(),
            kind: None,
            text_edits: None,
            tooltip: None,
            padding_left: Some(true),
            padding_right: None,
            data: None,
        });
        write(hints.collect::<Vec<_>>())
    }

    /// Fixes of findings, or of the whole file where that is asked for.
    fn actions(&mut self, span: Span, only: Option<&[String]>) -> Result<Value, Failure> {
        let wants = |kind: &str| {
            let includes = |only: &String| {
                let rest = kind.strip_prefix(only.as_str());
                rest.is_some_and(|rest| only.is_empty() || rest.is_empty() || rest.starts_with('.'))
            };
            only.is_some_and(|only| only.iter().any(includes))
        };
        let mut found = Vec::new();
        if only.is_none() || wants(QUICK_FIX) {
            found.extend(self.document.actions(span));
        }
        if wants(FIX_ALL) {
            found.extend(self.document.fix_all());
        }
        let actions = found.iter().map(|action| self.action(action));
        Ok(Value::Array(actions.collect::<Result<_, _>>()?))
    }

    fn action(&mut self, action: &Action) -> Result<Value, Failure> {
        let title = action.title.in_lang(self.client.lang).to_string();
        let edit = self.change(&action.edits)?;
        let loaded = self.document.loaded();
        let one = action
            .finding
            .and_then(|index| loaded.diagnostics.get(index));
        let Some(one) = one else {
            return Ok(json!({ "title": title, "kind": FIX_ALL, "edit": edit }));
        };
        let finding = finding(loaded, one, self.uri, self.client, self.around);
        Ok(json!({
            "title": title,
            "kind": QUICK_FIX,
            "diagnostics": [write(finding)?],
            "isPreferred": action.is_certain,
            "edit": edit,
        }))
    }
}

/// Writing out thousands of labels would take longer than typing the next letter.
const MOST_OFFERS: usize = 150;

const QUICK_FIX: &str = "quickfix";
const FIX_ALL: &str = "source.fixAll";
