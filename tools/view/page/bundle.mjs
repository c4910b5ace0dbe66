// Makes a page of src/page.html: one file with a script, styles and the licences of what it holds. The playground is made of it
// as well (site/page/assemble.mjs).
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
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

/**
 * A page of a script and styles, by their paths; of page.html it holds what is marked for one of its kinds. `ahead` is a short
 * script that runs before the other has come, `scripts` and `allowed` are what else its policy lets it do, `parts` what stands
 * for marks of page.html, `define` what names in the script stand for.
 */
export async function page({ script: entry, ahead, styles, kinds, scripts = [], allowed, parts, define = {} }) {
  const compiled = (path) => bundle({ entryPoints: [path], format: 'iife', target: 'es2023', define });
  const script = await compiled(entry);
  const first = ahead ? await compiled(ahead) : { text: '', files: [] };
  const contents = ['./node_modules/uplot/dist/uPlot.min.css', ...styles].map((path) => `@import "${path}";`).join('\n');
  const style = await bundle({ stdin: { contents, loader: 'css', resolveDir: here } });
  if (/<\/script|<!--/i.test(script.text + first.text) || /<\/style/i.test(style.text)) throw new Error('the bundle would end its own element');

  // Nothing else is asked for, and no other script runs.
  const policy = [
    "default-src 'none'",
    ['script-src', hash(script.text), ...(ahead ? [hash(first.text)] : []), ...scripts].join(' '),
    `style-src ${hash(style.text)}`,
    'img-src data: blob:',
    ...allowed,
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
  const values = { 'BUILD-POLICY': policy, 'BUILD-STYLE': style.text, 'BUILD-SCRIPT': script.text, ...parts };
  if (ahead) values['BUILD-DATA'] = `${parts['BUILD-DATA'] ?? ''}<script>${first.text}</script>\n`;
  const marked = /<!--(\w+)-->([^]*?)<!--\/\1-->/g;
  let text = read('src/page.html');
  while (text.search(marked) >= 0) text = text.replace(marked, (_, kind, part) => (kinds.includes(kind) ? part : ''));
  return text.replace('<html', () => `${notice([...first.files, ...script.files, ...style.files])}<html`).replace(/BUILD-[A-Z]+|TIP-TITLE/g, (mark) => values[mark] ?? '');
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
