// The program, to be edited, with what is found in it at its place.

import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { lintGutter, lintKeymap, setDiagnostics } from '@codemirror/lint';
import { EditorState } from '@codemirror/state';
import { Decoration, EditorView, MatchDecorator, ViewPlugin, drawSelection, keymap, lineNumbers } from '@codemirror/view';
import { word } from './words.js';

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
  '.cm-scroller': { fontFamily: 'ui-monospace, "Cascadia Mono", Menlo, Consolas, "Noto Sans Mono CJK JP", "Noto Sans CJK JP", monospace', lineHeight: '1.5' },
  '.cm-content': { caretColor: 'var(--text)' },
  '.cm-cursor': { borderLeftColor: 'var(--text)' },
  '.cm-gutters': { backgroundColor: 'var(--card)', color: 'var(--muted)', border: 'none' },
  '.cm-selectionBackground, &.cm-focused .cm-selectionBackground': { backgroundColor: 'var(--accent-soft) !important' },
  '.comment': { color: 'var(--good)' },
  '.cm-tooltip': { backgroundColor: 'var(--card)', color: 'var(--text)', border: '1px solid var(--line)', maxWidth: '420px' },
  '.cm-diagnostic': { borderLeft: 'none', whiteSpace: 'normal' },
  '.cm-lintRange-error': { backgroundImage: 'none', textDecoration: 'underline wavy var(--bad)', textUnderlineOffset: '3px' },
  '.cm-lintRange-warning': { backgroundImage: 'none', textDecoration: 'underline wavy var(--warn)', textUnderlineOffset: '3px' },
});

/** `changed(byHand)` is called after each change of the text, `run()` at Ctrl+Enter. */
export class Editor {
  constructor(parent, changed, run) {
    this.extensions = [
      lineNumbers(), history(), drawSelection(), lintGutter(), comments, look,
      keymap.of([{ key: 'Mod-Enter', run: () => run() ?? true }, ...defaultKeymap, ...historyKeymap, ...lintKeymap]),
      EditorView.contentAttributes.of({ 'aria-label': word('program'), spellcheck: 'false', autocapitalize: 'off' }),
      EditorView.updateListener.of((update) => {
        if (update.docChanged) changed();
      }),
    ];
    // In a tree of its own the editor's styles are objects, and no elements that the page would have to allow.
    const root = parent.attachShadow({ mode: 'open' });
    this.view = new EditorView({ parent: root, root });
  }

  get text() {
    return this.view.state.doc.toString();
  }

  /** Another text, without what could be undone. */
  show(text) {
    this.view.setState(EditorState.create({ doc: text, extensions: this.extensions }));
  }

  offset({ line, utf16 }) {
    const { doc } = this.view.state;
    const row = doc.line(Math.min(Math.max(line, 1), doc.lines));
    return Math.min(row.from + utf16 - 1, row.to);
  }

  /** Underlines findings { range, level, reason, help }. */
  mark(findings) {
    const marks = findings.map(({ range, level, reason, help }) => {
      const [from, to] = [this.offset(range.start), this.offset(range.end)];
      return { from, to: Math.max(from, to), severity: level, message: help ? `${reason}\n${help}` : reason };
    });
    this.view.dispatch(setDiagnostics(this.view.state, marks));
  }

  /** To the place of a finding. */
  goTo({ range }) {
    const at = this.offset(range.start);
    this.view.dispatch({ selection: { anchor: at }, scrollIntoView: true });
    this.view.focus();
  }
}
