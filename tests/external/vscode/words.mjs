// The classes of words, once from the grammar, once from the language server.
import { spawn } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { join } from 'node:path';

const require = createRequire(import.meta.url);
const textmate = require('vscode-textmate');
const oniguruma = require('vscode-oniguruma');
const rpc = require('vscode-jsonrpc/node');

/** The class that a scope stands for; the first that fits counts. Nothing is said of the others. */
const CLASSES = [
  ['keyword.operator', 'operator'],
  ['keyword.control', 'keyword'],
  ['support.function.command', 'function'],
  ['support.function.math', 'method'],
  ['variable.language.flag', 'event'],
  ['variable.language.reading', 'variable'],
  ['constant.language', 'enumMember'],
  ['storage.modifier', 'modifier'],
  ['variable.other.member', 'property'],
  ['variable.other', 'variable'],
  ['entity.name.label', 'label'],
  ['constant.numeric', 'number'],
  ['string', 'string'],
  ['comment', 'comment'],
];

function classOf(scopes) {
  for (const scope of [...scopes].reverse()) {
    const found = CLASSES.find(([stem]) => scope.startsWith(stem));
    if (found) return found[1];
  }
  return '';
}

/** The grammar; what it gives is a function from a text to a class for each character of each line. */
export async function grammar(extension) {
  const wasm = await readFile(require.resolve('vscode-oniguruma/release/onig.wasm'));
  await oniguruma.loadWASM(wasm);
  const registry = new textmate.Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: async () => {
      const path = join(extension, 'syntaxes/tip.tmLanguage.json');
      return textmate.parseRawGrammar(await readFile(path, 'utf8'), path);
    },
  });
  const rules = await registry.loadGrammar('source.tip');
  return (text) => {
    let stack = textmate.INITIAL;
    return text.split(/\r\n|\n|\r/).map((line) => {
      const { tokens, ruleStack } = rules.tokenizeLine(line, stack);
      stack = ruleStack;
      return [...line].length && spread(line, tokens.map((it) => [it.startIndex, it.endIndex, classOf(it.scopes)]));
    });
  };
}

/** A class for each unit of a line; none for blanks. */
function spread(line, stretches) {
  const classes = Array(line.length).fill('');
  for (const [start, end, name] of stretches) classes.fill(name, start, Math.min(end, line.length));
  return classes.map((name, at) => (/[\s,]/.test(line[at]) ? '' : name));
}

/** A session with `tip lsp`; its `classes(text)` are like those of the grammar, or nothing where the program has errors. */
export function server(tip) {
  const child = spawn(tip, ['lsp'], { stdio: ['pipe', 'pipe', 'inherit'] });
  const connection = rpc.createMessageConnection(
    new rpc.StreamMessageReader(child.stdout),
    new rpc.StreamMessageWriter(child.stdin),
  );
  const waiting = new Map();
  connection.onNotification('textDocument/publishDiagnostics', ({ uri, diagnostics }) => waiting.get(uri)?.(diagnostics));
  connection.listen();
  let legend;
  let count = 0;
  return {
    async start(robot) {
      const capabilities = { general: { positionEncodings: ['utf-16'] } };
      const options = { processId: null, rootUri: null, capabilities, initializationOptions: { robot } };
      const started = await connection.sendRequest('initialize', options);
      legend = started.capabilities.semanticTokensProvider.legend.tokenTypes;
    },
    async classes(text) {
      const uri = `untitled:${(count += 1)}.prg`;
      const found = new Promise((resolve) => waiting.set(uri, resolve));
      const textDocument = { uri, languageId: 'tip', version: 1, text };
      await connection.sendNotification('textDocument/didOpen', { textDocument });
      const hasErrors = (await found).some((one) => one.severity === 1);
      const answer = await connection.sendRequest('textDocument/semanticTokens/full', { textDocument: { uri } });
      waiting.delete(uri);
      await connection.sendNotification('textDocument/didClose', { textDocument: { uri } });
      if (hasErrors) return undefined;
      const lines = text.split(/\r\n|\n|\r/);
      const stretches = lines.map(() => []);
      let [line, start] = [0, 0];
      for (let at = 0; at < answer.data.length; at += 5) {
        const [down, right, length, kind] = answer.data.slice(at, at + 4);
        [line, start] = [line + down, down ? right : start + right];
        stretches[line].push([start, start + length, legend[kind]]);
      }
      return lines.map((text, at) => text.length && spread(text, stretches[at]));
    },
    async end() {
      await connection.sendRequest('shutdown');
      await connection.sendNotification('exit');
    },
  };
}
