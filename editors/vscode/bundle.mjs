// Bundles the extension into dist/extension.cjs, with the licences of what it holds: node bundle.mjs
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'esbuild';

const here = import.meta.dirname;
const { metafile } = await build({
  absWorkingDir: here,
  entryPoints: ['src/extension.js'],
  outfile: 'dist/extension.cjs',
  bundle: true,
  minify: true,
  metafile: true,
  platform: 'node',
  target: 'node20',
  external: ['vscode'],
  legalComments: 'none',
});

const folders = Object.keys(metafile.inputs).map((file) => /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(file)?.[1]);
const licences = [...new Set(folders.filter(Boolean))].sort().map((folder) => {
  const { name, version } = JSON.parse(readFileSync(join(here, folder, 'package.json'), 'utf8'));
  const file = readdirSync(join(here, folder)).find((file) => /^licen[cs]e/i.test(file));
  if (!file) throw new Error(`${name} has no licence`);
  return `${name} ${version}\n\n${readFileSync(join(here, folder, file), 'utf8').trim()}\n`;
});
mkdirSync(join(here, 'dist'), { recursive: true });
const notice = `extension.cjs holds parts of these libraries.\n\n${licences.join(`\n${'-'.repeat(72)}\n\n`)}`;
writeFileSync(join(here, 'dist/licences.txt'), notice);
