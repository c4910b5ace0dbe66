// The editor of the program of a live run, with findings, the line that runs, and values under the pointer.

import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { lintGutter, lintKeymap, setDiagnostics } from '@codemirror/lint';
import { ChangeSet, EditorState, StateEffect, StateField, Transaction } from '@codemirror/state';
import { Decoration, EditorView, MatchDecorator, ViewPlugin, drawSelection, keymap, lineNumbers } from '@codemirror/view';
import { element, make } from './dom.js';
import { knowledge, placeOf } from './knowledge.js';
import { shown } from './source.js';
import { spoken, whenSpoken, word } from './words.js';

/** Pause after the last key until the text is sent, ms. */
const QUIET = 150;
/** Time between two scrolls to the line that runs, ms. */
const CALM = 400;
const NAME = /[A-Za-z_][A-Za-z0-9_]*(?:\.[A-Za-z0-9]+)?/g;

const lightLine = StateEffect.define();
const lit = StateField.define({
  create: () => Decoration.none,
  update(lines, transaction) {
    let now = lines.map(transaction.changes);
    for (const effect of transaction.effects) {
      if (!effect.is(lightLine)) continue;
      const { at, threads } = effect.value;
      const marks = threads.map(({ at, name }) => Decoration.line({ class: 'thread', attributes: { 'data-threads': name } }).range(at));
      if (at !== undefined) marks.push(Decoration.line({ class: 'lit', attributes: { 'aria-current': 'true' } }).range(at));
      now = Decoration.set(marks, true);
    }
    return now;
  },
  provide: (field) => EditorView.decorations.from(field),
});

const comment = new MatchDecorator({ regexp: /\/\/.*/g, decoration: Decoration.mark({ class: 'comment' }) });
const comments = ViewPlugin.fromClass(
  class {
    constructor(view) {
      this.decorations = comment.createDeco(view);
    }

    update(update) {
      this.decorations = comment.updateDeco(update, this.decorations);
    }
  },
  { decorations: (plugin) => plugin.decorations },
);

const look = EditorView.theme({
  '&': { height: '100%', fontSize: '13px', color: 'var(--text)', backgroundColor: 'var(--card)' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': { fontFamily: 'ui-monospace, "Cascadia Mono", Menlo, Consolas, "Noto Sans Mono CJK JP", "Noto Sans CJK JP", monospace', lineHeight: '1.55' },
  '.cm-content': { caretColor: 'var(--text)', padding: '6px 0' },
  '.cm-cursor': { borderLeftColor: 'var(--text)' },
  '.cm-gutters': { backgroundColor: 'var(--card)', color: 'var(--muted)', border: 'none' },
  '.cm-lineNumbers .cm-gutterElement': { minWidth: '34px', padding: '0 10px 0 4px' },
  '.cm-selectionBackground, &.cm-focused .cm-selectionBackground': { backgroundColor: 'var(--accent-soft) !important' },
  '.lit': { backgroundColor: 'var(--lit)', boxShadow: 'inset 3px 0 var(--accent)' },
  '.thread': { boxShadow: 'inset 3px 0 var(--good)' },
  // The names stand at the end of the line, and stay visible if the line is wider than the editor.
  '.thread::after': { content: 'attr(data-threads)', display: 'inline-block', position: 'sticky', right: '8px', marginLeft: '24px', padding: '0 6px', borderRadius: '4px', backgroundColor: 'var(--card)', fontSize: '11px', color: 'var(--good)' },
  '.comment': { color: 'var(--good)' },
  '.cm-tooltip': { backgroundColor: 'var(--card)', color: 'var(--text)', border: '1px solid var(--line)', borderRadius: '6px', maxWidth: '420px', padding: '2px 6px' },
  '.known': { fontFamily: 'system-ui, "Hiragino Sans", "Noto Sans JP", "Noto Sans CJK JP", sans-serif', padding: '2px 2px' },
  '.known p, .known ul, .known pre': { margin: '3px 0' },
  '.known ul': { paddingLeft: '16px', color: 'var(--muted)' },
  '.known pre, .value': { fontFamily: 'ui-monospace, "Cascadia Mono", Menlo, Consolas, monospace', whiteSpace: 'pre-wrap' },
  '.cm-tooltip-autocomplete': { padding: '0' },
  '.cm-tooltip-autocomplete > ul': { fontFamily: 'ui-monospace, "Cascadia Mono", Menlo, Consolas, monospace' },
  '.cm-tooltip-autocomplete > ul > li[aria-selected]': { backgroundColor: 'var(--accent)', color: 'var(--card)' },
  '.cm-completionDetail': { fontStyle: 'normal', color: 'var(--muted)' },
  'li[aria-selected] .cm-completionDetail': { color: 'inherit' },
  '.cm-diagnostic': { borderLeft: 'none', padding: '3px 4px', whiteSpace: 'normal' },
  '.cm-lintRange-error': { backgroundImage: 'none', textDecoration: 'underline wavy var(--bad)', textUnderlineOffset: '3px' },
  '.cm-lintRange-warning': { backgroundImage: 'none', textDecoration: 'underline wavy var(--warn)', textUnderlineOffset: '3px' },
});

/** The editor, with the text of this page and that of the session. */
export class Editor {
  constructor(requests, player) {
    this.requests = requests;
    this.player = player;
    this.own = crypto.getRandomValues(new Uint32Array(2)).join('-');
    this.version = 0;
    this.findings = [];
    // Callbacks for the answer of the session to an edit.
    this.behind = [];
    // Keys in the editor are not shortcuts of the page.
    element('editor').addEventListener('keydown', (event) => event.stopPropagation());
    this.view = new EditorView({ parent: shadow(element('editor')), root: element('editor').shadowRoot, state: this.fresh('') });
    whenSpoken(() => {
      this.view.contentDOM.setAttribute('aria-label', word('source'));
      this.showFindings();
    });
  }

  fresh(text) {
    const keys = [
      { key: 'Mod-s', run: () => Boolean(element('save')?.click() ?? true) },
      { key: 'Mod-Enter', run: () => Boolean(this.ask({ do: 'restart' })) },
    ];
    return EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(), lintGutter(), history(), drawSelection(), comments, lit, look,
        knowledge((question) => this.inquire(question), (place) => this.valueAt(place)),
        keymap.of([...keys, ...defaultKeymap, ...historyKeymap, ...lintKeymap]),
        EditorView.contentAttributes.of({ tabindex: '0' }),
        EditorView.updateListener.of((update) => this.updated(update)),
      ],
    });
  }

  get text() {
    return this.view.state.doc.toString();
  }

  /** Returns the first constant that the text assigns to a variable, with its line and place; undefined if there is none. */
  constantOf(name) {
    const literal = name.replace('.', '\\.');
    const found = new RegExp(`^([ \\t]*(?:[a-z]\\w*:[ \\t]*)?${literal}[ \\t]*=[ \\t]*)([-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:e[-+]?\\d+)?)(?=[ \\t]*(?:$|//|;))`, 'im').exec(this.text);
    if (!found) return undefined;
    const from = found.index + found[1].length;
    return { value: Number(found[2]), line: this.view.state.doc.lineAt(from).number, from, to: from + found[2].length };
  }

  /** Writes another value in the place of the first constant that the text assigns to a variable. Returns what people are told. */
  writeConstant(name, value) {
    const { from, to, line } = this.constantOf(name);
    this.view.dispatch({ changes: { from, to, insert: String(value) } });
    return word('written', line, `${name} = ${value}`);
  }

  /**
   * Sends the present text, so that the session has it before the next request. Resolves to false if the text changed
   * meanwhile.
   */
  async catchUp() {
    const { text } = this;
    this.sendText();
    // An earlier edit is not answered yet; this text follows it.
    if (!this.reaches(text)) await new Promise((go) => this.behind.push(go));
    return text === this.text && this.reaches(text);
  }

  /** Sends a request after the present text. */
  async ask(request) {
    await this.catchUp();
    this.requests.send(request);
  }

  /** Resolves to the answer to a question about the present text; to nothing if the text changed before the session had it. */
  async inquire(question) {
    return (await this.catchUp()) ? this.requests.ask(question) : undefined;
  }

  /** Returns true if the session has a text, or will have it before the next request. */
  reaches(text) {
    return text === (this.waits ? this.sent : this.known);
  }

  updated({ docChanged, changes, transactions }) {
    if (!docChanged) return;
    this.since = this.since?.compose(changes);
    if (transactions.some((one) => one.annotation(Transaction.remote))) return;
    clearTimeout(this.due);
    this.due = setTimeout(() => this.sendText(), QUIET);
  }

  sendText() {
    clearTimeout(this.due);
    const { text } = this;
    if (this.waits || text === this.known || !this.version) return;
    [this.waits, this.sent] = [true, text];
    this.requests.send({ do: 'edit', text, base: this.version, by: this.own });
  }

  /** Takes the text of the session: the one that was sent, another viewer's, or the file's. */
  takeText(update) {
    this.follow(update);
    this.behind.splice(0).forEach((go) => go());
  }

  follow({ version, by, text }) {
    const edited = this.version && this.text !== (this.waits ? this.sent : this.known);
    [this.version, this.known, this.waits] = [version, text, false];
    if (text === this.text) return;
    if (edited && by === this.own) {
      this.sendText();
      return;
    }
    this.replace(text);
  }

  /** Replaces the text, but keeps its common beginning and end. The first text of a session is another program. */
  replace(text) {
    if (this.version === 1) this.view.setState(this.fresh(text));
    const { text: old } = this;
    let [from, end] = [0, 0];
    const most = Math.min(old.length, text.length);
    while (from < most && old[from] === text[from]) from++;
    while (end < most - from && old[old.length - 1 - end] === text[text.length - 1 - end]) end++;
    const changes = { from, to: old.length - end, insert: text.slice(from, text.length - end) };
    this.view.dispatch({ changes, annotations: Transaction.remote.of(true) });
    this.align();
  }

  /** Ends the wait for an edit that was refused. The text of the session follows. */
  refused() {
    this.waits = false;
  }

  /** Takes the script of a run that begins. Its lines are marked in the text. */
  running(script) {
    const lines = (text) => text.replace(/\r\n?/g, '\n');
    this.runs = EditorState.create({ doc: lines(script.text) }).doc;
    this.since = undefined;
    this.align();
    this.names = new Map(script.scalars.map((name, scalar) => [name, scalar]));
    this.line = undefined;
  }

  /** Begins to follow changes, if the text is the one that runs: they tell where its lines are later. */
  align() {
    if (!this.runs?.eq(this.view.state.doc)) return;
    const { line, threads } = this;
    this.since = ChangeSet.empty(this.runs.length);
    this.line = undefined;
    this.light(line, threads);
  }

  /** Marks the line that runs and those of threads, at their present places in the text. */
  light(line, threads = []) {
    if (line === this.line && JSON.stringify(threads) === JSON.stringify(this.threads)) return;
    [this.line, this.threads] = [line, threads];
    const placeOf = (line) => {
      const known = this.since && line <= this.runs.lines;
      return known ? this.view.state.doc.lineAt(this.since.mapPos(this.runs.line(line).from, 1)).from : undefined;
    };
    const at = placeOf(line);
    const marks = threads.map(({ name, line }) => ({ name, at: placeOf(line) })).filter(({ at }) => at !== undefined);
    this.view.dispatch({ effects: lightLine.of({ at, threads: marks }) });
    this.lit = at;
    this.reveal ??= setTimeout(() => this.showLit(), CALM);
  }

  /** Scrolls to the line that runs, unless it is visible or the editor has the focus. */
  showLit() {
    this.reveal = undefined;
    const at = Math.min(this.lit ?? 0, this.view.state.doc.length);
    if (this.lit === undefined || this.view.hasFocus || this.isVisible(at)) return;
    // Scrolls the text alone, not the page around it.
    const { scrollDOM } = this.view;
    scrollDOM.scrollTop = this.view.lineBlockAt(at).top - scrollDOM.clientHeight * 0.4;
  }

  isVisible(place) {
    const { top, bottom } = this.view.lineBlockAt(place);
    const { scrollTop, clientHeight } = this.view.scrollDOM;
    return top > scrollTop + 20 && bottom < scrollTop + clientHeight - 40;
  }

  takeFindings({ version, findings }) {
    [this.checked, this.findings] = [version, findings];
    this.showFindings();
  }

  showFindings() {
    const { doc } = this.view.state;
    const at = (place) => placeOf(doc, place);
    const found = this.findings.map(({ level, code, from, to, text, help }) => ({
      from: at(from),
      to: Math.max(at(to), at(from)),
      severity: level,
      source: code,
      message: text[spoken()] + (help ? ` – ${help[spoken()]}` : ''),
    }));
    this.view.dispatch(setDiagnostics(this.view.state, found));
    const rows = found.map(({ from, severity, source, message }, n) => {
      const button = make('button', { type: 'button', className: `problem ${severity}` });
      const [line, column] = this.findings[n].from;
      button.append(make('b', { textContent: `${line}:${column}` }), make('span', { textContent: message }), make('small', { textContent: source }));
      button.addEventListener('click', () => {
        this.view.dispatch({ selection: { anchor: Math.min(from, this.view.state.doc.length) }, scrollIntoView: true });
        this.view.focus();
      });
      return make('li', {}, button);
    });
    element('problems').replaceChildren(...rows);
    element('problems').hidden = !rows.length;
  }

  /** Returns span and value of the variable at a place. */
  valueAt(place) {
    const line = this.view.state.doc.lineAt(place);
    for (const { 0: name, index } of line.text.matchAll(NAME)) {
      const [from, to] = [line.from + index, line.from + index + name.length];
      const scalar = this.names?.get(name.toUpperCase());
      if (place < from || place > to || scalar === undefined) continue;
      const value = this.player.recording.at(`set.${scalar}`, this.player.cycle);
      return { from, to, text: `${name.toUpperCase()} = ${value === undefined ? word('unassigned') : shown(value)}` };
    }
    return undefined;
  }
}

/** Creates a shadow tree: the page's policy does not allow the styles of the editor elsewhere. */
function shadow(host) {
  return host.attachShadow({ mode: 'open' });
}
