// The recording of a run, with its values by cycle or by time. It grows by the updates of a session (session.js); a page that
// replays a run contains all of them.

import { countUpTo, lastUpTo } from './search.js';
import { bytesOf, inflated } from './unpack.js';

/** Number of units of an update in 1 mm, deg or N. */
const HUNDREDTHS = 100;
/** Lists of rare events, and the fields of their entries besides the cycle. */
const LISTED = [
  ['messages', 'text'],
  ['lamps', 'device', 'on'],
  ['commands', 'op', 'target', 'values'],
  ['flags', 'text'],
  ['modes', 'list'],
  ['falls', 'margin', 'kind'],
  ['slips', 'leg', 'distance'],
  ['timers', 'timer', 'runs', 'time'],
  ['locks', 'text'],
  ['events', 'text'],
];

export class Recording {
  /** Reads the recording of a run that is over: its updates, one a line, deflated, in base64. */
  static async of(base64) {
    const updates = new TextDecoder().decode(await inflated(bytesOf(base64))).split('\n');
    const [run, more, { outcome, summary }] = updates.map((update) => JSON.parse(update));
    const recording = new Recording(run);
    recording.take(more);
    return Object.assign(recording, { outcome, summary });
  }

  /** Creates the recording of a run that begins with an update `run`. */
  constructor({ run, robot, scene, script, channels, inputs }) {
    Object.assign(this, { run, robot, scene, script, channels, inputs });
    this.outcome = { how: 'limit' };
    this.cycles = 1;
    this.first = 0;
    // The first frame that has changed since the last drawing.
    this.changed = 0;
    // True if the next update replaces the last frame.
    this.provisional = false;
    const lists = ['clock', 'frames', 'frameTimes', 'stepCycles', 'steps', 'contactCycles', 'contacts', ...LISTED.map(([list]) => list)];
    for (const list of lists) this[list] = [];
    this.columns = Object.fromEntries(channels.map((name) => [name, []]));
    this.sets = script.scalars.map(() => ({ cycles: [], values: [] }));
    this.threads = (script.threads ?? []).map(() => ({ cycles: [], steps: [] }));
    this.duration = this.endOf(0);
    this.stepsOfLine = new Map();
    script.lines.forEach((line, step) => {
      this.stepsOfLine.set(line, [...(this.stepsOfLine.get(line) ?? []), step]);
    });
  }

  /** Returns the time at the end of a cycle, ms. */
  endOf(cycle) {
    const tick = lastUpTo(this.clock, cycle) ?? { cycle: 0, time: 0, period: 20 };
    return tick.time + (cycle - tick.cycle + 1) * tick.period;
  }

  /** Returns the last cycle that had ended at a time. */
  cycleAt(time) {
    return Math.min(this.countAt(time), this.cycles - 1);
  }

  /** Returns the same, but counts on after the end of the run. */
  countAt(time) {
    let tick = this.clock[countUpTo(this.clock, time, ({ time, period }) => time + period - 1e-6) - 1];
    tick ??= this.clock[0] ?? { cycle: 0, time: 0, period: 20 };
    return Math.max(tick.cycle + Math.floor((time - tick.time) / tick.period + 1e-6) - 1, 0);
  }

  stepAt(cycle) {
    return this.steps[countUpTo(this.stepCycles, cycle) - 1];
  }

  lineAt(cycle) {
    return this.script.lines[this.stepAt(cycle)];
  }

  /** Returns true if a fault ended the run in this cycle or right after it: a trace has no record of the cycle of a fault. */
  isStoppedAt(cycle) {
    return this.outcome.how === 'emergency' && cycle === this.cycles - 1;
  }

  /** Returns the line to mark: the one that stopped the run, else the one that runs. */
  markedLineAt(cycle) {
    return (this.isStoppedAt(cycle) && this.outcome.line) || this.lineAt(cycle);
  }

  /** Returns a time as the terminal shows it, ms. There, the cycle of a fault takes no time; here, it takes a sampling time. */
  told(time) {
    return time > this.duration ? time : Math.min(time, this.outcome.time ?? time);
  }

  /**
   * Returns the next cycle in which a line begins to run, from the start again after the last one; undefined if it never
   * runs.
   */
  nextRunOf(line, cycle) {
    const steps = new Set(this.stepsOfLine.get(line));
    if (!steps.size) return undefined;
    const next = ({ cycles, steps: ran }) => {
      const from = countUpTo(cycles, cycle);
      for (let i = 0; i < ran.length; i++) {
        const at = (from + i) % ran.length;
        if (steps.has(ran[at])) return cycles[at];
      }
      return undefined;
    };
    const all = [{ cycles: this.stepCycles, steps: this.steps }, ...this.threads].map(next).filter((found) => found !== undefined);
    const later = all.filter((found) => found > cycle);
    return all.length ? Math.min(...(later.length ? later : all)) : undefined;
  }

  /** Returns the threads that ran in a cycle, with their lines. */
  threadsAt(cycle) {
    const lines = this.threads.map(({ cycles, steps }, thread) => {
      const step = steps[countUpTo(cycles, cycle) - 1];
      return { name: this.script.threads[thread], line: this.script.lines[step] };
    });
    return lines.filter(({ line }) => line !== undefined);
  }

  /** Returns the timers that were used up to the end of a cycle, with their times, ms. */
  timersAt(cycle) {
    const last = new Map(this.timers.slice(0, countUpTo(this.timers, cycle, (entry) => entry.cycle)).map((entry) => [entry.timer, entry]));
    const now = [...last.values()].map(({ timer, runs, time }) => ({ timer, time: runs ? this.endOf(cycle) - time : time }));
    return now.sort((one, other) => one.timer - other.timer);
  }

  messageAt(cycle) {
    return lastUpTo(this.messages, cycle)?.text ?? '';
  }

  /** Returns the value of a scalar after a cycle; undefined before it is assigned. */
  valueAt(scalar, cycle) {
    const { cycles, values } = this.sets[scalar];
    return values[countUpTo(cycles, cycle) - 1];
  }

  /** Returns the cycle, up to a given one, in which a scalar was assigned last; undefined before that. */
  assignedAt(scalar, cycle) {
    const { cycles } = this.sets[scalar];
    return cycles[countUpTo(cycles, cycle) - 1];
  }

  /** Returns true for each foot or fingertip that touches something. */
  touchesAt(cycle) {
    const mask = this.contacts[countUpTo(this.contactCycles, cycle) - 1] ?? 0;
    return this.robot.legs.map((_, leg) => Math.floor(mask / 2 ** leg) % 2 === 1);
  }

  /** Returns the intervals (ms) in which a foot stands, or a fingertip touches something. */
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

  /** Returns the frames around a time, and the share of the way from the first to the second. */
  between(time) {
    const after = Math.min(Math.max(countUpTo(this.frameTimes, time), 1), this.frameTimes.length - 1);
    const before = Math.max(after - 1, 0);
    const [from, to] = [this.frameTimes[before], this.frameTimes[Math.max(after, 0)]];
    const share = to > from ? Math.min(Math.max((time - from) / (to - from), 0), 1) : 0;
    return { before, after: Math.max(after, 0), share };
  }

  /** Returns the value of a channel at a place between frames, by linear interpolation. */
  value(name, { before, after, share }) {
    const column = this.columns[name];
    return column && column[before] + (column[after] - column[before]) * share;
  }

  has(name) {
    return name in this.columns;
  }

  /** Returns the pose and the joint angles at a place between frames. */
  posture(place) {
    const value = (name) => this.value(name, place) ?? 0;
    const angles = this.robot.legs.map((leg, l) => leg.joints.map((_, j) => value(`angle.${l}.${j}`)));
    const pose = this.has('pose.0') ? [0, 1, 2, 3, 4, 5].map((n) => value(`pose.${n}`)) : undefined;
    return { pose, angles };
  }

  /** The cycles with something to look at, in order, each with its kind. */
  get marks() {
    const kind = (entries, kind) => entries.map((entry) => ({ ...entry, kind }));
    const stop = this.outcome.how === 'emergency' ? [{ cycle: this.cycles - 1, kind: 'fault' }] : [];
    const messages = this.messages.filter(({ text }) => text !== '');
    return [
      ...kind(messages, 'message'),
      ...kind(this.falls.filter(({ cycle }) => cycle >= this.first), 'fall'),
      ...kind(this.slips, 'slip'),
      ...kind(this.events, 'event'),
      ...stop,
    ].sort((one, other) => one.cycle - other.cycle);
  }

  /** Replaces the recording by that of another run. */
  begin(run) {
    return Object.assign(this, new Recording(run));
  }

  /** Takes an update `more`. */
  take(more) {
    this.cut(more.from);
    for (const [cycle, time, period] of more.clock) this.clock.push({ cycle, time, period });
    this.addFrames(more.frames);
    const [steps, contacts, sets] = [more.steps.map(sums), more.contacts, more.sets];
    append(this.stepCycles, steps[0]);
    append(this.steps, steps[1]);
    append(this.contactCycles, sums(contacts[0]));
    append(this.contacts, contacts[1]);
    sums(sets[0]).forEach((cycle, n) => {
      const set = this.sets[sets[1][n]];
      set.cycles.push(cycle);
      set.values.push(sets[2][n]);
    });
    const [threadCycles, threads, threadSteps] = more.threads ?? [[], [], []];
    const ran = sums(threadSteps);
    sums(threadCycles).forEach((cycle, n) => {
      const thread = this.threads[threads[n] - 1];
      thread.cycles.push(cycle);
      thread.steps.push(ran[n] - 1);
    });
    for (const [list, ...names] of LISTED) {
      for (const entry of more[list] ?? []) {
        const made = Object.fromEntries(['cycle', ...names].map((name, n) => [name, entry[n]]));
        // An earlier slip may have grown.
        const known = made.cycle < more.from ? this[list].find(({ cycle, leg }) => cycle === made.cycle && leg === made.leg) : undefined;
        if (known) Object.assign(known, made);
        else if (made.cycle >= more.from) this[list].push(made);
      }
    }
    this.provisional = Boolean(more.now);
    if (more.now) this.addFrames(more.now);
    if (more.first > this.first) this.forget(more.first);
    this.cycles = Math.max(more.cycles, 1);
    this.duration = this.endOf(this.cycles - 1);
  }

  addFrames([cycles, ...motion]) {
    for (const cycle of sums(cycles)) {
      this.frames.push(cycle);
      this.frameTimes.push(this.endOf(cycle));
    }
    motion.forEach((column, n) => append(this.columns[this.channels[n]], sums(column), HUNDREDTHS));
  }

  /** Removes the entries of cycles from `from` on, and a provisional frame. */
  cut(from) {
    const kept = Math.min(countBefore(this.frames, from), this.frames.length - (this.provisional ? 1 : 0));
    this.changed = Math.min(this.changed, kept);
    for (const list of this.framed) list.length = kept;
    for (const lists of this.paired) lists.forEach((list) => (list.length = countBefore(lists[0], from)));
    for (const list of this.listed) list.length = countBefore(list, from, ({ cycle }) => cycle);
  }

  /** Removes the entries before a cycle, except those that still hold. */
  forget(first) {
    this.first = first;
    const frames = countBefore(this.frames, first);
    for (const list of this.framed) list.splice(0, frames);
    for (const lists of this.paired) {
      const before = Math.max(countUpTo(lists[0], first) - 1, 0);
      lists.forEach((list) => list.splice(0, before));
    }
    const before = countUpTo(this.clock, first, ({ cycle }) => cycle) - 1;
    this.clock.splice(0, Math.max(before, 0));
    keepLast(this.lamps, first, ({ device }) => device);
    keepLast(this.commands, first, ({ target }) => target);
    keepLast(this.timers, first, ({ timer }) => timer);
    for (const list of [this.messages, this.flags, this.modes, this.locks]) keepLast(list, first, () => 0);
    // Falls are kept, since they are counted from the start.
    for (const list of [this.slips, this.events]) list.splice(0, countBefore(list, first, ({ cycle }) => cycle));
    this.changed = 0;
  }

  /** Lists with a value for each frame. */
  get framed() {
    return [this.frames, this.frameTimes, ...this.channels.map((name) => this.columns[name])];
  }

  /** Pairs of lists: cycles, and the values from these cycles on. */
  get paired() {
    const threads = this.threads.map(({ cycles, steps }) => [cycles, steps]);
    const sets = this.sets.map(({ cycles, values }) => [cycles, values]);
    return [[this.stepCycles, this.steps], [this.contactCycles, this.contacts], ...threads, ...sets];
  }

  /** Lists of entries with a cycle. */
  get listed() {
    return [this.clock, ...LISTED.map(([list]) => this[list])];
  }
}

/** Returns the number of ordered values below `value`. */
function countBefore(values, value, of) {
  return countUpTo(values, value - 0.5, of);
}

/** Removes the entries before a cycle, except the last one of each key. */
function keepLast(list, first, key) {
  const before = list.splice(0, countBefore(list, first, ({ cycle }) => cycle));
  const last = new Map(before.map((entry) => [key(entry), entry]));
  list.unshift(...before.filter((entry) => last.get(key(entry)) === entry));
}

/** Returns the running sums of differences. */
function sums(differences) {
  let sum = 0;
  return differences.map((difference) => (sum += difference));
}

/** Appends values, divided by `share`, to a list. */
function append(list, values, share = 1) {
  for (const value of values) list.push(value / share);
}
