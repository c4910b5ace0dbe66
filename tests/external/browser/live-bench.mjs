// Counts the updates of the page of a run that goes on. There must be 50 a second or more.
import { launch, visit } from './browsers.mjs';
import { serve } from './served.mjs';

const SECONDS = 10;
const RUNS = { walk: ['walk-on.prg'], hold: ['hold.prg', '--robot', 'hand', '--scene', '../../../examples/grasp/scene.toml'] };
const browser = await launch();
let missed = 0;
for (const [name, [program, ...options]] of Object.entries(RUNS)) {
  const server = await serve(program, ...options);
  const times = [];
  const { page, close } = await visit(browser, server.address, {}, (page) =>
    page.on('websocket', (socket) =>
      socket.on('framereceived', ({ payload }) => {
        if (String(payload).startsWith('{"type":"more"')) times.push(performance.now());
      }),
    ),
  );
  await page.waitForTimeout(1000);
  const shown = () => page.evaluate(() => Number(document.querySelector('#now-cycle').textContent.split(' ')[0]));
  const [begin, first, cycle] = [performance.now(), times.length, await shown()];
  await page.waitForTimeout(SECONDS * 1000);
  const seconds = (performance.now() - begin) / 1000;
  const rate = (times.length - first) / seconds;
  const gaps = times.slice(first).map((time, n) => time - times[first + n - 1]);
  const frames = await page.evaluate(async () => {
    const begin = performance.now();
    for (let n = 0; n < 60; n++) await new Promise((resolve) => requestAnimationFrame(resolve));
    return 60_000 / (performance.now() - begin);
  });
  const cycles = ((await shown()) - cycle) / seconds;
  const good = rate >= 49.5;
  missed += good ? 0 : 1;
  console.log(
    `${name}: ${rate.toFixed(1)} updates/s, the longest pause ${Math.max(...gaps).toFixed(0)} ms, ${cycles.toFixed(0)} cycles/s, drawn ${frames.toFixed(0)} times/s${good ? '' : '  MISSED'}`,
  );
  await close();
  await server.end();
}
await browser.close();
process.exit(missed ? 1 : 0);
