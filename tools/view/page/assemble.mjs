// Bundles the page's sources into files of one page each: the one that replays a run, with two marks, which tip-view replaces
// by a title and a recording; and the one that shows a run that goes on.
// node assemble.mjs FOLDER
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { page } from './bundle.mjs';

const folder = process.argv[2];
mkdirSync(folder, { recursive: true });
const pages = {
  'page.html': await page({
    script: 'src/main.js',
    styles: ['./src/style.css'],
    kinds: ['replay'],
    allowed: [],
    parts: { 'TIP-TITLE': 'TIP-TITLE' },
  }),
  'live.html': await page({
    script: 'src/serve.js',
    styles: ['./src/style.css', './src/live.css'],
    kinds: ['live', 'served'],
    allowed: ["connect-src 'self'"],
    parts: { 'TIP-TITLE': 'tip serve' },
  }),
};
for (const [name, text] of Object.entries(pages)) writeFileSync(join(folder, name), text);
