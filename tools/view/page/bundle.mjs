// Makes a page of src/page.html: one file with a script, styles and the licences of what it holds. The playground is made of it
// as well (site/page/assemble.mjs).
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'esbuild';

const here = import.meta.dirname;
const read = (path) => readFileSync(join(here, path), 'utf8');
const shared = { absWorkingDir: here, bundle: true, minify: true, write: false, metafile: true, legalComments: 'none', charset: 'utf8' };
/** Browsers compile shaders, and need neither their indentation nor their comments. */
const shaders = {
  name: 'shaders',
  setup({ onLoad }) {
    // They are in strings, some of them over several lines.
    const bare = (text) => text.replace(/(\\n|\n)(\\t|\t)+/g, '$1').replace(/\\n\/\/[^"\\]*(?=\\n)|\n\/\/[^`\n]*(?=\n)/g, '');
    onLoad({ filter: /three\.module\.js$/ }, ({ path }) => ({ contents: bare(readFileSync(path, 'utf8')) }));
  },
};
const bundle = async (options) => {
  const { outputFiles, metafile } = await build({ ...shared, plugins: [shaders], ...options });
  return { text: outputFiles[0].text.trim(), files: Object.keys(metafile.inputs) };
};
const hash = (content) => `'sha256-${createHash('sha256').update(content).digest('base64')}'`;

const KINDS = ['replay', 'live', 'served', 'playground'];

/**
 * A page of a script and styles, by their paths: `{ html, script }`, where the script is part of the page unless `loader` is the
 * path of another one that fetches it from the page's element `script`. Of page.html the page holds what is marked for one of
 * `kinds`; what is marked for one of `left` stays marked. `ahead` is a short script that runs before the other has come,
 * `scripts` and `allowed` are what else its policy lets it do, `parts` what stands for marks of page.html, `define` what names in
 * the script stand for. Styles are lists of paths, by the kind that they are for.
 */
export async function page({ script: entry, ahead, loader, styles, kinds, left = [], scripts = [], allowed = '', parts, define = {} }) {
  const compiled = (path) => (path ? bundle({ entryPoints: [path], format: 'iife', target: 'es2023', define }) : { text: '', files: [] });
  const [script, first, fetcher] = [await compiled(entry), await compiled(ahead), await compiled(loader)];
  const sheets = [];
  for (const [kind, paths] of Object.entries(styles)) {
    const contents = paths.map((path) => `@import "${path}";`).join('\n');
    sheets.push({ kind, ...(await bundle({ stdin: { contents, loader: 'css', resolveDir: here } })) });
  }
  if (/<\/script|<!--/i.test(script.text + first.text) || sheets.some(({ text }) => /<\/style/i.test(text))) throw new Error('the bundle would end its own element');

  // Nothing else is asked for, and no other script runs.
  const own = [script, first, fetcher].filter(({ text }) => text);
  const policy = [
    "default-src 'none'",
    ['script-src', ...own.map(({ text }) => hash(text)), ...scripts].join(' '),
    ['style-src', ...sheets.map(({ text }) => hash(text))].join(' '),
    'img-src data: blob:',
    `${allowed}base-uri 'none'`,
    "form-action 'none'",
  ].join('; ');
  const element = (text) => `<script>${text}</script>`;
  const marked = (kind, text) => (left.includes(kind) ? `<!--${kind}-->${text}<!--/${kind}-->` : text);
  const values = {
    'BUILD-POLICY': policy,
    'BUILD-STYLE': sheets.map(({ kind, text }) => marked(kind, `<style>${text}</style>`)).join('\n'),
    'BUILD-SCRIPT': loader ? `<script type="application/octet-stream" id="script">TIP-SCRIPT</script>\n${element(fetcher.text)}` : element(script.text),
    ...parts,
  };
  if (ahead) values['BUILD-DATA'] = `${parts['BUILD-DATA'] ?? ''}${element(first.text)}\n`;
  let html = read('src/page.html');
  for (const kind of KINDS.filter((kind) => !left.includes(kind))) {
    html = html.replace(new RegExp(`<!--${kind}-->([^]*?)<!--/${kind}-->`, 'g'), kinds.includes(kind) ? '$1' : '');
  }
  const files = [...own, ...sheets].flatMap(({ files }) => files);
  html = html.replace('<html', () => `${notice(files)}<html`).replace(/BUILD-[A-Z]+|TIP-TITLE/g, (mark) => values[mark] ?? '');
  return { html, script: script.text };
}

/** The text of a package's licence, whatever the ending of its file. */
const licence = (name) => {
  const folder = `node_modules/${name}`;
  return read(`${folder}/${readdirSync(join(here, folder)).find((file) => /^licen[cs]e/i.test(file))}`);
};

/** The licences of all packages that files belong to. */
function notice(files) {
  const names = files.map((file) => /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file)?.[1]);
  const packages = [...new Set(names.filter(Boolean))].sort();
  const licences = packages.map((name) => {
    const { version } = JSON.parse(read(`node_modules/${name}/package.json`));
    return `${name} ${version}\n\n${licence(name).trim()}\n`;
  });
  return `<!--\nThis page holds parts of these libraries.\n\n${licences.join(`\n${'-'.repeat(72)}\n\n`)}-->\n`;
}
