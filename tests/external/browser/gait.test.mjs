// Tests a gait that fingers steer on the page of `tip serve`: the simulated body goes as the pads say. TIP is the command that `run` has
// built. With SHOTS, a folder, a picture of each motion is left there.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, visit } from './browsers.mjs';
import { serve } from './served.mjs';

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true };
/** Time for which a pad is pushed: ms. The body reaches its speed in 300 ms of the robot's time. */
const PUSH = 2500;
let browser;
let server;
let page;
let view;
before(async () => {
  browser = await launch();
  server = await serve('../../../examples/published/tripod.prg', '--robot', 'phantomx');
  view = await visit(browser, server.address, PHONE);
  page = view.page;
});
after(async () => {
  await view?.close();
  await browser?.close();
  assert.equal(await server.end(), 130);
});

/** Returns the way of the body since the start, which the page shows while it is paused: mm ahead and to the right, deg to the left. */
const way = async () => {
  await page.click('#play');
  await page.waitForFunction(() => document.querySelector('#outcome').textContent.includes('paused'));
  const figures = await page.textContent('#figures');
  await page.click('#play');
  const amount = (pattern, positive) => {
    const [, value, sense] = figures.match(pattern);
    return sense === positive ? Number(value) : -value;
  };
  return {
    ahead: amount(/([\d.]+) mm (forward|backward)/, 'forward'),
    right: amount(/([\d.]+) mm to the (right|left)/, 'right'),
    left: amount(/([\d.]+) ° to the (right|left)/, 'left'),
  };
};
/** Returns the way when it does not change any more, because the body stands. */
const stands = async () => {
  for (let last = await way(), times = 0; times < 20; times += 1) {
    await page.waitForTimeout(500);
    const now = await way();
    if (JSON.stringify(now) === JSON.stringify(last)) return now;
    last = now;
  }
  return assert.fail('it walks on');
};
/** Pushes a pad by a finger, which stays there for a while, and returns how far the body has come until it stands again. */
const pushed = async (name, pad, right, ahead) => {
  const from = await stands();
  const { x, y, width, height } = await page.locator(pad).boundingBox();
  const at = { x: x + width / 2, y: y + height / 2 };
  const devtools = await page.context().newCDPSession(page);
  const touch = (type, ...touchPoints) => devtools.send('Input.dispatchTouchEvent', { type, touchPoints });
  await touch('touchStart', { id: 0, ...at });
  await touch('touchMove', { id: 0, x: at.x + right, y: at.y - ahead });
  await page.waitForTimeout(PUSH);
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/gait-${name}.png` });
  await touch('touchEnd');
  const to = await stands();
  return Object.fromEntries(Object.keys(to).map((part) => [part, Math.round(to[part] - from[part])]));
};

test('the body goes as the pads say, and stands when they are let go', async () => {
  await page.waitForSelector('#stick:not([hidden])');
  await page.waitForFunction(() => document.querySelector('main').textContent.includes('ready'));
  // A word that is wider than its button would be cut off.
  for (const button of ['#stop', '#halt']) {
    assert.ok(await page.$eval(button, (button) => button.scrollWidth <= button.clientWidth), button);
  }
  // The body goes far in one of three directions.
  const ahead = await pushed('ahead', '#stick', 0, 60);
  assert.ok(ahead.ahead > 100 && Math.abs(ahead.right) < 5 && Math.abs(ahead.left) < 2, JSON.stringify(ahead));
  const right = await pushed('right', '#sidestep', 60, 0);
  assert.ok(right.right > 80 && Math.abs(right.ahead) < 5 && Math.abs(right.left) < 2, JSON.stringify(right));
  const left = await pushed('left', '#stick', -60, 0);
  assert.ok(left.left > 25 && Math.abs(left.ahead) < 20 && Math.abs(left.right) < 20, JSON.stringify(left));
  const back = await pushed('back', '#stick', 0, -60);
  assert.ok(Math.hypot(back.ahead, back.right) > 100, JSON.stringify(back));
  assert.deepEqual(view.complaints, []);
});
