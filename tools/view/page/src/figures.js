// The figures of a run, each with a link to its moment. For two runs the table has their differences.

import { element, fixed, make } from './dom.js';
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
    add('turnOf', sense(travel.turn_deg, '°', 'left', 'right'));
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
    add('waited', `${fixed(wait.length_s, 1)} s: ${place}${wait.until ? `, ${wait.until}` : ''}`, { at: wait });
  }
  return found;
}

/** Formats an amount with its direction. */
function sense(value, unit, positive, negative) {
  const text = fixed(value, 1);
  return `${text.replace('-', '')} ${unit} ${word(text.startsWith('-') ? negative : positive)}`;
}

/** Shows the figures of a run, or of two. */
export function showFigures(player, summary, other) {
  const table = element('figures');
  const [own, others] = [rows(summary), other ? rows(other.summary) : []];
  const go = (at) => {
    const button = make('button', { type: 'button', textContent: `${fixed(at.time_s, 3)} s`, title: `${word('cycle')} ${at.cycle}, ${word('line')} ${at.line}` });
    button.addEventListener('click', () => {
      player.pause();
      player.goTo(at.cycle);
    });
    return button;
  };
  const lines = own.map((row) => {
    const { key, of, text, at } = row;
    const name = make('th', { scope: 'row', textContent: [word(key), of].filter(Boolean).join(' ') });
    const moment = at ? [go(at), ` ${word('cycle')} ${at.cycle}, ${word('line')} ${at.line}`] : [];
    const line = make('tr', {}, name, make('td', { className: 'figure' }, text), make('td', { className: 'moment' }, ...moment));
    if (other) {
      const same = others.find((one) => one.key === key && key !== 'waited' && (one.of === of || !['lift', 'contactForce'].includes(key)));
      line.append(make('td', { className: 'figure' }, same ? [same.text, ['slip', 'clearance'].includes(key) || key.startsWith('joint') ? same.of : ''].join(' ') : '–'), difference(row, same));
    }
    return line;
  });
  const head = other ? [make('tr', {}, ...['', player.recording.script.name, '', other.script.name, word('difference')].map((textContent) => make('th', { scope: 'col', textContent })))] : [];
  table.replaceChildren(...head, ...lines);
}

/** Creates the cell with the second number minus the first one, and a word that tells if that is better. */
function difference({ value, unit, better, key }, same) {
  const cell = make('td', { className: 'figure' });
  if (value === undefined || same?.value === undefined || value === null || same.value === null) return cell;
  const change = same.value - value;
  const text = fixed(change, key === 'cost' ? 2 : ['falls', 'collisions'].includes(key) ? 0 : 1);
  cell.textContent = `${change > 0 && Number(text) !== 0 ? '+' : ''}${text} ${unit} `;
  if (Number(text) === 0) return cell;
  const good = change * better > 0;
  cell.append(make('span', { className: good ? 'good' : 'bad', textContent: word(good ? 'better' : 'worse'), title: word(better > 0 ? 'moreIsBetter' : 'lessIsBetter') }));
  return cell;
}
