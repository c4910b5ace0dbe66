// The program, to be edited while it runs: its findings in place, the line that runs, values under the pointer.

import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { lintGutter, lintKeymap, setDiagnostics } from '@codemirror/lint';
import { ChangeSet, EditorState, StateEffect, StateField, Transaction } from '@codemirror/state';
import { Decoration, EditorView, MatchDecorator, ViewPlugin, drawSelection, keymap, lineNumbers } from '@codemirror/view';
import { element, make } from './dom.js';
import { knowledge, placeOf } from './knowledge.js';
import { shown } from './source.js';
import { spoken, whenSpoken, word } from './words.js';

/** How long one waits for the next key before the text is sent: ms. */
const QUIET = 150;
/** How long the lines stand still while the run jumps: ms. */
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
  // At the end of its line, and in sight where the line is longer than the editor is wide.
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

/** The text, as the session has it and as it stands here. */
export class Editor {
  constructor(requests, player) {
    this.requests = requests;
    this.player = player;
    this.own = crypto.getRandomValues(new Uint32Array(2)).join('-');
    this.version = 0;
    this.findings = [];
    // What goes on once the session has answered an edit.
    this.behind = [];
    // Its keys are not those of the page.
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

  /** Lets the session have the text as it stands before whatever is sent next; false if another one stands here then. */
  async catchUp() {
    const { text } = this;
    this.sendText();
    // What was sent before is still on its way; this text follows it.
    if (!this.reaches(text)) await new Promise((go) => this.behind.push(go));
    return text === this.text && this.reaches(text);
  }

  /** Sends a request about the text as it stands. */
  async ask(request) {
    await this.catchUp();
    this.requests.send(request);
  }

  /** The answer to a question about the text as it stands; nothing if it has changed before the session could have it. */
  async inquire(question) {
    return (await this.catchUp()) ? this.requests.ask(question) : undefined;
  }

  /** Whether the session has a text, or has it before whatever is sent now. */
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

  /** The session has this text: what was sent, or another viewer's, or the file's. */
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

  /** Puts a text in the place of the one here, keeping what both begin and end with; a session's first text is another program. */
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

  /** An edit was refused: the text of the session follows. */
  refused() {
    this.waits = false;
  }

  /** The text that stands here is the one that runs from now on, by its lines. */
  running(script) {
    const lines = (text) => text.replace(/\r\n?/g, '\n');
    this.runs = EditorState.create({ doc: lines(script.text) }).doc;
    this.since = undefined;
    this.align();
    this.names = new Map(script.scalars.map((name, scalar) => [name, scalar]));
    this.line = undefined;
  }

  /** From a text that is the one that runs, changes lead to where its lines are now. */
  align() {
    if (!this.runs?.eq(this.view.state.doc)) return;
    const { line, threads } = this;
    this.since = ChangeSet.empty(this.runs.length);
    this.line = undefined;
    this.light(line, threads);
  }

  /** Lights the line that runs and marks those of threads, wherever their text has gone. */
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

  /** Scrolls to the line that runs, not too often, and not under the hands of someone who writes. */
  showLit() {
    this.reveal = undefined;
    const at = Math.min(this.lit ?? 0, this.view.state.doc.length);
    if (this.lit === undefined || this.view.hasFocus || this.isVisible(at)) return;
    // Only the text moves, not the page that it is in.
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

  /** The value of the variable at a place. */
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

/** A tree of its own: its styles need no leave of the page's policy. */
function shadow(host) {
  return host.attachShadow({ mode: 'open' });
}
