// The bytes of the module: inside this page where that is one file, else beside it.

import { bytesOf, inflated } from './link.js';

export async function load() {
  const inside = document.getElementById('module');
  if (inside) return inflated(bytesOf(inside.textContent));
  return (await fetch('playground.wasm')).arrayBuffer();
}
