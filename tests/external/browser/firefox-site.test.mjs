// Tests the site in Firefox, dark and in Japanese. SITE is the folder that site/build has filled. site.test.mjs has more tests, in
// Chromium.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { deflateRawSync } from 'node:zlib';
import { launchFirefox } from './bidi.mjs';

const home = `file://${process.env.SITE}/`;
let firefox;
before(async () => (firefox = await launchFirefox({ 'intl.accept_languages': 'ja', 'ui.systemUsesDarkTheme': 1 })));
after(() => firefox.close());

/** Sets the size of the window's content, CSS px. */
const resize = ({ session }, width) => session.send('browsingContext.setViewport', { context: session.context, viewport: { width, height: 844 } });
/** Waits until an element's text contains this, and returns the text. */
const says = ({ session }, selector, text) =>
  session.run(
    async (selector, text) => {
      const shown = () => document.querySelector(selector)?.textContent ?? '';
      for (let times = 0; times < 400 && !shown().includes(text); times += 1) await new Promise((resolve) => setTimeout(resolve, 50));
      return shown();
    },
    selector,
    text,
  );
/** Waits until another page is shown whose address contains this. */
async function arrives({ session }, part) {
  for (let times = 0; times < 200; times += 1) {
    // A page that is just left answers nothing.
    const address = await session.run(() => document.readyState === 'complete' && decodeURI(location.href)).catch(() => false);
    if (address && address.includes(part)) return;
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  assert.fail(`${part} was not reached`);
}
/** Makes sure that nothing but files was asked for, and that the browser complained of nothing. */
function isQuiet({ session }) {
  assert.deepEqual(session.asked.filter((url) => !url.startsWith('file:') && url !== 'about:blank'), []);
  assert.deepEqual(session.complaints, []);
}
/** Opens a program in the playground by its address. */
const write = ({ session }, text) =>
  session.open(`${home}playground.html#robot=titan8&events=&program=${deflateRawSync(text).toString('base64url')}`);

for (const width of [390, 1440]) {
  test(`pages are dark, in Japanese, and as wide as a window of ${width} px`, async () => {
    const { session } = firefox;
    await resize(firefox, width);
    for (const name of ['index.ja', 'gallery.ja', 'lessons.ja', 'docs/tutorial.ja', 'docs/language.ja', 'docs/drives']) {
      await session.load(`${home}${name}.html`);
      const page = await session.run(() => ({
        language: document.documentElement.lang,
        wide: document.documentElement.scrollWidth,
        background: getComputedStyle(document.body).backgroundColor.match(/\d+/g).slice(0, 3).map(Number),
      }));
      assert.equal(page.language, name.endsWith('.ja') ? 'ja' : 'en', name);
      assert.ok(page.wide <= width, `${name}: ${page.wide}`);
      assert.ok(Math.max(...page.background) < 80, `${name}: ${page.background}`);
      isQuiet(firefox);
    }
  });
}

test('search finds REL_PTP', async () => {
  const { session } = firefox;
  await session.load(`${home}index.ja.html`);
  await session.run(() => {
    document.querySelector('input[type=search]').value = 'REL_PTP';
    document.querySelector('form[role=search]').requestSubmit();
  });
  await arrives(firefox, 'search.ja.html?q=REL_PTP');
  assert.match(await says(firefox, '#results li a', 'REL_PTP'), /› REL_PTP$/);
  await session.run(() => document.querySelector('#results li a').click());
  await arrives(firefox, 'docs/commands.html#rel_ptp');
  isQuiet(firefox);
});

test('a pupil begins the lessons, and the first one runs', async () => {
  const { session } = firefox;
  await session.load(`${home}lessons.ja.html`);
  await session.run(() => {
    document.querySelector('input[name=pupil]').value = 'Aiko';
    document.querySelector('.pupil button').click();
  });
  await arrives(firefox, 'playground.html?pupil=Aiko');
  await session.ready();
  assert.match(await says(firefox, '#lesson-number', 'Aiko'), /^Aiko/);
  assert.match(await says(firefox, '#file', '01-hello'), /01-hello/);
  await session.run(() => document.getElementById('restart').click());
  assert.match(await says(firefox, '#outcome', 'END'), /END/);
  isQuiet(firefox);
});

test('the playground names an error, and runs a program without one', async () => {
  const { session } = firefox;
  await write(firefox, '3.1\nx\nMESAGE a\nEND\n');
  assert.match(await says(firefox, '#problems', 'コマンドはありません'), /3:1.*コマンドはありません/);
  await write(firefox, '3.1\n立つ\nSTAND_UP 60\nMESSAGE 立った\nEND\n');
  await session.run(() => document.getElementById('restart').click());
  assert.match(await says(firefox, '#message', '立った'), /立った/);
  isQuiet(firefox);
});
