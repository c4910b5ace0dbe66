// Tests the page of `tip drives record --listen` in a browser, on simulated servos, one of which a hand turns. TIP is the command that
// `run` has built, and `script` is its terminal.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import axe from 'axe-core';
import { launch, visit } from './browsers.mjs';

/** Times at which the hand turns J11 by 20 deg, s. A busy machine opens the page late. */
const TURNS = [10, 20, 30, 40];
let browser;
before(async () => (browser = await launch()));
after(() => browser?.close());

/** Starts a lesson. Returns its address, a function that presses keys, one that waits for a text, and the exit status to come. */
async function teach() {
  const file = join(mkdtempSync(join(tmpdir(), 'tip-lesson-')), 'wave.prg');
  const port = `simulated:${TURNS.map((time) => `turn=1@${time}`).join()}`;
  const command = `'${process.env.TIP}' drives record '${resolve('leg.toml')}' -o '${file}' --port ${port} --listen --lang en`;
  const child = spawn('script', ['-qefc', command, '/dev/null'], { stdio: ['pipe', 'pipe', 'inherit'] });
  let said = '';
  let heard = () => {};
  child.stdout.on('data', (data) => {
    said += data;
    heard();
  });
  const says = (pattern) =>
    new Promise((found) => {
      heard = () => pattern.test(said) && found(pattern.exec(said));
      heard();
    });
  const over = new Promise((ended) => child.on('exit', ended));
  const press = (keys) => child.stdin.write(keys);
  await says(/RETURN begins: /);
  press('\n');
  const [address] = await says(/http:\S+/);
  return { address, press, says, over, file };
}

test('a page shows the robot that a hand turns, and stops it', async () => {
  const lesson = await teach();
  const { page, complaints, close } = await visit(browser, lesson.address, { viewport: { width: 390, height: 844 }, hasTouch: true });
  const says = (text) => page.waitForFunction((text) => document.querySelector('#lesson-state').textContent.includes(text), text);
  const angle = (table) => page.$eval(`${table} tr td:nth-of-type(${table === '#joint-rows' ? 1 : 2})`, (cell) => Number(cell.textContent));
  await says('no torque');
  const first = await angle('#servo-rows');
  await page.waitForFunction((first) => Number(document.querySelector('#servo-rows tr td:nth-of-type(2)').textContent) > first + 15, first);
  const shown = await page.waitForFunction((first) => Number(document.querySelector('#joint-rows tr td').textContent) > first + 15, first);
  assert.ok(shown, 'the robot in three dimensions has the posture of the servos');
  for (const hidden of ['#halt', '#keys', '#transport', '#source-tab', '#knobs']) assert.equal(await page.isVisible(hidden), false, hidden);
  const stop = await page.locator('#stop').boundingBox();
  assert.ok(stop.y + stop.height <= 844 && stop.height >= 44, 'the stop is reached without scrolling');
  lesson.press(' ');
  await page.waitForFunction(() => document.querySelector('#poses [aria-current]')?.textContent === 'POSE1');
  await page.evaluate(axe.source);
  const { violations } = await page.evaluate(() => window.axe.run('#controls'));
  assert.deepEqual(violations.map(({ id }) => id), []);
  lesson.press('g');
  await says('holds pose POSE1');
  await page.click('#stop');
  assert.equal(await lesson.over, 3);
  await page.waitForSelector('#lost:not([hidden])');
  assert.ok(existsSync(lesson.file));
  assert.deepEqual(complaints.filter((text) => !/WebSocket/.test(text)), []);
  await close();
});
