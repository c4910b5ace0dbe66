// What a browser makes of the playground, as one file and from a server. Needs what tests/browser needs.
// PLAYGROUND=FOLDER node --test playground.test.mjs
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { after, before, describe, test } from 'node:test';
import { launch } from '../tests/browser/browsers.mjs';

const folder = process.env.PLAYGROUND;
const axe = readFileSync(`${import.meta.dirname}/../tests/browser/node_modules/axe-core/axe.min.js`, 'utf8');
const TYPES = { html: 'text/html', wasm: 'application/wasm' };
const WAIT = { state: 'attached', timeout: 30_000 };
let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** The playground at an address, with all that it asked for and complained of. */
async function open(address, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, locale: 'en', ...options });
  const page = await context.newPage();
  const [asked, complaints] = [[], []];
  page.on('request', (request) => {
    if (!/^(data|blob|about):/.test(request.url())) asked.push(request.url());
  });
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()) && !/GPU stall|GL Driver/.test(message.text())) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  await page.goto(address);
  await page.waitForSelector('html[data-ready]', WAIT);
  const replay = page.frameLocator('#view');
  await replay.locator('html[data-ready]').waitFor(WAIT);
  return { page, replay, asked, complaints, close: () => context.close() };
}

const one = `file://${folder}/playground.html`;

/** Writes a program into the editor, and waits until it is checked. */
async function write(page, text) {
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(text);
  await page.waitForTimeout(600);
}

describe('one file', () => {
  test('asks for nothing, complains of nothing, and is accessible', async () => {
    const { page, replay, asked, complaints, close } = await open(one);
    assert.deepEqual(asked, [one]);
    assert.match(await replay.locator('#file').textContent(), /01-hello/);
    await page.evaluate(axe);
    const found = await page.evaluate(async () => (await window.axe.run(document, { iframes: false })).violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`));
    assert.deepEqual(found, []);
    assert.deepEqual(complaints, []);
    await close();
  });

  test('shows an error at its place, and runs the program after it is put right', async () => {
    const { page, replay, close } = await open(one);
    await write(page, '3.1\nrises\nSTAND_UPP 60\nMESSAGE risen\nEND\n');
    assert.match(await page.textContent('#findings'), /line 3.*STAND_UPP.*STAND_UP/s);
    assert.equal(await page.locator('.cm-lintRange-error').textContent(), 'STAND_UPP');
    await page.click('#run');
    await page.waitForFunction(() => document.getElementById('notice').textContent.includes('errors'));
    await write(page, '3.1\nrises\nSTAND_UP 60\nMESSAGE risen\nEND\n');
    assert.equal(await page.locator('#findings li').count(), 0);
    await page.click('#run');
    await replay.locator('#title', { hasText: 'rises' }).waitFor(WAIT);
    await close();
  });

  test('a lesson, an example and a program of one\'s own have addresses', async () => {
    const { page, replay, close } = await open(`${one}#lesson=10`);
    assert.equal(await page.textContent('#lesson-title'), 'A hand that grasps');
    assert.match(await replay.locator('#file').textContent(), /grasp\.prg · hand/);
    await replay.locator('#play[data-playing=true]').waitFor(WAIT);
    await page.selectOption('#choice', 'example 3');
    await replay.locator('#file', { hasText: 'tripod.prg' }).waitFor(WAIT);
    assert.equal(new URL(page.url()).hash, '#example=3');
    await write(page, '3.1\n足を上げる 🤖\nMESSAGE はい\nEND\n');
    const address = page.url();
    assert.match(address, /#robot=hexapod&events=&program=/);
    await close();
    const other = await open(address);
    assert.equal(await other.replay.locator('#title').textContent(), '足を上げる 🤖');
    assert.equal(await other.page.inputValue('#robot'), 'hexapod');
    await other.close();
  });

  test('what an address holds never becomes markup', async () => {
    const { page, close } = await open(one);
    await write(page, '3.1\n</script><img src=x onerror=alert(1)>\nMESSAGE <b>\nEND\n');
    const address = page.url();
    await close();
    const other = await open(address);
    assert.deepEqual(other.complaints, []);
    assert.match(await other.replay.locator('#title').textContent(), /<\/script><img/);
    await other.close();
  });

  test('speaks Japanese, findings and replay included', async () => {
    const { page, replay, close } = await open(`${one}#lesson=8`, { locale: 'ja' });
    assert.equal(await page.textContent('#lesson-title'), '支持三角形');
    await write(page, '3.1\nx\nMESAGE a\nEND\n');
    assert.match(await page.textContent('#findings'), /3 行目.*コマンドはありません/s);
    await page.click('#language');
    assert.match(await page.textContent('#findings'), /line 3.*not a command/s);
    assert.equal(await replay.locator('html').getAttribute('lang'), 'ja');
    await write(page, '3.1\nagain\nEND\n');
    await page.click('#run');
    await replay.locator('#title', { hasText: 'again' }).waitFor(WAIT);
    assert.equal(await replay.locator('html').getAttribute('lang'), 'en');
    await close();
  });
});

test('from a server it asks for its two files alone, and is ready in a second', async () => {
  const server = createServer((request, response) => {
    const name = request.url === '/' ? 'index.html' : request.url.slice(1);
    response.setHeader('Content-Type', TYPES[name.split('.').at(-1)] ?? 'text/plain');
    response.end(readFileSync(`${folder}/hosted/${name}`));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const home = `http://127.0.0.1:${server.address().port}/`;
  const { page, asked, complaints, close } = await open(home);
  assert.deepEqual(asked.sort(), [home, `${home}playground.wasm`, `${home}replay.html`]);
  assert.deepEqual(complaints, []);
  console.log(`ready after ${await page.getAttribute('html', 'data-ready')} ms`);
  await close();
  server.close();
});
