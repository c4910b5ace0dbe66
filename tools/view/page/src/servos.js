// What the servos of a robot measure, and how busy their bus is.

import { element, fixed, make } from './dom.js';
import { word } from './words.js';

const SVG = 'http://www.w3.org/2000/svg';
/** Size of a plot: px. A report, five of which come in a second, takes one. */
const [WIDTH, HEIGHT] = [240, 36];

/** The last values of a quantity, each as a bar from 0 to `most`; what exceeds it is cut off. */
function bars(values, most) {
  const picture = document.createElementNS(SVG, 'svg');
  Object.entries({ width: WIDTH, height: HEIGHT, viewBox: `0 0 ${WIDTH} ${HEIGHT}`, 'aria-hidden': 'true' }).forEach(([name, value]) => picture.setAttribute(name, value));
  const path = document.createElementNS(SVG, 'path');
  const level = (value) => (Math.min(value / most, 1) * HEIGHT).toFixed(1);
  path.setAttribute('d', values.map((value, n) => (value > 0 ? `M${n + 0.5} ${HEIGHT}v-${level(value)}` : '')).join(''));
  picture.append(path);
  return picture;
}

export class Servos {
  /** Mean time on the bus and number of late cycles, by report. */
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
    const cell = (value, decimals, times = 1) => make('td', { textContent: value === null ? '?' : fixed(value * times, decimals) });
    const rows = servos.map(({ joint, id, angle, load, voltage, temperature, missing }) =>
      make('tr', {}, make('th', { scope: 'row', textContent: joint }), make('td', { textContent: id }), cell(angle, 1), cell(load, 0, 100), cell(voltage, 1), cell(temperature, 0), cell(missing, 0)),
    );
    element('servo-rows').replaceChildren(...rows);
    element('servo-bus').textContent = word('servoBus', answers[1], answers[0]);
    element('bus-time').replaceChildren(word('busTime', bus === null ? '?' : fixed(bus, 1), fixed(period, 0)), bars(this.times, period));
    element('late-cycles').replaceChildren(word('lateCycles', late), bars(this.lates, Math.max(...this.lates, 1)));
  }
}
