// The listing of the program, with the line that runs, those of its threads, and that of a run that is compared.

import { lineBefore, namesOf } from './comparison.js';
import { element, fixed, make } from './dom.js';
import { spark } from './spark.js';
import { whenSpoken, word } from './words.js';

const NAME = /[A-Za-z_][A-Za-z0-9_]*(?:\.[A-Za-z0-9]+)?/g;

export function source(player, plot) {
  const { recording } = player;
  const list = element('source');
  const tip = element('tip');
  const byName = new Map(recording.script.scalars.map((name, scalar) => [name, scalar]));
  const rows = recording.script.text.split(/\r\n|\r|\n/).map((text, n) => row(text, n + 1, recording, byName));
  while (rows.length > 1 && !rows.at(-1).querySelector('code').textContent) rows.pop();
  list.replaceChildren(...rows);
  list.addEventListener('click', ({ target }) => {
    const name = target.closest('[data-scalar]');
    if (name) return plot(Number(name.dataset.scalar));
    const line = target.closest('li');
    if (line) goToLine(player, Number(line.value));
  });
  // Tab reaches one line, and the arrow keys reach the others from there.
  const lines = rows.filter((row) => row.matches('.step')).map((row) => row.firstElementChild);
  const rove = (to) => {
    lines.forEach((button) => (button.tabIndex = button === to ? 0 : -1));
    return to;
  };
  rove(lines[0]);
  list.addEventListener('focusin', ({ target }) => lines.includes(target) && rove(target));
  list.addEventListener('keydown', (event) => {
    if (!event.target.matches('button')) return;
    if (event.key === 'Enter') event.stopPropagation();
    const way = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    const next = way && lines[lines.indexOf(event.target) + way];
    if (!next) return;
    event.preventDefault();
    rove(next).focus();
  });
  list.addEventListener('pointerover', ({ target }) => showTip(target.closest('[data-scalar]')));
  list.addEventListener('pointerleave', () => showTip(undefined));

  function showTip(name) {
    tip.hidden = !name;
    if (!name) return;
    const value = recording.at(`set.${name.dataset.scalar}`, player.cycle);
    const text = `${recording.script.scalars[name.dataset.scalar]} = ${value === undefined ? word('unassigned') : shown(value)}`;
    tip.replaceChildren(text, spark(recording, Number(name.dataset.scalar), player.cycle));
    const place = name.getBoundingClientRect();
    tip.style.left = `${Math.min(place.left, innerWidth - tip.offsetWidth - 8)}px`;
    tip.style.top = `${Math.max(place.top - tip.offsetHeight - 6, 4)}px`;
  }

  whenSpoken(() => {
    for (const button of list.querySelectorAll('li > button')) {
      const never = button.parentElement.classList.contains('idle');
      button.setAttribute('aria-label', `${word('line')} ${button.textContent}${never ? `, ${word('never')}` : ''}`);
    }
  });
  // All rows have the height of the first one. The sizes are measured once, since a measurement in every frame would force a
  // layout.
  const size = { top: 0, row: 0, shown: 0, from: 0 };
  const measure = () => {
    const [{ offsetTop: top, offsetHeight: row }, { clientHeight: shown, scrollTop: from }] = [rows[0], list];
    Object.assign(size, { top, row, shown, from });
  };
  const intoView = () => {
    const top = lit && size.top + size.row * (lit.value - 1);
    if (top < size.from + 40 || top > size.from + size.shown - 60) list.scrollTop = size.from = Math.max(top - size.shown * 0.4, 0);
  };
  list.addEventListener('scroll', () => (size.from = list.scrollTop), { passive: true });
  new ResizeObserver(() => {
    measure();
    intoView();
  }).observe(list);
  let lit;
  const light = () => {
    const line = recording.markedLineAt(player.cycle);
    const stopped = recording.isStoppedAt(player.cycle);
    if (lit?.value === line && lit.classList.contains('stopped') === stopped) return;
    lit?.removeAttribute('aria-current');
    lit?.classList.remove('lit', 'stopped');
    lit = rows[line - 1];
    if (!lit) return;
    lit.classList.toggle('stopped', stopped);
    lit.classList.add('lit');
    lit.setAttribute('aria-current', 'true');
    intoView();
  };
  let others = [];
  const lightThreads = () => {
    const threads = recording.threadsAt(player.cycle);
    if (player.other) {
      const [, { recording: other, cycle }] = player.runs;
      threads.push({ name: namesOf([recording, other])[1], line: lineBefore(player.changes, other.markedLineAt(cycle)) });
    }
    for (const row of others) delete row.dataset.threads;
    others = [];
    for (const { name, line } of threads) {
      const row = rows[line - 1];
      if (!row) continue;
      row.dataset.threads = [row.dataset.threads, name].filter(Boolean).join(' ');
      others.push(row);
    }
  };
  player.onRest(light);
  player.onRest(lightThreads);
}

/** Formats a value with few digits. */
export function shown(value) {
  return Number.isInteger(value) ? String(value) : fixed(value, Math.abs(value) < 10 ? 3 : 2);
}

/** Goes to the next cycle in which one of the runs, the first one by default, runs a line. */
export function goToLine(player, line, run = 0) {
  const { recording, cycle: now } = player.runs[run];
  const cycle = recording.nextRunOf(line, now);
  if (cycle === undefined) return;
  player.pause();
  player.goToMoment({ cycle, run });
}

function row(text, number, recording, byName) {
  const code = make('code');
  const comment = text.indexOf('//');
  const statement = comment < 0 ? text : text.slice(0, comment);
  let at = 0;
  for (const { 0: name, index } of statement.matchAll(NAME)) {
    const scalar = byName.get(name.toUpperCase());
    if (scalar === undefined) continue;
    code.append(statement.slice(at, index), made(name, scalar));
    at = index + name.length;
  }
  code.append(statement.slice(at));
  if (comment >= 0) code.append(make('span', { className: 'comment', textContent: text.slice(comment) }));
  const runs = recording.stepsOfLine.has(number);
  const button = make('button', { type: 'button', textContent: number, tabIndex: -1, disabled: !runs });
  return make('li', { value: number, className: runs ? 'step' : 'idle' }, button, code);
}

function made(name, scalar) {
  const span = make('span', { className: 'variable', textContent: name });
  span.dataset.scalar = scalar;
  return span;
}
