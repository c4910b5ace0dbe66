// Takes pictures of the pages for people to judge, in four widths, two schemes and two languages.
import { mkdirSync } from 'node:fs';
import { launch, open } from './browsers.mjs';

const folder = `${process.env.PAGES}/../shots`;
mkdirSync(folder, { recursive: true });
const SIZES = { 390: 844, 1024: 768, 1440: 900, 1920: 1080 };
const MOMENTS = { walk: 400, compare: 900, grasp: 2600, hexapod: 560, step: 700, a1: 260, trifinger: 200 };
const wanted = process.argv.slice(2);
const browser = await launch();
for (const [name, cycle] of Object.entries(MOMENTS)) {
  for (const [width, height] of Object.entries(SIZES)) {
    for (const scheme of ['light', 'dark']) {
      for (const locale of ['en', 'ja']) {
        const file = `${name}-${width}-${scheme}-${locale}.png`;
        if (wanted.length && !wanted.some((part) => file.includes(part))) continue;
        const size = { width: Number(width), height };
        const view = await open(browser, `${process.env.PAGES}/${name}.html`, { viewport: size, colorScheme: scheme, locale }, `#cycle=${cycle}`);
        // At rest all pixels are drawn.
        await view.page.waitForTimeout(900);
        await view.page.screenshot({ path: `${folder}/${file}` });
        await view.close();
        console.log(`${folder}/${file}`);
      }
    }
  }
}
await browser.close();
