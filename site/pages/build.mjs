// Writes the pages around the playground: the Markdown of the repository, a gallery of replays, the lessons and the search.
// A link that leads nowhere ends the build.
// node build.mjs OUT TIP
import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { dirname, extname, join, normalize, relative } from 'node:path';
import MarkdownIt from 'markdown-it';
import { WORDS } from './words.mjs';

const [out, tip] = process.argv.slice(2);
const root = join(import.meta.dirname, '../..');
const read = (path) => readFileSync(join(root, path), 'utf8');
// In a container the folder may belong to another user.
const stored = execFileSync('git', ['-c', 'safe.directory=*', 'ls-files'], { cwd: root, encoding: 'utf8' }).trim().split('\n');
const workspace = read('Cargo.toml').split('[workspace.package]')[1];
const [version, repository] = ['version', 'repository'].map((key) => new RegExp(`^${key} = "(.*)"`, 'm').exec(workspace)[1]);

/** Files that pages show or offer, beside Markdown. */
const ASSETS = new Set(['.webp', '.svg', '.json']);
const LANGUAGES = ['en', 'ja'];

const escaped = (text) => text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;').replace(/"/g, '&quot;');
/** The identity that GitHub gives a heading, which links in Markdown use. */
const slug = (text) => text.toLowerCase().replace(/[^\p{L}\p{N}\p{M}_ -]/gu, '').replace(/ /g, '-');
const languageOf = (path) => (path.includes('.ja.') ? 'ja' : 'en');
/** `index.html` in a language. */
const spoken = (page, language) => (language === 'ja' ? page.replace(/\.html$/, '.ja.html') : page);

/** The page of a Markdown file. */
const pageOf = (path) => path.replace(/README/, 'index').replace(/\.md$/, '.html');
/** The example that a file belongs to: its folder has a page with its sources. */
const exampleOf = (path) => /^examples\/[^/]+/.exec(path)?.[0];

/** Markdown files whose pages are to be written, the pages that were written with their identities, the links to check, and the sections to search. */
const [wanted, pages, links, sections] = [[], new Map(), [], []];

/** Returns the address on the site that a link of a Markdown file leads to, relative to the page of that file. */
function place(from, href) {
  if (/^(https?|mailto):/.test(href)) return href;
  const [name, fragment = ''] = decodeURI(href).split('#');
  const page = pageOf(from);
  const path = name ? normalize(join(dirname(from), name)).replace(/\/$/, '') : from;
  if (!existsSync(join(root, path))) throw new Error(`${from}: ${href} is not in the repository`);
  const folder = statSync(join(root, path)).isDirectory();
  const text = folder ? `${path}/README.md` : path;
  let target;
  if (text.endsWith('.md') && stored.includes(text)) {
    wanted.push(text);
    target = `${pageOf(text)}${fragment && `#${fragment}`}`;
  } else if (ASSETS.has(extname(path))) {
    cpSync(join(root, path), join(out, path), { recursive: true });
    target = path;
  } else if (exampleOf(path)) {
    wanted.push(`${exampleOf(path)}/README.md`);
    target = `${exampleOf(path)}/index.html#${folder ? 'sources' : path}`;
  } else {
    return `${repository}/${folder ? 'tree' : 'blob'}/v${version}/${path}`;
  }
  links.push({ from, target });
  const [file, identity] = target.split('#');
  return encodeURI(file === page ? '' : relative(dirname(page), file)) + (identity || file === page ? `#${identity ?? ''}` : '');
}

const markdown = new MarkdownIt({ html: true });
// Parts that scroll can have the focus, for readers without a mouse.
markdown.renderer.rules.table_open = () => '<div class="wide" tabindex="0"><table>';
markdown.renderer.rules.table_close = () => '</table></div>';
const fence = markdown.renderer.rules.fence;
markdown.renderer.rules.fence = (...all) => fence(...all).replace('<pre>', '<pre tabindex="0">');

/** Returns the HTML of a Markdown file, its headings and its identities; adds its sections to the search. */
function rendered(path) {
  const tokens = markdown.parse(read(path).replace(/^```(\w+),.*$/gm, '```$1'), {});
  const [headings, ids] = [[], new Set()];
  let section = { text: '' };
  const words = (token) => token.children.map(({ type, content }) => (type === 'softbreak' ? ' ' : content)).join('');
  tokens.forEach((token, n) => {
    if (token.type === 'heading_open') {
      const title = words(tokens[n + 1]);
      let id = slug(title);
      for (let again = 1; ids.has(id); again++) id = `${slug(title)}-${again}`;
      ids.add(id);
      token.attrSet('id', id);
      headings.push({ level: Number(token.tag[1]), title, id });
      section = { url: `${pageOf(path)}#${id}`, page: headings[0].title, title, language: languageOf(path), text: '' };
      sections.push(section);
    } else if (token.type === 'inline') {
      for (const child of token.children) {
        for (const name of ['href', 'src']) {
          if (child.attrGet(name)) child.attrSet(name, place(path, child.attrGet(name)));
        }
      }
      if (tokens[n - 1].type !== 'heading_open') section.text += `${words(token)} `;
    } else if (token.type === 'fence' || token.type === 'code_block') {
      section.text += `${token.content} `;
    }
  });
  const html = markdown.renderer
    .render(tokens, markdown.options, {})
    .replace(/<img src="(docs[^"]*)"/g, (_, src) => `<img src="${place(path, src)}"`)
    // Tables that are written as HTML scroll, too. A heading cell without words becomes a plain cell.
    .replace(/<thead>\s*<tr>\s*(<th[^>]*><\/th>\s*)+<\/tr>\s*<\/thead>/g, '')
    .replace(/(^|[^>])<table>([^]*?)<\/table>(?!<\/div>)/g, '$1<div class="wide" tabindex="0"><table>$2</table></div>')
    .replace(/<th([^>]*)><\/th>/g, '<td$1></td>');
  return { html, headings, ids };
}

/** Returns the HTML of the files of an example, and its identities. */
function sources(folder) {
  const files = stored.filter((path) => path.startsWith(`${folder}/`) && !/README\.md$|Cargo\.lock$/.test(path));
  const shown = files.map((path) => `<details><summary>${path}</summary><pre tabindex="0" id="${path}"><code>${escaped(read(path))}</code></pre></details>`);
  return { html: `<h2 id="sources">Sources</h2>\n${shown.join('\n')}`, ids: ['sources', ...files] };
}

/** Writes a page: its language, title and content; `other` is the same page in the other language, else that has its first page. */
function write(page, { language, title, html, headings = [], ids = new Set(), scripts = [] }) {
  const word = (name) => WORDS[name][LANGUAGES.indexOf(language)];
  const up = (target) => encodeURI(relative(dirname(page), target));
  const entries = [['home', spoken('index.html', language)], ['playground', 'playground.html'], ['gallery', spoken('gallery.html', language)], ['lessons', spoken('lessons.html', language)], ['documentation', `${spoken('index.html', language)}#${word('readOn')}`]];
  const items = entries.map(([name, target]) => `<li><a href="${up(target)}"${target === page ? ' aria-current="page"' : ''}>${word(name)}</a></li>`);
  const contents = headings.filter(({ level }) => level === 2).map(({ title, id }) => `<li><a href="#${encodeURI(id)}">${escaped(title)}</a></li>`);
  const other = LANGUAGES.find((one) => one !== language);
  const text = `<!doctype html>
<html lang="${language}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escaped(title)}${title === 'TIP' ? '' : ' – TIP'}</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="${up('style.css')}">
</head>
<body>
<a class="skip" href="#content">${word('skip')}</a>
<header>
<nav aria-label="TIP"><ul>${items.join('')}</ul></nav>
<form role="search" action="${up(spoken('search.html', language))}"><input type="search" name="q" required aria-label="${word('search')}" placeholder="${word('search')}"></form>
<a id="language" lang="${other}" hreflang="${other}" href="BUILD-OTHER">${word('other')}</a>
</header>
<div class="columns">
${contents.length > 2 ? `<nav class="contents" aria-label="${word('contents')}"><ul>${contents.join('')}</ul></nav>` : ''}
<main id="content">
${html}
</main>
</div>
${scripts.map((name) => `<script src="${up(name)}"></script>`).join('\n')}
</body>
</html>
`;
  pages.set(page, { text, language, ids: new Set([...ids, 'content', 'language']) });
  for (const [, target] of entries) links.push({ from: page, target });
}

/** Writes the page of the runs that were simulated while the site was built, each with its replay, its diagram and its source. */
function gallery(language) {
  const at = LANGUAGES.indexOf(language);
  const word = (name) => WORDS[name][at];
  const { examples } = JSON.parse(read('site/contents.json'));
  const cards = JSON.parse(read('site/gallery.json')).map(({ name, program, title }) => {
    const source = place('README.md', program);
    const example = examples.findIndex((one) => one.program === program) + 1;
    const tried = example ? ` <a href="playground.html#example=${example}">${word('change')}</a>` : '';
    return `<li><h2>${title[at]}</h2><img src="gallery/${name}.svg" alt="${word('diagram')}" loading="lazy"><p><a href="gallery/${name}.html">${word('replay')}</a> <a href="${source}">${word('source')}</a>${tried}</p></li>`;
  });
  const page = spoken('gallery.html', language);
  write(page, { language, title: word('gallery'), html: `<h1>${word('gallery')}</h1>\n<p>${word('galleryText')}</p>\n<ul class="cards">${cards.join('\n')}</ul>` });
}

function lessons(language) {
  const at = LANGUAGES.indexOf(language);
  const word = (name) => WORDS[name][at];
  const list = JSON.parse(read('site/contents.json')).lessons.map(({ title, text }, n) => `<li><button class="link" formaction="playground.html#lesson=${n + 1}" formnovalidate>${title[at]}</button><br>${escaped(text[at][0])}</li>`);
  const form = `<form class="pupil" action="playground.html#lesson=1"><label>${word('pupil')} <input name="pupil" required autocomplete="off"></label> <button>${word('begin')}</button>\n<ol class="lessons">${list.join('\n')}</ol></form>`;
  const page = spoken('lessons.html', language);
  write(page, { language, title: word('lessons'), html: `<h1>${word('lessons')}</h1>\n<p>${word('lessonsText')}</p>\n${form}` });
}

function search(language) {
  const word = (name) => WORDS[name][LANGUAGES.indexOf(language)];
  const html = `<h1>${word('search')}</h1>\n<p id="found" role="status" data-none="${word('none')}" data-found="${word('found')}"></p>\n<ol id="results"></ol>`;
  write(spoken('search.html', language), { language, title: word('search'), html, scripts: ['sections.js', 'search.js'] });
}

mkdirSync(join(out, 'gallery'), { recursive: true });
for (const { name, program, options } of JSON.parse(read('site/gallery.json'))) {
  execFileSync(tip, ['view', program, '--quiet', ...options, '-o', join(out, `gallery/${name}.html`)], { cwd: root });
  execFileSync(tip, ['plot', program, ...options, '-o', join(out, `gallery/${name}.svg`)], { cwd: root, stdio: 'ignore' });
}
wanted.push('README.md', 'README.ja.md', ...stored.filter((path) => /^docs\/.*\.md$|^examples\/[^/]+\/README\.md$/.test(path)));
for (const language of LANGUAGES) {
  gallery(language);
  lessons(language);
  search(language);
}
for (let path = wanted.shift(); path; path = wanted.shift()) {
  const page = pageOf(path);
  if (pages.has(page)) continue;
  const language = languageOf(path);
  const { html, headings, ids } = rendered(path);
  const folder = exampleOf(path);
  const shown = folder === dirname(path) ? sources(folder) : { html: '', ids: [] };
  const [ahead, ...rest] = html.split(/(?=<p>\n<img)/);
  const first = page === spoken('index.html', language);
  const doors = first ? WORDS.doors[LANGUAGES.indexOf(language)] : '';
  write(page, { language, title: headings[0].title, html: `${ahead}${doors}${rest.join('')}${shown.html}`, headings, ids: new Set([...ids, ...shown.ids]) });
  for (const [, target] of doors.matchAll(/href="([^"]*)"/g)) links.push({ from: page, target: target.startsWith('#') ? `${page}${target}` : target });
}

let broken = 0;
for (const { from, target } of links) {
  const [file, identity] = decodeURI(target).split('#');
  const page = pages.get(file);
  if (page ? !identity || page.ids.has(identity) : existsSync(join(out, file))) continue;
  console.error(`${from}: nothing is at ${target}`);
  broken++;
}
for (const [page, { text, language }] of pages) {
  const other = language === 'ja' ? page.replace('.ja.html', '.html') : spoken(page, 'ja');
  const target = relative(dirname(page), pages.has(other) ? other : spoken('index.html', language === 'ja' ? 'en' : 'ja'));
  mkdirSync(dirname(join(out, page)), { recursive: true });
  writeFileSync(join(out, page), text.replace('BUILD-OTHER', encodeURI(target)));
}
writeFileSync(join(out, 'sections.js'), `const SECTIONS = ${JSON.stringify(sections)};\n`);
for (const name of ['style.css', 'search.js']) cpSync(join(import.meta.dirname, name), join(out, name));
console.log(`${out}: ${pages.size} pages, ${links.length} links between them`);
process.exit(broken ? 1 : 0);
