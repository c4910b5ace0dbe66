// Puts the playground together as one file.
// node assemble.mjs FILE.wasm OUT
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { deflateRawSync, gzipSync } from 'node:zlib';
import { page } from '../../tools/view/page/bundle.mjs';

/** Largest number of bytes that a visitor of the playground on a server downloads, by gzip. */
const LIMIT = 1.8e6;

const [wasm, out] = process.argv.slice(2);
const here = import.meta.dirname;
const root = `${here}/../..`;
const read = (path) => readFileSync(`${root}/${path}`, 'utf8');

/** Robots, examples and lessons, and the text of every file that they name. */
function contents() {
  const { robots, examples, lessons } = JSON.parse(read('site/contents.json'));
  const named = [...examples, ...lessons].map(({ program }) => program);
  const around = Object.values(robots).flatMap(({ robot, scene }) => [robot.name, scene?.name ?? '']);
  const paths = [...named, ...around].filter((name) => name.includes('/'));
  return { robots, examples, lessons, files: Object.fromEntries(paths.map((path) => [path, read(path)])) };
}

const define = { CONTENTS: JSON.stringify(contents()) };
const tour = read('site/page/src/tour.html').trim();
const packed = deflateRawSync(readFileSync(wasm), { level: 9 }).toString('base64');
const { html } = await page({
  script: `${here}/src/main.js`,
  ahead: `${here}/src/load.js`,
  styles: { live: ['./node_modules/uplot/dist/uPlot.min.css', './src/style.css', './src/live.css', `${here}/src/tour.css`] },
  kinds: ['live', 'playground'],
  scripts: ["'wasm-unsafe-eval'"],
  parts: { 'TIP-TITLE': 'T.I.P. playground', 'BUILD-TOUR': tour, 'BUILD-DATA': `<script type="application/octet-stream" id="module">${packed}</script>\n` },
  define,
});

mkdirSync(out, { recursive: true });
writeFileSync(`${out}/playground.html`, html);
const total = gzipSync(html, { level: 9 }).length;
const megabytes = (bytes) => `${(bytes / 1e6).toFixed(2)} MB`;
console.log(`${out}/playground.html: ${megabytes(Buffer.byteLength(html))}, by gzip ${megabytes(total)}${total > LIMIT ? `, MORE than ${megabytes(LIMIT)}` : ''}`);
process.exit(total > LIMIT ? 1 : 0);
