// A program in the fragment of an address: deflated (RFC 1951), in base64 without padding, + and /.

import { bytesOf, inflated, through } from '../../../tools/view/page/src/unpack.js';

/** The fragment of a program with its robot and its events, behind that of the lesson or example that it was made of (`#lesson=3`), or `#`. */
export async function fragmentOf({ text, robot, events }, shown) {
  const bytes = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
  const base64 = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  const fields = new URLSearchParams({ robot, events, program: base64.replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '') });
  return `${shown}${shown === '#' ? '' : '&'}${fields}`;
}

/** Reads a fragment: { lesson } or { example } from 1, { text, robot, events }, or both. Returns undefined if it has none of them. */
export async function readFragment(fragment) {
  const fields = new URLSearchParams(fragment.slice(1));
  const kind = ['lesson', 'example'].find((kind) => fields.has(kind));
  const shown = kind && { [kind]: Number(fields.get(kind)) };
  if (!fields.has('program')) return shown;
  const text = new TextDecoder('utf-8', { fatal: true }).decode(await inflated(bytesOf(fields.get('program').replace(/-/g, '+').replace(/_/g, '/'))));
  return { ...shown, text, robot: fields.get('robot') ?? '', events: fields.get('events') ?? '' };
}
