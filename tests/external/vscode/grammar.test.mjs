// The grammar colours programs as the language server does.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { grammar, server } from './words.mjs';

const root = join(import.meta.dirname, '../../..');
const colour = await grammar(join(root, 'editors/vscode'));
const lsp = server(process.env.TIP);
await lsp.start('titan8');
after(() => lsp.end());

/** Stretches of a line with their classes: `PTP/function F1/enumMember`. */
function stretches(line, classes) {
  const found = [];
  for (let at = 0; at < line.length; ) {
    let end = at + 1;
    while (end < line.length && classes[end] === classes[at]) end += 1;
    if (classes[at]) found.push(`${line.slice(at, end)}/${classes[at]}`);
    at = end;
  }
  return found.join(' ');
}

const painted = (text) => {
  const classes = colour(text);
  return text.split('\n').map((line, at) => stretches(line, classes[at]));
};

/** Where the two disagree; nothing where the program has errors. */
async function differences(text) {
  const known = await lsp.classes(text);
  if (!known) return undefined;
  const coloured = colour(text);
  const lines = text.split(/\r\n|\n|\r/);
  // Only the server knows which names are constants.
  const constants = new Set([...text.matchAll(/\bDEFINE\s+(\w+)/gi)].map(([, name]) => name.toUpperCase()));
  const asNames = (line) => line.replace(/(\w+)\/enumMember/g, (word, name) => (constants.has(name.toUpperCase()) ? `${name}/variable` : word));
  const pairs = lines.map((line, at) => [stretches(line, coloured[at]), asNames(stretches(line, known[at]))]);
  return pairs.filter(([one, other]) => one !== other);
}

// Only the server knows the edition, which names are declared and as what, and that % scans from left to right.
const UNDECLARED = [
  'define/no-variable-in-dumps.prg',
  'edition-3-2/readings.prg',
  'edition-3-2/words-of-3-1.prg',
  'edition-3.2-text/structs-in-messages.prg',
  'editions/new-words-are-free-in-the-first.prg',
  'file-message/values.prg',
  'message/special-values.prg',
  'message/struct-placeholders.prg',
  'message/struct-placeholders-of-the-first.prg',
  'message/unassigned-structures.prg',
  'percent-scanning.prg',
  'percent-that-is-text.prg',
];

test('programs of this repository that are without errors', async () => {
  let count = 0;
  for (const folder of ['examples', 'site/lessons', 'tests/language/cases']) {
    for (const name of readdirSync(join(root, folder), { recursive: true })) {
      if (!name.endsWith('.prg') || UNDECLARED.some((file) => name.endsWith(file))) continue;
      // An editor takes the mark off that some files begin with.
      const text = readFileSync(join(root, folder, name), 'utf8').replace(/^\uFEFF/, '');
      // Those in Shift_JIS say nothing more.
      const found = text.includes('\uFFFD') ? undefined : await differences(text);
      if (!found) continue;
      count += 1;
      assert.deepEqual(found, [], join(folder, name));
    }
  }
  console.log(`${count} programs`);
  assert.ok(count > 500);
});

test('what belongs to a place is found in it alone', () => {
  assert.deepEqual(painted('3.1 //first\nPTP //title\nptp hs F1 R A; A = R //PTP'), [
    '3.1/number //first/comment',
    'PTP/string //title/string',
    'ptp/function hs/modifier F1/enumMember R/modifier A/modifier A/variable =/operator R/variable //PTP/comment',
  ]);
});

test('after END nothing is read but its comment', () => {
  assert.deepEqual(painted('3.1\n\nEND PTP //over\nPTP F1\n//no'), ['3.1/number', '', 'END/keyword //over/comment', '', '']);
});

test('a piece of a program has neither version nor title', () => {
  assert.deepEqual(painted('PTP F1\nL1: GOTO L1:'), ['PTP/function F1/enumMember', 'L1/label GOTO/keyword L1/label']);
});

test('a line that is not finished does not reach into the next', () => {
  const lines = painted('3.1\n\nMESSAGE %A\nPTP HS\nA = \nIF !\nREM');
  assert.deepEqual(lines.slice(2), ['MESSAGE/keyword %A/string', 'PTP/function HS/modifier', 'A/variable =/operator', 'IF/keyword !/operator', 'REM/keyword']);
});
