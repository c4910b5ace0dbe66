// The figures of a run, each with a link to its moment. For two runs the table has their differences.

import { namesOf } from './comparison.js';
import { element, fixed, make } from './dom.js';
import { goToLine } from './source.js';
import { word } from './words.js';

/**
 * Returns the rows of the table: name, text, number and unit for comparisons, the better direction (1 is more), and the
 * moment.
 */
function rows(summary) {
  const found = [];
  const add = (key, text, { value, unit = '', better, at, of = '' } = {}) => found.push({ key, of, text, value, unit, better, at });
  const { travel, falls, energy } = summary;
  if (travel) {
    const ways = [[travel.forward_mm, 'ahead', 'behind'], [travel.right_mm, 'right', 'left'], [travel.up_mm, 'up', 'down']];
    add('travel', ways.map(([value, one, other]) => sense(value, 'mm', one, other)).join(', '), { value: travel.forward_mm, unit: 'mm', better: 1 });
    add('turnOf', sense(travel.turn_deg, '°', 'left', 'right'), { value: travel.turn_deg, unit: '°' });
    add('averageSpeed', sense(travel.speed_mm_s, 'mm/s', 'ahead', 'behind'), { value: travel.speed_mm_s, unit: 'mm/s', better: 1 });
  }
  if (falls) {
    const { count, upright, first_kind: kind, first } = falls;
    const many = kind === 'would-fall' && upright === count ? word('wouldFalls', count) : upright ? word('uprightFalls', count, upright) : String(count);
    add('falls', count ? many : word('none'), { value: count, better: -1, at: first });
  }
  const { collisions } = summary;
  const peak = (key, one, better, most) => {
    if (!one) return;
    const text = `${word(most, `${fixed(one.value, key === 'contactForce' ? 2 : 1)} ${one.unit}`)}${one.limit == null ? '' : ` (${word('limit', one.limit)})`}`;
    add(key, text, { ...one, better, of: one.of ?? '' });
    // The figure itself has the keys of its moment.
    found.at(-1).at = one;
  };
  peak('margin', summary.margin, 1, 'atLeast');
  peak('clearance', summary.clearance, 1, 'atLeast');
  if (collisions) add('collisions', collisions.cycles ? word('inCycles', collisions.cycles) : word('none'), { value: collisions.cycles, better: -1, at: collisions.first });
  peak('slip', summary.slip, -1, 'atMost');
  peak('jointRate', summary.rate, -1, 'atMost');
  peak('jointTorque', summary.torque, -1, 'atMost');
  if (energy) {
    add('energy', `${fixed(energy.work_j, 1)} J`, { value: energy.work_j, unit: 'J', better: -1 });
    if (energy.cost_of_transport !== null) add('cost', fixed(energy.cost_of_transport, 2), { value: energy.cost_of_transport, better: -1 });
  }
  for (const lift of summary.lifts) peak('lift', lift, 1, 'atMost');
  for (const force of summary.forces) peak('contactForce', force, -1, 'atMost');
  for (const wait of summary.waits) {
    const [first, last] = wait.lines;
    const place = first === last ? `${word('line')} ${first}` : `${word('line')} ${first}–${last}`;
    add('waited', `${fixed(wait.length_s, 1)} s: ${place}${wait.until ? `, ${wait.until}` : ''}`, { at: wait, value: wait.length_s, unit: 's', of: place });
  }
  return found;
}

/** Formats an amount with its direction. */
function sense(value, unit, positive, negative) {
  const text = fixed(value, 1);
  return `${text.replace('-', '')} ${unit} ${word(text.startsWith('-') ? negative : positive)}`;
}

/** Shows the figures of a run, or of two with the difference of their programs. */
export function showFigures(player, summary, other) {
  const { recording } = player;
  const link = (at, run) => {
    const button = make('button', { type: 'button', textContent: `${fixed(at.time_s, 3)} s`, title: `${word('cycle')} ${at.cycle}, ${word('line')} ${at.line}` });
    button.addEventListener('click', () => {
      player.pause();
      player.goToMoment({ cycle: at.cycle, run });
    });
    return button;
  };
  const place = (at) => `${word('cycle')} ${at.cycle}, ${word('line')} ${at.line}`;
  if (!other) {
    const lines = rows(summary).map(({ key, of, text, at }) => {
      const name = make('th', { scope: 'row', textContent: [word(key), key === 'waited' ? '' : of].filter(Boolean).join(' ') });
      return make('tr', {}, name, make('td', { className: 'figure' }, text), make('td', { className: 'moment' }, ...(at ? [link(at, 0), ` ${place(at)}`] : [])));
    });
    return element('figures').replaceChildren(...lines);
  }
  const [own, others] = [summary, other.summary].map((one) => [{ key: 'duration', of: '', text: `${fixed(one.time_s, 3)} s`, value: one.time_s, unit: 's' }, ...rows(one)]);
  // Figures of the same name are compared; an object or a finger is part of the name, a foot or a joint is not.
  const name = ({ key, of }) => [word(key), ['lift', 'contactForce', 'waited'].includes(key) ? of : ''].filter(Boolean).join(' ');
  const cell = (row, run) => {
    if (!row) return make('td', { className: 'figure' }, '–');
    const moment = row.at ? [make('br'), link(row.at, run), ` ${word('line')} ${row.at.line}`] : [];
    return make('td', { className: 'figure' }, [row.text, name(row).endsWith(row.of) ? '' : row.of].filter(Boolean).join(' '), ...moment);
  };
  const names = [...new Set([...own, ...others].map(name))];
  const lines = names.map((named) => {
    const pair = [own, others].map((rows) => rows.find((row) => name(row) === named));
    return make('tr', {}, make('th', { scope: 'row', textContent: named }), ...pair.map(cell), difference(...pair));
  });
  const head = ['', ...namesOf([recording, other]), word('difference')].map((textContent) => make('th', { scope: 'col', textContent }));
  element('figures').replaceChildren(make('tr', {}, ...head), ...lines);
  return showChanges(player);
}

/** Creates the cell with the second number minus the first one, and words that tell if that is better, and why. */
function difference(row, same) {
  const cell = make('td', { className: 'figure' });
  if (typeof row?.value !== 'number' || typeof same?.value !== 'number') return cell;
  const { key, unit, better } = row;
  const change = same.value - row.value;
  const text = fixed(change, { cost: 2, falls: 0, collisions: 0, duration: 3 }[key] ?? 1);
  cell.textContent = `${change > 0 && Number(text) !== 0 ? '+' : ''}${text} ${unit}`;
  if (!better || Number(text) === 0) return cell;
  const good = change * better > 0;
  const verdict = make('span', { className: good ? 'good' : 'bad', textContent: word(good ? 'better' : 'worse') });
  cell.append(make('br'), verdict, make('br'), make('small', { textContent: word(better > 0 ? 'moreIsBetter' : 'lessIsBetter') }));
  return cell;
}

/** Shows the lines in which two programs differ. */
function showChanges(player) {
  const runs = [player.recording, player.other];
  const names = namesOf(runs);
  const list = (run, texts, first) => texts.map((text, n) => {
    const line = first + n;
    const number = make('button', { type: 'button', textContent: line, title: `${names[run]}, ${word('line')} ${line}`, disabled: !runs[run].stepsOfLine.has(line) });
    number.addEventListener('click', () => goToLine(player, line, run));
    return make('li', { className: run ? 'added' : 'removed' }, number, make('b', { textContent: '−+'[run] }), make('code', { textContent: text }));
  });
  const rows = player.changes.flatMap(({ line, removed, place, added }) => [...list(0, removed, line), ...list(1, added, place)]);
  element('changes-title').textContent = word(rows.length ? 'programsDiffer' : 'programsEqual', ...names);
  element('changes').replaceChildren(...rows);
}
