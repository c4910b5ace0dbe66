// The module and the page of `tipc view`: inside this page where that is one file, else beside it.

import { asker } from '../../wasm.mjs';
import { bytesOf, inflated } from './link.js';

async function part(id, file) {
  const inside = document.getElementById(id);
  if (inside) return inflated(bytesOf(inside.textContent));
  return new Uint8Array(await (await fetch(file)).arrayBuffer());
}

/** { ask, page }: a function that answers questions, and the page's text. */
export async function load() {
  const [wasm, page] = await Promise.all([part('part-wasm', 'playground.wasm'), part('part-page', 'replay.html')]);
  const { instance } = await WebAssembly.instantiate(wasm);
  return { ask: asker(instance.exports), page: new TextDecoder().decode(page) };
}
