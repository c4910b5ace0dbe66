// Signals over time, and when each foot stands, all on one axis.

import uPlot from 'uplot';
import { colour, element, legColour, make } from './dom.js';
import { firstChoice, series, signalGroups } from './signals.js';
import { whenSpoken, word } from './words.js';

/** The width of what stands left of every plot: px. */
const GUTTER = 64;
const HEIGHT = 108;
const DASHES = [[], [6, 3], [2, 2], [8, 2, 2, 2]];

export class Plots {
  constructor(player) {
    this.player = player;
    this.recording = player.recording;
    this.box = element('plots');
    this.chosen = firstChoice(this.recording);
    this.range = [0, this.recording.duration / 1000];
    this.charts = [];
    this.gait = element('gait');
    this.gait.addEventListener('click', (event) => this.goTo(event.offsetX));
    whenSpoken(() => this.say());
    player.onRest(() => this.movePlayheads());
    new ResizeObserver(() => this.resize()).observe(this.box);
  }

  goTo(x) {
    const [from, to] = this.range;
    const share = (x - GUTTER) / Math.max(this.gait.clientWidth - GUTTER - 8, 1);
    this.player.pause();
    this.player.goToTime((from + share * (to - from)) * 1000);
  }

  /** The list in which one chooses. */
  listSignals() {
    const sets = this.groups.map(({ key, title, unit, signals }) => {
      const boxes = signals.map((signal) => {
        const box = make('input', { type: 'checkbox', checked: this.chosen.has(signal.key) });
        box.dataset.signal = signal.key;
        box.addEventListener('change', () => this.choose(signal.key, box.checked));
        return make('label', {}, box, signal.name());
      });
      return make('fieldset', { className: key === 'variable' ? 'wide' : '' }, make('legend', { textContent: unit ? `${word(title)} (${unit})` : word(title) }), ...boxes);
    });
    element('signal-list').replaceChildren(...sets);
  }

  choose(key, on) {
    if (on) this.chosen.add(key);
    else this.chosen.delete(key);
    this.build();
  }

  /** Plots a variable as well, and shows where. */
  showVariable(scalar) {
    const key = `variable.${scalar}`;
    this.chosen.add(key);
    this.listSignals();
    this.build();
    const chart = this.charts.find(({ group }) => group.key === 'variable');
    chart?.box.scrollIntoView({ block: 'nearest' });
  }

  build() {
    this.measure();
    this.charts.forEach(({ plot, box }) => {
      plot.destroy();
      box.remove();
    });
    this.charts = this.groups
      .map((group) => ({ group, signals: group.signals.filter(({ key }) => this.chosen.has(key)) }))
      .filter(({ signals }) => signals.length)
      .map(({ group, signals }) => this.chart(group, signals));
    this.drawGait();
    this.movePlayheads();
  }

  /** Another program, perhaps on another robot: its signals are other ones. */
  begin() {
    this.chosen = firstChoice(this.recording);
    this.zoomed = false;
    this.say();
  }

  say() {
    const title = this.recording.robot.body ? 'gait' : 'touch';
    element('gait-title').textContent = word(title);
    this.gait.setAttribute('aria-label', word(title));
    this.groups = signalGroups(this.recording);
    this.listSignals();
    this.build();
  }

  /** Shows the last time (ms) of a run that goes on. */
  follow(time) {
    const { duration, first } = this.recording;
    if (this.zoomed || !this.box.offsetParent) return;
    const begin = Math.max(duration - time, this.recording.endOf(first));
    this.charts.forEach(({ plot, signals }) => plot.setData(series(this.recording, signals, begin), false));
    this.setRange([begin / 1000, Math.max(duration, begin + 1000) / 1000]);
  }

  chart(group, signals) {
    const title = group.key === 'variable' ? word('variables') : `${word(group.title)} (${group.unit})`;
    const legend = signals.map((signal) => {
      const dot = make('i', { className: 'dot' });
      dot.style.background = this.stroke(signal);
      return make('span', {}, dot, signal.name());
    });
    const box = make('figure', { className: 'chart' }, make('figcaption', {}, make('b', { textContent: title }), ...legend));
    this.box.append(box);
    const axis = { stroke: colour('muted'), grid: { stroke: colour('line'), width: 1 }, ticks: { show: false }, font: '11px system-ui, sans-serif' };
    const steps = uPlot.paths.stepped({ align: 1 });
    const plot = new uPlot(
      {
        width: this.width,
        height: HEIGHT,
        padding: [6, 8, 0, 0],
        legend: { show: false },
        cursor: { sync: { key: 'run' }, points: { show: false }, drag: { x: true, y: false } },
        scales: { x: { time: false, range: () => this.range } },
        axes: [{ ...axis, size: 22, values: (_, ticks) => ticks.map((tick) => `${tick} s`) }, { ...axis, size: GUTTER, gap: 4, space: 22 }],
        series: [{}, ...signals.map((signal) => ({
          stroke: this.stroke(signal),
          width: 1.4,
          dash: DASHES[(signal.dash ?? 0) % DASHES.length],
          points: { show: false },
          spanGaps: true,
          ...(signal.scalar === undefined ? {} : { paths: steps }),
        }))],
        hooks: { setSelect: [(plot) => this.zoom(plot)] },
      },
      series(this.recording, signals),
      box,
    );
    const head = make('div', { className: 'playhead' });
    plot.over.append(head);
    plot.over.addEventListener('dblclick', () => {
      this.zoomed = false;
      this.setRange([0, this.recording.duration / 1000]);
    });
    plot.over.addEventListener('click', (event) => {
      if (!plot.select.width) this.goTo(event.offsetX + GUTTER);
    });
    plot.root.setAttribute('role', 'img');
    plot.root.setAttribute('aria-label', `${title}: ${signals.map((signal) => signal.name()).join(', ')}`);
    return { group, signals, plot, head, box };
  }

  stroke(signal) {
    return signal.leg === undefined ? colour(`leg-${(signal.place % 9) + 1}`) : legColour(signal.leg);
  }

  zoom(plot) {
    const { left, width } = plot.select;
    if (width < 4) return;
    const range = [plot.posToVal(left, 'x'), plot.posToVal(left + width, 'x')];
    plot.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
    this.zoomed = true;
    this.setRange(range);
  }

  setRange(range) {
    this.range = range;
    this.charts.forEach(({ plot }) => plot.setScale('x', { min: range[0], max: range[1] }));
    this.drawGait();
    this.movePlayheads();
  }

  /** How wide every plot is, within the box's padding: px. */
  measure() {
    this.width = Math.max(this.box.clientWidth - 24, 200);
  }

  resize() {
    this.measure();
    this.charts.forEach(({ plot }) => plot.setSize({ width: this.width, height: HEIGHT }));
    this.drawGait();
    this.movePlayheads();
  }

  movePlayheads() {
    const [from, to] = this.range;
    const share = (this.player.time / 1000 - from) / (to - from);
    const visible = share >= 0 && share <= 1;
    const width = this.width - GUTTER - 8;
    for (const head of [element('gait-head'), ...this.charts.map(({ head }) => head)]) {
      head.hidden = !visible;
      const offset = head.id ? GUTTER : 0;
      head.style.transform = `translateX(${offset + share * width}px)`;
    }
  }

  /** One row a leg, filled while it stands. */
  drawGait() {
    const { recording, gait } = this;
    const legs = recording.robot.legs.length;
    const known = recording.contactCycles.length && recording.has('load.0');
    element('gait-box').hidden = !known;
    if (!known) return;
    const [row, ratio] = [14, devicePixelRatio];
    gait.style.height = `${legs * row + 2}px`;
    const width = gait.clientWidth;
    [gait.width, gait.height] = [width * ratio, (legs * row + 2) * ratio];
    const pen = gait.getContext('2d');
    pen.scale(ratio, ratio);
    const [from, to] = this.range;
    const x = (time) => GUTTER + ((Math.min(Math.max(time / 1000, from), to) - from) / (to - from)) * (width - GUTTER - 8);
    pen.font = '11px system-ui, sans-serif';
    pen.textBaseline = 'middle';
    pen.textAlign = 'right';
    for (let leg = 0; leg < legs; leg++) {
      const top = leg * row + 1;
      pen.fillStyle = colour('text');
      pen.fillText(`F${leg + 1}`, GUTTER - 8, top + row / 2);
      pen.fillStyle = colour('well');
      pen.fillRect(GUTTER, top + 2, width - GUTTER - 8, row - 4);
      pen.fillStyle = legColour(leg);
      for (const [begin, end] of recording.stances(leg)) {
        pen.fillRect(x(begin), top + 2, x(end) - x(begin), row - 4);
      }
    }
  }
}
