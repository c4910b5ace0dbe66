// A program in the fragment of an address: deflated (RFC 1951), in base64 without padding, + and /.

import { bytesOf, inflated, through } from '../../../tools/view/page/src/unpack.js';

/** The fragment of a program with its robot and its events. */
export async function fragmentOf({ text, robot, events }) {
  const bytes = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
  const base64 = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  const fields = new URLSearchParams({ robot, events, program: base64.replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '') });
  return `#${fields}`;
}

/** Reads a fragment: { lesson } or { example } from 1, or { text, robot, events }. Returns undefined if it has none of them. */
export async function readFragment(fragment) {
  const fields = new URLSearchParams(fragment.slice(1));
  for (const kind of ['lesson', 'example']) {
    if (fields.has(kind)) return { [kind]: Number(fields.get(kind)) };
  }
  if (!fields.has('program')) return undefined;
  const text = new TextDecoder('utf-8', { fatal: true }).decode(await inflated(bytesOf(fields.get('program').replace(/-/g, '+').replace(/_/g, '/'))));
  return { text, robot: fields.get('robot') ?? '', events: fields.get('events') ?? '' };
}
