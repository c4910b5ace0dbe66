// The table of servos with their measurements, and the plots of their bus.

import { element, fixed, make } from './dom.js';
import { word } from './words.js';

const SVG = 'http://www.w3.org/2000/svg';
/** Size of a plot, px. Each report takes one pixel. Five reports come in a second. */
const [WIDTH, HEIGHT] = [240, 36];

/** Draws the last values of a quantity, each as a bar from 0 to `most`. A larger value is cut off. */
function bars(values, most) {
  const picture = document.createElementNS(SVG, 'svg');
  Object.entries({ width: WIDTH, height: HEIGHT, viewBox: `0 0 ${WIDTH} ${HEIGHT}`, 'aria-hidden': 'true' }).forEach(([name, value]) => picture.setAttribute(name, value));
  const path = document.createElementNS(SVG, 'path');
  const level = (value) => (Math.min(value / most, 1) * HEIGHT).toFixed(1);
  path.setAttribute('d', values.map((value, n) => (value > 0 ? `M${n + 0.5} ${HEIGHT}v-${level(value)}` : '')).join(''));
  picture.append(path);
  return picture;
}

/** Shows the measurements of each servo. What is wrong with a servo stands below them. */
export function showServos(servos) {
  const cell = (value, decimals, times = 1) => make('td', { textContent: value === null ? '?' : fixed(value * times, decimals) });
  const rows = servos.flatMap(({ joint, id, angle, load, voltage, temperature, missing, problem }) => {
    const head = make('th', { scope: 'row', textContent: joint });
    const row = make('tr', {}, head, make('td', { textContent: id }), cell(angle, 1), cell(load, 0, 100), cell(voltage, 1), cell(temperature, 0), cell(missing, 0));
    return problem === null ? [row] : [row, make('tr', { className: 'bad' }, make('td', { colSpan: 7, textContent: problem }))];
  });
  element('servo-rows').replaceChildren(...rows);
}

export class Servos {
  /** The mean time on the bus and the number of late cycles, by report. */
  times = [];
  lates = [];
  late = 0;

  /** Takes the state of a robot. */
  take({ bus, late }) {
    // A new run counts anew.
    this.lates.push(Math.max(late - this.late, 0));
    this.times.push(bus ?? 0);
    this.late = late;
    for (const values of [this.times, this.lates]) if (values.length > WIDTH) values.shift();
  }

  show({ servos, answers, bus, late, period }) {
    showServos(servos);
    element('servo-bus').textContent = word('servoBus', answers[1], answers[0]);
    element('bus-time').replaceChildren(word('busTime', bus === null ? '?' : fixed(bus, 1), fixed(period, 0)), bars(this.times, period));
    element('late-cycles').replaceChildren(word('lateCycles', late), bars(this.lates, Math.max(...this.lates, 1)));
  }
}
