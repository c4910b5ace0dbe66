// The session of session.json over npm's vscode-jsonrpc, with the messages of vscode-languageserver-protocol, for one encoding
// of columns: node session.cjs TIP SESSION ENCODING
const { spawn } = require("node:child_process");
const fs = require("node:fs");
const rpc = require("vscode-jsonrpc/node");
const lsp = require("vscode-languageserver-protocol/node");

const [tip, path, encoding] = process.argv.slice(2);
const session = JSON.parse(fs.readFileSync(path, "utf8"));
const uri = "file:///robot/walk.prg";
const textDocument = { uri };
let text = session.text;
let version = 0;

const units = (part) =>
  encoding === "utf-8" ? Buffer.byteLength(part) : encoding === "utf-16" ? part.length : [...part].length;

function position(at) {
  const before = text.slice(0, at);
  const start = before.lastIndexOf("\n") + 1;
  return { line: before.split("\n").length - 1, character: units(before.slice(start)) };
}

function offset(place) {
  const lines = text.split("\n");
  const start = lines.slice(0, place.line).reduce((sum, line) => sum + line.length + 1, 0);
  for (let column = 0; column <= lines[place.line].length; column++) {
    const part = lines[place.line].slice(0, column);
    if (part.isWellFormed() && units(part) === place.character) return start + column;
  }
  throw new Error(`${JSON.stringify(place)} is inside a character`);
}

const slice = (range) => text.slice(offset(range.start), offset(range.end));

function find(step) {
  let at = -1;
  for (let nth = 0; nth <= (step.nth ?? 0); nth++) at = text.indexOf(step.find, at + 1);
  return at;
}

const log = (...words) =>
  console.log(words.map((word) => String(word).replaceAll("\r\n", "⏎").replaceAll("\n", " | ")).join(" "));

async function main() {
  const server = spawn(tip, ["lsp", "--stdio"], { stdio: ["pipe", "pipe", "inherit"] });
  const connection = rpc.createMessageConnection(
    new rpc.StreamMessageReader(server.stdout),
    new rpc.StreamMessageWriter(server.stdin),
  );
  let arrived;
  connection.onNotification(lsp.PublishDiagnosticsNotification.type, (params) => arrived(params.diagnostics));
  const findings = () => new Promise((resolve) => (arrived = resolve));
  connection.listen();
  const capabilities = {
    general: { positionEncodings: [encoding] },
    textDocument: { completion: { completionItem: { snippetSupport: true } }, publishDiagnostics: {} },
  };
  const started = await connection.sendRequest(lsp.InitializeRequest.type, {
    processId: process.pid, rootUri: null, capabilities,
  });
  if (started.capabilities.positionEncoding !== encoding) throw new Error(started.capabilities.positionEncoding);
  const legend = started.capabilities.semanticTokensProvider.legend.tokenTypes;
  await connection.sendNotification(lsp.InitializedNotification.type, {});

  const ask = (type, more = {}) => connection.sendRequest(type, { textDocument, ...more });
  const at = (type, step, more = {}) => ask(type, { position: position(find(step)), ...more });

  async function apply(edits) {
    const sorted = [...edits].sort((a, b) => offset(b.range.start) - offset(a.range.start));
    const contentChanges = [];
    for (const { range, newText } of sorted) {
      const [start, end] = [offset(range.start), offset(range.end)];
      contentChanges.push({ range, text: newText });
      text = text.slice(0, start) + newText + text.slice(end);
    }
    version += 1;
    const found = findings();
    const params = { textDocument: { uri, version }, contentChanges };
    await connection.sendNotification(lsp.DidChangeTextDocumentNotification.type, params);
    return (await found).map((one) => one.code);
  }

  const steps = {
    async hover(step) {
      const hover = await at(lsp.HoverRequest.type, step);
      log("hover", slice(hover.range), hover.contents.value);
    },
    async definition(step) {
      const place = await at(lsp.DefinitionRequest.type, step);
      log("definition", place.range.start.line, slice(place.range));
    },
    async references(step) {
      const places = await at(lsp.ReferencesRequest.type, step, { context: { includeDeclaration: true } });
      log("references", ...places.map((it) => `${it.range.start.line}:${slice(it.range)}`));
    },
    async completion(step) {
      const items = (await at(lsp.CompletionRequest.type, step)).filter((it) => it.label.startsWith(step.prefix));
      log("completion", ...items.map((it) => `${it.label}/${slice(it.textEdit.range)}`));
    },
    async signature(step) {
      const found = await at(lsp.SignatureHelpRequest.type, step);
      const form = found.signatures[found.activeSignature];
      const [start, end] = form.parameters[found.activeParameter].label;
      log("signature", form.label, "/", form.label.slice(start, end));
    },
    async symbols() {
      const found = await ask(lsp.DocumentSymbolRequest.type);
      log("symbols", ...found.map((one) => `${one.name}/${slice(one.selectionRange)}`));
    },
    async folds() {
      const found = await ask(lsp.FoldingRangeRequest.type);
      log("folds", ...found.map((one) => `${one.startLine}-${one.endLine}`));
    },
    async hints() {
      const range = { start: { line: 0, character: 0 }, end: position(text.length) };
      for (const one of await ask(lsp.InlayHintRequest.type, { range })) log("hint", one.position.line, one.label);
    },
    async tokens() {
      const { data } = await ask(lsp.SemanticTokensRequest.type);
      let [line, character] = [0, 0];
      for (let token = 0; token < data.length; token += 5) {
        const [down, right, length, kind, marks] = data.slice(token, token + 5);
        [line, character] = [line + down, down ? right : character + right];
        const range = { start: { line, character }, end: { line, character: character + length } };
        log("token", slice(range), legend[kind], marks);
      }
    },
    async refused(step) {
      const answer = at(lsp.RenameRequest.type, step, { newName: step.name });
      await answer.then(() => log("not refused"), (error) => log("refused", error.message));
    },
    async rename(step) {
      const edit = await at(lsp.RenameRequest.type, step, { newName: step.name });
      const codes = await apply(edit.changes[uri]);
      log("renamed", text, ...codes);
    },
    async fix(step) {
      const place = position(find(step));
      const range = { start: place, end: place };
      const [action] = await ask(lsp.CodeActionRequest.type, { range, context: { diagnostics: [] } });
      const codes = await apply(action.edit.changes[uri]);
      log("fixed", action.title, ...codes);
    },
    async format() {
      const edits = await ask(lsp.DocumentFormattingRequest.type, { options: { tabSize: 2, insertSpaces: true } });
      const codes = await apply(edits);
      log("formatted", text, ...codes);
    },
  };

  const found = findings();
  await connection.sendNotification(lsp.DidOpenTextDocumentNotification.type, {
    textDocument: { uri, languageId: "tip", version, text },
  });
  for (const one of await found) log("finding", one.code, slice(one.range) || "nothing", one.message);
  for (const step of session.steps) await steps[step.ask](step);
  await connection.sendRequest(lsp.ShutdownRequest.type);
  await connection.sendNotification(lsp.ExitNotification.type);
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
