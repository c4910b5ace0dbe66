// The signals that can be plotted, in groups with a common unit.

import { countUpTo } from './search.js';
import { word } from './words.js';

/** Largest number of joints in a strip of plots. */
const JOINTS = 6;

/** Returns the groups of a recording with their signals: name, unit, and values by frame or by change. */
export function signalGroups(recording) {
  const { robot } = recording;
  const columns = (list) => list.filter(({ column }) => recording.has(column));
  const legs = robot.legs.map((_, leg) => leg);
  const joints = robot.legs.flatMap((leg, l) => leg.joints.map((_, j) => ({ l, j })));
  const group = (key, title, unit, signals) => ({ key, title, unit, signals });
  const groups = [
    group('margin', 'margin', 'mm', columns([{ column: 'margin', name: () => word('margin') }])),
    group('clearance', 'clearance', 'mm', columns([{ column: 'clearance', name: () => word('clearance') }])),
    group('body', 'position6', 'mm', columns(['x', 'y', 'z'].map((name, n) => ({ column: `pose.${n}`, name: () => name })))),
    group('turn', 'position6', '°', columns(['roll', 'pitch', 'yaw'].map((name, n) => ({ column: `pose.${n + 3}`, name: () => name })))),
    group('objects', 'objects', 'mm', columns(recording.scene.objects.map((_, n) => ({ column: `thing.${n}.1`, name: () => `${word('object', n + 1)} y` })))),
    group('load', 'loads', 'N', columns(legs.map((leg) => ({ column: `load.${leg}`, leg, name: () => `F${leg + 1}` })))),
    group('slip', 'slips', 'mm', columns(legs.map((leg) => ({ column: `slip.${leg}`, leg, name: () => `F${leg + 1}` })))),
    group('angle', 'angles', '°', columns(joints.map(({ l, j }) => ({ column: `angle.${l}.${j}`, leg: l, dash: j, name: () => `J${l + 1}${j + 1}` })))),
    group('lag', 'lags', '°', columns(joints.map(({ l, j }) => ({ column: `lag.${l}.${j}`, leg: l, dash: j, name: () => `J${l + 1}${j + 1}` })))),
    group('torque', 'torques', robot.planar ? 'mN·m' : 'N·m', columns(joints.map(({ l, j }) => ({ column: `torque.${l}.${j}`, leg: l, dash: j, name: () => `J${l + 1}${j + 1}` })))),
    group('variable', 'variables', '', recording.script.scalars.map((name, scalar) => ({ scalar, name: () => name }))),
  ];
  groups.forEach(({ key, signals }) => signals.forEach((signal, n) => Object.assign(signal, { key: `${key}.${n}`, place: n })));
  return groups.filter(({ signals }) => signals.length);
}

/** Returns the signals that are plotted at first. */
export function firstChoice(recording) {
  const walker = ['margin.0', 'body.2', ...recording.robot.legs.map((_, leg) => `load.${leg}`)];
  const hand = ['objects.0', ...recording.robot.legs.map((_, leg) => `load.${leg}`)];
  const arm = recording.robot.legs.flatMap((leg, l) => leg.joints.map((_, j) => `angle.${l * leg.joints.length + j}`));
  if (recording.has('margin')) return new Set(walker);
  return new Set(recording.has('load.0') ? hand : arm);
}

/** Returns signals in strips of plots: those of many joints leg by leg. */
export function inStrips(signals) {
  if (signals.length <= JOINTS || signals.some(({ dash }) => dash === undefined)) return signals.length ? [signals] : [];
  return [...new Set(signals.map(({ leg }) => leg))].map((of) => signals.filter(({ leg }) => leg === of));
}

/** Returns the value of a signal at a time (ms); undefined after the end of the run, and for a variable before it is assigned. */
export function valueOf(recording, { column, scalar }, time) {
  if (time > recording.duration) return undefined;
  if (column) return recording.value(column, recording.between(time));
  return recording.at(`set.${scalar}`, recording.cycleAt(time));
}

/** Returns the same signal of another recording; variables are found by their names. Undefined if there is none. */
export function counterpart(recording, signal) {
  if (signal.column) return recording.has(signal.column) ? signal : undefined;
  const scalar = recording.script.scalars.indexOf(signal.name());
  return scalar < 0 ? undefined : { ...signal, scalar };
}

/** Returns times (s) and the values of signals of a group at these times, from a time (ms) on. */
export function series(recording, signals, begin = -Infinity) {
  if (signals.every(({ column }) => column)) {
    const from = Math.max(countUpTo(recording.frameTimes, begin) - 1, 0);
    const times = Array.from(recording.frameTimes.slice(from), (time) => time / 1000);
    return [times, ...signals.map(({ column }) => recording.columns[column].slice(from))];
  }
  // Variables have values at each change of one of them, and just before it.
  const first = begin > 0 ? recording.cycleAt(begin) : 0;
  const cycles = new Set([first, recording.cycles - 1]);
  for (const { scalar } of signals) {
    const changes = recording.entries(`set.${scalar}`).cycles;
    changes.slice(countUpTo(changes, first)).forEach((cycle) => cycles.add(cycle));
  }
  const ordered = [...cycles].sort((one, other) => one - other);
  const times = ordered.map((cycle) => recording.endOf(cycle) / 1000);
  return [times, ...signals.map(({ scalar }) => ordered.map((cycle) => recording.at(`set.${scalar}`, cycle) ?? null))];
}
