//! Requests about programs: parameters in, answers of a [`Document`](crate::Document) out.

use super::Workspace;
use super::client::Positions;
use super::convert;
use super::server::{OpenProgram, Server, failure, path};
use crate::{CodeAction, Edit, FoldKind, ReferenceKind};
use gen_lsp_types::{
    CompletionItem, CompletionList, DocumentHighlight, DocumentHighlightKind, DocumentSymbol,
    FoldingRange, FoldingRangeKind, FoldingRangeParams, Hover, InlayHint, InlayHintParams,
    Location, MarkupContent, MarkupKind, PrepareRenamePlaceholder, ReferenceParams, RenameParams,
    SemanticTokens, SignatureHelp, TextDocumentIdentifier, TextDocumentPositionParams, TextEdit,
    Uri,
};
use lsp_server::{ErrorCode, ResponseError};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, from_value, json};
use tip_lint::message::Formatting;
use tipc::message::Message;
use tipc::source::Span;

/// Maximum number of completion items in an answer: writing thousands of labels would take longer than typing the next letter.
const MAX_COMPLETIONS: usize = 150;

const QUICK_FIX: &str = "quickfix";
const FIX_ALL: &str = "source.fixAll";

/// Parses the parameters of a request.
fn read<P: DeserializeOwned>(params: Value) -> Result<P, ResponseError> {
    from_value(params).map_err(|error| failure(ErrorCode::InvalidParams, error.to_string()))
}

impl<W: Workspace> Server<W> {
    /// Answers a request about a program.
    pub(super) fn answer(&mut self, method: &str, params: Value) -> Result<Value, ResponseError> {
        match method {
            "textDocument/hover" => self.at(params, |it, at| Ok(it.hover(at))),
            "textDocument/definition" => self.at(params, |it, at| Ok(it.definition(at))),
            "textDocument/documentHighlight" => self.at(params, |it, at| Ok(it.highlights(at))),
            "textDocument/completion" => self.at(params, |it, at| Ok(it.completion(at))),
            "textDocument/signatureHelp" => self.at(params, |it, at| Ok(it.signatures(at))),
            "textDocument/prepareRename" => self.at(params, |it, at| it.prepare_rename(at)),
            "textDocument/references" => {
                let params: ReferenceParams = read(params)?;
                let declares = params.context.include_declaration;
                self.at_position(params.text_document_position_params, |it, at| {
                    Ok(it.references(at, declares))
                })
            }
            "textDocument/rename" => {
                let params: RenameParams = read(params)?;
                let name = params.new_name;
                self.at_position(params.text_document_position_params, |it, at| {
                    it.rename(at, &name)
                })
            }
            "textDocument/documentSymbol" => self.whole(params, |it| Ok(it.outline())),
            "textDocument/foldingRange" => self.whole(params, |it| Ok(it.folds())),
            "textDocument/formatting" => self.whole(params, |it| it.format(it.all())),
            "textDocument/rangeFormatting" => self.range(params, |it, span| it.format(span)),
            "textDocument/semanticTokens/full" => {
                self.whole(params, |it| Ok(it.semantic_tokens(it.all())))
            }
            "textDocument/semanticTokens/range" => {
                self.range(params, |it, span| Ok(it.semantic_tokens(span)))
            }
            "textDocument/inlayHint" => self.range(params, |it, span| Ok(it.inlay_hints(span))),
            "textDocument/codeAction" => {
                let only = params.pointer("/context/only").and_then(Value::as_array);
                let only: Option<Vec<String>> = only.map(|kinds| {
                    let kinds = kinds.iter().filter_map(Value::as_str);
                    kinds.map(str::to_owned).collect()
                });
                self.range(params, |it, span| Ok(it.actions(span, only.as_deref())))
            }
            // An extension of the protocol, for editors that read and write files in the encoding of a `tip.toml`.
            "tip/encoding" => {
                let params: TextDocumentIdentifier = read(params)?;
                let file = path(&params.uri.0);
                Ok(json!(file.and_then(|file| self.workspace.encoding(&file))))
            }
            _ => {
                let message = format!("`{method}` is not served");
                Err(failure(ErrorCode::MethodNotFound, message))
            }
        }
    }

    /// Answers a request about the open program at an address.
    fn answer_about<A: Serialize>(
        &mut self,
        uri: &Uri,
        ask: impl FnOnce(&mut OpenProgram<'_, W>) -> Result<A, ResponseError>,
    ) -> Result<Value, ResponseError> {
        let Some((mut program, _)) = self.open_program(&uri.0) else {
            let message = format!("`{}` is not open", uri.0);
            return Err(failure(ErrorCode::InvalidParams, message));
        };
        ask(&mut program).map(|answer| json!(answer))
    }

    /// Answers a request whose only parameter is a position.
    fn at<A: Serialize>(
        &mut self,
        params: Value,
        ask: impl FnOnce(&mut OpenProgram<'_, W>, usize) -> Result<A, ResponseError>,
    ) -> Result<Value, ResponseError> {
        let params: TextDocumentPositionParams = read(params)?;
        self.at_position(params, ask)
    }

    fn at_position<A: Serialize>(
        &mut self,
        params: TextDocumentPositionParams,
        ask: impl FnOnce(&mut OpenProgram<'_, W>, usize) -> Result<A, ResponseError>,
    ) -> Result<Value, ResponseError> {
        self.answer_about(&params.text_document.uri, |program| {
            let at = program.positions().offset(params.position);
            ask(program, at)
        })
    }

    /// Answers a request about a range of a program.
    fn range<A: Serialize>(
        &mut self,
        params: Value,
        ask: impl FnOnce(&mut OpenProgram<'_, W>, Span) -> Result<A, ResponseError>,
    ) -> Result<Value, ResponseError> {
        let params: InlayHintParams = read(params)?;
        self.answer_about(&params.text_document.uri, |program| {
            let span = program.positions().span(params.range);
            ask(program, span)
        })
    }

    /// Answers a request about a whole program.
    fn whole<A: Serialize>(
        &mut self,
        params: Value,
        ask: impl FnOnce(&mut OpenProgram<'_, W>) -> Result<A, ResponseError>,
    ) -> Result<Value, ResponseError> {
        let params: FoldingRangeParams = read(params)?;
        self.answer_about(&params.text_document.uri, ask)
    }
}

impl<W: Workspace> OpenProgram<'_, W> {
    fn positions(&self) -> Positions<'_> {
        Positions {
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
            range: self.positions().range(span),
        }
    }

    fn refused(&self, reason: &Message) -> ResponseError {
        let reason = reason.in_lang(self.client.lang).to_string();
        failure(ErrorCode::RequestFailed, reason)
    }

    fn hover(&self, at: usize) -> Option<Hover> {
        let hover = self.document.hover(at, self.client.lang)?;
        let contents = MarkupContent {
            kind: MarkupKind::Markdown,
            value: hover.text,
        };
        Some(Hover {
            contents: contents.into(),
            range: Some(self.positions().range(hover.span)),
        })
    }

    fn definition(&self, at: usize) -> Option<Location> {
        let span = self.document.definition(at)?;
        Some(self.location(span))
    }

    fn references(&self, at: usize, declares: bool) -> Vec<Location> {
        let found = self.document.references(at, declares).into_iter();
        found.map(|it| self.location(it.span)).collect()
    }

    fn highlights(&self, at: usize) -> Vec<DocumentHighlight> {
        let found = self.document.references(at, true).into_iter();
        let highlights = found.map(|it| DocumentHighlight {
            range: self.positions().range(it.span),
            kind: Some(match it.kind {
                ReferenceKind::Uses => DocumentHighlightKind::Read,
                ReferenceKind::Declares | ReferenceKind::Assigns => DocumentHighlightKind::Write,
            }),
        });
        highlights.collect()
    }

    fn completion(&self, at: usize) -> Value {
        let (items, are_all) = self.document.complete_with(at, MAX_COMPLETIONS);
        let positions = self.positions();
        let items = items
            .into_iter()
            .map(|it| convert::completion_item(it, positions, self.client));
        let items: Vec<CompletionItem> = items.collect();
        match are_all {
            true => json!(items),
            // The editor asks again after the next letter.
            false => json!(CompletionList {
                is_incomplete: true,
                items,
                ..CompletionList::default()
            }),
        }
    }

    fn signatures(&self, at: usize) -> Option<SignatureHelp> {
        let found = self.document.signatures(at)?;
        Some(convert::signatures(found, self.client.lang))
    }

    fn prepare_rename(&self, at: usize) -> Result<PrepareRenamePlaceholder, ResponseError> {
        let name = self.document.prepare_rename(at);
        let name = name.map_err(|reason| self.refused(&reason))?;
        Ok(PrepareRenamePlaceholder {
            range: self.positions().range(name.span),
            placeholder: name.name,
        })
    }

    fn rename(&self, at: usize, name: &str) -> Result<Value, ResponseError> {
        let edits = self.document.rename(at, name);
        let edits = edits.map_err(|reason| self.refused(&reason))?;
        Ok(self.change(&edits))
    }

    /// Returns edits of this program as a change of the workspace.
    fn change(&self, edits: &[Edit]) -> Value {
        json!({ "changes": { self.uri: self.positions().edits(edits) } })
    }

    fn outline(&self) -> Vec<DocumentSymbol> {
        let positions = self.positions();
        let outline = self.document.outline();
        let symbols = outline.iter().map(|one| convert::symbol(one, positions));
        symbols.collect()
    }

    fn folds(&self) -> Vec<FoldingRange> {
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
        folds.collect()
    }

    /// Formats the lines of a span. An unfinished program has no edits: editors format after each save, and would show the error.
    fn format(&self, span: Span) -> Result<Option<Vec<TextEdit>>, ResponseError> {
        match self.document.format() {
            Ok(mut edits) => {
                let source = self.document.source();
                let line = |at: usize| source.line_column(at).0;
                let lines = line(span.start)..=line(span.end);
                edits.retain(|edit| lines.contains(&line(edit.span.start)));
                Ok(Some(self.positions().edits(&edits)))
            }
            Err(Formatting::DoesNotLoad) => Ok(None),
            Err(reason) => Err(self.refused(&reason.into())),
        }
    }

    fn semantic_tokens(&self, span: Span) -> SemanticTokens {
        let tokens = self.document.semantic_tokens(span);
        SemanticTokens {
            result_id: None,
            data: convert::semantic_tokens(&tokens, self.positions()),
        }
    }

    fn inlay_hints(&self, span: Span) -> Vec<InlayHint> {
        let hints = self.document.inlay_hints(span).into_iter();
        let hints = hints.map(|hint| InlayHint {
            position: self.positions().position(hint.at),
            label: hint.text.in_lang(self.client.lang).to_string().into(),
            kind: None,
            text_edits: None,
            tooltip: None,
            padding_left: Some(true),
            padding_right: None,
            data: None,
        });
        hints.collect()
    }

    /// Returns the fixes of diagnostics, or of the whole file if the client asks for them.
    fn actions(&mut self, span: Span, only: Option<&[String]>) -> Vec<Value> {
        let wants = |kind: &str| {
            let includes = |only: &String| {
                let rest = kind.strip_prefix(only.as_str());
                rest.is_some_and(|rest| only.is_empty() || rest.is_empty() || rest.starts_with('.'))
            };
            only.is_some_and(|only| only.iter().any(includes))
        };
        let mut found = Vec::new();
        if only.is_none() || wants(QUICK_FIX) {
            found.extend(self.document.code_actions(span));
        }
        if wants(FIX_ALL) {
            found.extend(self.document.fix_all());
        }
        found.iter().map(|action| self.action(action)).collect()
    }

    fn action(&mut self, action: &CodeAction) -> Value {
        let title = action.title.in_lang(self.client.lang).to_string();
        let edit = self.change(&action.edits);
        let loaded = self.document.loaded();
        let one = action
            .diagnostic
            .and_then(|index| loaded.diagnostics.get(index));
        let Some(one) = one else {
            return json!({ "title": title, "kind": FIX_ALL, "edit": edit });
        };
        let diagnostic = convert::diagnostic(loaded, one, self.uri, self.client, self.workspace);
        json!({
            "title": title,
            "kind": QUICK_FIX,
            "diagnostics": [diagnostic],
            "isPreferred": action.is_certain,
            "edit": edit,
        })
    }
}
