// Tests the page of `tip serve --hardware` in a browser, on simulated servos. The tests use touch, a stubbed gamepad, pages that are
// frozen, closed and out of focus, and two pages. TIP is the command that `run` has built.
import assert from 'node:assert/strict';
import { resolve } from 'node:path';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import axe from 'axe-core';
import { launch, visit } from './browsers.mjs';
import { serve } from './served.mjs';

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true };
const DESK = { viewport: { width: 1440, height: 900 } };
let browser;
let server;
const views = [];
before(async () => (browser = await launch()));
after(() => browser?.close());
beforeEach(async () => (server = await serve('steered.prg', '--hardware', resolve('leg.toml'), '--port', 'simulated')));
afterEach(async () => {
  for (const view of views.splice(0)) await view.close();
  assert.equal(await server.end(), 130);
});

const open = async (options = PHONE, prepare) => {
  const view = await visit(browser, server.address, options, prepare);
  views.push(view);
  await view.page.waitForSelector('html[data-hardware]', { state: 'attached' });
  return view;
};
const says = (page, text) => page.waitForFunction((text) => document.querySelector('#drive-state').textContent.includes(text), text);
/** Returns the angle of J11 as its servo measures it, deg. */
const angle = (page) => page.$eval('#servo-rows tr td:nth-child(3)', (cell) => Number(cell.textContent));
/** Waits until J11 is between two angles. */
const turns = (page, least, most) =>
  page.waitForFunction(
    ([least, most]) => {
      const deg = Number(document.querySelector('#servo-rows tr td:nth-child(3)').textContent);
      return deg >= least && deg <= most;
    },
    [least, most],
  );
const cycle = (page) => page.$eval('#now-cycle', (element) => Number(element.textContent.split(' ')[0]));
const centre = async (page, selector) => {
  const { x, y, width, height } = await page.locator(selector).boundingBox();
  return { x: x + width / 2, y: y + height / 2 };
};
/** Opens a page that drives. */
const driver = async (options, prepare) => {
  const view = await open(options, prepare);
  await view.page.click('#take');
  await view.page.waitForSelector('#give:not([hidden])');
  return view;
};
/** Returns functions that put fingers on the screen of a page, and lift them. */
const fingers = async (page) => {
  const devtools = await page.context().newCDPSession(page);
  const down = new Map();
  const tell = (type, ids) => devtools.send('Input.dispatchTouchEvent', { type, touchPoints: ids.map((id) => ({ id, ...down.get(id) })) });
  return {
    put(id, at) {
      const isNew = !down.has(id);
      down.set(id, at);
      return tell(isNew ? 'touchStart' : 'touchMove', [...down.keys()]);
    },
    /** The end of a touch names the finger that is lifted. */
    async lift(id) {
      await tell('touchEnd', [id]);
      down.delete(id);
    },
  };
};
const RUNS = 'The program runs';

/** Presses the button until the program runs. A page that is busy with its graphics lets a press lapse; then it is repeated. */
const drivesBy = async (page, press, release) => {
  await says(page, 'no torque');
  for (let times = 0; times < 10; times += 1) {
    await press();
    const runs = await page
      .waitForFunction((text) => document.querySelector('#drive-state').textContent.includes(text), RUNS, { timeout: 4000 })
      .catch(() => undefined);
    if (runs) return;
    await release();
  }
  assert.fail(await page.textContent('#drive-state'));
};
/** Holds the button with a finger until the program runs. */
const drives = async (page) => {
  const touch = await fingers(page);
  const at = await centre(page, '#hold');
  await drivesBy(page, () => touch.put(0, at), () => touch.lift(0));
  return touch;
};

test('a finger on the button and one on the pad drive the robot', async () => {
  const { page, complaints } = await driver();
  // Both thumbs reach what they need without scrolling.
  for (const part of ['#stop', '#hold', '#stick', '#sidestep']) {
    const { x, y, width, height } = await page.locator(part).boundingBox();
    assert.ok(x >= 0 && x + width <= 390 && y >= 0 && y + height <= 844 && height >= 44, part);
  }
  const touch = await drives(page);
  const { x, y } = await centre(page, '#stick');
  await touch.put(1, { x, y });
  await touch.put(1, { x, y: y - 60 });
  await turns(page, 30, 90);
  await touch.lift(1);
  await turns(page, -1, 1);
  await touch.lift(0);
  await says(page, 'Paused');
  const paused = await cycle(page);
  await touch.put(0, await centre(page, '#hold'));
  await page.waitForFunction((paused) => Number(document.querySelector('#now-cycle').textContent.split(' ')[0]) > paused + 5, paused);
  await page.click('#halt', { noWaitAfter: true });
  await says(page, 'was left');
  assert.deepEqual(complaints, []);
});

test('a page that is stuck pauses the robot, and moves nothing when it is back', async () => {
  const { page } = await driver();
  const watcher = await open(DESK);
  await drives(page);
  await watcher.page.waitForFunction(() => document.querySelector('#drive-state').textContent.includes('The program runs'));
  await page.evaluate(() => {
    const end = performance.now() + 1500;
    while (performance.now() < end);
  });
  await says(watcher.page, 'Paused');
  const paused = await cycle(watcher.page);
  await page.waitForTimeout(500);
  assert.equal(await page.getAttribute('#hold', 'aria-pressed'), 'true', 'the finger is still there');
  assert.equal(await cycle(watcher.page), paused);
});

test('a page out of focus lets go of the button', async () => {
  const { page } = await driver();
  await drives(page);
  await page.evaluate(() => window.dispatchEvent(new Event('blur')));
  await says(page, 'Paused');
  assert.equal(await page.getAttribute('#hold', 'aria-pressed'), 'false');
});

test('a closed page ends the run in order', async () => {
  const view = await driver();
  const watcher = await open(DESK);
  await drives(view.page);
  await views.shift().close();
  await says(watcher.page, 'was left');
  assert.match(await watcher.page.textContent('#outcome'), /^EXIT/);
  await says(watcher.page, 'Nobody drives');
});

test('a watcher stops the robot and does nothing else', async () => {
  const { page } = await driver();
  const watcher = await open(DESK);
  await says(watcher.page, 'Another page drives');
  assert.ok(await watcher.page.isDisabled('#hold'));
  await drives(page);
  await watcher.page.click('#halt');
  await watcher.page.waitForFunction(() => document.querySelector('#notice').textContent.includes('Only the page that drives'));
  await watcher.page.click('#stop');
  await says(page, 'Stopped in');
  await says(watcher.page, 'was left');
  assert.ok((await watcher.page.textContent('#outcome')).includes('emergency'), await watcher.page.textContent('#outcome'));
});

test('the robot is handed over', async () => {
  const one = await driver();
  const other = await open();
  await other.page.click('#take');
  await says(one.page, 'asks for the robot');
  await one.page.click('#give');
  await other.page.waitForSelector('#give:not([hidden])');
  await says(one.page, 'Another page drives');
});

test('a gamepad drives, and its button stops', async () => {
  const stub = (page) =>
    page.addInitScript(() => {
      const pad = { connected: true, mapping: 'standard', axes: [0, 0, 0, 0], buttons: Array.from({ length: 17 }, () => ({ pressed: false })) };
      window.pad = pad;
      navigator.getGamepads = () => [null, pad];
    });
  const { page } = await driver(DESK, stub);
  const holds = (on) => page.evaluate((on) => (window.pad.buttons[7].pressed = on), on);
  await drivesBy(page, () => holds(true), () => holds(false));
  await page.evaluate(() => (window.pad.axes = [0.05, -1, 0, 0]));
  await turns(page, 30, 90);
  await page.evaluate(() => (window.pad.axes = [0, -0.09, 0, 0]));
  await turns(page, -1, 1);
  await page.evaluate(() => (window.pad.buttons[1].pressed = true));
  await says(page, 'Stopped in');
});

test('what a real robot cannot do is not offered', async () => {
  const { page } = await driver(DESK);
  for (const hidden of ['#speed', '#push', '#go-on']) assert.equal(await page.isVisible(hidden), false, hidden);
  await page.click('#back');
  await page.click('#state-tab');
  await page.waitForFunction(() => document.querySelectorAll('#servo-rows tr').length === 3);
  assert.ok(Math.abs((await angle(page)) - 5) < 1, 'a little beside the first posture');
  assert.equal(await page.textContent('.knob output'), '5.0 V', 'a stick rests');
  await page.click('#language');
  assert.equal(await page.textContent('#hold'), '押し続けて開始');
  await page.evaluate(axe.source);
  for (const theme of ['light', 'dark']) {
    await page.evaluate((theme) => (document.documentElement.dataset.theme = theme), theme);
    const { violations } = await page.evaluate(() => window.axe.run('#controls'));
    assert.deepEqual(violations.map(({ id }) => id), [], theme);
  }
});
