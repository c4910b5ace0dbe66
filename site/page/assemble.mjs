// Puts the playground together twice: as one file, and as files for a server.
// node assemble.mjs FILE.wasm OUT
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { deflateRawSync, gzipSync } from 'node:zlib';
import { build } from 'esbuild';

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

const shared = { absWorkingDir: here, bundle: true, minify: true, write: false, legalComments: 'none', charset: 'utf8' };
const text = async (options) => (await build({ ...shared, ...options })).outputFiles[0].text.trim();
const define = { CONTENTS: JSON.stringify(contents()) };
const script = (await text({ entryPoints: ['src/main.js'], format: 'iife', target: 'es2023', define })).replace(/<\/script/gi, '<\\/script').replace(/<!--/g, '<\\!--');
const style = await text({ entryPoints: ['src/style.css'] });
const replay = read('tools/view/page/dist/page.html');

const licences = ['commands', 'lint', 'state', 'view']
  .map((name) => `node_modules/@codemirror/${name}`)
  .concat(['crelt', 'style-mod', 'w3c-keyname'].map((name) => `node_modules/${name}`))
  .map((folder) => `${folder.replace('node_modules/', '')}\n\n${readFileSync(`${here}/${folder}/LICENSE`, 'utf8').trim()}\n`)
  .join(`\n${'-'.repeat(72)}\n\n`);
const notice = `<!--\nThis page holds parts of these libraries; its replay names its own.\n\n${licences}-->\n`;

const hash = (content) => `'sha256-${createHash('sha256').update(content).digest('base64')}'`;
/** What the replay may do, this page must not forbid: a frame that it fills is bound by both. */
const rule = (name) => new RegExp(`${name} ([^;"]+)`).exec(replay)[1];
const policy = (files) =>
  [
    "default-src 'none'",
    `script-src ${hash(script)} ${rule('script-src')} 'wasm-unsafe-eval'`,
    `style-src ${hash(style)} ${rule('style-src')}`,
    'img-src data: blob:',
    'media-src blob:',
    ...(files ? ["connect-src 'self'"] : []),
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');

function write(path, files, parts) {
  const values = { 'BUILD-POLICY': policy(files), 'BUILD-STYLE': `<style>${style}</style>`, 'BUILD-SCRIPT': `<script>${script}</script>`, 'BUILD-PARTS': parts };
  const page = read('site/page/src/index.html').replace(/BUILD-[A-Z]+/g, (mark) => values[mark]).replace('<html', () => `${notice}<html`);
  writeFileSync(path, page);
  return Buffer.from(page);
}

mkdirSync(`${out}/hosted`, { recursive: true });
const module = readFileSync(wasm);
const part = (id, bytes) => `<script type="application/octet-stream" id="${id}">${deflateRawSync(bytes, { level: 9 }).toString('base64')}</script>`;
const one = write(`${out}/playground.html`, false, `${part('part-wasm', module)}\n${part('part-page', replay)}`);
const index = write(`${out}/hosted/index.html`, true, '');
writeFileSync(`${out}/hosted/playground.wasm`, module);
writeFileSync(`${out}/hosted/replay.html`, replay);
const packed = [index, module, Buffer.from(replay)].map((bytes) => gzipSync(bytes, { level: 9 }).length);
const total = packed.reduce((sum, size) => sum + size, 0);
const megabytes = (bytes) => `${(bytes / 1e6).toFixed(2)} MB`;
console.log(`${out}/playground.html: ${megabytes(one.length)}`);
console.log(`${out}/hosted: ${megabytes(total)} by gzip${total > 1.5e6 ? ', MORE than 1.5 MB' : ''}`);
process.exit(total > 1.5e6 ? 1 : 0);
