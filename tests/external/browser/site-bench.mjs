// Measures how soon the playground on a server is ready for visitors who have nothing of it in their cache. SITE is the folder that site/build has filled.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { launch, settle, visit } from './browsers.mjs';

const VISITS = 15;
/** The most that half of the visits may take: ms. */
const MOST = 1000;
const text = readFileSync(`${process.env.SITE}/playground.html`);
const server = createServer((_, response) => response.setHeader('Content-Type', 'text/html').end(text));
await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
const home = `http://127.0.0.1:${server.address().port}/`;
const browser = await launch();
const times = [];
for (let n = 0; n < VISITS; n++) {
  const visited = await visit(browser, home, {}, settle);
  times.push(Number(await visited.page.getAttribute('html', 'data-ready')));
  await visited.close();
}
await browser.close();
server.close();
times.sort((a, b) => a - b);
const median = times[VISITS >> 1];
console.log(`playground: ready after ${median} ms in the median of ${VISITS} visits, ${times[0]} to ${times.at(-1)}${median > MOST ? '  MISSED' : ''}`);
process.exit(median > MOST ? 1 : 0);
