// Tests the site in a browser. SITE is the folder that site/build has filled. playground.test.mjs has more tests of the playground.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { after, before, test } from 'node:test';
import axe from 'axe-core';
import { launch } from './browsers.mjs';

const folder = process.env.SITE;
const home = `file://${folder}/`;
const root = `${import.meta.dirname}/../../..`;
/** Largest numbers of bytes of all files, and of the first page with its pictures. */
const [MOST, MOST_FIRST] = [25e6, 0.8e6];
const files = readdirSync(folder, { recursive: true }).filter((name) => statSync(`${folder}/${name}`).isFile());
let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** Opens a page in a context of its own, and records its requests and its errors. */
async function open(path, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, locale: 'en', ...options });
  const page = await context.newPage();
  const [asked, complaints] = [[], []];
  page.on('request', (request) => asked.push(request.url()));
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  await page.goto(`${home}${path}`);
  return { page, asked, complaints, close: () => context.close() };
}

test('every page is reached from the first one, every link leads somewhere, and nothing is asked of another host', async () => {
  const { page, asked, complaints, close } = await open('index.html');
  const [found, waiting, links] = [new Map(), ['index.html'], []];
  for (let path = waiting.shift(); path; path = waiting.shift()) {
    if (found.has(path)) continue;
    // These are pages of a run, which other tests open.
    if (path.startsWith('gallery/') || path === 'playground.html') {
      found.set(path, undefined);
      continue;
    }
    await page.goto(`${home}${encodeURI(path)}`);
    const { ids, hrefs } = await page.evaluate(() => ({
      ids: [...document.querySelectorAll('[id]')].map(({ id }) => id),
      hrefs: [...document.querySelectorAll('a[href], img[src]')].map((one) => one.href || one.src),
    }));
    found.set(path, new Set(ids));
    for (const href of hrefs.filter((href) => href.startsWith('file:'))) {
      const [file, id] = decodeURI(href.slice(home.length)).split('#');
      links.push({ path, href, file, id });
      if (file.endsWith('.html')) waiting.push(file);
    }
    const [, repository] = /^repository = "(.*)"/m.exec(readFileSync(`${root}/Cargo.toml`, 'utf8'));
    for (const href of hrefs.filter((href) => href.startsWith(`${repository}/`))) {
      const name = href.slice(repository.length).replace(/^\/(blob|tree)\/[^/]+\//, '');
      assert.ok(existsSync(`${root}/${name}`), `${path}: ${href}`);
    }
  }
  const broken = links.filter(({ file, id }) => !files.includes(file) || (id && found.get(file) && !found.get(file).has(id)));
  assert.deepEqual(broken.map(({ path, href }) => `${path}: ${href}`), []);
  assert.ok(links.length > 1000, String(links.length));
  assert.deepEqual(files.filter((name) => name.endsWith('.html') && !found.has(name) && !/^search(\.ja)?\.html$/.test(name)), []);
  assert.deepEqual(asked.filter((url) => !url.startsWith('file:') && !url.startsWith('data:')), []);
  assert.deepEqual(complaints, []);
  await close();
});

test('no page is wider than its window, from 390 to 1440 px', async () => {
  for (const width of [390, 768, 1440]) {
    const { page, close } = await open('index.html', { viewport: { width, height: 800 } });
    for (const path of files.filter((name) => name.endsWith('.html') && !name.startsWith('gallery/') && name !== 'playground.html')) {
      await page.goto(`${home}${path}`);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width, `${path} at ${width}`);
    }
    await close();
  }
});

test('has nothing that axe objects to, in both schemes and languages', async () => {
  const found = [];
  for (const colorScheme of ['light', 'dark']) {
    for (const language of ['', '.ja']) {
      for (const name of ['index', 'gallery', 'lessons', 'search', 'docs/tutorial', 'docs/language']) {
        const { page, close } = await open(`${name}${language}.html${name === 'search' ? '?q=walk' : ''}`, { colorScheme });
        await page.evaluate(axe.source);
        const { violations } = await page.evaluate(() => globalThis.axe.run());
        found.push(...violations.map(({ id, nodes }) => `${name}${language} ${colorScheme} ${id}: ${nodes[0].target} ${nodes[0].failureSummary}`));
        await close();
      }
    }
  }
  assert.deepEqual(found, []);
});

test('search finds REL_PTP by keys alone, and what two languages say', async () => {
  const { page, complaints, close } = await open('index.html');
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.className), 'skip');
  // Five links and then the search.
  for (let n = 0; n < 6; n++) await page.keyboard.press('Tab');
  await page.keyboard.type('REL_PTP');
  await page.keyboard.press('Enter');
  const first = page.locator('#results li a').first();
  await first.waitFor();
  assert.match(await first.textContent(), /› REL_PTP$/);
  await first.press('Enter');
  await page.waitForURL(/docs\/commands\.html#rel_ptp$/);
  assert.ok((await page.locator('#rel_ptp').boundingBox()).y < 400);

  await page.goto(`${home}search.ja.html?q=${encodeURIComponent('支持三角形')}`);
  assert.match(await page.locator('#results li a').first().getAttribute('href'), /tutorial\.ja\.html/);
  await page.goto(`${home}search.html?q=<img src=x onerror=alert(1)> .*`);
  assert.equal(await page.textContent('#found'), 'Nothing was found.');
  for (const words of ['--robot', 'quasi-static', '100 %', 'STEP_1:', '@POS_F1', '[bus]']) {
    await page.goto(`${home}search.html?q=${encodeURIComponent(words)}`);
    assert.ok((await page.locator('#results li mark').count()) > 0, words);
  }
  assert.deepEqual(complaints, []);
  await close();
});

test('three doors lead to the playground, the installation and the crate, in both languages', async () => {
  for (const [path, heading] of [['index.html', 'First minute'], ['index.ja.html', '最初の1分']]) {
    const { page, close } = await open(path);
    const doors = page.locator('.doors a');
    assert.equal(await doors.count(), 3);
    await doors.nth(1).click();
    assert.equal(await page.evaluate(() => document.getElementById(decodeURI(location.hash.slice(1))).textContent), heading);
    await page.click('#language');
    assert.equal(await page.evaluate(() => document.documentElement.lang), path === 'index.html' ? 'ja' : 'en');
    await close();
  }
});

test('a pupil begins the lessons under a name, and a replay shows a run of the gallery', async () => {
  const { page, complaints, close } = await open('lessons.html');
  await page.fill('input[name=pupil]', 'Aiko');
  await page.click('.pupil button');
  await page.waitForSelector('html[data-ready]', { state: 'attached' });
  assert.equal(await page.textContent('#lesson-number'), 'Aiko · 1 of 11');
  await page.goto(`${home}lessons.html`);
  await page.fill('input[name=pupil]', 'Aiko');
  await page.locator('.lessons button').nth(2).click();
  await page.waitForSelector('html[data-ready]', { state: 'attached' });
  assert.equal(await page.textContent('#lesson-number'), 'Aiko · 3 of 11');
  await page.goto(`${home}gallery.html`);
  assert.equal(await page.locator('.cards li').count(), 11);
  await page.locator('.cards li').nth(3).getByText('Replay').click();
  await page.waitForSelector('html[data-ready]', { state: 'attached' });
  assert.match(await page.textContent('#file'), /tripod\.prg/);
  await page.goto(`${home}gallery.html`);
  await page.locator('.cards li').first().getByText('Source').click();
  // The fragment opens the file that it names.
  await page.waitForFunction(() => document.querySelector('details[open] pre')?.textContent.startsWith('3.1'));
  assert.deepEqual(complaints, []);
  await close();
});

test('is small', () => {
  const size = (names) => names.reduce((sum, name) => sum + statSync(`${folder}/${name}`).size, 0);
  const first = size(['index.html', 'style.css', ...files.filter((name) => /^docs\/.*\.webp$/.test(name))]);
  assert.ok(size(files) < MOST && first < MOST_FIRST, `${size(files)} ${first}`);
});
