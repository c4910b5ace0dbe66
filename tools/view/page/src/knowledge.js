// Hover texts and completions of the editor, from the session.

import { autocompletion, completionKeymap, snippet } from '@codemirror/autocomplete';
import { hoverTooltip, keymap, tooltips } from '@codemirror/view';
import { make } from './dom.js';
import { spoken } from './words.js';

/** The word before the cursor. */
const BEGUN = /[A-Za-z_][\w.]*$/;

/**
 * Returns the extensions of the editor. `ask(question)` resolves to the answer about the present text, or to nothing.
 * `valueAt(place)` returns the value of the variable there as { from, to, text }, or nothing.
 */
export function knowledge(ask, valueAt) {
  return [
    hoverTooltip((view, place) => hover(view.state.doc, place, ask, valueAt)),
    autocompletion({ override: [(context) => offers(context, ask)], icons: false, positionInfo: beside }),
    keymap.of(completionKeymap),
    // Tooltips stay within the editor, since its section clips them.
    tooltips({ tooltipSpace: ({ dom }) => dom.getBoundingClientRect() }),
  ];
}

/** Places the description of a completion below or above the list, so that it covers none of it. */
function beside(view, list, option, info, space) {
  const height = info.bottom - info.top;
  const below = list.bottom + height <= space.bottom || list.top - height < space.top;
  return { style: `left: 0; ${below ? 'top' : 'bottom'}: ${list.bottom - list.top}px; max-width: ${Math.min(space.right - list.left, 400)}px` };
}

async function hover(doc, place, ask, valueAt) {
  const value = valueAt(place);
  const known = (await ask({ do: 'hover', at: positionOf(doc, place) }))?.hover;
  if (!value && !known) return null;
  const [pos, end] = value ? [value.from, value.to] : [placeOf(doc, known.from), placeOf(doc, known.to)];
  const parts = [...(value ? [make('p', { className: 'value', textContent: value.text })] : []), ...(known ? paragraphs(known.text[spoken()]) : [])];
  return { pos, end, above: true, create: () => ({ dom: make('div', { className: 'known' }, ...parts) }) };
}

async function offers(context, ask) {
  const begun = context.matchBefore(BEGUN);
  if (!begun && !context.explicit) return null;
  const { doc } = context.state;
  const found = (await ask({ do: 'complete', at: positionOf(doc, context.pos) }))?.offers ?? [];
  const written = begun?.text.toUpperCase();
  const isWhole = found.some(({ label }) => label.toUpperCase() === written);
  if (context.aborted || !found.length || (isWhole && !context.explicit)) return null;
  return {
    from: placeOf(doc, found[0].from),
    options: found.map(({ label, detail, description, text, fills }) => ({
      label,
      detail: detail === label ? undefined : detail,
      info: description[spoken()] || undefined,
      apply: fills ? snippet(fields(text)) : text,
    })),
  };
}

/** Converts a snippet of the Language Server Protocol for CodeMirror, which has no choices and no final place. */
function fields(text) {
  return text.replace(/\$\{(\d+)\|([^,|]*)[^|]*\|\}/g, '${$1:$2}').replace(/\$0/g, '${99}');
}

/** Returns a place of the text as sessions write it: line and column from 1. */
export function positionOf(doc, place) {
  const { number, from } = doc.lineAt(place);
  return [number, place - from + 1];
}

export function placeOf(doc, [line, column]) {
  if (line > doc.lines) return doc.length;
  const { from, to } = doc.line(Math.max(line, 1));
  return Math.min(from + column - 1, to);
}

/** Renders the Markdown of hover texts: code, lists, paragraphs. */
function paragraphs(text) {
  const blocks = text.split(/```\w*\n([^]*?)\n```\n*/);
  return blocks.flatMap((block, n) => (n % 2 ? [make('pre', { textContent: block })] : block.split(/\n{2,}/).filter(Boolean).map(paragraph)));
}

function paragraph(text) {
  if (!text.startsWith('- ')) return make('p', { textContent: text.trim() });
  const items = text.trim().split(/^- /m).filter(Boolean);
  return make('ul', {}, ...items.map((item) => make('li', { textContent: item.trim() })));
}
