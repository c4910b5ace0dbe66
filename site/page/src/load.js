// The module: inside this page where that is one file, else beside it. A script of its own, which begins while the page's script
// still comes.

import { bytesOf, inflated } from '../../../tools/view/page/src/unpack.js';

const TYPE = 'application/wasm';

globalThis.module = load();

async function load() {
  const inside = document.getElementById('module');
  if (inside) return WebAssembly.compile(await inflated(bytesOf(inside.textContent)));
  const response = await fetch('playground.wasm');
  // As it comes, and the browser keeps what it has compiled; unless the server calls it something else, or says more than this.
  if (response.headers.get('Content-Type')?.toLowerCase() === TYPE) return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}
