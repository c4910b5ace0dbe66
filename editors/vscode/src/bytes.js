// How a program spells text, and what of it the editor would spell otherwise.

/** The editor's names of the encodings that tip.toml has. */
const NAMES = { 'utf-8': 'utf8', shift_jis: 'shiftjis' };

/** The encoding of a program; nothing where any is right. `said` is what tip.toml says. */
export function encodingOf(bytes, said) {
  if (said in NAMES) return NAMES[said];
  if (bytes.every((byte) => byte < 0x80)) return undefined;
  try {
    new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    return NAMES['utf-8'];
  } catch {
    return NAMES.shift_jis;
  }
}

const isLead = (byte) => (byte >= 0x81 && byte <= 0x9f) || (byte >= 0xe0 && byte <= 0xfc);

/** The line and column of a place in a text. */
export function place(text, offset) {
  const lines = text.slice(0, offset).split(/\r\n|\r|\n/);
  return { line: lines.length - 1, character: lines.at(-1).length };
}

/** The characters of Shift_JIS from `start` on, each as the end of its bytes. */
function* characters(bytes) {
  for (let at = 0; at < bytes.length; ) {
    const length = isLead(bytes[at]) && at + 1 < bytes.length ? 2 : 1;
    yield bytes.subarray(at, at + length);
    at += length;
  }
}

/**
 * The bytes that become others when the editor saves them: where in its text (`start` and `end`, in UTF-16), `from` and `to`.
 * `codec` decodes and encodes as the editor does.
 */
export async function respelt(bytes, codec) {
  const text = await codec.decode(bytes);
  if (same(await codec.encode(text), bytes)) return [];
  const known = new Map();
  const found = [];
  let start = 0;
  for (const from of characters(bytes)) {
    const key = from.length === 2 ? from[0] * 256 + from[1] : from[0];
    if (!known.has(key)) {
      const decoded = await codec.decode(from);
      known.set(key, { decoded, to: await codec.encode(decoded) });
    }
    const { decoded, to } = known.get(key);
    const end = start + decoded.length;
    if (!same(from, to)) found.push({ start, end, from: hex(from), to: hex(to) });
    start = end;
  }
  return found;
}

/** The characters of a text that come back as others: where, and as what. */
export async function unspellable(text, codec) {
  if ((await codec.decode(await codec.encode(text))) === text) return [];
  const known = new Map();
  const found = [];
  let start = 0;
  for (const from of text) {
    if (!known.has(from)) known.set(from, await codec.decode(await codec.encode(from)));
    const to = known.get(from);
    if (to !== from) found.push({ start, end: start + from.length, from, to });
    start += from.length;
  }
  return found;
}

const same = (one, other) => one.length === other.length && one.every((byte, at) => byte === other[at]);

const hex = (bytes) => [...bytes].map((byte) => byte.toString(16).toUpperCase().padStart(2, '0')).join(' ');
