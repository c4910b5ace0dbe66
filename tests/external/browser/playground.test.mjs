// Tests the playground in a browser. SITE is the folder that site/build has filled.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, describe, test } from 'node:test';
import axe from 'axe-core';
import { launch, visit } from './browsers.mjs';

const one = `file://${process.env.SITE}/playground.html`;
/** A program that counts its cycles, and shows the key that was pressed, the reading of VR1, and a request to halt. */
const COUNTS = readFileSync(`${import.meta.dirname}/counts.prg`, 'utf8');
/** It counts once in so many cycles. */
const TURN = 8;
/** Graphics by software take their time. */
const SMALL = { width: 1000, height: 620 };
let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const open = (address = `${one}#lesson=1`, options = {}) => visit(browser, address, { viewport: SMALL, locale: 'en', ...options });
const cycle = (page) => page.$eval('#now-cycle', (element) => Number(element.textContent.split(' ')[0]));
const says = (page, selector, text) =>
  page.waitForFunction(([selector, text]) => document.querySelector(selector).textContent.includes(text), [selector, text]);
const value = async (page, name) => {
  await page.click('#state-tab');
  return page.locator(`#variables tr:has(button:text-is("${name}")) td:nth-child(2)`).textContent();
};
/** Writes a program into the editor, and waits until the address has it. */
async function write(page, text) {
  const before = new URL(page.url()).hash;
  await page.click('#source-tab');
  await page.locator('#editor .cm-content').click();
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(text);
  await page.keyboard.press('Escape');
  await page.waitForFunction((before) => location.hash !== before, before);
}
/** Runs another program than that of the page. */
async function run(page, text) {
  await write(page, text);
  await page.click('#restart');
}

describe('one file', () => {
  test('asks for nothing, complains of nothing, and is accessible in both schemes and languages', async () => {
    for (const colorScheme of ['light', 'dark']) {
      for (const locale of ['en', 'ja']) {
        const { page, asked, complaints, close } = await open(one, { colorScheme, locale, bypassCSP: true });
        assert.deepEqual(asked, [one]);
        assert.match(await page.textContent('#file'), /walk\.prg/);
        // axe takes turns with the page, and fails where an element that it has seen is gone.
        await page.click('#play');
        await says(page, '#outcome', locale === 'ja' ? '一時停止中' : 'paused');
        await page.evaluate(axe.source);
        for (const tab of ['source-tab', 'state-tab', 'log-tab']) {
          await page.click(`#${tab}`);
          const { violations } = await page.evaluate(() => globalThis.axe.run());
          const found = violations.map(({ id, nodes }) => `${colorScheme} ${locale} ${tab} ${id}: ${nodes[0].target} ${nodes[0].failureSummary}`);
          assert.deepEqual(found, []);
        }
        assert.deepEqual(complaints, []);
        await close();
      }
    }
  });

  test('opens on a robot that moves, which a telephone shows without scrolling', async () => {
    const { page, close } = await open(one, { viewport: { width: 390, height: 844 } });
    const { y, height } = await page.locator('#canvas').boundingBox();
    assert.ok(y >= 0 && y + height <= 844, `${y} ${height}`);
    // It stands up.
    await page.waitForFunction(() => Number(document.querySelector('#scrub').max) > 60, undefined, { timeout: 60_000 });
    await page.click('#state-tab');
    assert.notEqual(await page.locator('#joint-rows td').nth(0).textContent(), '–');
    await page.click('#lesson-after');
    await says(page, '#file', '01-hello');
    await close();
  });

  test('what is written into a lesson is there again after another one', async () => {
    const { page, close } = await open();
    const { length } = await page.locator('#editor .cm-line').all();
    await write(page, '3.1\nMine\nMESSAGE mine\nEND\n');
    await page.click('#lesson-after');
    await says(page, '#file', '02-foot');
    assert.equal(await page.isHidden('#original'), true);
    await page.click('#lesson-before');
    await says(page, '#title', 'Mine');
    await page.waitForFunction(() => location.hash.includes('program='));
    await page.click('#original');
    await says(page, '#file', '01-hello');
    assert.notEqual(await page.textContent('#title'), 'Mine');
    assert.equal((await page.locator('#editor .cm-line').all()).length, length);
    await close();
  });

  test('keeps what each pupil writes, until it is discarded', async () => {
    const { page, close } = await open(`${one}?pupil=Aiko#lesson=1`);
    assert.equal(await page.textContent('#lesson-number'), 'Aiko · 1 of 11');
    await write(page, '3.1\nBy Aiko\nMESSAGE mine\nEND\n');
    const visited = async (pupil) => {
      await page.goto('about:blank');
      await page.goto(`${one}?pupil=${pupil}#lesson=1`);
      await page.waitForSelector('html[data-ready]', { state: 'attached' });
    };
    await visited('Ken');
    assert.notEqual(await page.textContent('#title'), 'By Aiko');
    assert.equal(await page.isHidden('#original'), true);
    await visited('Aiko');
    await says(page, '#title', 'By Aiko');
    await page.click('#original');
    await visited('Aiko');
    assert.notEqual(await page.textContent('#title'), 'By Aiko');
    await close();
  });

  const MINE = '3.1\nMine\nMESSAGE mine\nEND\n';
  const ready = (page) => page.waitForSelector('html[data-ready]', { state: 'attached' });

  test('a lesson stays the lesson after a reload, with what was written and its inputs', async () => {
    const { page, close } = await open(`${one}#lesson=6`);
    await write(page, MINE);
    await page.fill('#scripted', '2:key Q');
    await page.keyboard.press('Tab');
    await page.waitForFunction(() => location.hash.includes('events=2%3Akey+Q'));
    await page.reload();
    await ready(page);
    assert.equal(await page.inputValue('#choice'), 'lesson 6');
    assert.equal(await page.isVisible('#lesson'), true);
    await write(page, MINE.replaceAll('ine', 'ore'));
    await page.click('#lesson-after');
    await page.click('#lesson-before');
    await says(page, '#title', 'More');
    assert.equal(await page.inputValue('#scripted'), '2:key Q');
    await close();
  });

  test('what was discarded is there again by Back', async () => {
    const { page, close } = await open(`${one}#lesson=2`);
    await write(page, MINE);
    await page.click('#original');
    await page.waitForFunction(() => location.hash === '#lesson=2');
    assert.notEqual(await page.textContent('#title'), 'Mine');
    await page.goBack();
    await says(page, '#title', 'Mine');
    assert.equal(await page.inputValue('#choice'), 'lesson 2');
    await close();
  });

  test('a program of one\'s own begins with what is shown, and is no lesson any more', async () => {
    const { page, close } = await open(`${one}#lesson=4`);
    await page.selectOption('#choice', 'own');
    await page.waitForSelector('#lesson', { state: 'hidden' });
    await write(page, MINE);
    await page.waitForFunction(() => localStorage['tip-lessons  own']?.includes('Mine'));
    await page.selectOption('#choice', 'lesson 4');
    await says(page, '#file', '04-loop');
    assert.equal(await page.isHidden('#original'), true);
    await page.selectOption('#choice', 'own');
    await says(page, '#title', 'Mine');
    await close();
  });

  test('a program that was sent takes no place of one\'s own, and Back returns to it', async () => {
    const { page, close } = await open(`${one}#lesson=2`);
    await write(page, MINE);
    const sent = page.url();
    await page.click('#original');
    await page.waitForFunction(() => location.hash === '#lesson=2' && !document.querySelector('#editor').textContent.includes('Mine'));
    await write(page, MINE.replaceAll('ine', 'ore'));
    await page.goto('about:blank');
    await page.goto(sent);
    await ready(page);
    await says(page, '#title', 'Mine');
    assert.equal(await page.inputValue('#choice'), 'own');
    await page.selectOption('#choice', 'lesson 2');
    await says(page, '#title', 'More');
    await page.goBack();
    await says(page, '#title', 'Mine');
    await close();
  });

  test('two tabs keep what is written in both', async () => {
    const { page, close } = await open(`${one}#lesson=6`);
    const other = await page.context().newPage();
    await other.goto(`${one}#lesson=7`);
    await ready(other);
    await write(page, MINE);
    await write(other, MINE.replaceAll('ine', 'ore'));
    await other.selectOption('#choice', 'lesson 6');
    await says(other, '#title', 'Mine');
    await other.selectOption('#choice', 'lesson 7');
    await says(other, '#title', 'More');
    await close();
  });

  test('takes a key and a slider, and halts', async () => {
    const { page, complaints, close } = await open();
    await run(page, COUNTS);
    await says(page, '#outcome', 'running');
    await page.focus('#keys');
    await page.keyboard.type('F');
    await says(page, '#message', 'key');
    assert.equal(await value(page, 'K'), '70');
    await page.locator('input[data-input=VR1]').fill('7.5');
    await page.waitForTimeout(300);
    assert.equal(await value(page, 'V'), '7.500');
    await page.click('#halt');
    await says(page, '#message', 'halted');
    await says(page, '#outcome', 'EXIT');
    assert.deepEqual(complaints, []);
    await close();
  });

  test('rests, and steps forward and back', async () => {
    const { page, close } = await open();
    await run(page, COUNTS);
    await says(page, '#outcome', 'running');
    await page.click('#play');
    await says(page, '#outcome', 'paused');
    const at = await cycle(page);
    const before = await value(page, 'N');
    for (let n = 0; n < TURN; n++) await page.click('#forward');
    await page.waitForFunction((at) => document.querySelector('#now-cycle').textContent.startsWith(`${at} `), at + TURN);
    assert.equal(Number(await value(page, 'N')), Number(before) + 1);
    for (let n = 0; n < TURN; n++) await page.click('#back');
    await page.waitForFunction((at) => document.querySelector('#now-cycle').textContent.startsWith(`${at} `), at);
    assert.equal(await value(page, 'N'), before);
    await close();
  });

  test('stops in an emergency, and runs again', async () => {
    const { page, close } = await open();
    await run(page, COUNTS);
    await says(page, '#outcome', 'running');
    await page.click('#stop');
    await says(page, '#outcome', 'emergency stop');
    await page.click('#restart');
    await says(page, '#outcome', 'running');
    await close();
  });

  test('shows an error at its place, and runs the program after it is put right', async () => {
    const { page, close } = await open();
    await write(page, '3.1\nrises\nSTAND_UPP 60\nMESSAGE risen\nEND\n');
    await page.waitForSelector('.problem.error');
    assert.match(await page.textContent('#problems'), /3:1.*STAND_UPP/);
    assert.equal(await page.locator('#editor .cm-lintRange-error').textContent(), 'STAND_UPP');
    await page.click('#restart');
    await says(page, '#notice', 'errors');
    await write(page, '3.1\nrises\nSTAND_UP 60\nMESSAGE risen\nEND\n');
    await page.waitForSelector('.problem', { state: 'detached' });
    await page.click('#restart');
    await says(page, '#title', 'rises');
    await says(page, '#message', 'risen');
    await close();
  });

  test('says what words are, and what can be written', async () => {
    const { page, close } = await open();
    await write(page, '3.1\nrises\nSTAND_UP 60\nEND\n');
    await page.locator('#editor .cm-line').nth(2).hover({ position: { x: 20, y: 8 } });
    await page.locator('#editor .known').waitFor();
    assert.match(await page.locator('#editor .known').textContent(), /STAND_UP.*mm/s);
    // Away from the word, its description goes.
    await page.mouse.move(1, 1);
    await page.locator('#editor .known').waitFor({ state: 'detached' });
    await page.locator('#editor .cm-line').nth(3).click();
    await page.keyboard.press('Home');
    await page.keyboard.type('SIT');
    await page.locator('#editor .cm-tooltip-autocomplete li', { hasText: 'SIT_DOWN' }).waitFor();
    // The editor takes no key for the list that may have been meant for the text.
    await page.waitForTimeout(200);
    await page.keyboard.press('Enter');
    assert.match(await page.locator('#editor .cm-line').nth(3).textContent(), /^SIT_DOWN/);
    await close();
  });

  test('a lesson, an example and a program of one\'s own have addresses', async () => {
    const { page, close } = await open(`${one}#lesson=10`);
    assert.equal(await page.textContent('#lesson-title'), 'A hand that grasps');
    assert.match(await page.textContent('#file'), /grasp\.prg · hand/);
    assert.equal(await page.locator('#modes dt').count(), 3);
    await page.selectOption('#choice', 'example 3');
    await says(page, '#file', 'tripod.prg');
    assert.equal(await page.locator('#modes dt').count(), 6);
    assert.equal(await page.isHidden('#lesson'), true);
    assert.equal(new URL(page.url()).hash, '#example=3');
    await write(page, '3.1\n足を上げる 🤖\nMESSAGE はい\nEND\n');
    const address = page.url();
    assert.match(address, /#example=3&robot=hexapod&events=&program=/);
    await close();
    const other = await open(address);
    await says(other.page, '#title', '足を上げる 🤖');
    assert.equal(await other.page.inputValue('#robot'), 'hexapod');
    await other.close();
  });

  test('another robot, and inputs that come by themselves, begin the run anew', async () => {
    const { page, complaints, close } = await open();
    await write(page, COUNTS);
    await page.fill('#scripted', '20:key F');
    await page.keyboard.press('Tab');
    await says(page, '#message', 'key');
    await page.fill('#scripted', 'soon');
    await page.keyboard.press('Tab');
    await page.waitForSelector('#notice:not([hidden])');
    await page.fill('#scripted', '');
    await page.keyboard.press('Tab');
    await page.selectOption('#robot', 'hand');
    await says(page, '#file', '· hand');
    await says(page, '#outcome', 'running');
    assert.equal(await page.locator('#modes dt').count(), 3);
    assert.deepEqual(complaints, []);
    await close();
  });

  test('what an address holds never becomes markup', async () => {
    const { page, close } = await open();
    await write(page, '3.1\n</script><img src=x onerror=alert(1)>\nMESSAGE <b>\nEND\n');
    const address = page.url();
    await close();
    const other = await open(address);
    await says(other.page, '#title', '</script><img');
    assert.deepEqual(other.complaints, []);
    await other.close();
  });

  test('an address may hold a program with errors', async () => {
    const { page, close } = await open();
    await write(page, '3.1\nx\nMESAGE a\nEND\n');
    const address = page.url();
    await close();
    const other = await open(address);
    await other.page.waitForSelector('.problem.error');
    assert.match(await other.page.locator('#editor .cm-content').textContent(), /MESAGE a/);
    await other.close();
  });

  test('speaks Japanese, findings included', async () => {
    const { page, close } = await open(`${one}#lesson=8`, { locale: 'ja' });
    assert.equal(await page.textContent('#lesson-title'), '支持三角形');
    await write(page, '3.1\nx\nMESAGE a\nEND\n');
    await page.waitForSelector('.problem.error');
    assert.match(await page.textContent('#problems'), /コマンドはありません/);
    await page.click('#language');
    assert.match(await page.textContent('#problems'), /not a command/);
    assert.equal(await page.textContent('#lesson-title'), 'The support triangle');
    await close();
  });
});
