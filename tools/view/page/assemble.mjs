// Bundles the page's sources into one file with two marks, which tip-view replaces by a title and a recording.
// node assemble.mjs OUT
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { build } from 'esbuild';

const here = import.meta.dirname;
const read = (path) => readFileSync(join(here, path), 'utf8');
const shared = { absWorkingDir: here, bundle: true, minify: true, write: false, legalComments: 'none', charset: 'utf8' };
const text = async (options) => (await build({ ...shared, ...options })).outputFiles[0].text.trim();

const script = await text({ entryPoints: ['src/main.js'], format: 'iife', target: 'es2023' });
const uplot = 'node_modules/uplot/dist/uPlot.min.css';
const style = await text({ stdin: { contents: `@import "./${uplot}";\n@import "./src/style.css";`, loader: 'css', resolveDir: here } });
if (/<\/script|<!--/i.test(script) || /<\/style/i.test(style)) throw new Error('the bundle would end its own element');

// Nothing is asked for, and no other script runs.
const hash = (content) => `'sha256-${createHash('sha256').update(content).digest('base64')}'`;
const policy = [
  "default-src 'none'",
  `script-src ${hash(script)}`,
  `style-src ${hash(style)}`,
  'img-src data: blob:',
  'media-src blob:',
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

const version = (name) => JSON.parse(read(`node_modules/${name}/package.json`)).version;
const licences = ['three', 'uplot']
  .map((name) => `${name} ${version(name)}\n\n${read(`node_modules/${name}/LICENSE`).trim()}\n`)
  .join(`\n${'-'.repeat(72)}\n\n`);
const notice = `<!--\nThis page holds parts of these libraries.\n\n${licences}-->\n`;

const parts = { 'BUILD-POLICY': policy, 'BUILD-STYLE': style, 'BUILD-SCRIPT': script };
const page = read('src/page.html').replace(/BUILD-[A-Z]+/g, (mark) => parts[mark]);
const out = process.argv[2];
mkdirSync(dirname(out), { recursive: true });
writeFileSync(out, page.replace('<html', () => `${notice}<html`));
