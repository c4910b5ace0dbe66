// Tests the page of `tip serve --hardware` in Firefox, on simulated servos: a finger arms and drives, a watcher stops.
// driving.test.mjs has more tests, in Chromium.
import assert from 'node:assert/strict';
import { resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { launchFirefox } from './bidi.mjs';
import { serve } from './served.mjs';
import { Viewer } from './viewer.mjs';

let firefox;
let server;
before(async () => {
  firefox = await launchFirefox();
  server = await serve('steered.prg', '--hardware', resolve('leg.toml'), '--port', 'simulated');
});
after(async () => {
  await firefox.close();
  assert.equal(await server.end(), 130);
});

/** Puts fingers on the screen. Each finger is a list of actions; all lists have the same length. */
const touch = ({ session }, ...fingers) => {
  const actions = fingers.map((actions, n) => ({ type: 'pointer', id: `finger${n}`, parameters: { pointerType: 'touch' }, actions }));
  return session.send('input.performActions', { context: session.context, actions });
};
const put = ({ x, y }) => [{ type: 'pointerMove', x: Math.round(x), y: Math.round(y) }, { type: 'pointerDown', button: 0 }];
const pause = { type: 'pause', duration: 50 };
const centre = ({ session }, selector) =>
  session.run((selector) => {
    const part = document.querySelector(selector);
    part.scrollIntoView({ block: 'center' });
    const { x, y, width, height } = part.getBoundingClientRect();
    return { x: x + width / 2, y: y + height / 2 };
  }, selector);
/** Waits until the page says this of the robot. */
const says = ({ session }, text) =>
  session.run(async (text) => {
    const state = document.getElementById('drive-state');
    for (let times = 0; times < 200 && !state.textContent.includes(text); times += 1) await new Promise((resolve) => setTimeout(resolve, 50));
    return state.textContent;
  }, text).then((state) => assert.ok(state.includes(text), state));

test('a finger starts the robot, another one steers it, and a watcher stops it', async () => {
  const { session } = firefox;
  await session.send('browsingContext.setViewport', { context: session.context, viewport: { width: 390, height: 844 } });
  await session.open(server.address);
  // A screen without a window manager gives no window the focus.
  await session.run(() => void (document.hasFocus = () => true));
  const watcher = await Viewer.at(server.address);
  await session.run(() => document.getElementById('take').click());
  await watcher.until(({ held }) => held, 'the page drives');
  const button = await centre(firefox, '#hold');
  // On a busy machine the press may lapse; then it is repeated.
  for (let times = 0; times < 10; times += 1) {
    await touch(firefox, put(button));
    if (await watcher.until(({ phase, stage }) => phase === 'running' && stage === 'driven', 'it runs', 6000).catch(() => undefined)) break;
    await touch(firefox, [{ type: 'pointerUp', button: 0 }]);
  }
  await says(firefox, 'The program runs');
  const { x, y } = await session.run(() => {
    const { x, y, width, height } = document.getElementById('stick').getBoundingClientRect();
    return { x: x + width / 2, y: y + height / 2 };
  });
  await touch(firefox, [pause, pause, pause], [...put({ x, y }), { type: 'pointerMove', x: Math.round(x), y: Math.round(y - 60), duration: 50 }]);
  await watcher.until(({ servos }) => servos[0].angle > 30, 'the stick turns J11');
  await touch(firefox, [pause], [{ type: 'pointerUp', button: 0 }]);
  await watcher.until(({ servos }) => Math.abs(servos[0].angle) < 2, 'the stick springs back');
  await touch(firefox, [{ type: 'pointerUp', button: 0 }]);
  await watcher.until(({ stage }) => stage === 'paused', 'a released button pauses');
  watcher.send({ do: 'event', event: 'key 0x0D' });
  await watcher.until(({ phase }) => phase === 'left', 'it is stopped');
  await says(firefox, 'Stopped in');
  watcher.close();
  assert.deepEqual(session.complaints, []);
});
