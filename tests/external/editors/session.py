"""The session of session.json from pytest-lsp's client, for one encoding of columns: session.py TIP SESSION ENCODING."""

import asyncio
import json
import sys

import lsprotocol.types as lsp
from pytest_lsp import LanguageClient, client_capabilities
from pytest_lsp.client import make_test_lsp_client

URI = "file:///robot/walk.prg"
KINDS = {"utf-8": lsp.PositionEncodingKind.Utf8, "utf-16": lsp.PositionEncodingKind.Utf16,
         "utf-32": lsp.PositionEncodingKind.Utf32}


class Editor:
    def __init__(self, client: LanguageClient, encoding: str, text: str, legend):
        self.client, self.encoding, self.text, self.legend = client, encoding, text, legend
        self.version = 0

    def units(self, text: str) -> int:
        match self.encoding:
            case "utf-8":
                return len(text.encode())
            case "utf-16":
                return len(text.encode("utf-16-le")) // 2
            case _:
                return len(text)

    def position(self, at: int) -> lsp.Position:
        before = self.text[:at]
        start = before.rfind("\n") + 1
        return lsp.Position(line=before.count("\n"), character=self.units(before[start:]))

    def offset(self, place: lsp.Position) -> int:
        lines = self.text.split("\n")
        start = sum(len(line) + 1 for line in lines[: place.line])
        for column in range(len(lines[place.line]) + 1):
            if self.units(lines[place.line][:column]) == place.character:
                return start + column
        raise ValueError(f"{place} is inside a character")

    def slice(self, place: lsp.Range) -> str:
        return self.text[self.offset(place.start) : self.offset(place.end)]

    def find(self, step) -> int:
        at = -1
        for _ in range(step.get("nth", 0) + 1):
            at = self.text.index(step["find"], at + 1)
        return at

    def at(self, step) -> dict:
        return {"text_document": lsp.TextDocumentIdentifier(uri=URI), "position": self.position(self.find(step))}

    async def apply(self, edits) -> list[str]:
        edits = sorted(edits, key=lambda edit: self.offset(edit.range.start), reverse=True)
        changes = []
        for edit in edits:
            start, end = self.offset(edit.range.start), self.offset(edit.range.end)
            changes.append(lsp.TextDocumentContentChangePartial(range=edit.range, text=edit.new_text))
            self.text = self.text[:start] + edit.new_text + self.text[end:]
        self.version += 1
        document = lsp.VersionedTextDocumentIdentifier(uri=URI, version=self.version)
        waits = self.client.wait_for_notification("textDocument/publishDiagnostics")
        self.client.text_document_did_change(
            lsp.DidChangeTextDocumentParams(text_document=document, content_changes=changes)
        )
        await waits
        return [one.code for one in self.client.diagnostics[URI]]

    def log(self, *words) -> None:
        print(*(str(word).replace("\r\n", "⏎").replace("\n", " | ") for word in words))

    async def step(self, step) -> None:
        client, document = self.client, lsp.TextDocumentIdentifier(uri=URI)
        match step["ask"]:
            case "hover":
                hover = await client.text_document_hover_async(lsp.HoverParams(**self.at(step)))
                self.log("hover", self.slice(hover.range), hover.contents.value)
            case "definition":
                place = await client.text_document_definition_async(lsp.DefinitionParams(**self.at(step)))
                self.log("definition", place.range.start.line, self.slice(place.range))
            case "references":
                context = lsp.ReferenceContext(include_declaration=True)
                places = await client.text_document_references_async(
                    lsp.ReferenceParams(**self.at(step), context=context)
                )
                self.log("references", *(f"{it.range.start.line}:{self.slice(it.range)}" for it in places))
            case "completion":
                items = await client.text_document_completion_async(lsp.CompletionParams(**self.at(step)))
                items = [item for item in items if item.label.startswith(step["prefix"])]
                self.log("completion", *(f"{item.label}/{self.slice(item.text_edit.range)}" for item in items))
            case "signature":
                found = await client.text_document_signature_help_async(lsp.SignatureHelpParams(**self.at(step)))
                form = found.signatures[found.active_signature]
                start, end = form.parameters[found.active_parameter].label
                self.log("signature", form.label, "/", form.label[start:end])
            case "symbols":
                found = await client.text_document_document_symbol_async(
                    lsp.DocumentSymbolParams(text_document=document)
                )
                self.log("symbols", *(f"{one.name}/{self.slice(one.selection_range)}" for one in found))
            case "folds":
                found = await client.text_document_folding_range_async(lsp.FoldingRangeParams(text_document=document))
                self.log("folds", *(f"{one.start_line}-{one.end_line}" for one in found))
            case "hints":
                end = self.position(len(self.text))
                place = lsp.Range(start=lsp.Position(0, 0), end=end)
                found = await client.text_document_inlay_hint_async(
                    lsp.InlayHintParams(text_document=document, range=place)
                )
                for one in found:
                    self.log("hint", one.position.line, one.label)
            case "tokens":
                found = await client.text_document_semantic_tokens_full_async(
                    lsp.SemanticTokensParams(text_document=document)
                )
                line = column = 0
                for at in range(0, len(found.data), 5):
                    down, right, length, kind, marks = found.data[at : at + 5]
                    line, column = line + down, right if down else column + right
                    start, end = lsp.Position(line, column), lsp.Position(line, column + length)
                    self.log("token", self.slice(lsp.Range(start, end)), self.legend[kind], marks)
            case "refused":
                try:
                    await client.text_document_rename_async(lsp.RenameParams(**self.at(step), new_name=step["name"]))
                    self.log("not refused")
                except Exception as error:  # noqa: BLE001
                    self.log("refused", getattr(error, "message", error))
            case "rename":
                edit = await client.text_document_rename_async(
                    lsp.RenameParams(**self.at(step), new_name=step["name"])
                )
                codes = await self.apply(edit.changes[URI])
                self.log("renamed", self.text, *codes)
            case "fix":
                place = self.position(self.find(step))
                actions = await client.text_document_code_action_async(
                    lsp.CodeActionParams(
                        text_document=document,
                        range=lsp.Range(start=place, end=place),
                        context=lsp.CodeActionContext(diagnostics=[]),
                    )
                )
                codes = await self.apply(actions[0].edit.changes[URI])
                self.log("fixed", actions[0].title, *codes)
            case "format":
                options = lsp.FormattingOptions(tab_size=2, insert_spaces=True)
                edits = await client.text_document_formatting_async(
                    lsp.DocumentFormattingParams(text_document=document, options=options)
                )
                codes = await self.apply(edits)
                self.log("formatted", self.text, *codes)


async def main(tip: str, path: str, encoding: str) -> None:
    with open(path, encoding="utf-8") as file:
        session = json.load(file)
    client = make_test_lsp_client()
    # The server asks to be told when a tip.toml changes; here none does.
    client.feature("client/registerCapability")(lambda params: None)
    await client.start_io(tip, "lsp")
    # What Visual Studio Code says of itself, but for the encoding.
    capabilities = client_capabilities("visual-studio-code")
    capabilities.general.position_encodings = [KINDS[encoding]]
    answer = await client.initialize_session(
        lsp.InitializeParams(capabilities=capabilities, process_id=None, root_uri=None)
    )
    assert answer.capabilities.position_encoding == KINDS[encoding], answer.capabilities.position_encoding
    legend = answer.capabilities.semantic_tokens_provider.legend.token_types
    editor = Editor(client, encoding, session["text"], legend)
    item = lsp.TextDocumentItem(uri=URI, language_id="tip", version=0, text=editor.text)
    client.text_document_did_open(lsp.DidOpenTextDocumentParams(text_document=item))
    await client.wait_for_notification("textDocument/publishDiagnostics")
    for one in client.diagnostics[URI]:
        editor.log("finding", one.code, editor.slice(one.range) or "nothing", one.message)
    for step in session["steps"]:
        await editor.step(step)
    await client.shutdown_session()


asyncio.run(main(*sys.argv[1:]))
