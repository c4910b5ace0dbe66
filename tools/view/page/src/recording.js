// The recording of a run, with its values by cycle or by time. It grows by the updates of a session (session.js); a page that
// replays a run contains all of them.

import { countUpTo } from './search.js';
import { bytesOf, inflated } from './unpack.js';

/** Number of units of an update in 1 mm, deg or N. */
const HUNDREDTHS = 100;
/** Cycles and values under a key without entries. */
const NOTHING = { cycles: [], values: [] };
/** The first cycle, its time and its period (ms), before anything is known. */
const START = [0, 0, 20];

export class Recording {
  /**
   * Reads the recording of a run that is over: its updates, one a line, deflated, in base64. A last line is the diff from the program
   * of another run to that of this one.
   */
  static async of(base64) {
    const updates = new TextDecoder().decode(await inflated(bytesOf(base64))).split('\n');
    const [run, more, { outcome, summary }, diff] = updates.map((update) => JSON.parse(update));
    const recording = new Recording(run);
    recording.take(more);
    return Object.assign(recording, { outcome, summary, diff });
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
    [this.frames, this.frameTimes] = [[], []];
    this.columns = Object.fromEntries(channels.map((name) => [name, []]));
    // Cycles and values under each key (session.js).
    this.log = new Map();
    this.duration = this.endOf(0);
    this.stepsOfLine = new Map();
    script.lines.forEach((line, step) => {
      this.stepsOfLine.set(line, [...(this.stepsOfLine.get(line) ?? []), step]);
    });
  }

  /** Returns the cycles and values under a key of the log. */
  entries(key) {
    return this.log.get(key) ?? NOTHING;
  }

  /** Returns the cycle of the last entry under a key, up to a cycle; undefined before the first. */
  lastOf(key, cycle) {
    const { cycles } = this.entries(key);
    return cycles[countUpTo(cycles, cycle) - 1];
  }

  /** Returns the value under a key at the end of a cycle; undefined before the first entry. */
  at(key, cycle) {
    const { cycles, values } = this.entries(key);
    return values[countUpTo(cycles, cycle) - 1];
  }

  /** Returns the numbers of the things of a kind, such as lamps, that have entries. */
  numbers(kind) {
    const keys = [...this.log.keys()].map((key) => key.split('.'));
    return keys.filter(([of]) => of === kind).map(([, number]) => Number(number)).sort((one, other) => one - other);
  }

  /** Returns the time at the end of a cycle, ms. */
  endOf(cycle) {
    const [from, time, period] = this.at('clock', cycle) ?? START;
    return time + (cycle - from + 1) * period;
  }

  /** Returns the last cycle that had ended at a time. */
  cycleAt(time) {
    return Math.min(this.countAt(time), this.cycles - 1);
  }

  /** Returns the same, but counts on after the end of the run. */
  countAt(time) {
    const { values } = this.entries('clock');
    const [from, begin, period] = values[countUpTo(values, time, ([, begin, period]) => begin + period - 1e-6) - 1] ?? values[0] ?? START;
    return Math.max(from + Math.floor((time - begin) / period + 1e-6) - 1, 0);
  }

  lineAt(cycle) {
    return this.script.lines[this.at('step', cycle)];
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
    const next = (key) => {
      const { cycles, values } = this.entries(key);
      const from = countUpTo(cycles, cycle);
      for (let i = 0; i < values.length; i++) {
        const at = (from + i) % values.length;
        if (steps.has(values[at])) return cycles[at];
      }
      return undefined;
    };
    const all = ['step', ...this.threads.map((_, thread) => `thread.${thread + 1}`)].map(next).filter((found) => found !== undefined);
    const later = all.filter((found) => found > cycle);
    return all.length ? Math.min(...(later.length ? later : all)) : undefined;
  }

  /** Names of the program's threads. */
  get threads() {
    return this.script.threads ?? [];
  }

  /** Returns the threads that ran in a cycle, with their lines. */
  threadsAt(cycle) {
    const lines = this.threads.map((name, thread) => ({ name, line: this.script.lines[this.at(`thread.${thread + 1}`, cycle)] }));
    return lines.filter(({ line }) => line !== undefined);
  }

  /** Returns the timers that were used up to the end of a cycle, with their times, ms. */
  timersAt(cycle) {
    const timers = this.numbers('timer').filter((timer) => this.at(`timer.${timer}`, cycle));
    return timers.map((timer) => {
      const [runs, time] = this.at(`timer.${timer}`, cycle);
      return { timer, time: runs ? this.endOf(cycle) - time : time };
    });
  }

  messageAt(cycle) {
    return this.at('message', cycle) ?? '';
  }

  /** Returns true for each foot or fingertip that touches something. */
  touchesAt(cycle) {
    const mask = this.at('contacts', cycle) ?? 0;
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
    const { cycles, values } = this.entries('contacts');
    cycles.forEach((cycle, n) => {
      change(Math.floor(values[n] / 2 ** leg) % 2 === 1, cycle ? this.endOf(cycle - 1) : 0);
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

  /** Returns the cycles with something to look at, in order: `{cycle, kind, value}`. */
  get marks() {
    const of = (key, kind, value = (value) => value) => {
      const { cycles, values } = this.entries(key);
      return cycles.map((cycle, n) => ({ cycle, kind, value: value(values[n], cycle) })).filter(({ cycle }) => cycle >= this.first);
    };
    const slips = this.robot.legs.flatMap((_, leg) => of(`slip.${leg}`, 'slip', (distance, cycle) => ({ leg, distance: this.largestSlip(leg, cycle, distance) })));
    const stop = this.outcome.how === 'emergency' ? [{ cycle: this.cycles - 1, kind: 'fault' }] : [];
    const messages = of('message', 'message').filter(({ value }) => value !== '');
    // A collision is one event, whichever pair is the nearest in it.
    const collisions = of('collision', 'collision').filter(({ value, cycle }) => value && !this.at('collision', cycle - 1));
    return [...messages, ...of('fall', 'fall'), ...collisions, ...slips, ...of('event', 'event'), ...stop].sort((one, other) => one.cycle - other.cycle);
  }

  /** Returns the slip of a foot until it was lifted, mm, from its slip in a cycle. */
  largestSlip(leg, cycle, distance) {
    const slips = this.columns[`slip.${leg}`] ?? [];
    let largest = distance;
    for (let frame = countBefore(this.frames, cycle); slips[frame] > 0; frame++) largest = Math.max(largest, slips[frame]);
    return largest;
  }

  /** Replaces the recording by that of another run. */
  begin(run) {
    return Object.assign(this, new Recording(run));
  }

  /** Takes an update `more`. */
  take(more) {
    this.cut(more.from);
    for (const [key, [cycles, values]] of Object.entries(more.log)) {
      if (!this.log.has(key)) this.log.set(key, { cycles: [], values: [] });
      append(this.log.get(key).cycles, sums(cycles));
      append(this.log.get(key).values, values);
    }
    this.addFrames(more.frames);
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
    motion.forEach((column, n) => append(this.columns[this.channels[n]], sums(column).map((value) => value / HUNDREDTHS)));
  }

  /** Removes the entries of cycles from `from` on, and a provisional frame. */
  cut(from) {
    const kept = Math.min(countBefore(this.frames, from), this.frames.length - (this.provisional ? 1 : 0));
    this.changed = Math.min(this.changed, kept);
    for (const list of this.framed) list.length = kept;
    for (const [key, { cycles, values }] of this.log) {
      cycles.length = values.length = countBefore(cycles, from);
      if (!cycles.length) this.log.delete(key);
    }
  }

  /** Removes the entries before a cycle, except those that still hold. */
  forget(first) {
    this.first = first;
    const frames = countBefore(this.frames, first);
    for (const list of this.framed) list.splice(0, frames);
    for (const { cycles, values } of this.log.values()) {
      const before = Math.max(countUpTo(cycles, first) - 1, 0);
      for (const list of [cycles, values]) list.splice(0, before);
    }
    this.changed = 0;
  }

  /** Lists with a value for each frame. */
  get framed() {
    return [this.frames, this.frameTimes, ...this.channels.map((name) => this.columns[name])];
  }
}

/** Returns the number of ordered values below `value`. */
function countBefore(values, value, of) {
  return countUpTo(values, value - 0.5, of);
}

/** Returns the running sums of differences. */
function sums(differences) {
  let sum = 0;
  return differences.map((difference) => (sum += difference));
}

/** Appends values to a list. */
function append(list, values) {
  for (const value of values) list.push(value);
}
