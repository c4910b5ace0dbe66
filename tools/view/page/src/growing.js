// A recording of a run that goes on: it fills the lists of one that is over.

import { Recording } from './recording.js';
import { countUpTo } from './search.js';

const NOTHING = { outcome: { how: 'limit' }, cycles: 0, clock: [], messages: [], lamps: [], commands: [], flags: [], modes: [], falls: [], slips: [], events: [] };
const COLUMNS = ['frame', 'step.cycle', 'step', 'contact.cycle', 'contact', 'set.cycle', 'set.scalar', 'set.value'];

export class GrowingRecording extends Recording {
  /** Of a run that begins, an update `run`. */
  constructor({ run, robot, scene, script, channels, inputs }) {
    super({ ...NOTHING, robot, scene, script }, Object.fromEntries([...COLUMNS, ...channels].map((name) => [name, []])));
    Object.assign(this, { run, inputs });
    this.channels = channels;
    this.first = 0;
    // From which frame on those that were known have changed.
    this.changed = 0;
    // Whether the last frame is there for the moment only.
    this.provisional = false;
  }

  /** Another run in the place of this one. */
  begin(run) {
    return Object.assign(this, new GrowingRecording(run));
  }

  /** What has happened, an update `more`. */
  take(more) {
    this.cut(more.from);
    for (const [cycle, time, period] of more.clock) this.clock.push({ cycle, time, period });
    for (const frame of more.frames) this.addFrame(frame);
    const add = (list, ...names) => (values) => list.push(Object.fromEntries(['cycle', ...names].map((name, i) => [name, values[i]])));
    more.steps.forEach(([cycle, step]) => this.stepCycles.push(cycle) && this.steps.push(step));
    more.contacts.forEach(([cycle, mask]) => this.contactCycles.push(cycle) && this.contacts.push(mask));
    more.sets.forEach(([cycle, scalar, value]) => this.sets[scalar].cycles.push(cycle) && this.sets[scalar].values.push(value));
    more.messages.forEach(add(this.messages, 'text'));
    more.lamps.forEach(add(this.lamps, 'device', 'on'));
    more.commands.forEach(add(this.commands, 'op', 'target', 'values'));
    more.flags.forEach(add(this.flags, 'text'));
    more.modes.forEach(add(this.modes, 'list'));
    more.falls.forEach(add(this.falls, 'margin'));
    more.slips.forEach(add(this.slips, 'leg', 'distance'));
    more.events.forEach(add(this.events, 'text'));
    this.provisional = Boolean(more.now);
    if (more.now) this.addFrame(more.now);
    if (more.first > this.first) this.forget(more.first);
    this.cycles = Math.max(more.cycles, 1);
    this.duration = this.endOf(this.cycles - 1);
  }

  addFrame([cycle, values]) {
    this.frames.push(cycle);
    this.frameTimes.push(this.endOf(cycle));
    this.channels.forEach((name, n) => this.columns[name].push(values[n]));
  }

  /** Takes away what was known of cycles from `from` on, and a frame that was there for the moment only. */
  cut(from) {
    const kept = Math.min(countBefore(this.frames, from), this.frames.length - (this.provisional ? 1 : 0));
    this.changed = Math.min(this.changed, kept);
    for (const list of this.framed) list.length = kept;
    for (const lists of this.paired) lists.forEach((list) => (list.length = countBefore(lists[0], from)));
    for (const list of this.listed) list.length = countBefore(list, from, ({ cycle }) => cycle);
  }

  /** Forgets what was before a cycle, but for what still holds. */
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
    for (const list of [this.messages, this.flags, this.modes]) keepLast(list, first, () => 0);
    for (const list of [this.falls, this.slips, this.events]) list.splice(0, countBefore(list, first, ({ cycle }) => cycle));
    this.changed = 0;
  }

  /** Lists with a value for each frame. */
  get framed() {
    return [this.frames, this.frameTimes, ...this.channels.map((name) => this.columns[name])];
  }

  /** Cycles with what changed in them. */
  get paired() {
    return [[this.stepCycles, this.steps], [this.contactCycles, this.contacts], ...this.sets.map(({ cycles, values }) => [cycles, values])];
  }

  /** Lists of entries with a cycle. */
  get listed() {
    return [this.clock, this.messages, this.lamps, this.commands, this.flags, this.modes, this.falls, this.slips, this.events];
  }
}

/** How many of the ordered values are below `value`. */
function countBefore(values, value, of) {
  return countUpTo(values, value - 0.5, of);
}

/** Of the entries before a cycle, keeps the last of each key. */
function keepLast(list, first, key) {
  const before = list.splice(0, countBefore(list, first, ({ cycle }) => cycle));
  const last = new Map(before.map((entry) => [key(entry), entry]));
  list.unshift(...before.filter((entry) => last.get(key(entry)) === entry));
}
