// A folder on a server of this machine's own.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';

/** Serves a folder's files, WebAssembly under a type. `home` is the address of its index.html. */
export async function host(folder, type = 'application/wasm') {
  const server = createServer((request, response) => {
    const name = request.url === '/' ? 'index.html' : request.url.slice(1);
    response.setHeader('Content-Type', name.endsWith('.wasm') ? type : 'text/html');
    response.end(readFileSync(`${folder}/${name}`));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { home: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}
