// Two runs on one page: their names, their programs, and which moment of one belongs to a moment of the other.

import { countUpTo } from './search.js';

/** Number of pairs of moments that align two runs. */
const PAIRS = 2000;

/** Returns the names of runs: of their files without folders and extensions, or more of them, or numbers where these are equal. */
export function namesOf(runs) {
  const files = runs.map(({ script }) => script.name);
  const bare = files.map((name) => name.replace(/^.*[/\\]/, ''));
  const stems = bare.map((name) => name.replace(/\.[^.]*$/, ''));
  const differ = [stems, bare, files].find((names) => new Set(names).size === names.length);
  return differ ?? stems.map((name, n) => `${name} ${n + 1}`);
}

/** Reads a unified diff without context: `{ line, removed, place, added }`, the first lines of both programs and their texts. */
export function changesOf(diff) {
  const changes = [];
  for (const text of diff.split('\n')) {
    const [, line, removed, place, added] = /^@@ -(\d+)(,\d+)? \+(\d+)(,\d+)? @@/.exec(text) ?? [];
    // Of no lines the diff names the line before.
    if (line) changes.push({ line: Number(line) + (removed === ',0'), removed: [], place: Number(place) + (added === ',0'), added: [] });
    else if (text.startsWith('-')) changes.at(-1)?.removed.push(text.slice(1));
    else if (text.startsWith('+')) changes.at(-1)?.added.push(text.slice(1));
  }
  return changes;
}

/** Returns the line of the first program that stands for a line of the second one; undefined for a line that was added. */
export function lineBefore(changes, line) {
  let moved = 0;
  for (const { line: from, removed, place, added } of changes) {
    if (line < place) break;
    if (line < place + added.length) return line - place < removed.length ? from + line - place : undefined;
    moved = from + removed.length - place - added.length;
  }
  return line + moved;
}

/** The times of two runs at which they run the same lines. */
export class Alignment {
  /** Aligns runs of programs that differ by `changes`. */
  constructor(one, other, changes) {
    const [visits, others] = [visitsOf(one, (line) => line), visitsOf(other, (line) => lineBefore(changes, line))];
    const pairs = [];
    // Rare lines say more about the course of a run than those of a loop that waits.
    const many = (line) => Math.max(visits.get(line).length, others.get(line).length);
    const shared = [...visits.keys()].filter((line) => others.has(line)).sort((a, b) => many(a) - many(b));
    for (const line of shared) {
      for (let n = 0; n < Math.min(visits.get(line).length, others.get(line).length) && pairs.length < PAIRS; n++) {
        const [own, its] = [visits.get(line)[n], others.get(line)[n]];
        const at = countUpTo(pairs, own, ([time]) => time);
        const fits = (pairs[at - 1] ?? [-1, -1]).every((time, run) => time < [own, its][run]) && (pairs[at]?.[1] ?? Infinity) > its;
        if (fits) pairs.splice(at, 0, [own, its]);
      }
    }
    this.pairs = [[0, 0], ...pairs];
  }

  /** Returns the time of the other run that belongs to a time of the first one, ms. */
  toOther(time) {
    return this.map(time, 0, 1);
  }

  /** Returns the time of the first run that belongs to a time of the other one, ms. */
  toOwn(time) {
    return this.map(time, 1, 0);
  }

  /** Maps a time linearly between pairs. Before and after all of them both clocks run alike. */
  map(time, from, to) {
    const at = Math.max(countUpTo(this.pairs, time, (pair) => pair[from]), 1);
    const [before, after] = [this.pairs[at - 1], this.pairs[at]];
    const slope = after ? (after[to] - before[to]) / (after[from] - before[from]) : 1;
    return before[to] + (time - before[from]) * slope;
  }
}

/** Returns the times at which each line began to run, ms. */
function visitsOf(recording, lineOf) {
  const found = new Map();
  const { cycles, values } = recording.entries('step');
  cycles.forEach((cycle, n) => {
    const line = lineOf(recording.script.lines[values[n]]);
    if (line === undefined) return;
    if (!found.has(line)) found.set(line, []);
    found.get(line).push(recording.endOf(cycle));
  });
  return found;
}
