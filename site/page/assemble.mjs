// Puts the playground together twice: as one file, and as files for a server.
// node assemble.mjs FILE.wasm OUT
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { deflateRawSync, gzipSync } from 'node:zlib';
import { page } from '../../tools/view/page/bundle.mjs';

/** The most bytes that a visitor of the hosted playground downloads, by gzip. */
const LIMIT = 1.64e6;

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
const made = async (data, allowed) => {
  const { html } = await page({
    script: `${here}/src/main.js`,
    ahead: `${here}/src/load.js`,
    styles: { live: ['./node_modules/uplot/dist/uPlot.min.css', './src/style.css', './src/live.css', `${here}/src/tour.css`] },
    kinds: ['live', 'playground'],
    scripts: ["'wasm-unsafe-eval'"],
    allowed,
    parts: { 'TIP-TITLE': 'T.I.P. playground', 'BUILD-TOUR': tour, 'BUILD-DATA': data },
    define,
  });
  return html;
};

mkdirSync(`${out}/hosted`, { recursive: true });
const module = readFileSync(wasm);
const packed = deflateRawSync(module, { level: 9 }).toString('base64');
const one = await made(`<script type="application/octet-stream" id="module">${packed}</script>\n`, '');
// The module is on its way while the script still comes.
const ahead = '<link rel="preload" href="playground.wasm" as="fetch" type="application/wasm" crossorigin>\n';
const index = await made(ahead, "connect-src 'self'; ");
writeFileSync(`${out}/playground.html`, one);
writeFileSync(`${out}/hosted/index.html`, index);
writeFileSync(`${out}/hosted/playground.wasm`, module);
const total = [index, module].reduce((sum, bytes) => sum + gzipSync(bytes, { level: 9 }).length, 0);
const megabytes = (bytes) => `${(bytes / 1e6).toFixed(2)} MB`;
console.log(`${out}/playground.html: ${megabytes(Buffer.byteLength(one))}`);
console.log(`${out}/hosted: ${megabytes(total)} by gzip${total > LIMIT ? `, MORE than ${megabytes(LIMIT)}` : ''}`);
process.exit(total > LIMIT ? 1 : 0);
