// Bundles the page's sources into two files: page.html, in which tip-view chooses between what replays a run and what shows a run
// that goes on, and fills in a title, the script and a recording; and page.js, its script.
// node assemble.mjs FOLDER
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { page } from './bundle.mjs';

const folder = process.argv[2];
mkdirSync(folder, { recursive: true });
const { html, script } = await page({
  script: 'src/main.js',
  loader: 'src/load.js',
  styles: { both: ['./node_modules/uplot/dist/uPlot.min.css', './src/style.css'], live: ['./src/live.css'] },
  kinds: ['served'],
  left: ['replay', 'live'],
  allowed: "<!--live-->connect-src 'self'; <!--/live-->",
  parts: { 'TIP-TITLE': 'TIP-TITLE' },
});
writeFileSync(join(folder, 'page.html'), html);
writeFileSync(join(folder, 'page.js'), script);
