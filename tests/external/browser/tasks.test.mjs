// Does tasks of a new user, from opening a page to the answer, each within a minute. The answers are computed here from traces and
// tables. PAGES is the folder that `run` has put them into, TIP the command that it has built.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { launch, open } from './browsers.mjs';
import { serveFile } from './served.mjs';

const pages = process.env.PAGES;
let browser;
before(async () => (browser = await launch()));
after(() => browser?.close());

/** Defines a test that takes a minute at most, graphics by software included. */
const task = (name, work) => test(name, { timeout: 60_000 }, async (context) => {
  const begin = performance.now();
  await work();
  context.diagnostic(`${((performance.now() - begin) / 1000).toFixed(1)} s`);
});

/** Returns the cycles of a trace. */
const traced = (name) => readFileSync(`${pages}/${name}.jsonl`, 'utf8').trimEnd().split('\n').map((line) => JSON.parse(line)).filter(({ cycle }) => cycle !== undefined);

/** Returns the text of a figure, the text of its moment, and a function that clicks on the moment. */
async function figure(page, name) {
  await page.click('#figures-tab');
  const row = page.locator('#figures tr', { has: page.locator(`th:text("${name}")`) });
  const [figure, moment] = await Promise.all(['.figure', '.moment'].map((part) => row.locator(part).textContent()));
  return { figure, moment, go: () => row.locator('.moment button').click() };
}

task('where and when is the stability margin least?', async () => {
  const { page, close } = await open(browser, `${pages}/walk.html`);
  const { figure: text, moment, go } = await figure(page, 'margin');
  const cycles = traced('keyed');
  const least = Math.min(...cycles.map(({ margin }) => margin));
  const { cycle } = cycles.find(({ margin }) => margin === least);
  assert.equal(text, `${least.toFixed(1)} mm at least`);
  // The moment is the beginning of a cycle; cycles take 20 ms.
  assert.match(moment, new RegExp(`^${(cycle * 0.02).toFixed(3)} s cycle ${cycle}, line \\d+$`));
  await go();
  assert.match(await page.textContent('#now-cycle'), new RegExp(`^${cycle} / `));
  assert.equal(await page.textContent('#now-margin'), `${least.toFixed(0)} mm`);
  await close();
});

task('how far does a foot slip, and which one?', async () => {
  const { page, close } = await open(browser, `${pages}/slips.html`);
  const { figure: text, go } = await figure(page, 'slip');
  const [, most] = text.match(/^([\d.]+) mm at most$/);
  const foot = await page.locator('#figures th:text("slip")').textContent();
  // The terminal has said the same.
  const said = JSON.parse(readFileSync(`${pages}/slips.json`, 'utf8'));
  assert.deepEqual([most, foot], [said.slip.value.toFixed(1), `slip ${said.slip.of}`]);
  assert.ok(Number(most) > 100, most);
  await go();
  assert.match(await page.textContent('#now-cycle'), new RegExp(`^${said.slip.cycle} / `));
  // The list of events, from the recorded motion, has a slip of this foot that is as long.
  await page.click('#log-tab');
  const listed = await page.$$eval('.mark.slip', (all) => all.map((one) => one.textContent));
  const longest = Math.max(...listed.filter((one) => one.includes(`${said.slip.of} slipped`)).map((one) => Number(one.match(/\(([\d.]+) mm\)/)[1])));
  assert.ok(Math.abs(longest - said.slip.value) < 0.2, `${longest} ${most}`);
  await close();
});

task('which of two speeds is better?', async () => {
  const { page, close } = await open(browser, `${pages}/programs.html`);
  await page.click('#figures-tab');
  const row = page.locator('#figures tr', { has: page.locator('th:text-is("speed")') });
  assert.match(await row.locator('td').nth(2).textContent(), /^\+[\d.]+ mm\/s.*better.*more is better$/);
  assert.match(await page.textContent('#changes'), /SPEED = 300.*SPEED = 350/s);
  await close();
});

task('how does the best run of a sweep look?', async () => {
  const server = await serveFile(`${pages}/speeds.csv`);
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  const page = await context.newPage();
  await page.goto(server.address);
  const row = page.locator('tr.best');
  await row.click();
  const [shown] = await Promise.all([context.waitForEvent('page'), page.click('#open')]);
  await shown.waitForSelector('html[data-ready]', { state: 'attached', timeout: 30_000 });
  // It is the run of the row: its speed is that of the table, and that of no other row.
  const { figure: speed } = await figure(shown, 'speed');
  const [head, ...rows] = readFileSync(`${pages}/speeds.csv`, 'utf8').trimEnd().split('\n').map((line) => line.split(','));
  const column = head.findIndex((name) => name.startsWith('speed'));
  const speeds = rows.map((cells) => Number(cells[column]));
  assert.equal(speed, `${Math.max(...speeds).toFixed(1)} mm/s forward`);
  assert.equal(await row.locator('td').first().textContent(), `★ ${speeds.indexOf(Math.max(...speeds))}`);
  await shown.close();
  // A double click opens the run, too.
  const [again] = await Promise.all([context.waitForEvent('page'), row.dblclick()]);
  await again.waitForSelector('html[data-ready]', { state: 'attached', timeout: 30_000 });
  await context.close();
  assert.equal(await server.end(), 130);
});
