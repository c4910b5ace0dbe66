// Bundles the page's sources into files of one page each: the one that replays a run, with two marks, which tip-view replaces
// by a title and a recording; and the one that shows a run that goes on.
// node assemble.mjs FOLDER
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'esbuild';

const here = import.meta.dirname;
const read = (path) => readFileSync(join(here, path), 'utf8');
const shared = { absWorkingDir: here, bundle: true, minify: true, write: false, metafile: true, legalComments: 'none', charset: 'utf8' };
const bundle = async (options) => {
  const { outputFiles, metafile } = await build({ ...shared, ...options });
  return { text: outputFiles[0].text.trim(), files: Object.keys(metafile.inputs) };
};
const hash = (content) => `'sha256-${createHash('sha256').update(content).digest('base64')}'`;

/** What a page holds: a script, styles, the parts of page.html that are marked for it, and more that its policy allows. */
async function page(entry, styles, kind, allowed, title) {
  const script = await bundle({ entryPoints: [`src/${entry}`], format: 'iife', target: 'es2023' });
  const imports = ['./node_modules/uplot/dist/uPlot.min.css', ...styles.map((name) => `./src/${name}`)];
  const contents = imports.map((path) => `@import "${path}";`).join('\n');
  const style = await bundle({ stdin: { contents, loader: 'css', resolveDir: here } });
  if (/<\/script|<!--/i.test(script.text) || /<\/style/i.test(style.text)) throw new Error('the bundle would end its own element');

  // Nothing else is asked for, and no other script runs.
  const policy = [
    "default-src 'none'",
    `script-src ${hash(script.text)}`,
    `style-src ${hash(style.text)}`,
    'img-src data: blob:',
    ...allowed,
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
  const parts = { 'BUILD-POLICY': policy, 'BUILD-STYLE': style.text, 'BUILD-SCRIPT': script.text, 'TIP-TITLE': title };
  const marked = /<!--(live|replay)-->([^]*?)<!--\/\1-->/g;
  return read('src/page.html')
    .replace(marked, (_, whose, part) => (whose === kind ? part : ''))
    .replace('<html', () => `${notice([...script.files, ...style.files])}<html`)
    .replace(/BUILD-[A-Z]+|TIP-TITLE/g, (mark) => parts[mark]);
}

/** The licences of all packages that files belong to. */
function notice(files) {
  const names = files.map((file) => /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file)?.[1]);
  const packages = [...new Set(names.filter(Boolean))].sort();
  const licences = packages.map((name) => {
    const { version } = JSON.parse(read(`node_modules/${name}/package.json`));
    return `${name} ${version}\n\n${read(`node_modules/${name}/LICENSE`).trim()}\n`;
  });
  return `<!--\nThis page holds parts of these libraries.\n\n${licences.join(`\n${'-'.repeat(72)}\n\n`)}-->\n`;
}

const folder = process.argv[2];
mkdirSync(folder, { recursive: true });
const pages = {
  'page.html': await page('main.js', ['style.css'], 'replay', ['media-src blob:'], 'TIP-TITLE'),
  'live.html': await page('serve.js', ['style.css', 'live.css'], 'live', ["connect-src 'self'"], 'tipc serve'),
};
for (const [name, text] of Object.entries(pages)) writeFileSync(join(folder, name), text);
