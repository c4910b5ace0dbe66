// Takes pictures of the page of a run that goes on, for people to judge, in four widths, two schemes and two languages.
import { mkdirSync } from 'node:fs';
import { launch, visit } from './browsers.mjs';
import { serve } from './served.mjs';

const folder = `${process.env.PAGES}/../shots`;
mkdirSync(folder, { recursive: true });
const SIZES = { 390: 844, 1024: 768, 1440: 900, 1920: 1080 };
const RUNS = {
  walk: ['../../../examples/walk/motions/walk.prg'],
  grasp: ['../../../examples/grasp/motions/grasp.prg', '--robot', 'hand', '--scene', '../../../examples/grasp/scene.toml'],
};
const wanted = process.argv.slice(2);
const browser = await launch();
for (const [name, [program, ...options]] of Object.entries(RUNS)) {
  const server = await serve(program, ...options);
  for (const [width, height] of Object.entries(SIZES)) {
    for (const colorScheme of ['light', 'dark']) {
      for (const locale of ['en', 'ja']) {
        const file = `live-${name}-${width}-${colorScheme}-${locale}.png`;
        if (wanted.length && !wanted.some((part) => file.includes(part))) continue;
        const { page, close } = await visit(browser, server.address, { viewport: { width: Number(width), height }, colorScheme, locale });
        await page.evaluate(() => document.querySelector('#play').click());
        await page.waitForTimeout(900);
        await page.screenshot({ path: `${folder}/${file}` });
        await page.evaluate(() => document.querySelector('#play').click());
        await page.waitForTimeout(300);
        await close();
        console.log(`${folder}/${file}`);
      }
    }
  }
  await server.end();
}
await browser.close();
