// The module, which is inside this page. A script of its own, which begins while the page's script still comes.

import { bytesOf, inflated } from '../../../tools/view/page/src/unpack.js';

globalThis.module = load();

async function load() {
  return WebAssembly.compile(await inflated(bytesOf(document.getElementById('module').textContent)));
}
