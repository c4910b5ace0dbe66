// Tests the page of `tip serve` in a browser. TIP is the command that `run` has built.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import axe from 'axe-core';
import { launch, visit } from './browsers.mjs';
import { serve } from './served.mjs';

/** Graphics by software take their time. */
const SMALL = { width: 1000, height: 560 };
/** counts.prg counts once in so many cycles. */
const TURN = 8;
let browser;
let server;
let view;
before(async () => (browser = await launch()));
after(() => browser?.close());
beforeEach(async () => {
  server = await serve('counts.prg');
  view = await visit(browser, server.address, { viewport: SMALL });
});
afterEach(async () => {
  await view?.close();
  assert.equal(await server.end(), 130);
});

const cycle = (page) => page.$eval('#now-cycle', (element) => Number(element.textContent.split(' ')[0]));
/** Waits until an element says something. */
const says = (page, selector, text) =>
  page.waitForFunction(([selector, text]) => document.querySelector(selector).textContent.includes(text), [selector, text]);
const value = async (page, name) => {
  await page.click('#state-tab');
  return page.locator(`#variables tr:has(button:text-is("${name}")) td:nth-child(2)`).textContent();
};
const rests = async (page) => {
  await page.click('#play');
  await says(page, '#outcome', 'paused');
};
/** Returns the editor's text, which is in a tree of its own. */
const editor = (page) => page.locator('#editor .cm-content');
const write = async (page, line, text, key) => {
  await page.click('#source-tab');
  // The pointer could miss a line that moves, as the list of findings grows and shrinks.
  await editor(page).focus();
  await page.keyboard.press('Control+Home');
  for (let down = 1; down < line; down += 1) await page.keyboard.press('ArrowDown');
  if (key) await page.keyboard.press(key);
  await page.keyboard.type(text);
};

test('runs, and complains of nothing', async () => {
  const { page, complaints } = view;
  const first = await cycle(page);
  await page.waitForTimeout(600);
  assert.ok((await cycle(page)) > first, 'it runs');
  assert.equal(await page.textContent('#outcome'), 'running');
  await page.waitForFunction(() => document.querySelector('#editor').shadowRoot.querySelector('.lit'));
  assert.deepEqual(complaints, []);
});

test('takes a key and a knob', async () => {
  const { page } = view;
  await page.fill('#keys', '');
  await page.focus('#keys');
  await page.keyboard.type('F');
  await says(page, '#message', 'key');
  assert.equal(await value(page, 'K'), '70');
  await page.locator('input[data-input=VR1]').fill('7.5');
  await page.waitForTimeout(300);
  assert.equal(await value(page, 'V'), '7.500');
  assert.match(await page.textContent('#inputs'), /VR1=7.5/);
});

test('rests, and steps forward and back', async () => {
  const { page } = view;
  await rests(page);
  const at = await cycle(page);
  const before = await value(page, 'N');
  for (let n = 0; n < TURN; n++) await page.click('#forward');
  await page.waitForFunction((at) => document.querySelector('#now-cycle').textContent.startsWith(`${at} `), at + TURN);
  assert.equal(Number(await value(page, 'N')), Number(before) + 1);
  for (let n = 0; n < TURN; n++) await page.click('#back');
  await page.waitForFunction((at) => document.querySelector('#now-cycle').textContent.startsWith(`${at} `), at);
  assert.equal(await value(page, 'N'), before);
});

test('looks back while the run goes on, and goes on from there', async () => {
  const { page } = view;
  await page.waitForFunction(() => Number(document.querySelector('#scrub').max) > 60);
  await page.$eval('#scrub', (slider) => {
    slider.value = 20;
    slider.dispatchEvent(new Event('input'));
  });
  const size = () => page.$eval('#canvas', ({ clientWidth, clientHeight }) => [clientWidth, clientHeight]);
  const before = await size();
  await page.waitForSelector('#past:not([hidden])');
  await page.waitForTimeout(300);
  assert.equal(await cycle(page), 20);
  assert.deepEqual(await size(), before, 'the stage is as large as before');
  const newest = () => page.$eval('#scrub', (slider) => Number(slider.max));
  const last = await newest();
  // It goes on from cycle 20, and forgets the cycles after it. The test looks from before the click on, because it grows again.
  const shorter = page.waitForFunction((last) => Number(document.querySelector('#scrub').max) < last, last);
  await page.click('#go-on');
  await shorter;
  await page.waitForSelector('#past', { state: 'hidden' });
  await says(page, '#outcome', 'running');
  await page.waitForFunction(() => Number(document.querySelector('#scrub').max) > 40);
});

test('sets a variable', async () => {
  const { page } = view;
  await page.click('#state-tab');
  await page.click('#variables tr:has(button:text-is("N")) td:nth-child(2)');
  await page.keyboard.type('5000');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => Number([...document.querySelectorAll('#variables tr')].find((row) => row.textContent.startsWith('N')).cells[1].textContent) >= 5000);
  assert.equal(await page.isHidden('#push'), true, 'a robot without mass is not pushed');
  await page.click('#log-tab');
  await says(page, '#marks', 'set N=5000');
});

test('tells when the program has read a changed variable, and writes its value into the program', async () => {
  const reads = await serve('reads.prg');
  const { page, complaints, close } = await visit(browser, reads.address, { viewport: SMALL });
  await page.click('#state-tab');
  const row = page.locator('#variables tr:has(button:text-is("SPEED"))');
  // The program has assigned it, so that there is nothing to write.
  await row.locator('.from button:text-is("line 5")').waitFor();
  await row.locator('td').first().click();
  await page.keyboard.type('350');
  await page.keyboard.press('Enter');
  await says(page, '#message', 'at 350 mm/s');
  await row.locator('.from button:text-is("not read yet")').waitFor();
  assert.equal(await row.locator('.from button').first().isDisabled(), true);
  await page.focus('#keys');
  await page.keyboard.type('F');
  await row.locator('.from button:text-is("read: line 11")').waitFor();
  assert.equal(await value(page, 'N'), '350');
  await row.locator('.from button').first().click();
  await page.waitForFunction(() => document.querySelector('#now-line').textContent === '11');
  // At a cycle before the change the cell has the value of then, though it has the focus.
  await row.locator('td').first().focus();
  await page.keyboard.press('Home');
  await page.waitForFunction(() => [...document.querySelectorAll('#variables tr')].find((row) => row.textContent.startsWith('SPEED')).cells[1].textContent === '300');
  await page.click('#newest');
  await row.locator('.from button:text-is("write")').click();
  await says(page, '#notice', 'Line 5 is now SPEED = 350. Run from start uses it.');
  await row.locator('.from button:text-is("write")').waitFor({ state: 'hidden' });
  await page.click('#source-tab');
  assert.match(await editor(page).textContent(), /SPEED = 350 {3}\/\/ mm\/s/);
  await page.click('#restart');
  await page.waitForFunction(() => document.querySelector('#outcome').textContent === 'running');
  await page.click('#state-tab');
  await row.locator('.from button:text-is("line 5")').waitFor();
  assert.equal(await value(page, 'SPEED'), '350');
  assert.deepEqual(complaints, []);
  await close();
  assert.equal(await reads.end(), 130);
});

test('a variable looks as if it could be changed, and the lines of the program do not show through their numbers', async () => {
  const { page } = view;
  await page.click('#state-tab');
  const style = await page.locator('#variables td.assignable').first().evaluate((cell) => {
    const { cursor, textDecorationLine, textDecorationStyle } = getComputedStyle(cell);
    return [cursor, textDecorationLine, textDecorationStyle, cell.tabIndex];
  });
  assert.deepEqual(style, ['text', 'underline', 'dashed', 0]);
  await page.click('#source-tab');
  const ground = await page.$eval('#editor', (editor) => getComputedStyle(editor.shadowRoot.querySelector('.cm-gutters')).backgroundColor);
  assert.match(ground, /^rgb\(/, 'it is opaque');
});

test('runs from the start even if it was paused', async () => {
  const { page } = view;
  await rests(page);
  await page.click('#restart');
  await says(page, '#outcome', 'running');
  await page.waitForFunction(() => Number(document.querySelector('#now-cycle').textContent.split(' ')[0]) > 5);
});

for (const [end, button] of [['EXIT', '#halt'], ['emergency stop', '#stop']]) {
  test(`a run that was over before the page was opened runs again: ${end}`, async () => {
    await view.page.click(button);
    await says(view.page, '#outcome', end);
    await view.close();
    view = await visit(browser, server.address, { viewport: SMALL });
    const { page } = view;
    await says(page, '#outcome', end);
    assert.equal(await page.getAttribute('#play', 'aria-label'), 'Run again');
    assert.equal(await page.isDisabled('#play'), false);
    await page.click('#play');
    await says(page, '#outcome', 'running');
    assert.equal(await page.getAttribute('#play', 'aria-label'), 'Pause');
  });
}

test('the cursor of the plots stays in view when one looks at a cycle before those that they followed', async () => {
  const { page, close } = await visit(browser, server.address, { viewport: { width: 1280, height: 900 } });
  await page.selectOption('#speed', '10');
  // Plots follow the last 30 s.
  await page.waitForFunction(() => Number(document.querySelector('#scrub').max) > 2000, undefined, { timeout: 60_000 });
  await page.$eval('#scrub', (slider) => {
    slider.value = 50;
    slider.dispatchEvent(new Event('input'));
  });
  await page.waitForFunction(() => {
    const [head, plot] = ['.chart .u-over .playhead', '.chart .u-over'].map((part) => document.querySelector(part).getBoundingClientRect());
    return head.width && head.left >= plot.left && head.left <= plot.left + plot.width * 0.2;
  });
  await close();
});

test('pushes a robot with mass', async () => {
  const massive = await serve('counts.prg', '--plant', 'dynamic');
  const { page, close } = await visit(browser, massive.address, { viewport: SMALL });
  await page.fill('#push-x', '30');
  await page.click('#push button');
  await page.click('#log-tab');
  await says(page, '#marks', 'push 30 80 0 for 5');
  await close();
  assert.equal(await massive.end(), 130);
});

test('shows that a halt is pending', async () => {
  const { page } = view;
  await rests(page);
  await page.click('#halt');
  assert.equal(await page.getAttribute('#halt', 'aria-pressed'), 'true');
  assert.equal(await page.textContent('#halt'), 'Halt requested');
  await page.click('#play');
  await says(page, '#outcome', 'EXIT');
  await says(page, '#halt', 'Halt');
  assert.equal(await page.getAttribute('#halt', 'aria-pressed'), 'false');
});

test('what can be written, and what is known of it, stay inside the editor', async () => {
  for (const width of [1440, 1024]) {
    const wide = await visit(browser, server.address, { viewport: { width, height: 800 } });
    const { page } = wide;
    await page.locator('#editor .cm-line').nth(3).click();
    await page.keyboard.press('End');
    await page.keyboard.press('Enter');
    await page.keyboard.type('REL');
    await page.waitForFunction(() => document.querySelector('#editor').shadowRoot.querySelector('.cm-completionInfo'));
    await page.waitForTimeout(200);
    const [list, info, room] = await page.$eval('#editor', (editor) => {
      const box = (element) => element.getBoundingClientRect().toJSON();
      return [...['.cm-tooltip-autocomplete', '.cm-completionInfo'].map((part) => box(editor.shadowRoot.querySelector(part))), box(editor)];
    });
    for (const part of [list, info]) assert.ok(part.left >= room.left - 1 && part.right <= room.right + 1, `${width}: ${JSON.stringify([list, info, room])}`);
    assert.ok(info.top >= list.bottom - 2 || info.bottom <= list.top + 2, `${width}: it covers what is offered`);
    await wide.close();
  }
});

test('says that it is not connected, and offers nothing that needs a connection', async () => {
  await view.close();
  const sockets = [];
  const { page, close } = await visit(browser, server.address, { viewport: SMALL }, (page) =>
    page.routeWebSocket(/live/, (socket) => {
      if (!sockets.length) socket.connectToServer();
      else socket.close();
      sockets.push(socket);
    }),
  );
  await sockets[0].close();
  await page.waitForSelector('#lost:not([hidden])', { state: 'attached' });
  assert.match(await page.textContent('#lost'), /^Not connected\..*open the address/);
  for (const part of ['#controls', '#play', '#restart', '#save']) assert.equal(await page.$eval(part, (element) => element.inert), true, part);
  await close();
});

test('finds an error where it is written, and runs the program when it is put right', async () => {
  const { page } = view;
  await write(page, 12, 'X');
  await page.waitForSelector('.problem.error');
  assert.match(await page.textContent('#problems'), /12:1.*XMESSAGE/);
  assert.equal(await page.locator('#editor .cm-lintRange-error').count(), 1);
  await page.click('#language');
  assert.match(await page.textContent('#problems'), /[ぁ-ん]/);
  await page.click('#language');
  await page.click('#restart');
  await says(page, '#notice', 'errors');
  await says(page, '#file-state', 'not saved');
  await write(page, 12, '', 'Delete');
  await page.waitForSelector('.problem.error', { state: 'detached' });
  await write(page, 2, 'New: ');
  await page.click('#restart');
  await says(page, '#title', 'New: Counts');
  assert.equal(await page.isHidden('#past'), true, 'the keys are those of the editor');
  await page.click('#save');
  await page.waitForFunction(() => document.querySelector('#file-state').textContent === 'saved');
  assert.match(readFileSync(server.file, 'utf8'), /^3\.1\nNew: Counts/);
});

test('runs the text that stands there, while the one before is still on its way', async () => {
  const { page, close } = await visit(browser, server.address, { viewport: SMALL }, (page) =>
    page.routeWebSocket(/live/, (socket) => {
      const session = socket.connectToServer();
      session.onMessage((message) => setTimeout(() => socket.send(message), 700));
    }),
  );
  await write(page, 2, 'New: ');
  // The text is sent when no key came for a while.
  await page.waitForTimeout(300);
  await page.keyboard.type('and newer: ');
  await page.click('#restart');
  await says(page, '#title', 'New: and newer: Counts');
  // A change that is taken back before it has arrived does not come back.
  await write(page, 12, 'Q');
  await page.waitForTimeout(300);
  await page.keyboard.press('Backspace');
  await page.waitForTimeout(2000);
  assert.doesNotMatch(await editor(page).textContent(), /QMESSAGE/);
  await close();
});

test('shows another text when its file changes', async () => {
  const { page } = view;
  writeFileSync(server.file, readFileSync(server.file, 'utf8').replace('Counts,', 'Changed:'));
  await says(page, '#title', 'Changed:');
  // The text follows its run.
  await editor(page).filter({ hasText: 'Changed:' }).waitFor();
});

test('halts', async () => {
  const { page } = view;
  await page.click('#halt');
  await says(page, '#message', 'halted');
  await says(page, '#outcome', 'EXIT');
});

test('stops in an emergency, and runs again', async () => {
  const { page } = view;
  await page.click('#stop');
  await says(page, '#outcome', 'emergency stop');
  assert.equal(await page.textContent('#alert'), 'emergency stop');
  await page.click('#restart');
  await says(page, '#outcome', 'running');
});

test('two pages see one run', async () => {
  const other = await visit(browser, server.address, { viewport: SMALL });
  await rests(view.page);
  await says(other.page, '#outcome', 'paused');
  assert.equal(await cycle(other.page), await cycle(view.page));
  await write(other.page, 2, 'Both: ');
  await view.page.waitForFunction(() => document.querySelector('#editor').shadowRoot.textContent.includes('Both: '));
  await other.close();
});

test('reaches the server anew', async () => {
  await view.close();
  const sockets = [];
  const { page, close } = await visit(browser, server.address, { viewport: SMALL }, (page) =>
    page.routeWebSocket(/live/, (socket) => {
      socket.connectToServer();
      sockets.push(socket);
    }),
  );
  const first = await cycle(page);
  await sockets[0].close();
  await page.waitForSelector('#lost:not([hidden])', { state: 'attached' });
  await page.waitForSelector('#lost', { state: 'hidden' });
  await page.waitForFunction((first) => Number(document.querySelector('#now-cycle').textContent.split(' ')[0]) > first + 10, first);
  assert.equal(sockets.length, 2);
  await page.click('#play');
  await says(page, '#outcome', 'paused');
  await close();
});

test('has nothing that axe objects to, in both schemes and languages', async () => {
  await rests(view.page);
  await view.close();
  for (const colorScheme of ['light', 'dark']) {
    for (const locale of ['en', 'ja']) {
      const { page, close } = await visit(browser, server.address, { viewport: SMALL, colorScheme, locale, bypassCSP: true });
      await write(page, 2, 'x');
      await page.evaluate(axe.source);
      for (const tab of ['source-tab', 'state-tab', 'log-tab']) {
        await page.click(`#${tab}`);
        const { violations } = await page.evaluate(() => globalThis.axe.run());
        const found = violations.map(({ id, nodes }) => `${colorScheme} ${locale} ${tab} ${id}: ${nodes[0].target} ${nodes[0].failureSummary}`);
        assert.deepEqual(found, []);
      }
      await close();
    }
  }
});
