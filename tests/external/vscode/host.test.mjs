// The extension at work in a true extension host: an editing session, a debugging session, a run, a program in Shift_JIS.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { open } from './host.mjs';

const WALK = `3.1
歩く
DEF_VAR N
// 歩数を数える
FOR N = 1 TO 3
  PTP F1 R 0 20 0
  SLEP 100
NEXT
MESSAGE 歩数 %N%
END
`;
// 歩く, and ∵ as NEC's row 13 spells it.
const OLD = Buffer.from([...Buffer.from('3.1\n'), 0x95, 0xe0, 0x82, 0xad, ...Buffer.from('\nMESSAGE '), 0x87, 0x9a, ...Buffer.from('\nEND\n')]);

// Line 13 runs in cycle 5 for the first time, when the main program stands at line 9.
const TWO = '3.2\ntwo\nDEF_VAR A, B\nA = 0\nB = 0\nSTART_THREAD SIDE:\nL:\nA += 1\nIF A < 99 GOTO L:\nEXIT\nTHREAD SIDE:\nAGAIN:\nB += 1\nSLEEP 40\nGOTO AGAIN:\nTHREADEND\nEND\n';

const TOML = '[[programs]]\nfiles = "new.prg"\nencoding = "shift_jis"\n';

const files = { 'walk.prg': WALK, 'two.prg': TWO, 'old.prg': OLD, 'new.prg': '3.1\n\nMESSAGE A\nEND\n', 'tip.toml': TOML };
const { page, folder, shot, close } = await open(files);
after(close);
page.setDefaultTimeout(30_000);

/** Runs a command by its name in the palette. */
async function command(name) {
  await page.keyboard.press('F1');
  await page.locator('.quick-input-widget input').fill(`>${name}`);
  await page.locator('.quick-input-list .monaco-list-row', { hasText: name }).first().click();
}

async function show(file) {
  await page.keyboard.press('Control+P');
  await page.locator('.quick-input-widget input').fill(file);
  await page.locator('.quick-input-list .monaco-list-row', { hasText: file }).first().click();
  await page.locator('.tab.active', { hasText: file }).waitFor();
}

async function goTo(line) {
  await page.keyboard.press('Control+G');
  await page.locator('.quick-input-widget input').fill(`:${line}`);
  await pressed('Enter', page.locator('.quick-input-widget'), 'hidden');
}

/** Presses keys until they have shown or hidden something: while an editor is busy it may pass them over. */
async function pressed(keys, part, state = 'visible') {
  for (let times = 0; times < 10; times += 1) {
    await page.keyboard.press(keys);
    const isSo = await part.waitFor({ state, timeout: 3000 }).then(() => true, () => false);
    if (isSo) return;
  }
  assert.fail(`${keys}: never ${state}`);
}

/** A word in the editor. */
const word = (text) => page.locator('.view-line span span', { hasText: text }).first();

test('an error is underlined, and its fix applied', async () => {
  await show('walk.prg');
  await page.locator('.squiggly-error').first().waitFor({ state: 'attached' });
  await word('SLEP').hover();
  const hover = page.locator('.monaco-hover:visible');
  await hover.first().waitFor();
  await page.waitForTimeout(500);
  await shot('squiggle');
  assert.match(await hover.first().innerText(), /SLEP/);
  await page.keyboard.press('Escape');
  await goTo('7:4');
  const fix = page.locator('.action-widget .monaco-list-row', { hasText: 'SLEEP' });
  await pressed('Control+.', fix);
  await page.waitForTimeout(500);
  await shot('fix');
  await fix.click();
  await word('SLEEP').waitFor();
  await page.locator('.squiggly-error').first().waitFor({ state: 'detached' });
});

test('hover says what a command does on this robot', async () => {
  await word('PTP').hover();
  const hover = page.locator('.monaco-hover:visible').first();
  await hover.waitFor();
  await page.waitForTimeout(500);
  await shot('hover');
  const text = await hover.innerText();
  assert.match(text, /PTP \[HS\]/);
  assert.match(text, /mm/);
  await page.keyboard.press('Escape');
});

test('completion puts in a command with places to fill, once', async () => {
  await goTo('7:99');
  await page.keyboard.press('Enter');
  await page.keyboard.type('TEACH_PO');
  const rows = page.locator('.suggest-widget.visible .monaco-list-row');
  await rows.first().waitFor();
  await page.waitForTimeout(500);
  await shot('completion');
  assert.equal(await rows.filter({ hasText: 'TEACH_POSITION' }).count(), 1);
  await page.keyboard.press('Enter');
  await word('TEACH_POSITION').waitFor();
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  for (let times = 0; times < 20 && (await word('TEACH').count()) > 0; times += 1) await page.keyboard.press('Control+Z');
  await goTo('7:1');
  assert.equal(await word('SLEEP').count(), 1);
  assert.equal(await word('TEACH').count(), 0);
  await page.keyboard.press('Control+S');
  await page.locator('.tab.active.dirty').waitFor({ state: 'detached' });
});

/** The line on which the debugger stands. */
async function standing(line) {
  await page.locator('#status\\.editor\\.selection', { hasText: `Ln ${line},` }).waitFor();
  await page.locator('.debug-top-stack-frame-line').first().waitFor({ state: 'attached' });
}

test('the debugger stops at a breakpoint and steps back', async () => {
  await goTo('7:1');
  await page.keyboard.press('F9');
  await page.locator('.codicon-debug-breakpoint').first().waitFor();
  await command('T.I.P.: Debug');
  await page.locator('.debug-toolbar').waitFor();
  await standing(5);
  await page.keyboard.press('F5');
  await standing(7);
  await page.waitForTimeout(1000);
  await shot('breakpoint');
  await page.locator('.debug-toolbar .codicon-debug-step-back').click();
  await standing(6);
  await page.waitForTimeout(1000);
  await shot('step-back');
  await page.locator('.debug-toolbar .codicon-debug-reverse-continue').click();
  await standing(5);
  await page.keyboard.press('Shift+F5');
  await page.locator('.debug-toolbar').waitFor({ state: 'hidden' });
});

test('a thread of the program has a call stack, breakpoints and steps of its own', async () => {
  await show('two.prg');
  await goTo('13:1');
  await page.keyboard.press('F9');
  await command('T.I.P.: Debug');
  await page.locator('.debug-toolbar').waitFor();
  await standing(4);
  await page.keyboard.press('F5');
  await standing(13);
  const stack = page.locator('.debug-call-stack');
  await stack.locator('.thread', { hasText: 'SIDE' }).waitFor();
  await stack.locator('.thread', { hasText: 'two.prg' }).waitFor();
  await page.waitForTimeout(1000);
  await shot('threads');
  await page.keyboard.press('F10');
  await standing(14);
  await page.keyboard.press('F10');
  await standing(15);
  await page.locator('.debug-toolbar .codicon-debug-step-back').click();
  await standing(14);
  await page.locator('.debug-toolbar .codicon-debug-reverse-continue').click();
  await standing(13);
  await page.waitForTimeout(1000);
  await shot('threads-back');
  await page.keyboard.press('Shift+F5');
  await page.locator('.debug-toolbar').waitFor({ state: 'hidden' });
  await show('walk.prg');
});

test('the buttons run and trace a program', async () => {
  await show('walk.prg');
  await command('T.I.P.: Trace a Run');
  await page.locator('.tab.active', { hasText: 'walk.jsonl' }).waitFor();
  await shot('trace');
  assert.ok(existsSync(join(folder, 'walk.jsonl')));
  await show('walk.prg');
  await page.locator('.editor-actions .codicon-play').first().click();
  await page.locator('.terminal-wrapper.active').waitFor();
  await page.waitForTimeout(4000);
  await shot('run');
});

/** The encoding of the program in front. */
const encoded = (name) => page.locator('#status\\.editor\\.encoding', { hasText: name }).waitFor();

test('a program in Shift_JIS is opened as such, with a warning', async () => {
  await show('old.prg');
  await encoded('Shift JIS');
  await page.locator('.notification-toast', { hasText: 'two spellings' }).waitFor();
  const underlined = page.locator('.squiggly-warning');
  await underlined.first().waitFor({ state: 'attached' });
  await page.waitForTimeout(500);
  assert.equal(await underlined.count(), 1);
  await word('∵').hover();
  const hover = page.locator('.monaco-hover:visible').first();
  await hover.waitFor();
  await page.waitForTimeout(500);
  await shot('shift-jis');
  assert.match(await hover.innerText(), /87 9A are saved as 81 E6/);
  assert.ok(readFileSync(join(folder, 'old.prg')).equals(OLD));
});

test('a program that tip.toml says to be in Shift_JIS is saved in it', async () => {
  await show('walk.prg');
  await encoded('UTF-8');
  await show('new.prg');
  await encoded('Shift JIS');
  await goTo('3:99');
  await page.keyboard.insertText(' 歩é');
  const underlined = page.locator('.squiggly-warning');
  await underlined.first().waitFor({ state: 'attached' });
  await page.waitForTimeout(500);
  await shot('typed');
  assert.equal(await underlined.count(), 1);
  const file = join(folder, 'new.prg');
  const before = readFileSync(file);
  await page.keyboard.press('Control+S');
  // The mark of an unsaved text is gone as soon as its saving begins.
  for (let times = 0; times < 50 && readFileSync(file).equals(before); times += 1) await page.waitForTimeout(100);
  const saved = Buffer.from([...Buffer.from('3.1\n\nMESSAGE A '), 0x95, 0xe0, ...Buffer.from('?\nEND\n')]);
  assert.deepEqual(readFileSync(file), saved);
});
