// Takes pictures of the site for people to judge, in four widths, two schemes and two languages. SITE is its folder.
import { mkdirSync } from 'node:fs';
import { launch, visit } from './browsers.mjs';

const folder = `${process.env.SITE}/../shots`;
mkdirSync(folder, { recursive: true });
const SIZES = { 390: 844, 1024: 768, 1440: 900, 1920: 1080 };
const PLAYED = { lesson: '#lesson=9', hand: '#lesson=10', hexapod: '#example=3' };
const READ = ['index', 'gallery', 'lessons', 'search', 'docs/tutorial'];
const wanted = process.argv.slice(2);
const browser = await launch();
const shown = [...Object.keys(PLAYED).map((name) => `playground-${name}`), ...READ];
for (const name of shown) {
  for (const [width, height] of Object.entries(SIZES)) {
    for (const colorScheme of ['light', 'dark']) {
      for (const locale of ['en', 'ja']) {
        const file = `${name.replace('/', '-')}-${width}-${colorScheme}-${locale}.png`;
        if (wanted.length && !wanted.some((part) => file.includes(part))) continue;
        const options = { viewport: { width: Number(width), height }, colorScheme, locale };
        if (READ.includes(name)) {
          const context = await browser.newContext(options);
          const page = await context.newPage();
          await page.goto(`file://${process.env.SITE}/${name}${locale === 'ja' ? '.ja' : ''}.html${name === 'search' ? '?q=REL_PTP' : ''}`);
          await page.screenshot({ path: `${folder}/${file}` });
          await context.close();
        } else {
          const { page, close } = await visit(browser, `file://${process.env.SITE}/playground.html${PLAYED[name.split('-')[1]]}`, options);
          await page.waitForTimeout(3000);
          await page.evaluate(() => document.querySelector('#play').click());
          // At rest all pixels are drawn.
          await page.waitForTimeout(900);
          await page.screenshot({ path: `${folder}/${file}` });
          await close();
        }
        console.log(`${folder}/${file}`);
      }
    }
  }
}
await browser.close();
