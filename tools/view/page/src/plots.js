// Plots of signals and stances of the feet, on one axis of time.

import uPlot from 'uplot';
import { namesOf } from './comparison.js';
import { clockTime, colour, element, fixed, legColour, make } from './dom.js';
import { counterpart, firstChoice, inStrips, series, signalGroups, valueOf } from './signals.js';
import { shown } from './source.js';
import { whenSpoken, word } from './words.js';

/** Width of the axis at the left of every plot, px. */
const GUTTER = 64;
/** Width of the margin at the right, which the last label of the axis needs, px. */
const EDGE = 28;
const HEIGHT = 108;
/** Opacity of the lines of the compared run, as two digits after a colour. */
const FAINT = '70';
/** Height of a leg in the diagram of the gait, px. */
const ROW = 14;
const DASHES = [[], [6, 3], [2, 2], [8, 2, 2, 2]];

export class Plots {
  constructor(player) {
    this.player = player;
    this.recording = player.recording;
    this.other = player.other;
    this.box = element('plots');
    this.chosen = firstChoice(this.recording);
    this.range = this.whole;
    this.charts = [];
    this.gait = element('gait');
    this.gait.addEventListener('click', (event) => this.goTo(event.offsetX));
    whenSpoken(() => this.say());
    player.onRest(() => this.movePlayheads());
    element('plot-mark').addEventListener('click', () => this.measureFrom(this.mark === undefined ? this.looked : undefined));
    new ResizeObserver(() => this.resize()).observe(this.box);
  }

  /** Start and end of the runs, s. */
  get whole() {
    return [0, this.player.end / 1000];
  }

  /** The time under the pointer, else that of the player, ms. */
  get looked() {
    return this.pointed ?? this.player.time;
  }

  /** Sets the second cursor (ms). Values are also shown as differences from those at this time. */
  measureFrom(time) {
    this.mark = time;
    element('plot-mark').setAttribute('aria-pressed', time !== undefined);
    this.movePlayheads();
  }

  /** Shows all values in the next frame, once for all plots that report the pointer. */
  tell() {
    this.due ??= requestAnimationFrame(() => {
      this.due = undefined;
      this.showValues();
    });
  }

  showValues() {
    const { looked, mark } = this;
    const told = (time) => this.recording.told(time);
    const signed = (text) => (text.startsWith('-') ? text : `+${text}`);
    element('plot-time').textContent = clockTime(told(looked)) + (mark === undefined ? '' : `  Δ ${signed(clockTime(told(looked) - told(mark)))}`);
    for (const { group, signals, outputs } of this.charts) {
      const said = (value) => (value === undefined ? '–' : group.unit ? fixed(value, 1) : shown(value));
      signals.forEach((signal, n) => {
        const value = valueOf(this.recording, signal, looked);
        const before = mark === undefined ? undefined : valueOf(this.recording, signal, mark);
        const change = value === undefined || before === undefined ? '' : `  Δ ${signed(said(value - before))}`;
        const same = this.other && counterpart(this.other, signal);
        const compared = same ? ` | ${said(valueOf(this.other, same, this.player.otherTime(looked)))}` : '';
        outputs[n].textContent = said(value) + compared + change;
      });
    }
  }

  goTo(x) {
    const [from, to] = this.range;
    const share = (x - GUTTER) / Math.max(this.gait.clientWidth - GUTTER - EDGE, 1);
    this.player.pause();
    this.player.goToTime((from + share * (to - from)) * 1000);
  }

  /** Fills the list of signals to choose from. */
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

  /** Adds the plot of a variable and scrolls to it. */
  showVariable(scalar) {
    const key = `variable.${scalar}`;
    this.chosen.add(key);
    this.listSignals();
    this.build();
    const chart = this.charts.find(({ group }) => group.key === 'variable');
    // The plot has a place only after the next layout of the page.
    requestAnimationFrame(() => chart?.box.scrollIntoView({ block: 'nearest' }));
  }

  build() {
    this.measure();
    this.charts.forEach(({ plot, box }) => {
      plot.destroy();
      box.remove();
    });
    this.charts = this.groups
      .map((group) => ({ group, signals: group.signals.filter(({ key }) => this.chosen.has(key)) }))
      .flatMap(({ group, signals }) => inStrips(signals).map((signals) => this.chart(group, signals)));
    this.drawGait();
    this.movePlayheads();
  }

  /** Plots the differences of two runs, or both runs over each other. */
  subtract(on) {
    this.subtracts = on;
    this.build();
  }

  /** Takes other times of the run that is compared. */
  retime() {
    this.zoomed = false;
    this.range = this.whole;
    this.build();
  }

  /** Takes another run, whose program and robot may have other signals. */
  begin() {
    this.chosen = firstChoice(this.recording);
    this.zoomed = false;
    this.say();
  }

  say() {
    const title = this.recording.robot.body ? 'gait' : 'touch';
    const names = this.other && namesOf([this.recording, this.other]);
    element('gait-title').textContent = names ? `${word(title)} (${word('aboveAndBelow', ...names)})` : word(title);
    this.gait.setAttribute('aria-label', word(title));
    this.groups = signalGroups(this.recording);
    this.listSignals();
    this.build();
  }

  /** Shows the last `time` ms of a live run. */
  follow(time) {
    const { duration, first } = this.recording;
    if (this.zoomed || !this.box.offsetParent) return;
    const begin = Math.max(duration - time, this.recording.endOf(first));
    this.charts.forEach(({ plot, signals }) => plot.setData(series(this.recording, signals, begin), false));
    this.setRange([begin / 1000, Math.max(duration, begin + 1000) / 1000]);
  }

  /** Shows all recorded cycles of a live run. */
  showAll() {
    const { duration, first } = this.recording;
    this.charts.forEach(({ plot, signals }) => plot.setData(series(this.recording, signals), false));
    this.setRange([first ? this.recording.endOf(first) / 1000 : 0, duration / 1000]);
  }

  chart(group, signals) {
    const title = group.key === 'variable' ? word('variables') : `${word(group.title)} (${group.unit})`;
    const outputs = signals.map(() => make('output'));
    const legend = signals.map((signal, n) => {
      const dot = make('i', { className: 'dot' });
      dot.style.background = this.stroke(signal);
      return make('span', { className: 'signal' }, dot, signal.name(), outputs[n]);
    });
    const others = this.other ? signals.map((signal) => counterpart(this.other, signal)).filter(Boolean) : [];
    const names = this.other && namesOf([this.recording, this.other]);
    const which = names ? [word(this.subtracts ? 'otherMinusOne' : 'strongAndFaint', ...names)] : [];
    const box = make('figure', { className: 'chart' }, make('figcaption', {}, make('b', { textContent: title }), ...which, ...legend));
    this.box.append(box);
    const axis = { stroke: colour('muted'), grid: { stroke: colour('line'), width: 1 }, ticks: { show: false }, font: '11px system-ui, sans-serif' };
    const steps = uPlot.paths.stepped({ align: 1 });
    const plot = new uPlot(
      {
        width: this.width,
        height: HEIGHT,
        padding: [6, EDGE, 0, 0],
        legend: { show: false },
        cursor: { sync: { key: 'run' }, points: { show: false }, drag: { x: true, y: false } },
        scales: { x: { time: false, range: () => this.range } },
        axes: [{ ...axis, size: 22, values: (_, ticks) => ticks.map((tick) => `${tick} s`) }, { ...axis, size: GUTTER, gap: 4, space: 22 }],
        series: [{}, ...[...signals.map((signal) => [signal, '', 1.4]), ...(this.subtracts ? [] : others).map((signal) => [signal, FAINT, 1])].map(([signal, opacity, width]) => ({
          stroke: this.stroke(signal) + opacity,
          width,
          dash: DASHES[(signal.dash ?? 0) % DASHES.length],
          points: { show: false },
          spanGaps: true,
          ...(signal.scalar === undefined ? {} : { paths: steps }),
        }))],
        hooks: {
          setSelect: [(plot) => this.zoom(plot)],
          setCursor: [({ cursor, posToVal }) => {
            this.pointed = cursor.left >= 0 ? posToVal(cursor.left, 'x') * 1000 : undefined;
            this.tell();
          }],
        },
      },
      this.data(signals, others),
      box,
    );
    const [head, reference] = ['playhead', 'reference'].map((className) => make('div', { className }));
    plot.over.append(head, reference);
    plot.over.addEventListener('dblclick', () => {
      this.zoomed = false;
      this.setRange(this.whole);
    });
    plot.over.addEventListener('click', (event) => {
      if (plot.select.width) return;
      if (event.shiftKey) this.measureFrom(this.pointed);
      else this.goTo(event.offsetX + GUTTER);
    });
    plot.root.setAttribute('role', 'img');
    plot.root.setAttribute('aria-label', `${title}: ${signals.map((signal) => signal.name()).join(', ')}`);
    return { group, signals, outputs, plot, head, reference, box };
  }

  /** Returns times (s) and values of the signals of a chart, and of the run that is compared or the differences from it. */
  data(signals, others) {
    const { player, recording, other } = this;
    const own = series(recording, signals);
    if (!other) return own;
    if (!this.subtracts) {
      const [times, ...values] = series(other, others);
      return uPlot.join([own, [times.map((time) => player.ownTime(time * 1000) / 1000), ...values]]);
    }
    const [times] = own;
    const less = (signal, same, time) => {
      const [value, compared] = [valueOf(recording, signal, time), same && valueOf(other, same, player.otherTime(time))];
      return value === undefined || compared === undefined ? null : compared - value;
    };
    return [times, ...signals.map((signal) => {
      const same = counterpart(other, signal);
      return times.map((time) => less(signal, same, time * 1000));
    })];
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

  /** Measures the width of plots within the padding of their box, px. */
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
    // The time of the player is visible, unless the user has zoomed in.
    const seconds = this.player.time / 1000;
    if (this.player.following === false && !this.zoomed && (seconds < this.range[0] || seconds > this.range[1])) this.showAll();
    const [from, to] = this.range;
    const width = this.width - GUTTER - EDGE;
    const move = (time, lines) => {
      const share = (time / 1000 - from) / (to - from);
      for (const line of lines) {
        line.hidden = !(share >= 0 && share <= 1);
        const offset = line.id ? GUTTER : 0;
        line.style.transform = `translateX(${offset + share * width}px)`;
      }
    };
    move(this.player.time, [element('gait-head'), ...this.charts.map(({ head }) => head)]);
    move(this.mark ?? NaN, [element('gait-reference'), ...this.charts.map(({ reference }) => reference)]);
    this.tell();
  }

  /** Draws a row for each leg, filled while its foot stands; that of a run which is compared is under it. */
  drawGait() {
    const { recording, other, player, gait } = this;
    const legs = recording.robot.legs.length;
    const isKnown = (run) => run?.entries('contacts').cycles.length && run.has('load.0');
    const runs = other ? [recording, other] : [recording];
    const known = runs.some(isKnown);
    element('gait-box').hidden = !known;
    if (!known) return;
    const ratio = devicePixelRatio;
    const row = ROW * (other ? 1.4 : 1);
    gait.style.height = `${legs * row + 2}px`;
    const width = gait.clientWidth;
    [gait.width, gait.height] = [width * ratio, (legs * row + 2) * ratio];
    const pen = gait.getContext('2d');
    pen.scale(ratio, ratio);
    const [from, to] = this.range;
    const x = (time) => GUTTER + ((Math.min(Math.max(time / 1000, from), to) - from) / (to - from)) * (width - GUTTER - EDGE);
    pen.font = '11px system-ui, sans-serif';
    pen.textBaseline = 'middle';
    pen.textAlign = 'right';
    const height = (row - 4) / runs.length;
    for (let leg = 0; leg < legs; leg++) {
      const top = leg * row + 3;
      pen.globalAlpha = 1;
      pen.fillStyle = colour('text');
      pen.fillText(`F${leg + 1}`, GUTTER - 8, top + row / 2 - 2);
      runs.forEach((run, n) => {
        pen.globalAlpha = 1;
        pen.fillStyle = colour('well');
        pen.fillRect(GUTTER, top + n * height, width - GUTTER - EDGE, height);
        if (!isKnown(run)) return;
        pen.fillStyle = legColour(leg);
        pen.globalAlpha = n ? 0.5 : 1;
        for (const stance of run.stances(leg)) {
          const [begin, end] = n ? stance.map((time) => player.ownTime(time)) : stance;
          pen.fillRect(x(begin), top + n * height, x(end) - x(begin), height);
        }
      });
    }
  }
}
