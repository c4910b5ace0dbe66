// The page's script, which is deflated: it would be most of the page. Its policy knows the script by its hash.

import { bytesOf, inflated } from './unpack.js';

async function load() {
  const text = new TextDecoder().decode(await inflated(bytesOf(document.getElementById('script').textContent)));
  document.body.append(Object.assign(document.createElement('script'), { text }));
}

load();
