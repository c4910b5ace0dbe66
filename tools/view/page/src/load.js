// Unpacks the script of the page, which is deflated since it is most of the page. The page's policy allows it by its hash.

import { bytesOf, inflated } from './unpack.js';

async function load() {
  const text = new TextDecoder().decode(await inflated(bytesOf(document.getElementById('script').textContent)));
  document.body.append(Object.assign(document.createElement('script'), { text }));
}

load();
