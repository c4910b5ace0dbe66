// The pictures that README.md opens with: a walk and a gait that a stick steers, and the page that replays a walk.
// node pictures.mjs OUT
import { writeFileSync } from 'node:fs';
import { launch, open } from './browsers.mjs';
import { animated } from './webp.mjs';

/** How many stills of each run, from which cycle to which: a stride of the walk, and one move of each stick. */
const MOTIONS = {
  walk: { stills: 36, from: 1067, to: 1526 },
  steered: { stills: 40, from: 200, to: 520 },
};
const SIZE = { width: 480, height: 320 };
/** For how long each still is shown: ms. */
const SHOWN = 80;
const QUALITY = 0.75;
/** Text stays readable. */
const SHARP = 0.9;
/** After so long at rest the page has drawn all pixels: ms. */
const REST = 400;

const [folder] = process.argv.slice(2);
const browser = await launch();

/** A page at a cycle, as those who read English see it by day. */
function show(name, cycle, viewport) {
  const file = `${process.env.PAGES}/${name}.html`;
  return open(browser, file, { viewport, colorScheme: 'light', locale: 'en' }, `#cycle=${cycle}`);
}

/** The canvas as a picture of that size; it may have more pixels, which make its edges smooth. */
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
  // Nearer, since nothing else is shown.
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
