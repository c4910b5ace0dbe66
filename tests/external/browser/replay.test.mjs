// Tests the pages of three runs: a walk, a grasp and a hexapod. PAGES is the folder into which `run` has put them.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, describe, test } from 'node:test';
import axe from 'axe-core';
import { launch, open } from './browsers.mjs';

const pages = process.env.PAGES;
let browser;
before(async () => (browser = await launch()));
after(() => browser?.close());

const cycle = (page) => page.$eval('#now-cycle', (element) => Number(element.textContent.split(' ')[0]));
const lit = (page) => page.$eval('#source .lit', (line) => line.value);

/** Returns the number of colours of a picture that are not rare. */
const colours = (page) =>
  page.$eval('#canvas', (canvas) => {
    const copy = Object.assign(document.createElement('canvas'), { width: 200, height: 120 });
    const pen = copy.getContext('2d');
    pen.drawImage(canvas, 0, 0, 200, 120);
    const found = new Map();
    const { data } = pen.getImageData(0, 0, 200, 120);
    for (let at = 0; at < data.length; at += 4) {
      const key = data.slice(at, at + 3).map((value) => value >> 4).join();
      found.set(key, (found.get(key) ?? 0) + 1);
    }
    return [...found.values()].filter((count) => count > 8).length;
  });

for (const name of ['walk', 'grasp', 'hexapod']) {
  describe(name, () => {
    let view;
    before(async () => (view = await open(browser, `${pages}/${name}.html`)));
    after(() => view?.close());

    test('asks for nothing but itself, and complains of nothing', async () => {
      const { page, asked, complaints } = view;
      await page.click('#play');
      await page.waitForTimeout(600);
      await page.click('#play');
      assert.deepEqual(asked, [`file://${pages}/${name}.html`]);
      assert.deepEqual(complaints, []);
      assert.ok((await cycle(page)) > 0, 'it plays');
    });

    test('draws a robot that moves', async () => {
      const { page } = view;
      assert.ok((await colours(page)) > 6, `${await colours(page)} colours`);
      const shot = () => page.$eval('#canvas', (canvas) => canvas.toDataURL());
      const first = await shot();
      await page.keyboard.press('End');
      await page.keyboard.press('n');
      await page.keyboard.press('p');
      await page.waitForTimeout(200);
      assert.notEqual(await shot(), first);
    });

    test('goes one cycle forward and back, by button and by key', async () => {
      const { page } = view;
      await page.keyboard.press('Home');
      assert.equal(await cycle(page), 0);
      await page.click('#forward');
      await page.keyboard.press('ArrowRight');
      assert.equal(await cycle(page), 2);
      await page.click('#back');
      assert.equal(await cycle(page), 1);
    });

    test('goes where the slider is dragged to', async () => {
      const { page } = view;
      const box = await (await page.$('#scrub')).boundingBox();
      const last = Number(await page.$eval('#scrub', (slider) => slider.max));
      await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
      assert.ok(Math.abs((await cycle(page)) / last - 0.5) < 0.02);
    });

    test('goes to the next run of a line that is clicked', async () => {
      const { page } = view;
      await page.keyboard.press('Home');
      const lines = await page.$$eval('#source li.step', (lines) => lines.map((line) => line.value));
      const line = lines[Math.floor(lines.length / 3)];
      await page.click(`#source li[value="${line}"] button`);
      assert.equal(await lit(page), line);
    });

    test('shows the value of a variable under the pointer, and plots it at a click', async () => {
      const { page } = view;
      await page.keyboard.press('End');
      const variable = page.locator('#source .variable').last();
      await variable.scrollIntoViewIfNeeded();
      await variable.hover();
      assert.match(await page.textContent('#tip'), /^[A-Z.0-9]+ = -?[\d.]+$/);
      assert.match(await page.getAttribute('#tip .spark path:last-child', 'd'), /^M[\d.]+ [\d.]+V.*H148$/);
      const before = await page.locator('.chart .uplot').count();
      await variable.click();
      assert.equal(await page.locator('.chart .uplot').count(), before + 1);
      // The new plot, below the others, is in view as a whole.
      await page.waitForTimeout(100);
      const [plot, panel] = await Promise.all(['.chart:last-child .uplot', '#plots-panel'].map((part) => page.locator(part).boundingBox()));
      assert.ok(plot.height > 80 && plot.y >= panel.y && plot.y + plot.height <= panel.y + panel.height + 1, JSON.stringify([plot, panel]));
    });

    test('tells every value at the pointer, and its difference from a second cursor', async () => {
      const { page } = view;
      const told = () => page.$$eval('.signal output', (all) => all.map((one) => one.textContent));
      const over = page.locator('.chart .u-over').first();
      const { width } = await over.boundingBox();
      await over.hover({ position: { x: width * 0.25, y: 20 } });
      await page.waitForTimeout(100);
      const [first, time] = [await told(), await page.textContent('#plot-time')];
      assert.ok(first.length > 2 && first.every((text) => /^(–|-?[\d.]+)$/.test(text)), first.join());
      assert.match(time, /^\d+\.\d{3} s$/);
      await over.click({ position: { x: width * 0.25, y: 20 }, modifiers: ['Shift'] });
      await over.hover({ position: { x: width * 0.75, y: 20 } });
      await page.waitForTimeout(100);
      assert.ok((await told()).every((text) => text === '–' || /  Δ [+-][\d.]+$/.test(text)), (await told()).join());
      assert.match(await page.textContent('#plot-time'), /  Δ \+\d+\.\d{3} s$/);
      await page.click('#plot-mark');
      await page.waitForFunction(() => [...document.querySelectorAll('.signal output')].every((one) => !one.textContent.includes('Δ')));
    });

    test('the last label of the axis of time is whole', async () => {
      const { page } = view;
      // Labels are drawn. Right of the last tick there is room for half of the widest one.
      const rooms = await page.$$eval('.chart .uplot', (all) => all.map((one) => one.getBoundingClientRect().right - one.querySelector('.u-over').getBoundingClientRect().right));
      assert.ok(rooms.every((room) => room >= 24), rooms.join());
    });

    test('tells of each joint its angle, setpoint, limits and torque, and where feet are', async () => {
      const { page } = view;
      await page.click('#state-tab');
      const rows = await page.$$eval('#joint-rows tr', (rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)));
      const legs = await page.$$eval('#modes dt', (all) => all.length);
      assert.equal(rows.length % legs, 0);
      for (const [name, angle, setpoint, limits, torque] of rows) {
        assert.match(name, /^J\d\d$/);
        for (const number of [angle, setpoint, torque]) assert.match(number, /^-?\d+\.\d+$/);
        const [low, high] = limits.split(' … ').map(Number);
        assert.ok(low < high && angle >= low - 1 && angle <= high + 1, `${name} ${angle} ${limits}`);
      }
      const feet = await page.$$eval('#feet dd', (all) => all.map((foot) => foot.textContent));
      assert.equal(feet.length, legs);
      assert.ok(feet.every((foot) => /^-?[\d.]+  -?[\d.]+  -?[\d.]+$/.test(foot)), feet.join());
      await page.click('#source-tab');
    });

    test('leads to the line that gave a variable its value', async () => {
      const { page } = view;
      await page.keyboard.press('End');
      await page.click('#state-tab');
      const last = await cycle(page);
      const button = page.locator('#variables .from button:visible').last();
      const line = Number((await button.textContent()).split(' ').at(-1));
      await button.click();
      assert.ok((await cycle(page)) < last);
      assert.equal(Number(await page.textContent('#now-line')), line);
      await page.click('#source-tab');
      assert.equal(await lit(page), line);
    });

    test('names feet, axes and forward, unless one does not want it', async () => {
      const { page } = view;
      const shot = async () => {
        await page.waitForTimeout(500);
        return page.$eval('#canvas', (canvas) => canvas.toDataURL());
      };
      const named = await shot();
      await page.click('#show-labels');
      const plain = await shot();
      assert.notEqual(plain, named);
      await page.click('#show-labels');
      assert.equal(await shot(), named);
    });

    test('one line of the program is reached by Tab, the others by arrows', async () => {
      const { page } = view;
      assert.equal(await page.locator('#source button[tabindex="0"]').count(), 1);
      await page.focus('#source button[tabindex="0"]');
      const first = await page.evaluate(() => Number(document.activeElement.textContent));
      await page.keyboard.press('ArrowDown');
      assert.ok((await page.evaluate(() => Number(document.activeElement.textContent))) > first);
      assert.equal(await page.locator('#source button[tabindex="0"]').count(), 1);
      await page.evaluate(() => document.activeElement.blur());
    });

    test('shows modes and flags', async () => {
      const { page } = view;
      await page.keyboard.press('End');
      await page.click('#state-tab');
      const modes = await page.$$eval('#modes .mode', (all) => all.map((mode) => mode.textContent));
      assert.ok(modes.every((mode) => /^((J\d\d )?(rest|position|compliance|velocity|force)(, )?)+$/.test(mode)), modes.join());
      assert.match(await page.textContent('#flags'), /^(none|[A-Z_]+\w*( [A-Z_]+\w*)*)$/);
      await page.click('#source-tab');
    });

    test('opens at the cycle of its address, and keeps it there', async () => {
      const linked = await open(browser, `${pages}/${name}.html`, {}, '#cycle=611');
      assert.equal(await cycle(linked.page), 611);
      await linked.page.keyboard.press('ArrowLeft');
      await linked.page.waitForFunction(() => location.hash === '#cycle=610');
      await linked.page.evaluate(() => (location.hash = 'cycle=5'));
      await linked.page.waitForFunction(() => document.getElementById('now-cycle').textContent.startsWith('5 '));
      await linked.close();
    });

    test('saves an image', async () => {
      const { page } = view;
      await page.click('#export');
      const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-image')]);
      const bytes = readFileSync(await download.path());
      assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
      assert.ok(bytes.length > 5000, `${bytes.length} bytes`);
      await page.keyboard.press('Escape');
    });

    test('has nothing that axe objects to, in both schemes and languages', async () => {
      for (const scheme of ['light', 'dark']) {
        for (const locale of ['en', 'ja']) {
          const { page, close } = await open(browser, `${pages}/${name}.html`, { colorScheme: scheme, locale, bypassCSP: true });
          await page.evaluate(axe.source);
          for (const tab of ['source-tab', 'state-tab', 'log-tab']) {
            await page.click(`#${tab}`);
            const { violations } = await page.evaluate(() => globalThis.axe.run());
            const found = violations.map(({ id, nodes }) => `${scheme} ${locale} ${tab} ${id}: ${nodes[0].target} ${nodes[0].failureSummary}`);
            assert.deepEqual(found, []);
          }
          await close();
        }
      }
    });
  });
}

test('exports frames as a ZIP that others read', async () => {
  const { page, close } = await open(browser, `${pages}/walk.html`, { viewport: { width: 480, height: 640 } });
  await page.click('#export');
  await page.fill('#export-seconds', '0.4');
  await page.fill('#export-rate', '10');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-frames')]);
  const bytes = readFileSync(await download.path());
  const names = bytes.toString('latin1').match(/walk-\d{5}\.png/g);
  // Every file is named twice; 0, 0.1, 0.2, 0.3 and 0.4 s.
  assert.equal(names.length, 10);
  await close();
});

/** Returns the elements of a film (RFC 8794) inside of these identifiers, each with its identifier and its bytes. */
function elements(bytes, inside) {
  const found = [];
  for (let at = 0; at < bytes.length; ) {
    const id = bytes.readUIntBE(at, Math.clz32(bytes[at]) - 23);
    const begin = at + Math.clz32(bytes[at]) - 23 + 8;
    const end = begin + Number(bytes.readBigUInt64BE(begin - 8) & 0xffffffffffffffn);
    found.push([id, bytes.subarray(begin, end)]);
    if (inside.includes(id)) found.push(...elements(bytes.subarray(begin, end), inside));
    at = end;
  }
  return found;
}

test('films each frame, however long it takes', async () => {
  const { page, close } = await open(browser, `${pages}/walk.html`, { viewport: { width: 480, height: 640 } });
  await page.click('#export');
  await page.fill('#export-seconds', '0.4');
  await page.fill('#export-rate', '10');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-video')]);
  const bytes = readFileSync(await download.path());
  // WebM begins with EBML (RFC 8794).
  assert.equal(bytes.subarray(0, 4).toString('hex'), '1a45dfa3');
  const [segment, cluster, time, block] = [0x18538067, 0x1f43b675, 0xe7, 0xa3];
  const film = elements(bytes, [segment, cluster]);
  const blocks = film.filter(([id]) => id === block).map(([, bytes]) => bytes);
  // 0, 0.1, 0.2, 0.3 and 0.4 s, counted from the cluster's 0.
  assert.deepEqual(film.filter(([id]) => id === time).map(([, bytes]) => bytes.toString('hex')), ['00']);
  assert.deepEqual(blocks.map((block) => block.readInt16BE(1)), [0, 100, 200, 300, 400]);
  await close();
});

test('an animation for slides shows the time, and leaves the player where it was', async () => {
  const view = await open(browser, `${pages}/walk.html`, {}, '#cycle=300');
  const { page } = view;
  await page.click('#export');
  await page.fill('#export-seconds', '0.5');
  await page.fill('#export-rate', '10');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-gif')]);
  const bytes = readFileSync(await download.path());
  assert.equal(bytes.subarray(0, 6).toString(), 'GIF89a');
  // A graphics control extension begins each frame: half a second at 10 Hz, and the first.
  let frames = 0;
  for (let at = bytes.indexOf('\x21\xf9\x04', 0, 'latin1'); at >= 0; at = bytes.indexOf('\x21\xf9\x04', at + 1, 'latin1')) frames += 1;
  assert.equal(frames, 6);
  await page.waitForFunction(() => document.querySelector('#now-cycle').textContent.startsWith('300 '));
  await view.close();
});

test('two runs are on one page: their plots, and the second robot as a ghost', async () => {
  const view = await open(browser, `${pages}/compare.html`, {}, '#cycle=900');
  const { page, complaints } = view;
  assert.match(await page.textContent('#file'), /walk\.jsonl · titan8 · ghost: .*slow\.jsonl$/);
  const told = await page.$$eval('.signal output', (all) => all.map((one) => one.textContent));
  assert.ok(told.every((text) => /^-?[\d.]+ \| -?[\d.]+$/.test(text)), told.join());
  // At half the way the slower robot is elsewhere.
  await page.waitForTimeout(500);
  const alone = await open(browser, `${pages}/walk.html`, {}, '#cycle=900');
  await alone.page.waitForTimeout(500);
  const shot = (page) => page.$eval('#canvas', (canvas) => canvas.toDataURL());
  assert.notEqual(await shot(page), await shot(alone.page));
  await alone.close();
  // The slider covers the slower run, that of the ghost, which is longer. The first run has no data after its end.
  const last = (name) => readFileSync(`${pages}/${name}.jsonl`, 'utf8').trimEnd().split('\n').length - 2;
  const [ends, longer] = [last('walk'), last('slow')];
  assert.ok(longer > ends);
  assert.equal(await page.getAttribute('#scrub', 'max'), String(longer));
  await page.keyboard.press('End');
  await page.waitForFunction((ends) => document.getElementById('now-cycle').textContent === ends, `${ends} / ${ends} | ${longer} / ${longer}`);
  assert.equal(await page.textContent('#now-line'), '80 | 80');
  assert.match(await page.textContent('#now-margin'), /^\d+ \| \d+ mm$/);
  await page.waitForFunction(() => [...document.querySelectorAll('.signal output')].every((one) => /^– \| -?[\d.]+$/.test(one.textContent)));
  assert.deepEqual(complaints, []);
  await view.close();
});

test('two runs that are compared both tell their ends, in both languages', async () => {
  for (const [locale, ends] of [
    ['en', /^walk: EXIT after (\d+\.\d{3}) s · slow: EXIT after (\d+\.\d{3}) s$/],
    ['ja', /^walk: (\d+\.\d{3}) s 後に EXIT · slow: (\d+\.\d{3}) s 後に EXIT$/],
  ]) {
    const { page, close } = await open(browser, `${pages}/compare.html`, { locale });
    const [, first, second] = (await page.textContent('#outcome')).match(ends);
    assert.ok(Number(first) < Number(second), `${first} ${second}`);
    await close();
  }
});

test('the figures of two runs have both moments, their difference, and which is better and why', async () => {
  const view = await open(browser, `${pages}/programs.html`);
  const { page, complaints } = view;
  await page.click('#figures-tab');
  const table = await page.$$eval('#figures tr', (rows) => rows.map((row) => [...row.cells].map((cell) => cell.innerText.replaceAll(/\s+/g, ' ').trim())));
  assert.deepEqual(table[0], ['', 'walk', 'faster', 'difference']);
  const figure = (name) => table.find(([first]) => first === name);
  const [, one, other, change] = figure('speed').map((text) => Number(text.split(' ')[0]));
  assert.ok(other > one && Math.abs(other - one - change) < 0.11, figure('speed').join());
  assert.match(figure('speed')[3], /^\+[\d.]+ mm\/s better more is better$/);
  assert.match(figure('rate')[3], /^\+[\d.]+ deg\/s worse less is better$/);
  assert.equal(figure('falls')[3], '0');
  // The moment of the second run is a moment of that run.
  const [, , margin] = figure('margin');
  const [, seconds, line] = margin.match(/ ([\d.]+) s line (\d+)$/);
  await page.click('#figures tr:has(th:text-is("margin")) td:nth-child(3) button');
  await page.waitForFunction((line) => document.getElementById('now-line').textContent.endsWith(`| ${line}`), line);
  assert.ok(Math.abs(Number((await page.textContent('#now-time')).split(' ')[0]) - Number(seconds) - 0.02) < 0.001);
  // The programs differ in line 16 alone.
  assert.equal(await page.textContent('#changes-title'), 'The programs differ: − walk, + faster');
  assert.deepEqual(await page.$$eval('#changes li', (rows) => rows.map((row) => row.textContent)), ['16−SPEED = 300   // mm/s', '16+SPEED = 350']);
  await page.click('#changes .removed button');
  assert.equal(await lit(page), 16);
  assert.deepEqual(complaints, []);
  await view.close();
});

test('two runs are aligned by time, or by the lines that they run', async () => {
  const view = await open(browser, `${pages}/compare.html`);
  const { page, complaints } = view;
  await page.click('#log-tab');
  const events = () => page.$$eval('.mark', (all) => all.map((one) => one.textContent));
  const order = async () => (await events()).filter((text) => text.includes('stride')).map((text) => text.match(/s(walk|slow): stride (\d)/).slice(1).join(''));
  // Both begin alike; the slow one comes later to each stride, but never later than the other one to the next.
  const both = [1, 2, 3, 4, 5, 6].flatMap((n) => [`walk${n}`, `slow${n}`]);
  assert.deepEqual(await order(), both);
  const last = Number(await page.getAttribute('#scrub', 'max'));
  const stride = page.locator('.mark:has-text("slow: stride 6")');
  await stride.click();
  const message = () => page.textContent('#message');
  assert.match(await message(), /^stride 6 of 6 at 300/);
  const cycles = async () => (await page.textContent('#now-cycle')).match(/\d+(?= \/)/g).map(Number);
  let [own, others] = await cycles();
  assert.equal(own, others);
  await page.click('#plot-align');
  assert.equal(await page.getAttribute('#plot-align', 'aria-pressed'), 'true');
  // Now the slider covers the first run, and the same line begins the stride in both.
  assert.ok(Number(await page.getAttribute('#scrub', 'max')) < last - 300);
  await stride.click();
  [own, others] = await cycles();
  assert.ok(others > own + 250, `${own} ${others}`);
  const [line, same] = (await page.textContent('#now-line')).split(' | ');
  assert.equal(line, same);
  assert.deepEqual(complaints, []);
  await view.close();
});

test('plots of two runs are over each other, or show their difference', async () => {
  const view = await open(browser, `${pages}/drives.html`);
  const { page, complaints } = view;
  const drawn = () => page.$$eval('.chart .uplot canvas', (all) => all.map((canvas) => canvas.toDataURL()).join());
  const over = await drawn();
  assert.match(await page.locator('.chart:has(.uplot) figcaption').first().textContent(), /strong: .*, faint: /);
  await page.click('#plot-difference');
  assert.match(await page.locator('.chart:has(.uplot) figcaption').first().textContent(), / minus /);
  assert.notEqual(await drawn(), over);
  await page.click('#plot-difference');
  assert.equal(await drawn(), over);
  assert.deepEqual(complaints, []);
  await view.close();
});

test('the joints of many legs have a strip for each leg, and a robot without a pose stands on the floor', async () => {
  const view = await open(browser, `${pages}/real.html`);
  const { page, complaints } = view;
  const strips = await page.$$eval('.chart:has(.uplot)', (all) => all.map((chart) => [...chart.querySelectorAll('.signal')].map((signal) => signal.textContent.slice(0, 3)).join(' ')));
  assert.deepEqual(strips, [1, 2, 3, 4, 5, 6].map((leg) => [1, 2, 3].map((joint) => `J${leg}${joint}`).join(' ')));
  // The readings name what each run knows.
  assert.match(await page.textContent('#now-margin'), /^– \| \d+ mm$/);
  // At the same moment the robot of the simulation alone has the same height above the floor.
  await page.goto(`file://${pages}/real.html#cycle=0`);
  const real = await picture(page);
  const simulated = await open(browser, `${pages}/hexapod.html`, {}, '#cycle=0');
  await simulated.page.click('#show-forces');
  await simulated.page.click('#show-support');
  const pixels = differences(real, await picture(simulated.page));
  await page.click('#show-support');
  assert.ok(pixels < 4000, `${pixels} pixels`);
  assert.deepEqual(complaints, []);
  await simulated.close();
  await view.close();
});

test('a run of drives, which do not tell where the body is, is compared at one place', async () => {
  const shown = [];
  for (const name of ['drives', 'mixed']) {
    const { page, close } = await open(browser, `${pages}/${name}.html`);
    shown.push(await picture(page));
    await close();
  }
  assert.equal(differences(...shown), 0);
});

test('an emergency stop has the time of the terminal everywhere, and its line is marked', async () => {
  // Two cycles of 20 ms ran; in the third one the clock stands still, and a trace has no record of it.
  for (const [name, last] of [['stops', 2], ['stops-traced', 1]]) {
    const { page, close } = await open(browser, `${pages}/${name}.html`);
    const now = async () => [await page.textContent('#now-cycle'), await page.textContent('#now-time'), await lit(page)];
    assert.match(await page.textContent('#outcome'), /^emergency stop after 0\.040 s: .*, line 5$/);
    await page.keyboard.press('End');
    await page.waitForSelector('#source .stopped');
    assert.deepEqual(await now(), [`${last} / ${last}`, '0.040 s', 5]);
    assert.equal(await page.textContent('#now-line'), '5');
    assert.equal(await page.locator('#source .lit').count(), 1);
    // All of the line can be read on its ground.
    await page.evaluate(axe.source);
    assert.deepEqual(await page.evaluate(async () => (await axe.run('#source')).violations.map(({ id }) => id)), []);
    assert.match(await page.textContent('#plot-time'), /^0\.040 s$/);
    await page.click('#log-tab');
    assert.equal(await page.textContent('.mark.fault time'), '0.040 s');
    await page.click('#back');
    await page.waitForFunction(() => !document.querySelector('#source .stopped'));
    assert.deepEqual(await now(), [`${last - 1} / ${last}`, `0.0${last * 2}0 s`, last + 2]);
    await close();
  }
});

test('from where a variable got its value, one goes on to the assignment before', async () => {
  const view = await open(browser, `${pages}/walk.html`);
  const { page } = view;
  await page.keyboard.press('End');
  await page.click('#state-tab');
  // N counts six strides; the last NEXT makes it 7.
  const row = page.locator('#variables tr:has(button:text-is("N"))');
  for (const value of ['7', '6', '5']) {
    await row.locator('.from button:visible').first().click();
    assert.equal(await row.locator('td').first().textContent(), value);
  }
  await view.close();
});

test('what happened has the times of the terminal', async () => {
  const view = await open(browser, `${pages}/walk.html`);
  const { page } = view;
  await page.click('#log-tab');
  // The key of cycle 120 is in the cycle that ends at 2.420 s.
  const times = await page.$$eval('.mark', (all) => all.map((mark) => mark.textContent));
  assert.ok(times.some((text) => text.startsWith('2.420 s') && text.includes('key F')), times.join());
  assert.match(await page.textContent('#outcome'), /^EXIT after \d+\.\d{3} s$/);
  await view.close();
});

test('a thread has a mark at its line, and the state shows it with timers and locks', async () => {
  const { page, complaints, close } = await open(browser, `${pages}/feeler.html`, {}, '#cycle=690');
  const marked = await page.$$eval('#source li[data-threads]', (lines) => lines.map((line) => [line.dataset.threads, line.textContent]));
  assert.equal(marked.length, 1);
  assert.equal(marked[0][0], 'WATCH');
  await page.click('#state-tab');
  assert.match(await page.textContent('#threads'), /^WATCH: line \d+$/);
  assert.match(await page.textContent('#timers'), /^0: \d+ ms$/);
  assert.equal(await page.textContent('#locks'), 'J11 J12 J13');
  const time = async () => Number((await page.textContent('#timers')).split(' ')[1]);
  const before = await time();
  const goTo = async (cycle) => {
    await page.evaluate((cycle) => (location.hash = `cycle=${cycle}`), cycle);
    await page.waitForFunction((cycle) => document.getElementById('now-cycle').textContent.startsWith(`${cycle} `), cycle);
    await page.waitForTimeout(200);
  };
  await goTo(691);
  assert.equal(await time(), before + 20);
  await goTo(20);
  assert.equal(await page.textContent('#threads'), 'none');
  assert.equal(await page.locator('#source li[data-threads]').count(), 0);
  assert.deepEqual(complaints, []);
  await close();
});

test('what a program says is text, whatever it says', async () => {
  const { page, complaints, close } = await open(browser, `${pages}/hostile.html`);
  assert.deepEqual(complaints, []);
  const said = '</script><script>alert(1)</script><img src=x onerror=alert(2)>';
  assert.equal(await page.textContent('#message'), said);
  assert.ok((await page.title()).startsWith('</title><script>alert(3)</script>'));
  assert.equal(await page.locator('img').count(), 0);
  // These are the recording, one to compare, the page's script, deflated and as it runs, and the script that inflates it.
  assert.equal(await page.locator('script').count(), 5);
  await close();
});

/** Returns the pixels of the robot's picture at rest, when all of them are drawn. */
async function picture(page) {
  await page.waitForTimeout(1000);
  return page.$eval('#canvas', (canvas) => {
    const copy = Object.assign(document.createElement('canvas'), { width: 400, height: 200 });
    const pen = copy.getContext('2d');
    pen.drawImage(canvas, 0, 0, 400, 200);
    return [...pen.getImageData(0, 0, 400, 200).data];
  });
}

/** Returns the number of pixels in which two pictures differ. */
function differences(one, other) {
  const differs = (at) => [0, 1, 2].reduce((sum, n) => sum + Math.abs(one[at + n] - other[at + n]), 0) > 24;
  return one.filter((_, at) => at % 4 === 0 && differs(at)).length;
}

test('forces inside an object show through it', async () => {
  const { page, close } = await open(browser, `${pages}/grasp.html`, { colorScheme: 'light' }, '#cycle=2600');
  const shown = await picture(page);
  await page.click('#show-forces');
  // About half of the object stands out.
  const pixels = differences(shown, await picture(page));
  assert.ok(pixels > 95, `${pixels} pixels`);
  await close();
});

test('links that overlap are red, and the event leads to the line', async () => {
  const { page, complaints, close } = await open(browser, `${pages}/crosses.html`, { colorScheme: 'light' }, '#cycle=0');
  const reds = () =>
    page.$eval('#canvas', (canvas) => {
      const copy = Object.assign(document.createElement('canvas'), { width: canvas.width, height: canvas.height });
      const pen = copy.getContext('2d');
      pen.drawImage(canvas, 0, 0);
      const { data } = pen.getImageData(0, 0, copy.width, copy.height);
      return Array.from({ length: data.length / 4 }, (_, n) => data.slice(4 * n, 4 * n + 3)).filter(([red, green, blue]) => red > 3 * green && red > 3 * blue && red > 90).length;
    });
  const apart = await reds();
  assert.equal(await page.isHidden('#alert'), true);
  await page.click('#log-tab');
  const events = page.locator('.mark.collision');
  assert.equal(await events.count(), 1);
  assert.match(await events.textContent(), /link3\d and link1\d overlap$/);
  await events.click();
  await page.waitForFunction(() => !document.getElementById('alert').hidden);
  assert.match(await page.textContent('#alert'), /^link3\d and link1\d overlap$/);
  // Both turn in SLEEP.
  assert.equal(await page.textContent('#now-line'), '5');
  await page.waitForTimeout(500);
  const overlapping = await reds();
  assert.ok(overlapping > apart + 200, `${overlapping} red pixels after ${apart}`);
  await page.click('#figures-tab');
  const figures = await page.textContent('#figures');
  assert.match(figures, /clearance link3\d and link1\d-\d+\.\d mm at least/);
  assert.match(figures, /collisionsin \d+ cycles/);
  assert.deepEqual(complaints, []);
  await close();
});

test('blocks of a scene stand on the floor', async () => {
  const shown = [];
  for (const name of ['step', 'level']) {
    const { page, complaints, close } = await open(browser, `${pages}/${name}.html`, { colorScheme: 'light' }, '#cycle=0');
    shown.push(await picture(page));
    assert.deepEqual(complaints, []);
    await close();
  }
  const pixels = differences(...shown);
  assert.ok(pixels > 1500, `${pixels} pixels`);
});
