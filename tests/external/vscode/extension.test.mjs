// What of the extension runs without an editor: where it looks for the command, what it asks of it, and what it reads of it.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { homedir, tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { runArguments, traceArguments, traceOf } from '../../../editors/vscode/src/arguments.js';
import { candidates, find } from '../../../editors/vscode/src/command.js';

const extension = join(import.meta.dirname, '../../../editors/vscode');
const json = (name) => JSON.parse(readFileSync(join(extension, name), 'utf8'));
const manifest = json('package.json');
const folder = mkdtempSync(join(tmpdir(), 'tip-vscode-'));
after(() => rmSync(folder, { recursive: true }));

test('the command is where the settings say, else on PATH or where Cargo installs', async () => {
  assert.deepEqual(candidates('', '/robot'), ['tip', join(homedir(), '.cargo/bin/tip')]);
  assert.deepEqual(candidates(' ${workspaceFolder}/bin/tip ', '/robot'), ['/robot/bin/tip']);
  assert.deepEqual(candidates('~/tip', undefined), [join(homedir(), 'tip')]);
  assert.deepEqual(await find(process.env.TIP), { path: process.env.TIP });
  assert.deepEqual(await find(join(folder, 'none')), { reason: 'missing' });
  assert.deepEqual(await find('echo'), { reason: 'other' });
  const { reason } = await find(folder);
  assert.match(reason, /EACCES/);
});

test('the buttons ask for what tip understands', () => {
  const settings = { robot: 'hand', runArguments: ['--cycles', '2'], traceArguments: ['--cycles', '3'] };
  const setting = (name) => settings[name];
  const file = join(folder, 'two words.PRG');
  writeFileSync(file, '3.1\n\nLOOP:\nGOTO\nEND\n');
  assert.equal(traceOf(file), join(folder, 'two words.jsonl'));
  for (const args of [runArguments(file, setting), traceArguments(file, setting)]) {
    const run = spawnSync(process.env.TIP, args, { encoding: 'utf8' });
    assert.equal(run.status, 0, run.stderr);
  }
  // One record for each cycle.
  const records = readFileSync(traceOf(file), 'utf8').trim().split('\n');
  assert.equal(records.filter((record) => 'step' in JSON.parse(record)).length, 3);
  const defaults = (name) => manifest.contributes.configuration.properties[`tip.${name}`].default;
  assert.deepEqual(runArguments('a.prg', defaults), ['run', 'a.prg', '--realtime']);
});

test('the problem matcher reads every line of the short format', () => {
  const [{ pattern }] = manifest.contributes.problemMatchers;
  writeFileSync(join(folder, 'wrong.prg'), '3.1\n歩く\nDEF_VAR A // 変数\nSLEP 10\n  PTP F1 1 2\nEND\n');
  for (const lang of ['en', 'ja']) {
    const check = spawnSync(process.env.TIP, ['check', '--lang', lang, '--message-format', 'short', 'wrong.prg'], { cwd: folder, encoding: 'utf8' });
    const lines = (check.stdout + check.stderr).trim().split('\n');
    const read = lines.map((line) => {
      const found = new RegExp(pattern.regexp).exec(line);
      assert.ok(found, line);
      const part = (name) => found[pattern[name]];
      assert.ok(part('message').length > 3, line);
      return [part('file'), part('line'), part('column'), part('severity'), part('code')].join(' ');
    });
    assert.deepEqual(read.sort(), [
      'wrong.prg 3 9 warning W101',
      'wrong.prg 4 1 error E204-01',
      'wrong.prg 5 3 error E205-01',
    ]);
  }
  const windows = new RegExp(pattern.regexp).exec('C:\\robot\\a.prg:4:1: error[E204]: x');
  assert.equal(windows[pattern.file], 'C:\\robot\\a.prg');
});

test('lines are indented by what opens and closes blocks', () => {
  const rules = json('language-configuration.json').indentationRules;
  const [more, less] = ['increaseIndentPattern', 'decreaseIndentPattern'].map((name) => new RegExp(rules[name].pattern, rules[name].flags));
  for (const line of ['IF A == 1 THEN', 'if kb_hit then // key', 'L1: WHILE KB_HIT', 'ELSE', '  ELSEIF A < 2 THEN', 'REPEAT', 'FOR N = 1 TO 3', 'SUBROUTINE S:']) {
    assert.match(line, more);
  }
  for (const line of ['IF A == 1 GOTO L1:', 'FORCE F1 1 2 3', 'FOR N = 1 TO 3; REM; NEXT', 'MESSAGE IF A THEN', '// ELSE', 'ENDIF']) {
    assert.doesNotMatch(line, more);
  }
  for (const line of ['ELSE', '  ELSEIF A < 2 THEN', 'ENDIF', 'wend', 'NEXT N', 'UNTIL KB_HIT', 'SUBEND']) assert.match(line, less);
  for (const line of ['ENDIF_DONE:', 'END', 'NEXTING = 1']) assert.doesNotMatch(line, less);
});

test('each text is there in both languages', () => {
  const [english, japanese] = [json('package.nls.json'), json('package.nls.ja.json')];
  const keys = [...JSON.stringify(manifest).matchAll(/"%([^%"]+)%"/g)].map((found) => found[1]);
  const sorted = (names) => [...new Set(names)].sort();
  assert.deepEqual(sorted(keys), sorted(Object.keys(english)));
  assert.deepEqual(sorted(keys), sorted(Object.keys(japanese)));

  const sources = readdirSync(join(extension, 'src')).map((name) => readFileSync(join(extension, 'src', name), 'utf8'));
  const told = sources.flatMap((text) => [...text.matchAll(/\bt\('([^']+)'/g)].map((found) => found[1]));
  const translated = json('l10n/bundle.l10n.ja.json');
  assert.deepEqual(sorted(told), sorted(Object.keys(translated)));
  const holes = (text) => sorted(text.match(/\{\d\}/g) ?? []);
  for (const [one, other] of Object.entries(translated)) assert.deepEqual(holes(one), holes(other));
});
