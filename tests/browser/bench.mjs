// How large pages are, how soon they show the robot, how fast they scrub.
import { statSync } from 'node:fs';
import { launch, open } from './browsers.mjs';

/** The most bytes that a page may have. */
const MOST = { walk: 1e6, grasp: 1e6, hexapod: 1e6, 'walk-on': 1e6, hold: 6e6 };
const browser = await launch();
let missed = 0;
for (const [name, most] of Object.entries(MOST)) {
  const file = `${process.env.PAGES}/${name}.html`;
  const view = await open(browser, file);
  const ready = Number(await view.page.getAttribute('html', 'data-ready'));
  const rate = await view.page.evaluate(async () => {
    const slider = document.getElementById('scrub');
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    const count = 90;
    const begin = performance.now();
    for (let n = 0; n < count; n++) {
      slider.value = (slider.max * n) / count;
      slider.dispatchEvent(new Event('input'));
      await frame();
    }
    return (count * 1000) / (performance.now() - begin);
  });
  const bytes = statSync(file).size;
  const good = bytes <= most && ready <= 1000 && rate >= 30;
  missed += good ? 0 : 1;
  const last = await view.page.$eval('#scrub', (slider) => slider.max);
  console.log(`${name}: ${last} cycles, ${(bytes / 1e6).toFixed(2)} MB, first frame after ${ready} ms, scrubs at ${rate.toFixed(0)} frames/s${good ? '' : '  MISSED'}`);
  await view.close();
}
await browser.close();
process.exit(missed ? 1 : 0);
