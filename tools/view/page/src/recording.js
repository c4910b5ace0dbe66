// What a program did, to be asked by cycle or by time. A source of cycles that is still running would fill the same lists.

import { countUpTo, lastUpTo } from './search.js';
import { signed, sums, unpack } from './unpack.js';

export class Recording {
  static async of(base64) {
    const { header, columns } = await unpack(base64);
    return new Recording(header, columns);
  }

  constructor(header, columns) {
    this.robot = header.robot;
    this.scene = header.scene;
    this.script = header.script;
    this.outcome = header.outcome;
    this.clock = header.clock.map(([cycle, time, period]) => ({ cycle, time, period }));
    this.columns = columns;
    this.frames = sums(columns['frame']);
    this.stepCycles = sums(columns['step.cycle']);
    this.steps = sums(signed(columns['step']));
    this.contactCycles = sums(columns['contact.cycle']);
    this.contacts = columns['contact'];
    const at = (list, ...names) =>
      list.map((values) => Object.fromEntries(['cycle', ...names].map((name, i) => [name, values[i]])));
    this.messages = at(header.messages, 'text');
    this.lamps = at(header.lamps, 'device', 'on');
    this.commands = at(header.commands, 'op', 'target', 'values');
    this.flags = at(header.flags, 'text');
    this.modes = at(header.modes, 'list');
    this.falls = at(header.falls, 'margin');
    this.slips = at(header.slips, 'leg', 'distance');
    this.events = at(header.events, 'text');
    this.sets = this.script.scalars.map(() => ({ cycles: [], values: [] }));
    const [cycles, scalars, values] = [sums(columns['set.cycle']), columns['set.scalar'], columns['set.value']];
    cycles.forEach((cycle, i) => {
      const set = this.sets[scalars[i]];
      set.cycles.push(cycle);
      set.values.push(values[i]);
    });
    const lastFrame = this.frames.length ? this.frames[this.frames.length - 1] + 1 : 1;
    this.cycles = Math.max(header.cycles, lastFrame, 1);
    this.frameTimes = this.frames.map((cycle) => this.endOf(cycle));
    this.duration = this.endOf(this.cycles - 1);
    this.stepsOfLine = new Map();
    this.script.lines.forEach((line, step) => {
      this.stepsOfLine.set(line, [...(this.stepsOfLine.get(line) ?? []), step]);
    });
  }

  /** When a cycle was over: ms. */
  endOf(cycle) {
    const tick = lastUpTo(this.clock, cycle) ?? { cycle: 0, time: 0, period: 20 };
    return tick.time + (cycle - tick.cycle + 1) * tick.period;
  }

  /** The last cycle that was over at a time. */
  cycleAt(time) {
    let tick = this.clock[countUpTo(this.clock, time, ({ time, period }) => time + period - 1e-6) - 1];
    tick ??= this.clock[0] ?? { cycle: 0, time: 0, period: 20 };
    const cycle = tick.cycle + Math.floor((time - tick.time) / tick.period + 1e-6) - 1;
    return Math.min(Math.max(cycle, 0), this.cycles - 1);
  }

  stepAt(cycle) {
    return this.steps[countUpTo(this.stepCycles, cycle) - 1];
  }

  lineAt(cycle) {
    return this.script.lines[this.stepAt(cycle)];
  }

  /** The next cycle after `cycle` in which a line begins to run, around the end; none if it never does. */
  nextRunOf(line, cycle) {
    const steps = new Set(this.stepsOfLine.get(line));
    if (!steps.size) return undefined;
    const from = countUpTo(this.stepCycles, cycle);
    for (let i = 0; i < this.steps.length; i++) {
      const at = (from + i) % this.steps.length;
      if (steps.has(this.steps[at])) return this.stepCycles[at];
    }
    return undefined;
  }

  messageAt(cycle) {
    return lastUpTo(this.messages, cycle)?.text ?? '';
  }

  /** The value of a scalar after a cycle; none before it is assigned. */
  valueAt(scalar, cycle) {
    const { cycles, values } = this.sets[scalar];
    return values[countUpTo(cycles, cycle) - 1];
  }

  /** Whether each foot or fingertip touches something. */
  touchesAt(cycle) {
    const mask = this.contacts[countUpTo(this.contactCycles, cycle) - 1] ?? 0;
    return this.robot.legs.map((_, leg) => Math.floor(mask / 2 ** leg) % 2 === 1);
  }

  /** From when to when (ms) a foot stands, or a fingertip touches something. */
  stances(leg) {
    const found = [];
    let begin;
    const change = (stands, time) => {
      if (stands) begin ??= time;
      else if (begin !== undefined) {
        found.push([begin, time]);
        begin = undefined;
      }
    };
    this.contactCycles.forEach((cycle, n) => {
      change(Math.floor(this.contacts[n] / 2 ** leg) % 2 === 1, cycle ? this.endOf(cycle - 1) : 0);
    });
    change(false, this.duration);
    return found;
  }

  /** Two frames and how far it is from the one to the other. */
  between(time) {
    const after = Math.min(Math.max(countUpTo(this.frameTimes, time), 1), this.frameTimes.length - 1);
    const before = Math.max(after - 1, 0);
    const [from, to] = [this.frameTimes[before], this.frameTimes[Math.max(after, 0)]];
    const share = to > from ? Math.min(Math.max((time - from) / (to - from), 0), 1) : 0;
    return { before, after: Math.max(after, 0), share };
  }

  /** A channel at a time, between frames on a straight line. */
  value(name, { before, after, share }) {
    const column = this.columns[name];
    return column && column[before] + (column[after] - column[before]) * share;
  }

  has(name) {
    return name in this.columns;
  }

  /** The pose and the joint angles at a place between frames. */
  posture(place) {
    const value = (name) => this.value(name, place) ?? 0;
    const angles = this.robot.legs.map((leg, l) => leg.joints.map((_, j) => value(`angle.${l}.${j}`)));
    const pose = this.has('pose.0') ? [0, 1, 2, 3, 4, 5].map((n) => value(`pose.${n}`)) : undefined;
    return { pose, angles };
  }

  /** Where something happened that one may want to go to, in order. */
  get marks() {
    const kind = (entries, kind) => entries.map((entry) => ({ ...entry, kind }));
    const stop = this.outcome.how === 'emergency' ? [{ cycle: this.cycles - 1, kind: 'fault' }] : [];
    const messages = this.messages.filter(({ text }) => text !== '');
    return [
      ...kind(messages, 'message'),
      ...kind(this.falls, 'fall'),
      ...kind(this.slips, 'slip'),
      ...kind(this.events, 'event'),
      ...stop,
    ].sort((one, other) => one.cycle - other.cycle);
  }
}
