// Measures the sizes of pages, the time until they show the robot, and the speed at which they scrub.
import { statSync } from 'node:fs';
import { launch, open, settle } from './browsers.mjs';

/** The most bytes that a page may have. */
const MOST = { walk: 1e6, grasp: 1e6, hexapod: 1e6, 'walk-on': 1e6, hold: 6e6 };
/** Number of frames that are scrubbed. */
const FRAMES = 90;
const browser = await launch();
const session = await browser.newBrowserCDPSession();

/** Returns the processor's time so far, ms, of the page and of its graphics. Other processes do not lengthen it. */
async function spent() {
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  const sum = (type) => processInfo.filter((one) => one.type === type).reduce((sum, { cpuTime }) => sum + 1000 * cpuTime, 0);
  return { page: sum('renderer'), graphics: sum('GPU') };
}

let missed = 0;
for (const [name, most] of Object.entries(MOST)) {
  const file = `${process.env.PAGES}/${name}.html`;
  const view = await open(browser, file, {}, '', settle);
  const ready = Number(await view.page.getAttribute('html', 'data-ready'));
  await view.page.waitForTimeout(1000);
  const before = await spent();
  const rate = await view.page.evaluate(async (count) => {
    const slider = document.getElementById('scrub');
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    const begin = performance.now();
    for (let n = 0; n < count; n++) {
      slider.value = (slider.max * n) / count;
      slider.dispatchEvent(new Event('input'));
      await frame();
    }
    return (count * 1000) / (performance.now() - begin);
  }, FRAMES);
  const after = await spent();
  const each = (part) => ((after[part] - before[part]) / FRAMES).toFixed(0);
  const bytes = statSync(file).size;
  const good = bytes <= most && ready <= 1000 && rate >= 30;
  missed += good ? 0 : 1;
  const last = await view.page.$eval('#scrub', (slider) => slider.max);
  console.log(`${name}: ${last} cycles, ${(bytes / 1e6).toFixed(2)} MB, first frame after ${ready} ms, scrubs at ${rate.toFixed(0)} frames/s, each ${each('page')} ms of the page and ${each('graphics')} ms of graphics${good ? '' : '  MISSED'}`);
  await view.close();
}
await browser.close();
process.exit(missed ? 1 : 0);
