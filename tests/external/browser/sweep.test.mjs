// Tests the page of a table of runs, with the data of runs.json. PAGES is the folder of pages.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, before, describe, test } from 'node:test';
import { launch } from './browsers.mjs';

/** Returns the place of `name` among the texts that canvases were asked to draw. */
const named = (texts, name) => texts.filter(({ text }) => text === name);

const here = (path) => readFileSync(new URL(path, import.meta.url), 'utf8');
const html = here('../../../tools/view/page/sweep.html').replaceAll('TIP-TITLE', 'runs.csv').replace('TIP-DATA', () => here('runs.json'));
writeFileSync(`${process.env.PAGES}/runs.html`, html);

for (const width of [1440, 390]) {
  describe(`a page of ${width} pixels`, () => {
    let browser, page, drawn;
    before(async () => {
      browser = await launch();
      page = await browser.newPage({ viewport: { width, height: 900 } });
      // The document does not have the texts of a canvas.
      await page.addInitScript(() => {
        window.drawn = [];
        const { prototype } = CanvasRenderingContext2D;
        const { fillText, lineTo } = prototype;
        prototype.fillText = function (text, x, y) {
          const long = this.measureText(text).width;
          const left = x - { left: 0, center: long / 2, right: long }[this.textAlign];
          window.drawn.push({ id: this.canvas.id, text, x, y, left, right: left + long });
          fillText.call(this, text, x, y);
        };
        prototype.lineTo = function (x, y) {
          window.drawn.push({ id: this.canvas.id, x, y });
          lineTo.call(this, x, y);
        };
      });
      await page.goto(`file://${process.env.PAGES}/runs.html`);
      await page.waitForFunction(() => document.getElementById('count').textContent === '4 runs');
      drawn = (await page.evaluate(() => window.drawn)).filter(({ id }) => id === 'parallel');
    });
    after(() => browser?.close());

    test('a result that is nearly the same in all runs is drawn so, others over the whole height', () => {
      const texts = drawn.filter(({ text }) => text);
      const ys = (name) => {
        const [{ x }] = named(texts, name);
        return drawn.filter((point) => !point.text && Math.abs(point.x - x) < 12).map(({ y }) => y);
      };
      const spread = (all) => Math.max(...all) - Math.min(...all);
      // The line of the axis itself ends at its foot; the first column has only moves.
      const runs = (name) => ys(name).filter((y) => y !== Math.max(...ys(name)));
      assert.ok(spread(ys('forward [mm]')) > 150, `${spread(ys('forward [mm]'))}`);
      for (const name of ['least_margin [mm]', 'tilt [deg]']) assert.ok(spread(runs(name)) < 5, `${name}: ${runs(name)}`);
    });

    test('no words of the axes lie over each other', () => {
      const texts = drawn.filter(({ text }) => text);
      assert.equal(named(texts, 'least_margin [mm]').length, 1);
      for (const [n, one] of texts.entries()) {
        for (const other of texts.slice(n + 1)) {
          const apart = one.right < other.left || other.right < one.left || Math.abs(one.y - other.y) >= 12;
          assert.ok(apart, `${one.text} and ${other.text}`);
        }
      }
    });

    test('the words at the top are above all lines', () => {
      const top = Math.min(...drawn.filter(({ text }) => !text).map(({ y }) => y));
      for (const { text, y } of drawn.filter(({ text, y }) => text && y < 200)) assert.ok(y <= top - 4, `${text} at ${y}, lines from ${top}`);
    });

    test('runs that failed and the best ones are marked in the table and in the plot', async () => {
      const rows = await page.$$eval('tbody tr', (rows) => rows.map((row) => [row.className, row.cells[0].textContent]));
      assert.deepEqual(rows, [['failed', '✕ 4'], ['failed', '✕ 3'], ['', '1'], ['best', '★ 2']]);
      assert.equal(await page.textContent('#note'), '★ best by forward (more), falls=0  ✕ fell or stopped');
      // Crosses are the only lines of the plot.
      const lines = await page.evaluate(() => window.drawn.filter(({ id, text }) => id === 'scatter' && !text).length);
      const draws = await page.evaluate(() => window.drawn.filter(({ id, text }) => id === 'scatter' && text === 'forward [mm]').length);
      assert.equal(lines, draws * 2 * 2);
      assert.equal(await page.$eval('#sy option:checked', (option) => option.textContent), 'forward [mm]');
    });

    test('a heading sorts, upwards, downwards, and no more', async () => {
      const cases = () => page.$$eval('tbody tr', (rows) => rows.map((row) => Number(row.cells[0].textContent.replace(/\D+/, ''))));
      const heading = page.locator('thead button:text-is("forward [mm]")');
      const orders = [];
      for (const sort of ['ascending', 'descending', null]) {
        await heading.click();
        await page.waitForFunction((sort) => [...document.querySelectorAll('thead th')].find((cell) => cell.textContent === 'forward [mm]').getAttribute('aria-sort') === sort, sort);
        orders.push(await cases());
      }
      assert.deepEqual(orders, [[4, 1, 2, 3], [3, 2, 1, 4], [4, 3, 1, 2]]);
    });

    test('changes its language and its scheme', async () => {
      const ground = () => page.$eval('body', (body) => getComputedStyle(body).backgroundColor);
      const light = await ground();
      await page.click('#theme');
      assert.notEqual(await ground(), light);
      await page.click('#theme');
      await page.click('#language');
      assert.equal(await page.textContent('#count'), '4回の実行');
      assert.equal(await page.getAttribute('html', 'lang'), 'ja');
      assert.match(await page.textContent('#note'), /^★ forward \(大\), falls=0で最良/);
      await page.click('#language');
    });

    test('without a server, a run has the command that replays it', async () => {
      await page.click('tbody tr:nth-child(3)');
      assert.equal(await page.textContent('#chosen'), 'replay: tip view runs.csv --case 1');
    });

    test('only the plot scrolls sideways, not the page', async () => {
      const [page1, plot] = await page.evaluate(() => [document.documentElement, document.querySelector('.sideways')].map((part) => part.scrollWidth > part.clientWidth));
      assert.deepEqual([page1, plot], [false, width < 1000]);
      assert.equal(await page.textContent('#clear'), 'clear selection');
    });
  });
}
