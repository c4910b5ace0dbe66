// Pictures of the playground, for people to judge: four widths, two schemes, two languages. PLAYGROUND is its folder.
import { mkdirSync } from 'node:fs';
import { launch, visit } from './browsers.mjs';

const folder = `${process.env.PLAYGROUND}/../shots`;
mkdirSync(folder, { recursive: true });
const SIZES = { 390: 844, 1024: 768, 1440: 900, 1920: 1080 };
const SHOWN = { lesson: '#lesson=9', hand: '#lesson=10', hexapod: '#example=3' };
const wanted = process.argv.slice(2);
const browser = await launch();
for (const [name, fragment] of Object.entries(SHOWN)) {
  for (const [width, height] of Object.entries(SIZES)) {
    for (const colorScheme of ['light', 'dark']) {
      for (const locale of ['en', 'ja']) {
        const file = `playground-${name}-${width}-${colorScheme}-${locale}.png`;
        if (wanted.length && !wanted.some((part) => file.includes(part))) continue;
        const size = { width: Number(width), height };
        const { page, close } = await visit(browser, `file://${process.env.PLAYGROUND}/playground.html${fragment}`, { viewport: size, colorScheme, locale });
        await page.waitForTimeout(3000);
        await page.evaluate(() => document.querySelector('#play').click());
        // At rest all pixels are drawn.
        await page.waitForTimeout(900);
        await page.screenshot({ path: `${folder}/${file}` });
        await close();
        console.log(`${folder}/${file}`);
      }
    }
  }
}
await browser.close();
