// Makes the first pictures of README.md: a walk, a gait that a stick steers, and the page that replays a walk.
// node pictures.mjs OUT
import { writeFileSync } from 'node:fs';
import { launch, open } from './browsers.mjs';
import { animated } from './webp.mjs';

/** Number of stills of each run, and their first and last cycle. They show a stride of the walk, and one move of each stick. */
const MOTIONS = {
  walk: { stills: 36, from: 1067, to: 1526 },
  steered: { stills: 40, from: 200, to: 520 },
};
const SIZE = { width: 480, height: 320 };
/** Time for which each still is shown, ms. */
const SHOWN = 80;
const QUALITY = 0.75;
/** Text stays readable. */
const SHARP = 0.9;
/** Time at rest after which the page has drawn all pixels, ms. */
const REST = 400;

const [folder] = process.argv.slice(2);
const browser = await launch();

/** Opens a page at a cycle, in English and light colours. */
function show(name, cycle, viewport) {
  const file = `${process.env.PAGES}/${name}.html`;
  return open(browser, file, { viewport, colorScheme: 'light', locale: 'en' }, `#cycle=${cycle}`);
}

/** Returns the canvas as a picture of that size. More pixels of the canvas make its edges smooth. */
function still(canvas, { width, height, quality }) {
  const copy = Object.assign(document.createElement('canvas'), { width, height });
  const pen = copy.getContext('2d');
  pen.imageSmoothingQuality = 'high';
  pen.drawImage(canvas, 0, 0, width, height);
  return copy.toDataURL('image/webp', quality);
}

function bytesOf(address) {
  return Buffer.from(address.split(',')[1], 'base64');
}

function save(name, bytes) {
  writeFileSync(`${folder}/${name}`, bytes);
  console.log(`${folder}/${name}: ${(bytes.length / 1000).toFixed(0)} kB`);
}

for (const [name, { stills: count, from, to }] of Object.entries(MOTIONS)) {
  const { page, close } = await show(name, from, SIZE);
  await page.$eval('#stage', (stage) => Object.assign(stage.style, { position: 'fixed', inset: 0, zIndex: 9 }));
  // It is nearer, because nothing else is shown.
  await page.mouse.move(SIZE.width / 2, SIZE.height / 2);
  await page.mouse.wheel(0, -400);
  const stills = [];
  for (let n = 0; n < count; n++) {
    const cycle = Math.round(from + ((to - from) * n) / count);
    await page.$eval('#scrub', (slider, cycle) => {
      slider.value = cycle;
      slider.dispatchEvent(new Event('input'));
    }, cycle);
    await page.waitForTimeout(REST);
    stills.push(bytesOf(await page.$eval('#canvas', still, { ...SIZE, quality: QUALITY })));
  }
  save(`${name}.webp`, animated(stills, SIZE, SHOWN));
  await close();
}
const { page, close } = await show('walk', 300, { width: 1280, height: 800 });
await page.waitForTimeout(REST);
const shot = await page.screenshot();
const address = await page.evaluate(async ({ bytes, quality }) => {
  const picture = await createImageBitmap(new Blob([Uint8Array.from(atob(bytes), (char) => char.charCodeAt(0))]));
  const canvas = Object.assign(document.createElement('canvas'), { width: picture.width, height: picture.height });
  canvas.getContext('2d').drawImage(picture, 0, 0);
  return canvas.toDataURL('image/webp', quality);
}, { bytes: shot.toString('base64'), quality: SHARP });
save('view.webp', bytesOf(address));
await close();
await browser.close();
