// Tests the pages in Firefox. replay.test.mjs has more tests, in Chromium.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launchFirefox } from './bidi.mjs';

let firefox;
before(async () => (firefox = await launchFirefox()));
after(() => firefox.close());

/** Returns the number of different colours of the robot's picture. */
function colours() {
  const [canvas, copy] = [document.getElementById('canvas'), Object.assign(document.createElement('canvas'), { width: 200, height: 120 })];
  const pen = copy.getContext('2d');
  pen.drawImage(canvas, 0, 0, 200, 120);
  const { data } = pen.getImageData(0, 0, 200, 120);
  return new Set(Array.from({ length: data.length / 4 }, (_, n) => data.slice(4 * n, 4 * n + 3).join())).size;
}

const shown = () => Number(document.getElementById('now-cycle').textContent.split(' ')[0]);

for (const [name, cycle, line] of [['walk', 400, 143], ['grasp', 2600, 48], ['hexapod', 560, undefined]]) {
  test(`${name}: asks for nothing, shows the robot, scrubs, steps, goes to a line`, async () => {
    const { session } = firefox;
    const address = `file://${process.env.PAGES}/${name}.html`;
    await session.open(`${address}#cycle=${cycle}`);
    assert.deepEqual(session.asked.filter((url) => !url.startsWith(address) && url !== 'about:blank'), []);
    assert.equal(await session.run(shown), cycle);
    if (line) assert.equal(await session.run(() => Number(document.querySelector('#source .lit').value)), line);
    assert.ok((await session.run(colours)) > 100, 'the canvas is not blank');

    await session.run(() => {
      const slider = document.getElementById('scrub');
      slider.value = 100;
      slider.dispatchEvent(new Event('input'));
    });
    assert.equal(await session.run(shown), 100);
    await session.run(() => document.getElementById('forward').click());
    assert.equal(await session.run(shown), 101);
    await session.run(() => document.getElementById('back').click());
    assert.equal(await session.run(shown), 100);
    const clicked = await session.run(() => {
      // It runs in the first cycle.
      const row = document.querySelector('#source .step');
      row.querySelector('code').click();
      return [row.value, Number(document.querySelector('#source .lit').value)];
    });
    assert.equal(clicked[1], clicked[0]);
    assert.deepEqual(session.complaints, []);
  });
}

test('tells values and differences, joints, and a second run', async () => {
  const { session } = firefox;
  await session.open(`file://${process.env.PAGES}/compare.html#cycle=900`);
  const told = () => [...document.querySelectorAll('.signal output')].map((one) => one.textContent);
  const settled = () => new Promise((done) => setTimeout(done, 400));
  await session.run(settled);
  const values = await session.run(told);
  assert.ok(values.length > 2 && values.every((text) => /^-?[\d.]+ \| -?[\d.]+$/.test(text)), values.join());
  await session.run(() => document.getElementById('plot-mark').click());
  await session.run(() => document.getElementById('forward').click());
  await session.run(settled);
  const differences = await session.run(told);
  assert.ok(differences.every((text) => /  Δ [+-][\d.]+$/.test(text)), differences.join());
  await session.run(() => document.getElementById('state-tab').click());
  assert.equal(await session.run(() => document.querySelectorAll('#joint-rows tr').length), 12);
  assert.equal(await session.run(() => document.querySelectorAll('#source button[tabindex="0"]').length), 1);
  assert.deepEqual(session.complaints, []);
});
