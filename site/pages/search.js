// Lists the sections (SECTIONS, of sections.js) that have every word of the query, those with the words in their titles first.

/** Largest number of sections that are listed. */
const MOST = 50;
/** Characters of the text around the first word that was found. */
const AROUND = 80;

const query = (new URLSearchParams(location.search).get('q') ?? '').trim();
const words = query.toLowerCase().split(/\s+/).filter(Boolean);
const spoken = document.documentElement.lang;

/** Returns the rank of a section; 0 if it lacks a word. */
function rank({ page, title, text, language }) {
  const [above, below] = [`${page} ${title}`.toLowerCase(), text.toLowerCase()];
  if (!words.every((word) => above.includes(word) || below.includes(word))) return 0;
  const named = title.toLowerCase() === query.toLowerCase() ? 100 : words.filter((word) => title.toLowerCase().includes(word)).length * 10;
  const often = words.reduce((sum, word) => sum + below.split(word).length - 1, 0);
  return 1 + named + Math.min(often, 9) + (language === spoken ? 5 : 0);
}

/** Returns the text around the first word, with the words marked. */
function excerpt(text) {
  const flat = text.replace(/\s+/g, ' ');
  const places = words.map((word) => flat.toLowerCase().indexOf(word)).filter((at) => at >= 0);
  const from = Math.max(0, Math.min(...places, flat.length) - AROUND);
  const shown = flat.slice(from, from + 3 * AROUND);
  const line = document.createElement('p');
  const pattern = new RegExp(`(${words.map((word) => word.replace(/[\\^$.*+?()[\]{}|/]/g, '\\$&')).join('|')})`, 'iu');
  line.append(
    ...shown.split(pattern).map((part, n) => (n % 2 ? Object.assign(document.createElement('mark'), { textContent: part }) : part)),
  );
  return line;
}

if (words.length) {
  document.querySelector('input[type=search]').value = query;
  const found = SECTIONS.map((section) => ({ section, value: rank(section) })).filter(({ value }) => value);
  found.sort((a, b) => b.value - a.value);
  const status = document.getElementById('found');
  status.textContent = found.length ? `${status.dataset.found} ${found.length}` : status.dataset.none;
  const items = found.slice(0, MOST).map(({ section: { url, page, title, text } }) => {
    const [item, link] = [document.createElement('li'), document.createElement('a')];
    link.href = encodeURI(url);
    link.textContent = page === title ? title : `${page} › ${title}`;
    item.append(link, excerpt(text));
    return item;
  });
  document.getElementById('results').append(...items);
}
