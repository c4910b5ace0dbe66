// Compiles the module, which is inside this page. It is a script of its own, so that it begins before the page's script has come.

import { bytesOf, inflated } from '../../../tools/view/page/src/unpack.js';

globalThis.module = load();

async function load() {
  return WebAssembly.compile(await inflated(bytesOf(document.getElementById('module').textContent)));
}
