// Programs in Shift_JIS: opened as what they are, with a warning where the editor would save other bytes.
import * as vscode from 'vscode';
import { encodingOf, place, respelt, unspellable } from './bytes.js';

const SHIFT_JIS = 'shiftjis';

const codec = {
  decode: (bytes) => vscode.workspace.decode(bytes, { encoding: SHIFT_JIS }),
  encode: (text) => vscode.workspace.encode(text, { encoding: SHIFT_JIS }),
};

/** `said` gives what tip.toml says of a file. */
export function register(context, said) {
  const onDisk = vscode.languages.createDiagnosticCollection('tip-bytes');
  const typed = vscode.languages.createDiagnosticCollection('tip-characters');
  const opened = new Set();
  const isOurs = (document) => document.languageId === 'tip' && document.uri.scheme === 'file';

  async function open(document) {
    if (!isOurs(document)) return;
    const key = document.uri.toString();
    const bytes = await vscode.workspace.fs.readFile(document.uri);
    let shown = document;
    // What the user chooses afterwards stays.
    if (!opened.has(key)) {
      opened.add(key);
      shown = await reopened(document, bytes, said);
    }
    onDisk.set(shown.uri, isShiftJis(shown) ? await warnOfBytes(shown, bytes) : []);
    await type(shown);
  }

  async function type(document) {
    if (!isOurs(document)) return;
    const { version } = document;
    const found = isShiftJis(document) ? await unspellable(document.getText(), codec) : [];
    if (document.version !== version) return;
    const warnings = found.map(({ start, end, from, to }) => {
      const text = vscode.l10n.t('Shift_JIS has no “{0}”: it is saved as “{1}”.', from, to);
      return warning(document.positionAt(start), document.positionAt(end), text);
    });
    typed.set(document.uri, warnings);
  }

  context.subscriptions.push(
    onDisk,
    typed,
    vscode.workspace.onDidOpenTextDocument(open),
    vscode.workspace.onDidSaveTextDocument(open),
    vscode.workspace.onDidChangeTextDocument((event) => type(event.document)),
    vscode.workspace.onDidCloseTextDocument((document) => {
      for (const collection of [onDisk, typed]) collection.delete(document.uri);
      // An encoding may be changed by closing and opening again.
      setTimeout(() => {
        const isOpen = vscode.workspace.textDocuments.some((other) => other.uri.toString() === document.uri.toString());
        if (!isOpen) opened.delete(document.uri.toString());
      }, 1000);
    }),
  );
  vscode.workspace.textDocuments.forEach(open);
}

const isShiftJis = (document) => document.encoding === SHIFT_JIS;

/** The document, in its own encoding. */
async function reopened(document, bytes, said) {
  const settings = vscode.workspace.getConfiguration('tip', document.uri);
  if (!settings.get('detectEncoding')) return document;
  // What UTF-8 cannot show is not left so until the server answers.
  const found = encodingOf(bytes);
  const encoding = found === SHIFT_JIS ? found : encodingOf(bytes, await said(document.uri));
  const has = document.encoding === 'utf8bom' ? 'utf8' : document.encoding;
  if (encoding === undefined || encoding === has) return document;
  if (document.isDirty) {
    warnOfChanges(document, encoding);
    return document;
  }
  return vscode.workspace.openTextDocument(document.uri, { encoding });
}

function warnOfChanges(document, encoding) {
  const name = vscode.workspace.asRelativePath(document.uri);
  const text = vscode.l10n.t('{0} was changed before it could be opened in its encoding, {1}. Undo the changes, close it, and open it again.', name, encoding);
  vscode.window.showWarningMessage(text);
}

async function warnOfBytes(document, bytes) {
  const found = await respelt(bytes, codec);
  if (found.length > 0) {
    const name = vscode.workspace.asRelativePath(document.uri);
    const text = vscode.l10n.t('{0} holds characters with two spellings in Shift_JIS (places: {1}). Saved from here they change to the other one; tip fmt and tip check --fix keep them.', name, found.length);
    vscode.window.showWarningMessage(text);
  }
  const content = await codec.decode(bytes);
  return found.map(({ start, end, from, to }) =>
    warning(place(content, start), place(content, end), vscode.l10n.t('The bytes {0} are saved as {1}.', from, to)),
  );
}

function warning(start, end, text) {
  const range = new vscode.Range(start.line, start.character, end.line, end.character);
  const made = new vscode.Diagnostic(range, text, vscode.DiagnosticSeverity.Warning);
  made.source = 'T.I.P.';
  return made;
}
